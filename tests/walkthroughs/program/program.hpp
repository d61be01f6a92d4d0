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

using namespace program;

using kit::has, kit::lines, kit::Outcome, kit::quoted, kit::shell;

inline Outcome run(const std::string& arguments, const std::string& environment = "") {
  return shell("env " + environment + " " + quoted(kit::program()) + " " + arguments);
}

/// Checks that the command fails with that code, says each of `expected` on standard error and nothing on standard output.
inline void check_failure(const std::string& arguments, int exit_code, const std::vector<std::string>& expected,
                          const std::string& environment = "") {
  INFO(environment << " gjkstep " << arguments);
  kit::check_failed(run(arguments, environment), exit_code, expected);
}

/// A folder that must not come into being.
struct Untouched {
  Folder parent;
  std::filesystem::path folder = parent.path() / "out";
  std::string option = " --out " + quoted(folder.string());
  ~Untouched() { CHECK_FALSE(std::filesystem::exists(folder)); }
};

}  // namespace walkthroughs::test
