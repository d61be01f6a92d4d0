// Scenes far away, very large or very small are drawn as what they are: pictures do not depend on unit and place.

#include <cmath>

#include "tests/kit/catch.hpp"
#include "tests/kit/pictures.hpp"
#include "walkthroughs/model/scene.hpp"
#include "walkthroughs/picture/draw.hpp"
#include "walkthroughs/picture/stage.hpp"
#include "walkthroughs/story/storyboard.hpp"

namespace placing_test {

using namespace walkthroughs::program;

namespace {

Points box(const Point& low, const Point& size) {
  Points corners;
  for (int i = 0; i < 8; ++i) corners.push_back(low + size.cwiseProduct(Point(i & 1, i >> 1 & 1, i >> 2)));
  return corners;
}

/// Two boxes, or two round objects, in a unit of their own and moved from the origin.
Walkthrough pair(const AnyShape& a, const AnyShape& b, Dimension dimension) {
  Walkthrough w{.name = "pair", .title = "pair", .source = "", .summary = ""};
  w.panels.algorithm = false;  // it shows numbers
  w.naming = Naming::roles;
  w.scenes.push_back({.name = "", .a = {"a", a}, .b = {"b", b}, .dimension = dimension});
  return w;
}

Walkthrough boxes(double unit, double along_x) {
  Points a = box({0, 0, 0}, {2, 1, 1}), b = box({1, 0.5, 0.25}, {1, 2, 1});
  for (Points* points : {&a, &b})
    for (Point& p : *points) p = (p + Point(along_x, 0, 0)) * unit;
  return pair(a, b, Dimension::space);
}

Walkthrough balls(double unit) {
  return pair(Ball{{0, 0, 0}, unit}, Ball{Point(1, 0.25, 0.5) * unit, unit}, Dimension::space);
}

/// Returns: the trace of a scene that was placed elsewhere, its directions left as they are.
Trace elsewhere(const Placing& placing, const Trace& usual) {
  Trace trace = placing.placed(usual);
  for (auto& event : trace.events) {
    if (auto* crossing = std::get_if<gjk::CrossingTested<double>>(&event); crossing && crossing->value)
      *crossing->value *= placing.scale;
    if (auto* region = std::get_if<gjk::RegionTested<double>>(&event); region && region->normal)
      if (auto* value = std::get_if<double>(&region->value)) *value *= placing.scale;
  }
  return trace;
}

/// Checks that all frames, numbers aside, look the same to a thousandth of a pixel.
void check_same_pictures(const Walkthrough& usual, const Walkthrough& extreme, double unit, double along_x = 0) {
  render::Font font(render::Font::default_directory());
  // The search itself may overflow or vanish there, so its story is that of the usual scene.
  const Placing away{unit, Point(-along_x, 0, 0)};
  const StagedStory expected(tell(usual)), story(tell(extreme, {elsewhere(away, run(usual.scenes[0]))}));
  CHECK_FALSE(expected.stages[0].placing.moves());
  CHECK(story.stages[0].placing.moves());
  REQUIRE(story.frames.size() == expected.frames.size());
  for (std::size_t i = 0; i < story.frames.size(); ++i) {
    INFO("frame " << i);
    const render::Size page = page_of_frame(Look{.text = Text::none});
    render::Canvas one(page, page, render::palette::white, font), other(page, page, render::palette::white, font);
    draw_frame(one, expected, i, {.text = Text::none, .values = false});
    draw_frame(other, story, i, {.text = Text::none, .values = false});
    const std::vector<render::CanvasVertex> drawn = kit::vertices_of(one), again = kit::vertices_of(other);
    REQUIRE(drawn.size() == again.size());
    double most = 0;
    for (std::size_t v = 0; v < drawn.size(); ++v)
      most = std::max<double>({most, std::abs(drawn[v].x - again[v].x), std::abs(drawn[v].y - again[v].y)});
    CHECK(most < 1e-3);
  }
}

}  // namespace

TEST_CASE("Very large and very small polytopes are drawn as those of usual size, edges included") {
  for (const int exponent : {-990, -300, 260, 495})
    check_same_pictures(boxes(1, 0), boxes(std::ldexp(1, exponent), 0), std::ldexp(1, exponent));
}

TEST_CASE("Very small and very large round objects are drawn as those of usual size") {
  for (const int exponent : {-996, 490})
    check_same_pictures(balls(1), balls(std::ldexp(1, exponent)), std::ldexp(1, exponent));
}

TEST_CASE("Objects far from the origin are drawn as those at it, small and large ones, too") {
  for (const double away : {std::ldexp(1, 37), std::ldexp(1, 45)}) {
    check_same_pictures(boxes(1, 0), boxes(1, away), 1, away);
    check_same_pictures(boxes(1, 0), boxes(std::ldexp(1, 260), away), std::ldexp(1, 260), away);
    check_same_pictures(boxes(1, 0), boxes(std::ldexp(1, -500), away), std::ldexp(1, -500), away);
  }
}

TEST_CASE("An object that vanishes beside the other is drawn with it") {
  render::Font font(render::Font::default_directory());
  const Ball large{{1e150, 0, 0}, 1e149};
  for (const AnyShape& small :
       {AnyShape(Ball{{0, 0, 0}, 1e-300}), AnyShape(Cylinder{{0, 0, 0}, {1, 2, 3}, 1e-250, 1e-300}),
        AnyShape(Sum{{Points{{0, 0, 0}, {1e-200, 0, 0}}, Ball{{0, 0, 0}, 1e-250}}})}) {
    const Walkthrough w = pair(small, large, Dimension::space);
    const StagedStory story(tell(w));
    render::Canvas canvas(frame_page, frame_page, render::palette::white, font);
    for (std::size_t i = 0; i < story.frames.size(); ++i) CHECK_NOTHROW(draw_frame(canvas, story, i));
  }
}

}  // namespace placing_test
