#include "render/triangles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace render {
namespace {

using Kind = CanvasVertex::Kind;

constexpr double fringe = 1;  // pixels drawn beyond an edge, more than the half pixel over which it fades

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

int clamped_pixel(double position, int size) {
  return static_cast<int>(std::lround(std::clamp(position, 0.0, static_cast<double>(size))));
}

/// Adds the triangles of each shape. All that its members take is in pixels.
class Builder {
 public:
  explicit Builder(const Canvas& canvas) : canvas_(canvas) {}

  void operator()(const shape::Polygon& polygon) {
    const CanvasVertex look = look_of(Kind::fill, polygon.fill);
    for (const CoverageCell& cell : coverage_cells(canvas_.to_pixels(polygon.corners), clip_box_.grown(fringe))) {
      const auto corner = [&](std::size_t i) { return vertex(cell[i].position, {cell[i].coverage, 0}, look); };
      for (std::size_t i = 1; i + 1 < cell.size(); ++i)
        all_.vertices.insert(all_.vertices.end(), {corner(0), corner(i), corner(i + 1)});
    }
  }

  void operator()(const shape::Polyline& line) {
    const std::vector<Vec2> corners = canvas_.to_pixels(line.corners);
    double travelled = 0;
    for (std::size_t i = 1; i < corners.size(); ++i) {
      add_segment(corners[i - 1], corners[i], travelled, line.stroke);
      travelled += (corners[i] - corners[i - 1]).norm();
    }
  }

  void operator()(const shape::Disc& disc) {
    const Vec2 center = canvas_.to_pixels(disc.center);
    add_capsule(center, center, disc.radius * canvas_.scale(), disc.fill);
  }

  void operator()(const shape::Ring& ring) {
    const double radius = ring.radius * canvas_.scale(), half_width = ring.stroke.width * canvas_.scale() / 2;
    const double outer = radius + half_width + fringe;
    add_quad(canvas_.to_pixels(ring.center), Vec2::UnitX(), {outer, outer},
             look_of(Kind::ring, ring.stroke.color, radius, half_width));
  }

  void operator()(const shape::Text& text) {
    const Canvas::PlacedText placed = canvas_.place(text.position, text.text, text.style);
    constexpr int copies = 16;
    for (int i = 0; i < copies && text.style.halo.a > 0; ++i) {
      const double angle = 2 * std::numbers::pi * i / copies;
      const Vec2 shift = halo_width * canvas_.scale() * Vec2(std::cos(angle), std::sin(angle));
      add_glyphs(placed, shift.array().round(), text.style.halo);
    }
    add_glyphs(placed, Vec2::Zero(), text.style.color);
  }

  void operator()(const shape::Clip& clip) {
    const Vec2 low = canvas_.to_pixels(clip.box.min), high = canvas_.to_pixels(clip.box.max);
    const auto [width, height] = canvas_.pixels();
    const Triangles::Run run{.first = static_cast<int>(all_.vertices.size()),
                             .left = clamped_pixel(low.x(), width),
                             .top = clamped_pixel(low.y(), height),
                             .right = clamped_pixel(high.x(), width),
                             .bottom = clamped_pixel(high.y(), height)};
    if (!all_.runs.empty() && all_.runs.back().first == run.first) all_.runs.pop_back();  // nothing was drawn in it
    all_.runs.push_back(run);
    clip_box_ = {{run.left, run.top}, {run.right, run.bottom}};
  }

  Triangles take() { return std::move(all_); }

 private:
  // Only the visible part is drawn: single precision is exact enough for it however far the segment reaches, and the
  // number of dashes is bounded by the size of the picture.
  void add_segment(const Vec2& from, const Vec2& to, double travelled, const Stroke& stroke) {
    const double radius = stroke.width * canvas_.scale() / 2;
    const auto visible = clip_segment(from, to, clip_box_.grown(radius + fringe));
    if (!visible) return;
    const Vec2 along = direction(from, to);
    const double length = (to - from).norm();
    const double first = visible->from * length, last = visible->to * length;
    if (stroke.dash.gap <= 0) return add_capsule(from + first * along, from + last * along, radius, stroke.color);
    const double period = (stroke.dash.length + stroke.dash.gap) * canvas_.scale();
    // The caps belong to the dash, so the straight part between them is shorter.
    const double straight = std::max(0.0, stroke.dash.length * canvas_.scale() - 2 * radius);
    const double first_dash = std::floor((travelled + first) / period) * period - travelled;
    const int count = 1 + static_cast<int>((last - first) / period + 1);
    for (int i = 0; i < count; ++i) {
      const double begin = std::max(first_dash + i * period, first);
      const double end = std::min(first_dash + i * period + straight, last);
      if (begin <= end) add_capsule(from + begin * along, from + end * along, radius, stroke.color);
    }
  }

  void add_capsule(const Vec2& from, const Vec2& to, double radius, Color color) {
    const double half_length = (to - from).norm() / 2;
    const double reach = radius + fringe;
    add_quad((from + to) / 2, direction(from, to), {half_length + reach, reach},
             look_of(Kind::capsule, color, half_length, radius));
  }

  void add_quad(const Vec2& center, const Vec2& along, const Vec2& half_size, const CanvasVertex& look) {
    const Vec2 across(-along.y(), along.x());
    const auto corner = [&](double u, double v) {
      const Vec2 uv(u * half_size.x(), v * half_size.y());
      return vertex(center + uv.x() * along + uv.y() * across, uv, look);
    };
    add_quad(corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1));
  }

  void add_glyphs(const Canvas::PlacedText& text, const Vec2& shift, Color color) {
    const CanvasVertex look = look_of(Kind::glyph, color);
    for (const PlacedGlyph& glyph : text.line.glyphs) {
      if (glyph.width == 0) continue;
      const Vec2 origin = text.whole_pen() + Vec2(glyph.x, glyph.y) + shift;
      const auto [left, top] = canvas_.font().in_atlas(glyph);
      const Vec2 texel(left, top);
      const auto corner = [&](int x, int y) { return vertex(origin + Vec2(x, y), texel + Vec2(x, y), look); };
      add_quad(corner(0, 0), corner(glyph.width, 0), corner(glyph.width, glyph.height), corner(0, glyph.height));
    }
  }

  void add_quad(const CanvasVertex& a, const CanvasVertex& b, const CanvasVertex& c, const CanvasVertex& d) {
    all_.vertices.insert(all_.vertices.end(), {a, b, c, a, c, d});
  }

  const Canvas& canvas_;
  Box clip_box_;  // on whole pixels
  Triangles all_;
};

}  // namespace

Triangles triangles_of(const Canvas& canvas) {
  Builder builder(canvas);
  for (const Shape& shape : canvas.shapes()) std::visit(builder, shape);
  return builder.take();
}

}  // namespace render
