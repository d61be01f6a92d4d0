#include "tests/golden/store.hpp"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <set>
#include <stdexcept>

#include "render/file.hpp"
#include "render/font.hpp"
#include "render/rendered_by.hpp"
#include "tests/kit/catch.hpp"
#include "tests/kit/places.hpp"
#include "tests/kit/text.hpp"

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

/// Returns: the first lines of `text` that `other` has not, or not as often.
std::string lines_missing_in(const std::string& other, const std::string& text, const std::string& mark) {
  constexpr int most_told = 6;
  const std::vector<std::string> lines = kit::lines(other);
  std::multiset<std::string> known(lines.begin(), lines.end());
  std::string told;
  int count = 0;
  for (const std::string& line : kit::lines(text)) {
    if (const auto found = known.find(line); found != known.end())
      known.erase(found);
    else if (++count <= most_told)
      told += mark + line + "\n";
  }
  return told + (count > most_told ? mark + "… and " + std::to_string(count - most_told) + " more\n" : "");
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

std::string command_to_accept(const std::string& tests) { return "tests/golden/accept.py --accept " + tests; }

void check_text(const std::string& name, const std::string& now, const std::string& tests) {
  const std::string accepted = accepted_text(name);
  if (now == accepted) {
    SUCCEED(name);
    return;
  }
  if (accepting()) return accept(name, now, "it is not what was accepted");
  const fs::path candidate = leave_candidate(name, now);
  FAIL_CHECK(name << " is not what is accepted; lines that are gone (-) and new (+):\n"
                  << lines_missing_in(now, accepted, "- ") << lines_missing_in(accepted, now, "+ ")
                  << "All of them: diff " << (folder() / name).string() << " " << candidate.string()
                  << "\nTo accept: " << command_to_accept(tests));
}

bool letters_are_those_accepted() {
  const auto notes = render::read_rendered_by(folder() / "images");
  const bool is_same = notes && std::ranges::any_of(*notes, [](const auto& note) {
                         return note.first == "FreeType" && note.second == render::freetype_version();
                       });
  if (!is_same) kit::skip("letters are as wide as another FreeType makes them");
  return is_same;
}

}  // namespace golden
