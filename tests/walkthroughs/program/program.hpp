/// The program as its users run it. GJKSTEP_PROGRAM is its path, given by the build.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/catch.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"

namespace walkthroughs::test {

inline std::string quoted(const std::string& text) { return "'" + text + "'"; }  // no test needs a ' inside

struct Outcome {
  int exit_code;
  std::string out, err;
};

/// Where standard output and standard error go.
struct Streams {
  std::string out, err;  ///< files; where empty, to be read back
};

inline Outcome run(const std::string& arguments, const std::string& environment = "", const Streams& streams = {}) {
  const Folder folder;
  const std::string out = (folder.path() / "stdout").string(), err = (folder.path() / "stderr").string();
  const std::string command = "env " + environment + " " + quoted(GJKSTEP_PROGRAM) + " " + arguments + " >" +
                              quoted(streams.out.empty() ? out : streams.out) + " 2>" +
                              quoted(streams.err.empty() ? err : streams.err);
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, bytes_of(out), bytes_of(err)};
}

inline bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

inline std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> list;
  for (std::size_t at = 0, end; (end = text.find('\n', at)) != std::string::npos; at = end + 1)
    list.push_back(text.substr(at, end - at));
  return list;
}

/// Checks that the command fails with that code, says each of `expected` on standard error and nothing on standard output.
inline void check_failure(const std::string& arguments, int exit_code, const std::vector<std::string>& expected,
                          const std::string& environment = "") {
  INFO(environment << " gjkstep " << arguments);
  const Outcome outcome = run(arguments, environment);
  INFO(outcome.err);
  CHECK(outcome.exit_code == exit_code);
  CHECK(outcome.out.empty());
  for (const std::string& part : expected) CHECK(has(outcome.err, part));
  CHECK(lines(outcome.err).size() <= 2);
}

/// A folder that must not come into being.
struct Untouched {
  Folder parent;
  std::filesystem::path folder = parent.path() / "out";
  std::string option = " --out " + quoted(folder.string());
  ~Untouched() { CHECK_FALSE(std::filesystem::exists(folder)); }
};

/// A scene file of that name: a square and a triangle in the plane, to be drawn at 48x27.
inline std::filesystem::path scene_file(const std::filesystem::path& file) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << R"({"dimension": 2, "size": "48x27",
    "a": {"points": [[0, 0], [2, 0], [2, 2], [0, 2]]}, "b": {"points": [[1, 1], [3, 1], [3, 3]]}})";
  return file;
}

/// Returns: a folder of the catalogue, or nothing where it has none.
inline std::string some_folder() {
  for (const Walkthrough& w : catalogue())
    if (const std::size_t slash = w.name.find('/'); slash != std::string::npos) return w.name.substr(0, slash);
  return "";
}

}  // namespace walkthroughs::test
