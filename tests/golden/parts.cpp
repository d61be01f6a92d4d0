#include <array>
#include <cmath>
#include <limits>

#include "render/camera.hpp"
#include "render/panel.hpp"
#include "tests/golden/pictures.hpp"
#include "tests/kit/dice.hpp"

namespace golden {
namespace {

using namespace render;
using kit::Dice;

// No two dice are thrown where a compiler may choose which is first.

// -- Things at random, in cells -----------------------------------------------------------------------------------------

constexpr Size size{340, 210};

/// Of a lattice a little larger than the cell, half of the time; else beside it.
Vec2 place(Dice& dice, const Box& cell) {
  const double right = dice.between(-1, 6) * 0.2, down = dice.between(-1, 6) * 0.2;
  Vec2 point = cell.min + Vec2(right * cell.width(), down * cell.height());
  if (dice.coin()) return point;
  point.x() += dice.between(-4.0, 4.0);
  point.y() += dice.between(-4.0, 4.0);
  return point;
}

/// Also what is not finite, or far away.
Vec2 any_place(Dice& dice, const Box& cell) {
  Vec2 point = place(dice, cell);
  if (dice.between(0, 15) == 0) point.x() = dice.coin() ? std::numeric_limits<double>::quiet_NaN() : 1e9;
  return point;
}

/// Corners of a convex polygon of either sense, on a circle; some twice, perhaps all at one place.
std::vector<Vec2> convex(Dice& dice, const Box& cell) {
  const Vec2 middle = place(dice, cell);
  const double radius = dice.between(0, 9) == 0 ? 0 : dice.between(2.0, 0.7 * cell.height()),
               sense = dice.coin() ? 1 : -1;
  std::vector<Vec2> corners;
  double angle = 0;
  for (int left = dice.between(1, 7); left > 0; --left) {
    angle += dice.between(0, 4) == 0 ? 0 : dice.between(0.3, 0.95);
    corners.emplace_back(middle + radius * Vec2(std::cos(angle), sense * std::sin(angle)));
  }
  return corners;
}

Color color(Dice& dice) {
  constexpr std::array all{palette::ink, palette::blue, palette::vermillion, palette::green, palette::orange};
  const Color color = all[static_cast<std::size_t>(dice.between(0, 4))];
  return dice.coin() ? color : color.with_alpha(100);
}

Stroke stroke(Dice& dice) {
  Stroke s{.color = color(dice), .width = dice.between(0.0, 5.0), .dash = {}};
  if (dice.coin()) return s;
  s.dash.length = dice.between(0.5, 12.0);
  s.dash.gap = dice.between(0.5, 8.0);
  return s;
}

TextStyle text_style(Dice& dice) {
  TextStyle style{.size = dice.between(8.0, 20.0), .color = color(dice).with_alpha(255)};
  if (dice.coin()) style.weight = Weight::bold;
  style.align = std::array{Align::left, Align::center, Align::right}[static_cast<std::size_t>(dice.between(0, 2))];
  if (dice.coin()) style.halo = palette::white;
  return style;
}

std::string words(Dice& dice) {
  static const std::array<std::string, 8> all{"A",       "AB_n",   "n·AO_{12}", "−3.25",
                                              "x\\_1 ä", "שלום 2", "√ \xFF",    "R_2 of B"};
  return all[static_cast<std::size_t>(dice.between(0, 7))];
}

std::vector<Box> cells(int columns, int rows) {
  std::vector<Box> all;
  const Vec2 step(static_cast<double>(size.width) / columns, static_cast<double>(size.height) / rows);
  for (int i = 0; i < columns * rows; ++i) {
    const Vec2 low(i % columns * step.x(), i / columns * step.y());
    all.push_back({low + Vec2(4, 4), low + step - Vec2(4, 4)});
  }
  return all;
}

template <class Draw>
Image sheet(walkthroughs::output::Studio& studio, std::uint64_t seed, int columns, int rows, Draw draw_cell) {
  Canvas canvas(size, size, palette::white, studio.font);
  Dice dice(seed);
  for (const Box& cell : cells(columns, rows)) {
    draw_cell(canvas, cell, dice);
    canvas.outline(std::array{cell.min, Vec2(cell.max.x(), cell.min.y()), cell.max, Vec2(cell.min.x(), cell.max.y())},
                   {.color = palette::grey, .width = 1, .dash = {}});
  }
  return studio.rasterizer.draw(canvas);
}

// -- The parts ----------------------------------------------------------------------------------------------------------

void draw_shapes(Canvas& canvas, const Box& cell, Dice& dice) {
  canvas.clip(cell.grown(dice.coin() ? 0 : -6));
  for (int i = 0; i < 4; ++i) {
    const Vec2 a = any_place(dice, cell), b = dice.between(0, 9) == 0 ? a : any_place(dice, cell);
    const Stroke s = stroke(dice);
    const double radius = dice.between(0.0, 20.0);
    const std::vector<Vec2> corners = convex(dice, cell);
    switch (dice.between(0, 8)) {
      case 0: canvas.line(a, b, s); break;
      case 1: canvas.arrow(a, b, s); break;
      case 2: canvas.disc(a, radius, s.color); break;
      case 3: canvas.circle(a, radius, s); break;
      case 4: canvas.plus(a, radius, s); break;
      case 5: canvas.rectangle({a.cwiseMin(b), a.cwiseMax(b)}, s.color); break;
      case 6: canvas.outline(corners, s); break;
      case 7: canvas.polyline(corners, s); break;
      default: canvas.polygon(corners, s.color);
    }
  }
  canvas.unclip();
}

void draw_labels(Canvas& canvas, const Box& cell, Dice& dice) {
  Panel panel(canvas, cell, View::fit({0, 0}, {cell.width(), cell.height()}, cell, dice.between(0.8, 1.2)));
  const Box scene{{0, 0}, {cell.width(), cell.height()}};
  const auto thin = [&] { return Stroke{.color = color(dice), .width = dice.between(1.0, 2.5), .dash = {}}; };
  for (int left = dice.between(1, 5); left > 0; --left) {
    const Vec2 a = place(dice, scene), b = place(dice, scene);
    const std::vector<Vec2> corners = convex(dice, scene);
    switch (const Stroke s = thin(); dice.between(0, 6)) {
      case 0: panel.line(a, b, s); break;
      case 1: panel.arrow(a, b, s); break;
      case 2: panel.disc(a, 4, s.color); break;
      case 3: panel.hatch(corners, dice.between(5.0, 12.0), s); break;
      case 4: panel.grid(dice.between(15.0, 40.0), s, a); break;
      case 5: panel.keep_clear({a.cwiseMin(b), a.cwiseMax(b)}); break;
      default: panel.outline(corners, s);
    }
  }
  for (int left = dice.between(2, 4); left > 0; --left) {
    const Vec2 anchor = place(dice, scene), toward = place(dice, scene) - scene.center();
    const TextStyle style = text_style(dice);
    const std::string text = words(dice), shorter = words(dice);
    const std::vector<Vec2> area = convex(dice, scene);
    switch (dice.between(0, 2)) {
      case 0: panel.label(anchor, toward, text, style); break;
      case 1: panel.label_on_its_side(anchor, toward, text, style); break;
      default:
        if (area.size() >= 3) panel.name_area(area, text, style, {shorter, "R"});
    }
  }
  panel.place_labels(dice.coin() ? 1 : 0.6);
}

/// Triangles and parallelograms of a lattice: some share edges, some cross one another.
void draw_solids(Canvas& canvas, const Box& cell, Dice& dice) {
  const int azimuth = dice.between(-18, 18), elevation = dice.between(-17, 17);
  const Camera camera(10 * azimuth, 5 * elevation);
  const auto point = [&] {
    const double x = dice.between(-2, 2), y = dice.between(-2, 2), z = dice.between(-2, 2);
    return Vec3(x, y, z);
  };
  std::vector<Face> faces;
  for (int left = dice.between(2, 6); left > 0; --left) {
    const Vec3 a = point(), ab = point(), ac = point();
    faces.push_back(dice.coin() ? Face{{a, a + ab, a + ac}} : Face{{a, a + ab, a + ab + ac, a + ac}});
  }
  const auto at = [&](const Vec3& p) { return Vec2(cell.center() + 7 * Vec2(camera(p).x(), -camera(p).y())); };
  canvas.clip(cell);
  for (const std::size_t i : back_to_front(faces, camera)) {
    std::vector<Vec2> corners;
    for (const Vec3& corner : faces[i].corners) corners.push_back(at(corner));
    constexpr std::array fills{palette::sky,   palette::orange, palette::green,
                               palette::white, palette::faint,  palette::blue};
    canvas.polygon(corners, fills[i]);
  }
  for (const Edge& edge : edges_of(faces, camera))
    canvas.line(at(edge.from), at(edge.to),
                {.color = palette::ink, .width = 1, .dash = edge.hidden ? Dash{2, 2} : Dash{}});
  canvas.unclip();
}

}  // namespace

const std::vector<Part>& parts() {
  static const std::vector<Part> all{
      {"parts-shapes-report", "every shape of a canvas at random, clipped: coinciding ends, no length, no number",
       [](walkthroughs::output::Studio& studio) { return sheet(studio, 41, 6, 4, draw_shapes); }},
      {"parts-labels-report", "labels and names of areas that look for a place among lines, grids and hatching",
       [](walkthroughs::output::Studio& studio) { return sheet(studio, 43, 3, 3, draw_labels); }},
      {"parts-solids-report", "faces at random from back to front, hidden edges dashed",
       [](walkthroughs::output::Studio& studio) { return sheet(studio, 47, 4, 4, draw_solids); }},
  };
  return all;
}

}  // namespace golden
