// What stands near the origin is magnified: the same picture at every power of ten.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/picture/draw.hpp"

namespace close_up_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;
using render::Vec2;
namespace shape = render::shape;

namespace {

constexpr double near_enough = 0.1;  // page units

Walkthrough scene_of(Dimension dimension, const std::vector<Point>& a, const std::vector<Point>& b) {
  Walkthrough w = walkthrough_of(a, {}, b);
  w.scenes[0].dimension = dimension;
  w.naming = Naming::roles;
  return w;
}

/// A corner of b beside a corner of a: at the end O, P and A would be one dot.
Walkthrough corners_apart(double gap) {
  return scene_of(Dimension::plane, {{0, 0, 0}, {1, 0.5, 0}, {0.5, 1, 0}}, {{gap, -gap, 0}, {2, -1, 0}, {-1, -2, 0}});
}

/// A corner of b below a face of a.
Walkthrough corner_and_face(double gap) {
  return scene_of(Dimension::space, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                  {{0.25, 0.25, -gap}, {1, 0.25, -1}, {0.25, 1, -1}, {0, 0, -2}});
}

struct Page {
  render::Canvas canvas;
  Page(const StagedStory& story, std::size_t frame, render::Font& font)
      : canvas(frame_page, frame_page, render::palette::white, font) {
    draw_frame(canvas, story, frame);
  }

  /// Returns: what is drawn inside of close-ups, but for fine lines, which one rounding more or less adds.
  std::vector<render::Shape> magnified() const {
    std::vector<render::Shape> found, inside, since;
    for (const render::Shape& each : canvas.shapes()) {
      if (std::holds_alternative<shape::Clip>(each)) inside = std::exchange(since, {});
      const auto* line = std::get_if<shape::Polyline>(&each);
      if (!line || line->stroke.width > 1) since.push_back(each);
      const auto* text = std::get_if<shape::Text>(&each);
      if (text && text->text.starts_with("magnified")) std::ranges::copy(inside, std::back_inserter(found));
    }
    return found;
  }
};

std::vector<Vec2> places(const shape::Polygon& s) { return s.corners; }
std::vector<Vec2> places(const shape::Polyline& s) { return s.corners; }
std::vector<Vec2> places(const shape::Disc& s) { return {s.center}; }
std::vector<Vec2> places(const shape::Ring& s) { return {s.center}; }
std::vector<Vec2> places(const shape::Clip& s) { return {s.box.min, s.box.max}; }
std::vector<Vec2> places(const shape::Text&) { return {}; }  // numbers differ, and what they leave room for

/// Returns: how far a shape of one page lies from that of the other, at most; infinite for one of another kind.
double distance(const render::Shape& one, const render::Shape& other) {
  const auto at = [](const render::Shape& shape) { return std::visit([](const auto& s) { return places(s); }, shape); };
  const std::vector<Vec2> here = at(one), there = at(other);
  if (one.index() != other.index() || here.size() != there.size()) return INFINITY;
  double most = 0;
  for (std::size_t i = 0; i < here.size(); ++i) most = std::max(most, (here[i] - there[i]).cwiseAbs().maxCoeff());
  return most;
}

}  // namespace

TEST_CASE("The close-up of a gap is the same picture at every power of ten, nothing covered, nothing cut") {
  render::Font font{render::Font::default_directory()};
  for (const auto& scene : {corners_apart, corner_and_face}) {
    const Walkthrough plain = scene(1e-7);
    const StagedStory usual(tell(plain));
    int magnified = 0;
    for (int e = 8; e <= 300; e += e < 20 ? 1 : 20) {
      const Walkthrough w = scene(std::pow(10, -e));
      const StagedStory story(tell(w));
      REQUIRE(story.frames.size() == usual.frames.size());
      for (std::size_t i = 0; i < story.frames.size(); ++i) {
        INFO((scene == corners_apart ? "corners, " : "face, ") << "1e-" << e << ", frame " << i);
        const Page page(story, i, font), wanted(usual, i, font);
        const std::vector<render::Shape> shown = page.magnified(), usually = wanted.magnified();
        REQUIRE(shown.size() == usually.size());
        if (shown.empty()) continue;
        ++magnified;
        CHECK(page.canvas.crowded() == 0);
        for (std::size_t s = 0; s < shown.size(); ++s) CHECK(distance(shown[s], usually[s]) < near_enough);
      }
    }
    CHECK(magnified > 20);
  }
}

TEST_CASE("An object that is a dot beside the other has a ring around it, and its name") {
  render::Font font{render::Font::default_directory()};
  for (const double size : {1.0, 1e-3, 1e-9}) {
    const Walkthrough w =
        scene_of(Dimension::plane, {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}}, {{4, 4, 0}, {4 + size, 4, 0}, {4, 4 + size, 0}});
    const StagedStory story(tell(w));
    const Page page(story, 0, font);
    const auto is_name = [](const render::Shape& each) {
      const auto* text = std::get_if<shape::Text>(&each);
      return text && text->text == "second";
    };
    CHECK(std::ranges::count_if(page.canvas.shapes(), is_name) == (size < 1 ? 2 : 1));  // the key has it, too
  }
}

TEST_CASE("A slanted edge whose ends are far away passes the origin in a close-up where it does") {
  const double ulp = 0x1p-52;  // the cross product of its ends is ulp², of which no rounded product leaves anything
  const Walkthrough w = scene_of(Dimension::plane, {{1 + ulp, 1, 0}, {-1, ulp - 1, 0}, {-1, -3, 0}}, {{0, 0, 0}});
  render::Font font{render::Font::default_directory()};
  const StagedStory story(tell(w));
  int edges = 0;
  for (std::size_t i = 0; i < story.frames.size(); ++i) {
    const std::vector<render::Shape> shown = Page(story, i, font).magnified();
    if (shown.empty()) continue;
    const Vec2 middle = std::get<shape::Clip>(shown.front()).box.center();  // between the edge and the origin
    for (const render::Shape& each : shown) {
      const auto* line = std::get_if<shape::Polyline>(&each);
      if (!line || line->corners.size() != 2 || line->stroke.color != render::themes::report.green) continue;
      ++edges;
      const double distance = render::distance_to_segment(middle, line->corners.front(), line->corners.back());
      CHECK((distance > 12 && distance < 38));
    }
  }
  CHECK(edges > 0);
}

TEST_CASE("Each gap between corners in space can be drawn, down to those that no product of doubles sees") {
  render::Font font{render::Font::default_directory()};
  for (const double gap : {1e-100, 1e-170, 1e-300}) {
    INFO(gap);
    const Walkthrough w = scene_of(Dimension::space, {{0, 0, 0}, {-1, -0.5, 0.3}, {-1, 0.6, 0.2}, {-0.8, 0, -1}},
                                   {{gap, 0, 0}, {1, 0.5, 0.1}, {1, -0.6, 0}, {0.8, 0, 1}});
    const StagedStory story(tell(w));
    for (std::size_t i = 0; i < story.frames.size(); ++i) CHECK(Page(story, i, font).canvas.shapes().size() > 50);
  }
}

TEST_CASE("In a close-up of round objects their border runs where it does") {
  render::Font font{render::Font::default_directory()};
  for (const double gap : {1e-2, 1e-5}) {  // beside a disc of radius 2 around the origin of the difference
    INFO(gap);
    Walkthrough w = scene_of(Dimension::plane, {{0, 0, 0}}, {{0, 0, 0}});
    w.scenes[0].a.form = Ball{{0, 0, 0}, 1};
    w.scenes[0].b.form = Ball{{1.6 * (1 + gap / 2), 1.2 * (1 + gap / 2), 0}, 1};
    const StagedStory story(tell(w));
    const std::vector<render::Shape> shown = Page(story, story.frames.size() - 1, font).magnified();
    REQUIRE_FALSE(shown.empty());
    const render::Box inside = std::get<shape::Clip>(shown.front()).box;
    double nearest = INFINITY;  // of the border, from the middle between that and the origin
    for (const render::Shape& each : shown)
      if (const auto* line = std::get_if<shape::Polyline>(&each);
          line && line->stroke.color == render::themes::report.grey && line->stroke.dash.length == 0)
        nearest = std::min(nearest,
                           render::distance_to_segment(inside.center(), line->corners.front(), line->corners.back()));
    CHECK(nearest < 80);  // in sight
  }
}

}  // namespace close_up_test
