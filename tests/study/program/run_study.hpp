/// gjkstep-study, as tests run it.
#pragma once

#include <string>
#include <vector>

#include "tests/kit/catch.hpp"
#include "tests/kit/folder.hpp"
#include "tests/kit/places.hpp"
#include "tests/kit/program.hpp"
#include "tests/kit/text.hpp"

namespace study::test {

using kit::bytes_of, kit::Folder, kit::has, kit::lines, kit::listing, kit::Outcome, kit::quoted, kit::write;

inline std::string in(const Folder& folder, const std::string& name) { return quoted((folder / name).string()); }

/// `out`: where standard output goes; empty where it is read back.
inline Outcome run(const std::string& arguments, const std::string& out = "") {
  return kit::shell(quoted(kit::built("gjkstep-study")) + " " + arguments + (out.empty() ? "" : " >" + quoted(out)));
}

/// Checks that the command fails with that code, says each of `expected` on standard error and nothing on standard output.
inline void check_failure(const std::string& arguments, int exit_code, const std::vector<std::string>& expected) {
  INFO("gjkstep-study " << arguments);
  kit::check_failed(run(arguments), exit_code, expected);
}

}  // namespace study::test
