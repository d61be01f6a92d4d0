#include "render/canvas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace render {
namespace {

constexpr double min_half_width = 0.5;   // pixels: thinner lines would fade away in small pictures
constexpr double min_dash_period = 0.5;  // pixels: finer dashes could not be told from a solid line
constexpr double circle_error = 0.1;     // pixels between a circle and the polygon that stands for it

/// Returns `dash` stretched so that the line around `corners`, whose last one is the first one again, ends with a gap.
Dash stretched(const Dash& dash, std::span<const Vec2> corners) {
  double perimeter = 0;
  for (std::size_t i = 1; i < corners.size(); ++i) perimeter += (corners[i] - corners[i - 1]).norm();
  const double period = dash.length + dash.gap;
  const double stretch = perimeter / (period * std::max(1.0, std::round(perimeter / period)));
  return {dash.length * stretch, dash.gap * stretch};
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

// Arithmetic in doubles is still much finer than a pixel there.
bool Canvas::are_drawable(std::span<const Vec2> points) const {
  return std::ranges::all_of(points, [&](const Vec2& p) { return (to_pixels(p).array().abs() < 1e12).all(); });
}

bool Canvas::is_drawable(const Vec2& center, double radius, const Stroke& stroke) const {
  const auto is_length = [](double pixels) { return pixels >= 0 && pixels < 1e6; };
  return are_drawable({&center, 1}) && is_length(radius * scale_) && is_length(as_drawn(stroke).width * scale_ / 2);
}

void Canvas::polygon(std::span<const Vec2> corners, Color fill) {
  if (are_drawable(corners)) shapes_.push_back(shape::Polygon{{corners.begin(), corners.end()}, fill});
}

void Canvas::line(const Vec2& from, const Vec2& to, const Stroke& stroke) {
  polyline(std::array<Vec2, 2>{from, to}, stroke);
}

void Canvas::polyline(std::span<const Vec2> corners, const Stroke& stroke) {
  if (!corners.empty() && are_drawable(corners) && is_drawable(corners.front(), 0, stroke))
    shapes_.push_back(shape::Polyline{{corners.begin(), corners.end()}, as_drawn(stroke)});
}

void Canvas::outline(std::span<const Vec2> corners, const Stroke& stroke) {
  if (corners.empty()) return;
  std::vector<Vec2> closed(corners.begin(), corners.end());
  closed.push_back(corners.front());
  Stroke around = stroke;
  if (stroke.dash.gap > 0) around.dash = stretched(stroke.dash, closed);
  polyline(closed, around);
}

void Canvas::arrow(const Vec2& from, const Vec2& to, const Stroke& stroke) {
  const double length = (to - from).norm();
  if (length == 0) return;
  // Of the width that is drawn: the head must stay wider than a shaft that is kept a pixel wide.
  Stroke shaft = as_drawn(stroke);
  shaft.width *= std::min(1.0, length / (arrow_head::whole * shaft.width));
  const Vec2 along = (to - from).normalized(), across(-along.y(), along.x());
  const Vec2 base = to - along * (arrow_head::length * shaft.width);
  const Vec2 side = across * (arrow_head::width / 2 * shaft.width);
  line(from, base + along * (shaft.width / 2), shaft);  // its round cap ends inside the head
  polygon(std::array<Vec2, 3>{to, base + side, base - side}, stroke.color);
}

void Canvas::disc(const Vec2& center, double radius, Color fill) {
  const double drawn = std::max(radius, min_half_width / scale_);
  if (is_drawable(center, drawn, {})) shapes_.push_back(shape::Disc{center, drawn, fill});
}

void Canvas::circle(const Vec2& center, double radius, const Stroke& stroke) {
  if (!is_drawable(center, radius, stroke)) return;
  if (stroke.dash.gap <= 0) {
    shapes_.push_back(shape::Ring{center, radius, as_drawn(stroke)});
    return;
  }
  // A chord of angle t is radius * (1 - cos(t/2)), about radius * t^2 / 8, away from the circle.
  const double turn = 2 * std::numbers::pi;
  const int count = 8 + static_cast<int>(turn / std::sqrt(8 * circle_error / std::max(radius * scale_, 1.0)));
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

void Canvas::rectangle(const Box& box, Color fill) { polygon(box.corners(), fill); }

void Canvas::text(const Vec2& position, std::string_view text, const TextStyle& style) {
  if (are_drawable({&position, 1})) shapes_.push_back(shape::Text{position, std::string(text), style});
}

void Canvas::clip(const Box& box) { shapes_.push_back(shape::Clip{box}); }

void Canvas::unclip() { clip({to_page(Vec2::Zero()), to_page({pixels_.width, pixels_.height})}); }

// ---------------------------------------------------------------------------------------------- in pixels

Stroke Canvas::as_drawn(Stroke stroke) const {
  stroke.width = std::max(stroke.width, 2 * min_half_width / scale_);
  if (!((stroke.dash.length + stroke.dash.gap) * scale_ >= min_dash_period)) stroke.dash = {};
  return stroke;
}

std::vector<Vec2> Canvas::to_pixels(std::span<const Vec2> page) const {
  std::vector<Vec2> pixels;
  for (const Vec2& point : page) pixels.push_back(to_pixels(point));
  return pixels;
}

Box Canvas::text_box(const Vec2& position, std::string_view text, const TextStyle& style) const {
  const PlacedText placed = place(position, text, style);
  const Vec2 pen = placed.whole_pen();
  const TextLine& line = placed.line;
  return {to_page(pen - Vec2(0, line.ascent)), to_page(pen + Vec2(line.advance, line.descent))};
}

Box Canvas::ink_box(const Vec2& position, std::string_view text, const TextStyle& style) const {
  const PlacedText placed = place(position, text, style);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box ink{Vec2::Constant(infinity), Vec2::Constant(-infinity)};
  for (const PlacedGlyph& glyph : placed.line.glyphs) {
    if (glyph.width == 0) continue;
    const Vec2 corner = placed.whole_pen() + Vec2(glyph.x, glyph.y);
    ink.add(corner);
    ink.add(corner + Vec2(glyph.width, glyph.height));
  }
  if (ink.min.x() > ink.max.x()) return {position, position};
  return {to_page(ink.min), to_page(ink.max)};
}

double Canvas::cap_height(const TextStyle& style) const { return set("", style).cap_height / scale_; }

TextStyle Canvas::fitted(std::string_view text, TextStyle style, double room) const {
  if (const double needed = width(text, style); needed > room) style.size *= room / needed;
  return style;
}

TextLine Canvas::set(std::string_view text, const TextStyle& style) const {
  return font_.set(text, style.size * scale_, style.weight);
}

Canvas::PlacedText Canvas::place(const Vec2& position, std::string_view text, const TextStyle& style) const {
  TextLine line = set(text, style);
  const double before = style.align == Align::left ? 0 : style.align == Align::center ? line.advance / 2 : line.advance;
  const Vec2 pen = to_pixels(position) - Vec2(before, 0);
  return {std::move(line), pen.cwiseMax(-1e6).cwiseMin(1e6)};  // fits an int, and is far outside any picture
}

// ---------------------------------------------------------------------------------------------- lines of text

std::vector<std::string> wrap(const Canvas& canvas, std::string_view text, const TextStyle& style, double width) {
  std::vector<std::string> lines = {""};
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word(text.substr(at, end - at));
    std::string& line = lines.back();
    const std::string longer = line.empty() ? word : line + " " + word;
    if (line.empty() || canvas.width(longer, style) <= width) {
      line = longer;
    } else {
      lines.push_back(word);
    }
    at = end + 1;
  }
  return lines;
}

}  // namespace render
