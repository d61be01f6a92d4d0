#include "render/canvas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "render/coverage.hpp"

namespace render {
namespace {

using Kind = CanvasVertex::Kind;

constexpr double min_half_width = 0.5;   // pixels: thinner lines would fade away in small pictures
constexpr double fringe = 1;             // pixels drawn beyond an edge, more than the half pixel over which it fades
constexpr double min_dash_period = 0.5;  // pixels: finer dashes could not be told from a solid line
constexpr double circle_error = 0.1;     // pixels between a circle and the polygon that stands for it
constexpr double halo_width = 2;         // page units

/// Returns whether arithmetic in doubles is still much finer than a pixel there.
bool drawable(const Vec2& p) { return (p.array().abs() < 1e12).all(); }
bool drawable_radius(double radius) { return radius >= 0 && radius < 1e6; }

CanvasVertex vertex(const Vec2& position, const Vec2& uv, CanvasVertex look) {
  look.x = static_cast<float>(position.x());
  look.y = static_cast<float>(position.y());
  look.u = static_cast<float>(uv.x());
  look.v = static_cast<float>(uv.y());
  return look;
}

CanvasVertex look_of(Kind kind, Color color, double half_length = 0, double radius = 0) {
  return {0, 0, 0, 0, static_cast<float>(half_length), static_cast<float>(radius), color, kind};
}

/// Returns the unit vector from `from` to `to`, or the x axis where they coincide.
Vec2 direction(const Vec2& from, const Vec2& to) { return from == to ? Vec2::UnitX() : Vec2((to - from).normalized()); }

Vec2 quarter_turn(const Vec2& v) { return {-v.y(), v.x()}; }

/// Returns `dash` stretched so that the line around `corners`, whose last one is the first one again, ends with a gap.
Dash fitted(const Dash& dash, std::span<const Vec2> corners) {
  double perimeter = 0;
  for (std::size_t i = 1; i < corners.size(); ++i) perimeter += (corners[i] - corners[i - 1]).norm();
  const double period = dash.length + dash.gap;
  const double stretch = perimeter / (period * std::max(1.0, std::round(perimeter / period)));
  return {dash.length * stretch, dash.gap * stretch};
}

int clamped_pixel(double position, int size) {
  return static_cast<int>(std::lround(std::clamp(position, 0.0, static_cast<double>(size))));
}

}  // namespace

Canvas::Canvas(Size pixels, Size page, Color background, Font& font)
    : pixels_(pixels),
      background_(background),
      font_(font),
      scale_(
          std::min(static_cast<double>(pixels.width) / page.width, static_cast<double>(pixels.height) / page.height)),
      offset_((pixels.width - scale_ * page.width) / 2, (pixels.height - scale_ * page.height) / 2) {
  unclip();
}

// ---------------------------------------------------------------------------------------------- shapes

void Canvas::polygon(std::span<const Vec2> corners, Color fill) {
  std::vector<Vec2> pixels;
  for (const Vec2& corner : corners) pixels.push_back(to_pixels(corner));
  add_polygon(pixels, fill);
}

void Canvas::line(const Vec2& from, const Vec2& to, const Stroke& stroke) {
  add_segment(to_pixels(from), to_pixels(to), 0, stroke);
}

void Canvas::polyline(std::span<const Vec2> corners, const Stroke& stroke) {
  double travelled = 0;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Vec2 from = to_pixels(corners[i - 1]), to = to_pixels(corners[i]);
    add_segment(from, to, travelled, stroke);
    travelled += (to - from).norm();
  }
}

void Canvas::outline(std::span<const Vec2> corners, const Stroke& stroke) {
  if (corners.empty()) return;
  std::vector<Vec2> closed(corners.begin(), corners.end());
  closed.push_back(corners.front());
  Stroke around = stroke;
  if (stroke.dash.gap > 0) around.dash = fitted(stroke.dash, closed);
  polyline(closed, around);
}

void Canvas::arrow(const Vec2& from, const Vec2& to, const Stroke& stroke) {
  const Vec2 tail = to_pixels(from), tip = to_pixels(to);
  const double length = (tip - tail).norm();
  if (length == 0) return;

  // Measured in drawn pixels, not in stroke.width: the head must stay wider than a shaft that is kept a pixel wide.
  const double drawn_width = 2 * half_width(stroke);
  const double width = drawn_width * std::min(1.0, length / (arrow_head::whole * drawn_width));
  const Vec2 along = direction(tail, tip), across = quarter_turn(along);
  const Vec2 base = tip - along * (arrow_head::length * width);
  const Vec2 side = across * (arrow_head::width / 2 * width);

  Stroke shaft = stroke;
  shaft.width = width / scale_;
  add_segment(tail, base + along * (width / 2), 0, shaft);  // its round cap ends inside the head
  add_polygon(std::array<Vec2, 3>{tip, base + side, base - side}, stroke.color);
}

void Canvas::disc(const Vec2& center, double radius, Color fill) {
  const Vec2 pixel = to_pixels(center);
  add_capsule(pixel, pixel, std::max(radius * scale_, min_half_width), fill);
}

void Canvas::circle(const Vec2& center, double radius, const Stroke& stroke) {
  const Vec2 middle = to_pixels(center);
  const double in_pixels = radius * scale_;
  if (!drawable(middle) || !drawable_radius(in_pixels)) return;

  if (stroke.dash.gap <= 0) {
    const double outer = in_pixels + half_width(stroke) + fringe;
    add_quad(middle, Vec2::UnitX(), {outer, outer}, look_of(Kind::ring, stroke.color, in_pixels, half_width(stroke)));
    return;
  }
  // A chord of angle t is radius * (1 - cos(t/2)), about radius * t^2 / 8, away from the circle.
  const double turn = 2 * std::numbers::pi;
  const int count = 8 + static_cast<int>(turn / std::sqrt(8 * circle_error / std::max(in_pixels, 1.0)));
  std::vector<Vec2> corners;
  for (int i = 0; i < count; ++i) {
    const double angle = turn * i / count;
    corners.push_back(center + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  outline(corners, stroke);
}

void Canvas::plus(const Vec2& center, double half, const Stroke& stroke) {
  line(center - half * Vec2::UnitX(), center + half * Vec2::UnitX(), stroke);
  line(center - half * Vec2::UnitY(), center + half * Vec2::UnitY(), stroke);
}

void Canvas::rectangle(const Box& box, Color fill) {
  polygon(std::array<Vec2, 4>{box.min, {box.max.x(), box.min.y()}, box.max, {box.min.x(), box.max.y()}}, fill);
}

// ---------------------------------------------------------------------------------------------- text

void Canvas::text(const Vec2& position, std::string_view text, const TextStyle& style) {
  if (!drawable(to_pixels(position))) return;
  const PlacedText placed = place(position, text, style);
  if (!placed.line.glyphs.empty()) smallest_text_ = std::min(smallest_text_, style.size);
  if (style.halo.a > 0) {
    constexpr int copies = 16;
    for (int i = 0; i < copies; ++i) {
      const double angle = 2 * std::numbers::pi * i / copies;
      const Vec2 shift = halo_width * scale_ * Vec2(std::cos(angle), std::sin(angle));
      add_glyphs(placed, static_cast<int>(std::lround(shift.x())), static_cast<int>(std::lround(shift.y())),
                 style.halo);
    }
  }
  add_glyphs(placed, 0, 0, style.color);
}

Box Canvas::text_box(const Vec2& position, std::string_view text, const TextStyle& style) const {
  const auto& [line, pen_x, pen_y] = place(position, text, style);
  return {to_page({pen_x, pen_y - line.ascent}), to_page({pen_x + line.advance, pen_y + line.descent})};
}

Box Canvas::ink_box(const Vec2& position, std::string_view text, const TextStyle& style) const {
  const auto& [line, pen_x, pen_y] = place(position, text, style);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box ink{Vec2::Constant(infinity), Vec2::Constant(-infinity)};
  for (const PlacedGlyph& glyph : line.glyphs) {
    if (glyph.width == 0) continue;
    const Vec2 corner(pen_x + glyph.x, pen_y + glyph.y);
    ink.min = ink.min.cwiseMin(corner);
    ink.max = ink.max.cwiseMax(corner + Vec2(glyph.width, glyph.height));
  }
  if (ink.min.x() > ink.max.x()) return {position, position};
  return {to_page(ink.min), to_page(ink.max)};
}

double Canvas::cap_height(const TextStyle& style) const { return set("", style).cap_height / scale_; }

TextLine Canvas::set(std::string_view text, const TextStyle& style) const {
  return font_.set(text, style.size * scale_, style.weight);
}

Canvas::PlacedText Canvas::place(const Vec2& position, std::string_view text, const TextStyle& style) const {
  TextLine line = set(text, style);
  const double before = style.align == Align::left ? 0 : style.align == Align::center ? line.advance / 2 : line.advance;
  const Vec2 pen = to_pixels(position) - Vec2(before, 0);
  const Vec2 whole = pen.cwiseMax(-1e6).cwiseMin(1e6);  // fits an int, and is far outside any picture
  return {std::move(line), static_cast<int>(std::lround(whole.x())), static_cast<int>(std::lround(whole.y()))};
}

// ---------------------------------------------------------------------------------------------- clipping

void Canvas::clip(const Box& box) {
  const Vec2 low = to_pixels(box.min), high = to_pixels(box.max);
  const Run run{.first = static_cast<int>(vertices_.size()),
                .left = clamped_pixel(low.x(), pixels_.width),
                .top = clamped_pixel(low.y(), pixels_.height),
                .right = clamped_pixel(high.x(), pixels_.width),
                .bottom = clamped_pixel(high.y(), pixels_.height)};
  if (!runs_.empty() && runs_.back().first == run.first) runs_.pop_back();  // nothing was drawn in it
  runs_.push_back(run);
}

void Canvas::unclip() { clip({to_page(Vec2::Zero()), to_page({pixels_.width, pixels_.height})}); }

Box Canvas::clip_box() const {
  const Run& run = runs_.back();
  return {{run.left, run.top}, {run.right, run.bottom}};
}

// ---------------------------------------------------------------------------------------------- triangles

double Canvas::half_width(const Stroke& stroke) const { return std::max(stroke.width * scale_ / 2, min_half_width); }

void Canvas::add_polygon(std::span<const Vec2> corners, Color color) {
  if (!std::all_of(corners.begin(), corners.end(), drawable)) return;
  const CanvasVertex look = look_of(Kind::fill, color);
  for (const CoverageCell& cell : coverage_cells(corners, clip_box().grown(fringe))) {
    const auto corner = [&](std::size_t i) { return vertex(cell[i].position, {cell[i].coverage, 0}, look); };
    for (std::size_t i = 1; i + 1 < cell.size(); ++i) {
      vertices_.insert(vertices_.end(), {corner(0), corner(i), corner(i + 1)});
    }
  }
}

// Only the visible part is drawn: single precision is exact enough for it however far the segment reaches, and the
// number of dashes is bounded by the size of the picture.
void Canvas::add_segment(const Vec2& from, const Vec2& to, double travelled, const Stroke& stroke) {
  const double radius = half_width(stroke);
  if (!drawable(from) || !drawable(to) || !drawable_radius(radius)) return;
  const auto visible = clip_segment(from, to, clip_box().grown(radius + fringe));
  if (!visible) return;

  const Vec2 along = direction(from, to);
  const double length = (to - from).norm();
  const double first = visible->from * length, last = visible->to * length;
  const double period = (stroke.dash.length + stroke.dash.gap) * scale_;
  if (stroke.dash.gap <= 0 || !(period >= min_dash_period)) {
    add_capsule(from + first * along, from + last * along, radius, stroke.color);
    return;
  }
  // The caps belong to the dash, so the straight part between them is shorter.
  const double straight = std::max(0.0, stroke.dash.length * scale_ - 2 * radius);
  const double first_dash = std::floor((travelled + first) / period) * period - travelled;
  const int count = 1 + static_cast<int>((last - first) / period + 1);
  for (int i = 0; i < count; ++i) {
    const double begin = std::max(first_dash + i * period, first);
    const double end = std::min(first_dash + i * period + straight, last);
    if (begin <= end) add_capsule(from + begin * along, from + end * along, radius, stroke.color);
  }
}

void Canvas::add_capsule(const Vec2& from, const Vec2& to, double radius, Color color) {
  if (!drawable(from) || !drawable_radius(radius)) return;
  const double half_length = (to - from).norm() / 2;
  const double reach = radius + fringe;
  add_quad((from + to) / 2, direction(from, to), {half_length + reach, reach},
           look_of(Kind::capsule, color, half_length, radius));
}

void Canvas::add_quad(const Vec2& center, const Vec2& along, const Vec2& half_size, CanvasVertex look) {
  const Vec2 across = quarter_turn(along);
  const auto corner = [&](double u, double v) {
    const Vec2 uv(u * half_size.x(), v * half_size.y());
    return vertex(center + uv.x() * along + uv.y() * across, uv, look);
  };
  const CanvasVertex a = corner(-1, -1), b = corner(1, -1), c = corner(1, 1), d = corner(-1, 1);
  vertices_.insert(vertices_.end(), {a, b, c, a, c, d});
}

void Canvas::add_glyphs(const PlacedText& text, int shift_x, int shift_y, Color color) {
  const CanvasVertex look = look_of(Kind::glyph, color);
  for (const PlacedGlyph& glyph : text.line.glyphs) {
    if (glyph.width == 0) continue;
    const Vec2 origin(text.pen_x + glyph.x + shift_x, text.pen_y + glyph.y + shift_y);
    const Vec2 texel(glyph.atlas_x, glyph.atlas_y);
    const auto corner = [&](int x, int y) { return vertex(origin + Vec2(x, y), texel + Vec2(x, y), look); };
    const CanvasVertex a = corner(0, 0), b = corner(glyph.width, 0);
    const CanvasVertex c = corner(glyph.width, glyph.height), d = corner(0, glyph.height);
    vertices_.insert(vertices_.end(), {a, b, c, a, c, d});
  }
}

// ---------------------------------------------------------------------------------------------- lines of text

std::vector<std::string> wrap(const Canvas& canvas, std::string_view text, const TextStyle& style, double width) {
  std::vector<std::string> lines = {""};
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word(text.substr(at, end - at));
    std::string& line = lines.back();
    const std::string longer = line.empty() ? word : line + " " + word;
    if (line.empty() || canvas.text_box(Vec2::Zero(), longer, style).width() <= width) {
      line = longer;
    } else {
      lines.push_back(word);
    }
    at = end + 1;
  }
  return lines;
}

}  // namespace render
