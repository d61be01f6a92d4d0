// Where labels and words of a page stand, told without rasterizing it; and the pictures of the README.

#include "walkthroughs/picture/draw.hpp"

#include <array>
#include <set>

#include "render/image.hpp"
#include "tests/kit/catch.hpp"
#include "tests/kit/places.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/output/renderer.hpp"

namespace draw_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;

namespace {

/// Returns: what of the text on a page is cut by its panel or the page, or stands over other text.
std::vector<std::string> unreadable(const render::Canvas& canvas, const render::Size& page) {
  constexpr double seen = 1;  // page units: so much of a letter is missed
  std::vector<std::string> found;
  render::Box clip{{0, 0}, {page.width, page.height}};
  std::vector<std::pair<render::Box, std::string>> before;
  for (const render::Shape& shape : canvas.shapes()) {
    if (const auto* to = std::get_if<render::shape::Clip>(&shape)) clip = to->box;
    const auto* const text = std::get_if<render::shape::Text>(&shape);
    if (!text || text->text.empty()) continue;
    const render::Box ink = canvas.ink_box(text->position, text->text, text->style), room = clip.grown(seen);
    if ((ink.min.array() < room.min.array()).any() || (ink.max.array() > room.max.array()).any())
      found.push_back("cut: " + text->text);
    for (const auto& [box, other] : before)
      if (box.grown(-seen).overlaps(ink.grown(-seen))) found.push_back(other + " under " + text->text);
    before.emplace_back(ink, text->text);
  }
  return found;
}

bool is_in_space(const Walkthrough& w) { return !w.scenes.empty() && w.scenes[0].dimension == Dimension::space; }

}  // namespace

// In the plane one frame is an exception: the origin lies on A there, the region tested is narrow and ends at the panel's border.
// In space a camera is chosen once for a whole search. In a close-up of a tetrahedron six edges, the borders of the regions in the
// plane of a face, a normal and the origin then meet in a small part of the picture, and a label may find no free place.
TEST_CASE(
    "No label stands over a line or another label or outside its panel, in space at most two in one frame of twenty",
    "[unsanitized][full]") {
  render::Font font{render::Font::default_directory()};
  std::size_t frames = 0, with_a_crowded_label = 0;
  for (const Walkthrough& w : whole_catalogue()) {
    const StagedStory story(tell(w));
    for (std::size_t i = 0; i < story.frames.size(); ++i) {
      INFO(w.name << ", frame " << i);
      render::Canvas page(frame_page, frame_page, render::palette::white, font);
      draw_frame(page, story, i);
      const int crowded = page.crowded();
      const bool is_exception = w.name == "regions/2-simplex-on-vertex" && i == 11;
      CHECK(crowded <= (is_in_space(w) ? 2 : is_exception ? 1 : 0));
      CHECK(unreadable(page, frame_page) == std::vector<std::string>{});
      frames += is_in_space(w);
      with_a_crowded_label += is_in_space(w) && crowded > 0;
    }
    if (!w.name.starts_with("figure-")) continue;
    INFO(w.name << ", strip");
    render::Canvas strip(strip_page(story), strip_page(story), render::palette::white, font);
    draw_strip(strip, story);
    CHECK(strip.crowded() == 0);
  }
  CHECK(with_a_crowded_label * 20 <= frames);
}

TEST_CASE("Where the origin is a vertex, its mark reaches out beyond those of that vertex") {
  render::Font font{render::Font::default_directory()};
  for (const char* name : {"regions/0-simplex-a-is-origin", "regions/2-simplex-on-vertex",
                           "regions/3-simplex-a-is-origin", "regions/2-simplex-on-edge"}) {
    INFO(name);
    const StagedStory story(tell(walkthrough(name)));
    render::Canvas page(frame_page, frame_page, render::palette::white, font);
    draw_frame(page, story, story.frames.size() - 1);
    double ring = 0, arm = 0;
    for (const render::Shape& shape : page.shapes()) {
      if (const auto* r = std::get_if<render::shape::Ring>(&shape)) ring = r->radius;  // the last is in the panel
      const auto* line = std::get_if<render::shape::Polyline>(&shape);
      if (line && line->stroke.width == Style(render::themes::report).origin.width && line->stroke.dash.gap == 0)
        arm = (line->corners[1] - line->corners[0]).norm() / 2;
    }
    CHECK(ring > 0);
    CHECK((arm > ring + 3) == (story.frames.back().moments[0].simplex.point(gjk::Role::A).isZero(0)));
  }
}

TEST_CASE("The line in which two objects in space cross is drawn where it is in sight") {
  render::Font font{render::Font::default_directory()};
  for (const char* name : {"regions/3-simplex-inside", "regions/3-simplex-on-face"}) {
    INFO(name);
    const StagedStory story(tell(walkthrough(name)));
    const std::vector<CrossingPiece>& crossing = story.stages[0].crossing;
    const auto seen = std::ranges::count_if(crossing, [&](const CrossingPiece& piece) {
      return story.stages[0].lens.sees(piece.outward_a) && story.stages[0].lens.sees(piece.outward_b);
    });
    const Style style(render::themes::report);
    render::Canvas page(frame_page, frame_page, style.theme.paper, font);
    draw_frame(page, story, story.frames.size() - 1);
    const auto drawn = std::ranges::count_if(page.shapes(), [&](const render::Shape& shape) {
      const auto* line = std::get_if<render::shape::Polyline>(&shape);
      return line && line->stroke.width == style.crossing.width && line->stroke.color == style.crossing.color;
    });
    CHECK((drawn == seen && 0 < seen && seen < std::ssize(crossing)));
  }
}

TEST_CASE("The faces of bodies in space are shaded, on white paper and on dark") {
  render::Font font{render::Font::default_directory()};
  const StagedStory story(tell(walkthrough("regions/3-simplex-on-face")));
  for (const render::Theme& theme : {render::themes::report, render::themes::dark}) {
    const Look look{.style = Style(theme)};
    render::Canvas page(frame_page, frame_page, theme.paper, font);
    draw_frame(page, story, story.frames.size() - 1, look);
    std::set<int> of_a, of_difference;
    for (const render::Shape& shape : page.shapes()) {
      if (const auto* face = std::get_if<render::shape::Polygon>(&shape)) {
        if (face->fill.with_alpha(0) == theme.sky.with_alpha(0)) of_a.insert(face->fill.a);
        if (face->fill.with_alpha(0) == theme.faint.with_alpha(0)) of_difference.insert(face->fill.a);
      }
    }
    CHECK(of_a.size() >= 4);
    CHECK(of_difference.size() >= 4);
  }
}

TEST_CASE("A strip is one row as long as that can be read, else rows that are read as text is") {
  render::Font font{render::Font::default_directory()};
  const auto drawn = [&](int iterations) {
    Story story = tell(walkthrough("figure-4-left"));
    const Frame last = story.frames.back();
    story.frames.assign(static_cast<std::size_t>(iterations), last);
    for (int i = 0; i < iterations; ++i) story.frames[static_cast<std::size_t>(i)].moments[0].iteration = i + 1;
    const StagedStory staged(std::move(story));
    render::Canvas strip(strip_page(staged), strip_page(staged), render::palette::white, font);
    draw_strip(strip, staged);
    return strip;
  };
  const int height = drawn(1).pixels().height, width = drawn(1).pixels().width;
  for (const int count : {2, 12, 13, 200}) {
    INFO(count);
    const render::Canvas strip = drawn(count);
    const auto [wide, high] = strip.pixels();
    if (count <= 12)
      CHECK((wide == count * width && high == height));
    else
      CHECK((wide > 1.3 * high && wide < 2.4 * high));
    CHECK(wide * high < (count + wide / width) * width * height);  // no row is empty
    int next = 1;
    render::Vec2 before(-1, -1);
    for (const render::Shape& shape : strip.shapes()) {
      const auto* title = std::get_if<render::shape::Text>(&shape);
      if (!title || title->text != "iteration " + std::to_string(next)) continue;
      CHECK((title->position.y() > before.y() ||
             (title->position.y() == before.y() && title->position.x() > before.x())));
      before = title->position;
      ++next;
    }
    CHECK(next == count + 1);
    CHECK((before.x() < wide && before.y() < high));
  }
}

TEST_CASE("At every scale of text all lines below the panels fit, and hardly a label is crowded",
          "[unsanitized][full]") {
  render::Font font{render::Font::default_directory()};
  constexpr std::array scales{0.75, 1.25, 1.5};
  for (std::size_t which = 0; which < scales.size(); ++which) {
    render::Theme theme = render::themes::report;
    theme.text = scales[which];
    const Look look{.style = Style(theme)};
    int frames = 0, with_crowded = 0;
    for (const Walkthrough& w : whole_catalogue()) {
      if (w.name.starts_with("cycle-")) continue;  // which show the same again and again
      const StagedStory story(tell(w));
      for (std::size_t i = which; i < story.frames.size(); i += scales.size()) {  // all are half a minute
        INFO(w.name << ", frame " << i << ", text " << scales[which]);
        render::Canvas page(frame_page, frame_page, look.style.theme.paper, font);
        draw_frame(page, story, i, look);
        const int crowded = page.crowded();
        CHECK(crowded <= (is_in_space(w) ? 3 : 1));
        CHECK(unreadable(page, frame_page) == std::vector<std::string>{});
        with_crowded += crowded > 0 ? 1 : 0;
        ++frames;
      }
    }
    CHECK(with_crowded * 10 <= frames);
  }
}

TEST_CASE("A key tells of earlier edges where some are drawn, and of the origin's side where it is drawn with one") {
  render::Font font{render::Font::default_directory()};
  const Style style(render::themes::report);
  constexpr double columns = 347;  // the view in space stands at the left of it, plane pictures at the right
  int with_earlier = 0, with_side = 0, frames = 0;
  for (const char* name :
       {"regions/3-simplex-face-acd-edge-ad", "regions/3-simplex-on-face", "complete/cycle-separated"}) {
    const StagedStory story(tell(walkthrough(name)));
    for (std::size_t i = 0; i < story.frames.size(); ++i, ++frames) {
      INFO(name << ", frame " << i);
      render::Canvas page(frame_page, frame_page, style.theme.paper, font);
      draw_frame(page, story, i);
      bool tells_earlier = false, shows_earlier = false;
      std::vector<Vec2> rings, keys;  // of the origin
      for (const render::Shape& shape : page.shapes()) {
        if (const auto* text = std::get_if<render::shape::Text>(&shape)) {
          tells_earlier = tells_earlier || text->text == "earlier";
          if (text->text == "O above") keys.push_back(text->position);
        }
        if (const auto* ring = std::get_if<render::shape::Ring>(&shape); ring && ring->radius == 6)
          rings.push_back(ring->center);
        if (const auto* line = std::get_if<render::shape::Polyline>(&shape); line && line->corners.size() == 2) {
          const bool is_dotted = line->stroke.dash.length == 3 && line->stroke.dash.gap == 7;
          const bool is_in_key = line->corners[1] - line->corners[0] == Vec2(30, 0);
          shows_earlier = shows_earlier || (is_dotted && !is_in_key);
        }
      }
      CHECK(tells_earlier == shows_earlier);
      for (const Vec2& key : keys)
        CHECK(std::ranges::any_of(rings, [&](const Vec2& ring) {
          return ring.y() > key.y() + 10 && (ring.x() < columns) == (key.x() < columns);
        }));
      with_earlier += tells_earlier ? 1 : 0;
      with_side += keys.empty() ? 0 : 1;
    }
  }
  CHECK((with_earlier > 10 && with_earlier < frames));
  CHECK((with_side > 10 && with_side < frames));
}

TEST_CASE("The pictures in the README are those that the program draws, and small") {
  Studio studio;
  const auto check = [&](const char* name, render::Size size, render::Size page, const auto& draw) {
    INFO(name);
    const std::filesystem::path file = kit::source("walkthroughs") / name;
    CHECK(std::filesystem::file_size(file) < 70 * 1024);
    render::Canvas canvas(size, page, render::palette::white, studio.font);
    draw(canvas);
    const render::Image committed = render::read_png(file).image, drawn = studio.rasterizer.draw(canvas);
    REQUIRE(committed.size() == drawn.size());
    int different = 0;  // a few pixels may differ by a shade from processor to processor
    for (int y = 0; y < drawn.size().height; ++y)
      for (int x = 0; x < drawn.size().width; ++x) different += committed.pixel(x, y) != drawn.pixel(x, y) ? 1 : 0;
    CHECK(different < 50);
  };
  const StagedStory plane(tell(walkthrough("figure-4-left"))),
      space(tell(walkthrough("regions/3-simplex-face-adb-edge-ad")));
  check("figure-4-left.png", strip_page(plane), strip_page(plane), [&](auto& canvas) { draw_strip(canvas, plane); });
  check("3-simplex-face-adb-edge-ad.png", {640, 360}, frame_page, [&](auto& canvas) { draw_frame(canvas, space, 22); });
}

}  // namespace draw_test
