/// The program as its users run it.
#pragma once

#include <filesystem>
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

}  // namespace walkthroughs::test
