// The three small arrows that tell where x, y and z point.

#include <optional>

#include "tests/kit/catch.hpp"
#include "tests/kit/pictures.hpp"
#include "walkthroughs/picture/pencil.hpp"

namespace triad_test {

using namespace walkthroughs::program;
using render::Box;
using render::Vec2;

namespace {

using Kind = render::CanvasVertex::Kind;

/// The letters of a triad, and its shafts from end to end.
struct Triad {
  std::vector<Box> letters;
  std::vector<std::pair<Vec2, Vec2>> shafts;
};

Triad triad_of(const render::Camera& camera, render::Font& font) {
  const Style style(render::themes::report);
  const Box frame{{0, 0}, {200, 200}};
  render::Canvas canvas({200, 200}, {200, 200}, render::palette::white, font);
  render::Panel panel(canvas, frame, render::View::fit({-1, -1}, {1, 1}, frame, 100));
  const Lens lens{camera};
  Pencil(panel, lens, style).triad(canvas, frame);
  Triad triad;
  const std::vector<render::CanvasVertex> all = kit::vertices_of(canvas);
  for (std::size_t i = 0; i + 5 < all.size();) {
    const auto at = [&](std::size_t corner) { return Vec2(all[i + corner].x, all[i + corner].y); };
    if (all[i].kind == Kind::fill) {  // a triangle
      i += 3;
      continue;
    }
    if (all[i].kind == Kind::glyph) triad.letters.push_back({at(0), at(2)});
    if (all[i].kind == Kind::capsule && all[i].color == style.theme.grey)
      triad.shafts.emplace_back((at(0) + at(5)) / 2, (at(1) + at(2)) / 2);
    i += 6;
  }
  return triad;
}

}  // namespace

TEST_CASE("The letters of the axes stand clear of each other and of the axes, from wherever a scene is looked at") {
  render::Font font(render::Font::default_directory());
  for (double azimuth = 0; azimuth < 360; azimuth += 2.5)
    for (const double elevation : {12.0, 20.0, 28.0, 40.0, 55.0}) {
      INFO("azimuth " << azimuth << ", elevation " << elevation);
      const Triad triad = triad_of({azimuth, elevation}, font);
      REQUIRE(triad.letters.size() >= 2);
      REQUIRE(triad.shafts.size() == 3);
      for (std::size_t i = 0; i < triad.letters.size(); ++i) {
        for (std::size_t j = i + 1; j < triad.letters.size(); ++j)
          REQUIRE_FALSE(triad.letters[i].grown(-2.5).overlaps(triad.letters[j].grown(-2.5)));
        for (const auto& [from, to] : triad.shafts)
          REQUIRE_FALSE(render::clip_segment(from, to, triad.letters[i].grown(-2.5)).has_value());
      }
    }
}

}  // namespace triad_test
