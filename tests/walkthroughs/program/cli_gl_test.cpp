// What draws, chosen with --gl or GJKSTEP_GL, and what it does where the machine lacks something.

#include <algorithm>
#include <filesystem>

#include "render/offscreen_context.hpp"
#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/program/program.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
namespace fs = std::filesystem;

TEST_CASE("The option --gl chooses what draws, and beats the variable GJKSTEP_GL, which beats the default") {
  const auto titled = [](render::Backend backend) {
    return backend == render::Backend::osmesa ? ", OSMesa\n" : ", EGL surfaceless\n";
  };
  CHECK(run("--version").out.ends_with(titled(render::default_backend())));
  CHECK(run("--version", "GJKSTEP_GL=").out.ends_with(titled(render::default_backend())));
  for (const render::Backend backend : render::built_in_backends()) {
    const std::string name(render::name_of(backend));
    CHECK(run("--version --gl " + name).out.ends_with(titled(backend)));
    CHECK(run("--version", "GJKSTEP_GL=" + name).out.ends_with(titled(backend)));
    for (const std::string other : {"osmesa", "egl", "nonsense"})
      CHECK(run("--version --gl " + name, "GJKSTEP_GL=" + other).out.ends_with(titled(backend)));
  }
}

TEST_CASE("The same frames are drawn, whatever draws them") {
  const Folder folder;
  const std::string names = "render figure-2 figure-4-left regions/3-simplex-inside --strip --sheet --size 640x360 ";
  const auto drawn_with = [&](render::Backend backend) {
    const fs::path out = folder.path() / render::name_of(backend);
    CHECK(run(names + "--gl " + std::string(render::name_of(backend)) + " --out " + quoted(out.string())).exit_code ==
          0);
    return out;
  };
  const fs::path expected = drawn_with(render::default_backend());
  for (const render::Backend backend : render::built_in_backends()) {
    const fs::path actual = drawn_with(backend);
    REQUIRE(listing(actual) == listing(expected));
    for (const std::string& file : listing(expected)) {
      INFO(actual / file);
      CHECK(bytes_of(actual / file) == bytes_of(expected / file));
    }
  }
}

TEST_CASE("A backend that there is not is refused with the names of those that there are, and nothing is written") {
  for (const char* name : {"nonsense", "OSMesa", "egl ", ""}) {
    const Untouched out;
    check_failure("render figure-5 --gl " + quoted(name) + out.option, 2, {"--gl " + quoted(name), "osmesa or egl"});
    check_failure("--version --gl " + quoted(name), 2, {"--gl " + quoted(name), "osmesa or egl"});
  }
  const Untouched out;
  check_failure("render figure-5" + out.option, 2, {"GJKSTEP_GL 'glx'", "osmesa or egl"}, "GJKSTEP_GL=glx");
}

TEST_CASE("No OpenGL context is exit code 4 and the message names what stands in the way, and nothing is written") {
  for (const render::Backend backend : render::built_in_backends()) {
    const Untouched out;
    const std::string gl = " --gl " + std::string(render::name_of(backend)), old = "MESA_GL_VERSION_OVERRIDE=2.1";
    check_failure("render figure-5" + gl + out.option, 4, {"OpenGL 3.3", old}, old);
    CHECK(run("--version" + gl, old).exit_code == 4);
  }
}

TEST_CASE(
    "Settings under which Mesa would crash or draw other pixels are exit code 4 and the message says what to choose") {
  for (const render::Backend backend : render::built_in_backends()) {
    const std::string gl = " --gl " + std::string(render::name_of(backend));
    for (const std::string setting : {"GALLIUM_DRIVER=bogus", "GALLIUM_DRIVER=softpipe", "LP_NATIVE_VECTOR_WIDTH=512",
                                      "DRAW_USE_LLVM=0", "LP_PERF=no_tex", "MESA_GLSL_VERSION_OVERRIDE=110"}) {
      const Untouched out;
      check_failure("render figure-5" + gl + out.option, 4, {setting, "unset it"}, setting);
    }
  }
}

TEST_CASE("A backend that this build lacks is exit code 4 and the message names its package, and nothing is written") {
  if (render::built_in_backends().size() == render::all_backends().size()) WARN("skipped: this build lacks none");
  for (const render::Backend backend : render::all_backends()) {
    if (std::ranges::count(render::built_in_backends(), backend) > 0) continue;
    const std::string name(render::name_of(backend));
    for (const bool by_variable : {false, true}) {
      const Untouched out;
      check_failure("render figure-5" + (by_variable ? "" : " --gl " + name) + out.option, 4,
                    {"'" + name + "'", "lib" + name, "-dev"}, by_variable ? "GJKSTEP_GL=" + name : "");
    }
  }
}

TEST_CASE("EGL that has no software renderer is exit code 4 and the message names its package") {
  if (std::ranges::count(render::built_in_backends(), render::Backend::egl) == 0) {
    WARN("skipped: this build does without EGL");
    return;
  }
  const Untouched out;
  const std::string none = "__EGL_VENDOR_LIBRARY_FILENAMES=/nowhere";
  check_failure("render figure-5 --gl egl" + out.option, 4, {none, "libegl-mesa0"}, none);
}

TEST_CASE("EGL that is told to draw with another driver is exit code 4 and the message says so") {
  if (std::ranges::count(render::built_in_backends(), render::Backend::egl) == 0) {
    WARN("skipped: this build does without EGL");
    return;
  }
  const Untouched out;
  const std::string other = "MESA_LOADER_DRIVER_OVERRIDE=zink";
  // Mesa complains as well; and what it leaks when it gives up is not ours.
  const Outcome outcome = run("render figure-5 --gl egl" + out.option, other + " ASAN_OPTIONS=detect_leaks=0");
  CHECK(outcome.exit_code == 4);
  CHECK(has(outcome.err, other));
}
