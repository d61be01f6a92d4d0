#include "tests/golden/store.hpp"

#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string_view>

#include "render/file.hpp"

namespace golden {
namespace {

namespace fs = std::filesystem;

bool is_set(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0' && std::string_view(value) != "0" && std::string_view(value) != "false";
}

}  // namespace

fs::path folder() { return GJKSTEP_GOLDEN; }
fs::path candidates() { return GJKSTEP_GOLDEN_CANDIDATES; }

bool accepting() {
  if (!is_set("GJKSTEP_UPDATE_GOLDENS")) return false;
  if (is_set("CI"))
    throw std::runtime_error(
        "GJKSTEP_UPDATE_GOLDENS is set where CI is set: goldens are accepted by people who look at them");
  return true;
}

fs::path leave_candidate(const std::string& name, const Bytes& bytes) {
  const fs::path file = candidates() / name;
  fs::create_directories(file.parent_path());
  render::write_file(file, bytes);
  return file;
}

void accept(const std::string& name, const Bytes& bytes, const std::string& why) {
  const fs::path file = folder() / name;
  fs::create_directories(file.parent_path());
  render::write_file(file, bytes);
  std::cout << "accepted " << name << ": " << why << std::endl;
}

std::string command_to_accept(const std::string& tests) {
  return "GJKSTEP_UPDATE_GOLDENS=1 ctest --test-dir BUILD -R '" + tests + "' --verbose";
}

}  // namespace golden
