/// The program as its users run it.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/kit/catch.hpp"
#include "tests/kit/places.hpp"
#include "tests/kit/program.hpp"
#include "tests/kit/text.hpp"
#include "tests/walkthroughs/support.hpp"

namespace walkthroughs::test {

using kit::has, kit::lines, kit::Outcome, kit::quoted, kit::shell;

/// Where standard output and standard error go.
struct Streams {
  std::string out, err;  ///< files; where empty, to be read back
};

inline Outcome run(const std::string& arguments, const std::string& environment = "", const Streams& streams = {}) {
  std::string command = "env " + environment + " " + quoted(kit::program()) + " " + arguments;
  if (!streams.out.empty()) command += " >" + quoted(streams.out);
  if (!streams.err.empty()) command += " 2>" + quoted(streams.err);
  return shell(command);
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

}  // namespace walkthroughs::test
