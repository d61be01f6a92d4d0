/// Accepted files, and what is to be done about those that differ.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace golden {

/// tests/golden in the source tree, and a folder of the build for candidates and reports.
std::filesystem::path folder();
std::filesystem::path candidates();

/// Whether new files are to be accepted: GJKSTEP_UPDATE_GOLDENS=1 is set.
/// Errors: std::runtime_error where CI is set as well: nobody looks at what CI would accept.
bool accepting();

/// Returns: what is accepted as `name`; empty where nothing is.
std::string accepted_text(const std::string& name);

/// Writes to candidates()/`name`. Returns: the file.
std::filesystem::path leave_candidate(const std::string& name, std::span<const std::uint8_t> bytes);
std::filesystem::path leave_candidate(const std::string& name, std::string_view text);

/// Writes to folder()/`name` and prints `why`.
void accept(const std::string& name, std::span<const std::uint8_t> bytes, const std::string& why);
void accept(const std::string& name, std::string_view text, const std::string& why);

/// Returns: the command that accepts what these tests draw or write now: "images", "traces", …
std::string command_to_accept(const std::string& tests);

/// Checks that a text is the one that is accepted as `name`, and tells which lines are others; or accepts it.
void check_text(const std::string& name, const std::string& now, const std::string& tests);

/// Whether letters are as wide as those of the accepted pictures. Warns that the test is skipped where another FreeType makes them.
bool letters_are_those_accepted();

}  // namespace golden
