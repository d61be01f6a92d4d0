#include "tests/golden/store.hpp"

#include <cstdlib>
#include <iostream>
#include <stdexcept>

#include "render/file.hpp"
#include "tests/kit/places.hpp"

namespace golden {
namespace {

namespace fs = std::filesystem;

bool is_set(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0' && std::string_view(value) != "0" && std::string_view(value) != "false";
}

fs::path write(const fs::path& file, const auto& contents) {
  fs::create_directories(file.parent_path());
  render::write_file(file, contents);
  return file;
}

void announce(const std::string& name, const std::string& why) {
  std::cout << "accepted " << name << ": " << why << std::endl;
}

}  // namespace

fs::path folder() { return kit::source("tests/golden"); }
fs::path candidates() { return kit::built("golden"); }

bool accepting() {
  if (!is_set("GJKSTEP_UPDATE_GOLDENS")) return false;
  if (is_set("CI"))
    throw std::runtime_error(
        "GJKSTEP_UPDATE_GOLDENS is set where CI is set: goldens are accepted by people who look at them");
  return true;
}

std::string accepted_text(const std::string& name) {
  if (!fs::exists(folder() / name)) return "";
  const auto read = render::read_file(folder() / name);
  return {read.begin(), read.end()};
}

fs::path leave_candidate(const std::string& name, std::span<const std::uint8_t> bytes) {
  return write(candidates() / name, bytes);
}
fs::path leave_candidate(const std::string& name, std::string_view text) { return write(candidates() / name, text); }

void accept(const std::string& name, std::span<const std::uint8_t> bytes, const std::string& why) {
  write(folder() / name, bytes);
  announce(name, why);
}
void accept(const std::string& name, std::string_view text, const std::string& why) {
  write(folder() / name, text);
  announce(name, why);
}

std::string command_to_accept(const std::string& tests) {
  return "GJKSTEP_UPDATE_GOLDENS=1 ctest --test-dir BUILD -R '" + tests + "' --verbose";
}

}  // namespace golden
