#include "render/offscreen_context.hpp"

#include <GL/glcorearb.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <string>
#include <thread>

#include "render/rasterizer.hpp"
#include "tests/kit/catch.hpp"

namespace offscreen_context_test {

using namespace render;

namespace {

/// Returns: a page with one of everything, as drawn by a context of its own.
Image page_drawn_with(Backend backend) {
  Font font{Font::default_directory()};
  Canvas canvas({400, 200}, {200, 100}, palette::white, font);
  canvas.polygon(std::array{Vec2(20, 20), Vec2(90, 30), Vec2(40, 80)}, palette::sky.with_alpha(120));
  canvas.outline(std::array{Vec2(20, 20), Vec2(90, 30), Vec2(40, 80)}, {palette::blue, 2.5, {8, 5}});
  canvas.arrow({100, 20}, {180, 70}, {palette::green, 3, {}});
  canvas.circle({150, 30}, 15, {palette::vermillion, 2, {}});
  canvas.text({20, 60}, "a_1 × b_{12}", {.size = 24, .halo = palette::white});
  OffscreenContext context(backend);
  Rasterizer rasterizer(context);
  return rasterizer.draw(canvas);
}

}  // namespace

TEST_CASE("this build has a backend, each once, and OSMesa is the default where it is there") {
  const auto here = built_in_backends();
  REQUIRE_FALSE(here.empty());
  REQUIRE(default_backend() == here.front());
  for (const Backend backend : here) REQUIRE(std::ranges::count(here, backend) == 1);
  if (std::ranges::count(here, Backend::osmesa) > 0) REQUIRE(default_backend() == Backend::osmesa);
}

TEST_CASE("all backends draw the same pixels, also in other threads and two at once") {
  const Image expected = page_drawn_with(default_backend());
  REQUIRE(expected.pixel(80, 80) != palette::white);
  for (const Backend one : built_in_backends()) {
    for (const Backend other : built_in_backends()) {
      std::optional<Image> first, second;
      std::thread one_thread([&] { first = page_drawn_with(one); });
      std::thread other_thread([&] { second = page_drawn_with(other); });
      one_thread.join();
      other_thread.join();
      REQUIRE(first == expected);
      REQUIRE(second == expected);
    }
  }
}

TEST_CASE("a context draws on while another thread makes and destroys one") {
  for (const Backend backend : built_in_backends()) {
    Font font{Font::default_directory()};
    Canvas canvas({64, 64}, {64, 64}, palette::sky, font);
    OffscreenContext context(backend);
    Rasterizer rasterizer(context);
    const Image expected = rasterizer.draw(canvas);
    for (const Backend other : built_in_backends()) {
      std::thread([&] { page_drawn_with(other); }).join();
      REQUIRE(rasterizer.draw(canvas) == expected);
    }
  }
}

TEST_CASE("a second context in one thread is refused, of whichever backend, and the first one stays usable") {
  for (const Backend one : built_in_backends()) {
    const OffscreenContext context(one);
    const std::string description = context.description();
    for (const Backend other : built_in_backends()) REQUIRE_THROWS_AS(OffscreenContext(other), ContextError);
    REQUIRE(context.description() == description);
  }
}

TEST_CASE("a thread may have a context again when its last one is gone") {
  for (const Backend one : built_in_backends()) {
    for (const Backend other : built_in_backends()) {
      { const OffscreenContext context(one); }
      REQUIRE_NOTHROW(OffscreenContext(other));
    }
  }
}

TEST_CASE("nothing stays current in the thread when its context is gone") {
  for (const Backend backend : built_in_backends()) {
    std::optional<OffscreenContext> context(std::in_place, backend);
    const auto get_string = reinterpret_cast<PFNGLGETSTRINGPROC>(context->function("glGetString"));
    REQUIRE(get_string(GL_VERSION) != nullptr);
    context.reset();
    REQUIRE(get_string(GL_VERSION) == nullptr);
  }
}

TEST_CASE("a function that OpenGL has not is refused") {
  for (const Backend backend : built_in_backends()) {
    const OffscreenContext context(backend);
    REQUIRE(context.function("glClear") != nullptr);
    REQUIRE_THROWS_AS(context.function("noSuchFunction"), ContextError);
  }
}

TEST_CASE("a backend that this build lacks is refused with its package, and leaves the thread free") {
  if (built_in_backends().size() == all_backends.size()) kit::skip("this build lacks none");
  for (const Backend backend : all_backends) {
    if (std::ranges::count(built_in_backends(), backend) > 0) continue;
    REQUIRE_THROWS_AS(OffscreenContext(backend), ContextError);
    REQUIRE_NOTHROW(OffscreenContext());
  }
}

}  // namespace offscreen_context_test
