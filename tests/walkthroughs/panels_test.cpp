// What stands where in the pictures, told from single pixels in the colours of the palette.

#include "walkthroughs/panels.hpp"

#include "tests/catch.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/draw.hpp"
#include "walkthroughs/render_frames.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
using render::Color;
namespace palette = render::palette;

namespace {

/// A panel that fills a page of its own, drawn at one pixel for each page unit.
class Picture {
 public:
  template <class Draw>
  Picture(const Bounds& bounds, Draw draw) {
    constexpr render::Size page{800, 800};
    const render::Box whole{{0, 0}, {800, 800}};
    view_ = render::View::fit(bounds.low, bounds.high, below_title(whole).grown(-100), 1e9);
    Studio studio;
    render::Canvas canvas(page, page, palette::white, studio.font);
    draw(canvas, Place{whole, "panel", view_});
    image_ = studio.rasterizer.draw(canvas);
  }

  Color at(const Vec2& scene) const {
    const Vec2 p = view_.page(scene);
    return image_.pixel(static_cast<int>(p.x()), static_cast<int>(p.y()));
  }
  /// Returns: how many pixels of the panel have exactly that colour.
  int count(Color color) const {
    int n = 0;
    for (int y = 0; y < image_.size().height; ++y)
      for (int x = 0; x < image_.size().width; ++x) n += image_.pixel(x, y) == color ? 1 : 0;
    return n;
  }

 private:
  render::View view_;
  render::Image image_{{1, 1}};
};

/// Returns: the moment after the last event of that kind in that iteration.
template <template <class> class E>
Moment after(const Told& told, int iteration) {
  const auto& events = told.trace.events;
  for (std::size_t i = events.size(); i-- > 0;)
    if (std::holds_alternative<E<double>>(events[i]) && iteration_of(events[i]) == iteration)
      return replay(told.trace, i + 1);
  throw std::logic_error("no such event");
}

Picture difference(const Told& told, const Moment& now, Focus focus) {
  return Picture(bounds_of_difference(told.hull), [&](render::Canvas& canvas, const Place& place) {
    draw_difference(canvas, place, told.hull, now, focus);
  });
}

Picture objects(const Told& told, const Moment& now, Focus focus) {
  return Picture(bounds_of_objects(told.scene), [&](render::Canvas& canvas, const Place& place) {
    draw_objects(canvas, place, told.scene, now, focus);
  });
}

}  // namespace

TEST_CASE("The origin is a dark plus") {
  for (const char* name : {"figure-4-left", "figure-4-right"}) {
    const Told told(name);
    const Picture picture = difference(told, replay(told.trace, 1), Focus::support);
    for (const Vec2& arm : {Vec2(0, 0), Vec2(0.06, 0), Vec2(-0.06, 0), Vec2(0, 0.06), Vec2(0, -0.06)})
      CHECK(picture.at(arm) == palette::ink);
    CHECK(picture.at({0.08, 0.08}) != palette::ink);
  }
}

TEST_CASE("The difference set is outlined and tinted, what lies outside is white") {
  const Told told("figure-4-right");
  const Picture picture = difference(told, replay(told.trace, 1), Focus::end);
  for (std::size_t i = 0; i < 7; ++i) {
    const Vec2 between = (told.hull.corners[i] + told.hull.corners[(i + 1) % 7]) / 2;
    CHECK(picture.at(between) == palette::grey);
  }
  const Color inside = picture.at({1.4, 3.4}), outside = picture.at({-1.4, 0.4});
  CHECK(inside != palette::white);
  CHECK(outside == palette::white);
}

TEST_CASE("The newest vertex and the older ones have their own colours, the other corners none") {
  const Told told("figure-4-left");
  const Vec2 ring(0, 0.125);  // in scene units; the newest one has it
  const Picture before = difference(told, after<gjk::SupportFound>(told, 4), Focus::support);
  CHECK(before.at(told.corner('F')) == palette::vermillion);  // found, not yet added
  const Picture picture = difference(told, after<gjk::RegionTested>(told, 4), Focus::end);
  CHECK(picture.at(told.corner('F')) == palette::green);
  CHECK(picture.at(told.corner('F') - ring) == palette::ink);
  CHECK(picture.at(told.corner('E') + ring) != palette::ink);
  CHECK(picture.at(told.corner('E')) == palette::green);
  CHECK(picture.at(told.corner('G')) == palette::green);
  for (const char other : {'B', 'C', 'D'}) CHECK(picture.at(told.corner(other)) == palette::grey);  // the outline
}

TEST_CASE("The newest vertex stays the newest while the next direction is chosen") {
  const Told told("figure-4-left");
  const Picture picture = difference(told, after<gjk::DirectionChosen>(told, 3), Focus::direction);
  CHECK(picture.at(told.corner('G')) == palette::green);
  CHECK(picture.at(told.corner('G') - Vec2(0, 0.125)) == palette::ink);  // its ring
  CHECK(picture.at(told.corner('E')) == palette::green);
}

TEST_CASE("A vertex that was dropped is no longer drawn as one") {
  const Told told("figure-4-left");
  CHECK(difference(told, after<gjk::VertexAdded>(told, 3), Focus::end).at(told.corner('A')) == palette::green);
  CHECK(difference(told, after<gjk::SimplexReduced>(told, 3), Focus::reduction).at(told.corner('A')) ==
        palette::ink);  // crossed out
  CHECK(difference(told, after<gjk::DirectionChosen>(told, 3), Focus::direction).at(told.corner('A')) !=
        palette::green);
}

TEST_CASE("The support points are marked on the objects where the event has them") {
  const Told told("figure-4-left");
  for (const int iteration : {1, 2, 3, 4}) {
    const Moment now = after<gjk::SupportFound>(told, iteration);
    const Picture picture = objects(told, now, Focus::support);
    CHECK(picture.at(now.found->a.point.head<2>()) == palette::blue);
    CHECK(picture.at(now.found->b.point.head<2>()) == palette::ink);
  }
}

TEST_CASE("What the crossing test looks at is drawn for it alone") {
  const Told told("figure-4-left");
  const Moment now = after<gjk::CrossingTested>(told, 2);
  const Vec2 middle_of_OE = told.corner('E') * 0.7;
  CHECK(difference(told, now, Focus::crossing).at(middle_of_OE) == palette::blue);
  CHECK(difference(told, now, Focus::support).at(middle_of_OE) != palette::blue);
}

TEST_CASE("A region that was tested is shaded on its own side, green where the origin lies in it") {
  const Told told("figure-4-left");
  const Picture chosen = difference(told, after<gjk::RegionTested>(told, 3), Focus::region);
  const Color beyond_EG = chosen.at({-1.2, -0.6}), before_EG = chosen.at({4.3, 2.4});
  CHECK(beyond_EG.g > beyond_EG.r + 20);
  CHECK(before_EG == palette::white);
}

TEST_CASE("A close-up shows the whole move and names no other corner") {
  const Told told("figure-5", 1);
  const Moment now = after<gjk::CrossingTested>(told, 2);
  const Picture picture(bounds_of_move(now), [&](render::Canvas& canvas, const Place& place) {
    draw_move(canvas, place, told.hull, now, Focus::crossing);
  });
  CHECK(picture.at(told.corner('A')) == palette::green);
  CHECK(picture.at(told.corner('E')) == palette::vermillion);
  CHECK(picture.at({0, 0}) == palette::ink);
  CHECK(picture.at(told.corner('E') / 2) == palette::blue);
  CHECK(picture.count(palette::vermillion) > 200);
}

TEST_CASE("Bounds hold everything that a panel must show") {
  for (const char* name : {"figure-4-left", "figure-4-right"}) {
    const Told told(name);
    const Bounds box = bounds_of_difference(told.hull);
    CHECK((box.low.array() <= 0).all());
    CHECK((box.high.array() >= 0).all());
    for (const Vec2& corner : told.hull.corners) {
      CHECK((box.low.array() <= corner.array()).all());
      CHECK((corner.array() <= box.high.array()).all());
    }
  }
  const Bounds of_objects = bounds_of_objects(Told("figure-4-left").scene);
  CHECK(of_objects.low == Vec2(-1.5, -1.75));
  CHECK(of_objects.high == Vec2(2.25, 2.25));
}

TEST_CASE("No label of any frame or strip stands over a line, over another label, or outside its panel") {
  render::Font font{render::Font::default_directory()};
  for (const Walkthrough& walkthrough : catalogue()) {
    const Story story = tell(walkthrough);
    for (std::size_t i = 0; i < story.frames.size(); ++i) {
      INFO(walkthrough.name << ", frame " << i);
      render::Canvas page(frame_page, frame_page, palette::white, font);
      CHECK(draw_frame(page, story, i) == 0);
    }
    INFO(walkthrough.name << ", strip");
    render::Canvas strip(strip_page(story), strip_page(story), palette::white, font);
    CHECK(draw_strip(strip, story) == 0);
  }
}
