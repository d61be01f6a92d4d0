// Backends that this build does without.

#include <algorithm>

#include "render/offscreen_context.hpp"
#include "tests/walkthroughs/program/program.hpp"

namespace cli_gl_test {

using namespace walkthroughs::test;

TEST_CASE("A backend that this build lacks is exit code 4 and the message names its package, and nothing is written") {
  if (render::built_in_backends().size() == render::all_backends.size()) kit::skip("this build lacks none");
  for (const render::Backend backend : render::all_backends) {
    if (std::ranges::count(render::built_in_backends(), backend) > 0) continue;
    const std::string name(render::name_of(backend));
    for (const bool by_variable : {false, true}) {
      const Untouched out;
      check_failure("render figure-5" + (by_variable ? "" : " --gl " + name) + out.option, 4,
                    {"'" + name + "'", "lib" + name, "-dev"}, by_variable ? "GJKSTEP_GL=" + name : "");
    }
  }
}

}  // namespace cli_gl_test
