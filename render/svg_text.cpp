#include "render/svg_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>

#include "render/html.hpp"
#include "render/utf8.hpp"

namespace render {
namespace {

/// Appends what is drawn, element by element.
class Writer {
 public:
  Writer(std::string& to, const Canvas& canvas) : to_(to), canvas_(canvas) {}
  ~Writer() {
    end_path();
    if (is_clipped_) to_ += "</svg>";
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  void operator()(const shape::Polygon& polygon) {
    begin_path();
    places(polygon.corners, true);
    to_ += '\'';
    color("fill", polygon.fill);
    to_ += "/>";
  }

  /// Lines of one stroke, one after the other, are one path: half as many elements to lay out. Not where they would be seen through
  /// each other; dashes hardly meet.
  void operator()(const shape::Polyline& line) {
    const bool goes_on = path_ && *path_ == line.stroke && (line.stroke.color.a == 255 || line.stroke.dash.gap > 0);
    if (!goes_on) begin_path();
    places(line.corners, false);
    path_ = line.stroke;
  }

  void operator()(const shape::Disc& disc) {
    circle(disc.center, disc.radius);
    color("fill", disc.fill);
    to_ += "/>";
  }

  void operator()(const shape::Ring& ring) {
    circle(ring.center, ring.radius);
    stroke(ring.stroke);
    to_ += "/>";
  }

  void operator()(const shape::Text& text) {
    const Canvas::PlacedText placed = canvas_.place(text.position, text.text, text.style);
    const std::span<const PlacedGlyph> glyphs = placed.line.glyphs;
    for (std::size_t first = 0, last = 0; first < glyphs.size(); first = last) {
      while (last < glyphs.size() && glyphs[last].pen.y() == glyphs[first].pen.y()) ++last;
      const double end = last < glyphs.size() ? glyphs[last].pen.x() : placed.line.advance;
      run(glyphs.subspan(first, last - first), placed.pen, end, text.style);
    }
  }

  void operator()(const shape::Clip& clip) {
    end_path();
    if (is_clipped_) to_ += "</svg>";
    is_clipped_ = true;
    to_ += "<svg";
    number("x", clip.box.min.x());
    number("y", clip.box.min.y());
    number("width", clip.box.width());
    number("height", clip.box.height());
    view_box(clip.box);
    to_ += '>';
  }

  void view_box(const Box& box) {
    to_ += " viewBox='";
    place(box.min);
    to_ += ' ';
    place(box.max - box.min);
    to_ += '\'';
  }

 private:
  void number(double x) {
    const long hundredths = std::lround(std::clamp(x, -1e6, 1e6) * 100);
    const long whole = std::abs(hundredths) / 100, rest = std::abs(hundredths) % 100;
    char digits[24];
    if (hundredths < 0) to_ += '-';
    to_.append(digits, std::to_chars(digits, digits + sizeof digits, whole).ptr);
    if (rest == 0) return;
    to_ += '.';
    to_ += static_cast<char>('0' + rest / 10);
    if (rest % 10 != 0) to_ += static_cast<char>('0' + rest % 10);
  }
  void place(const Vec2& at) {
    number(at.x());
    to_ += ' ';
    number(at.y());
  }
  void open(std::string_view name) {
    to_ += ' ';
    to_ += name;
    to_ += "='";
  }
  void number(std::string_view name, double x) {
    open(name);
    number(x);
    to_ += '\'';
  }

  void color(std::string_view name, Color color) {
    constexpr std::string_view digits = "0123456789abcdef";
    open(name);
    to_ += '#';
    const auto append = [&](std::size_t part) {
      to_ += digits[part >> 4];
      to_ += digits[part & 15];
    };
    for (const std::size_t part : {color.r, color.g, color.b}) append(part);
    if (color.a != 255) append(color.a);
    to_ += '\'';
  }

  void places(std::span<const Vec2> corners, bool is_closed) {
    char letter = 'M';
    for (const Vec2& corner : corners) {
      to_ += letter;
      place(corner);
      letter = 'L';
    }
    if (is_closed || corners.size() == 1) to_ += 'Z';
  }
  void begin_path() {
    end_path();
    to_ += "<path d='";
  }
  void end_path() {
    if (!path_) return;
    to_ += '\'';
    stroke(*path_);
    to_ += "/>";
    path_.reset();
  }

  void circle(const Vec2& center, double radius) {
    end_path();
    to_ += "<circle";
    number("cx", center.x());
    number("cy", center.y());
    number("r", radius);
  }

  /// The round caps of a dash belong to it.
  void stroke(const Stroke& stroke) {
    color("stroke", stroke.color);
    number("stroke-width", stroke.width);
    if (stroke.dash.gap <= 0) return;
    const double straight = std::max(0.0, stroke.dash.length - stroke.width);
    open("stroke-dasharray");
    place({straight, stroke.dash.length + stroke.dash.gap - straight});
    to_ += '\'';
  }

  /// Letters on one line. `pen`: where the text begins; `end`: where the next run does, from there, as each glyph's own pen.
  void run(std::span<const PlacedGlyph> glyphs, const Vec2& pen, double end, const TextStyle& style) {
    end_path();
    const PlacedGlyph& first = glyphs.front();
    const Vec2 at = pen + first.pen;
    to_ += "<text";
    number("x", at.x());
    number("y", at.y());
    number("font-size", first.size);
    if (glyphs.size() > 1) {
      number("textLength", end - first.pen.x());
      to_ += " lengthAdjust='spacingAndGlyphs'";
    }
    if (style.weight == Weight::bold) to_ += " font-weight='bold'";
    color("fill", style.color);
    if (style.halo.a > 0) {
      color("stroke", style.halo);
      number("stroke-width", 2 * halo_width);
    }
    to_ += '>';
    for (const PlacedGlyph& glyph : glyphs) to_ += escaped(utf8_of(glyph.code));
    to_ += "</text>";
  }

  std::string& to_;
  const Canvas& canvas_;
  bool is_clipped_ = false;
  std::optional<Stroke> path_ = {};  // of the path that is not ended
};

}  // namespace

std::string svg_text(const Canvas& canvas, const Box& part) {
  std::string text;
  text.reserve(std::size_t{1} << 15);
  text += "<svg xmlns='http://www.w3.org/2000/svg'";
  Writer(text, canvas).view_box(part);
  text += " stroke-linecap='round' stroke-linejoin='round' paint-order='stroke' fill='none'";
  text += " font-family='DejaVu Sans, Verdana, sans-serif'>";
  for (Writer writer(text, canvas); const Shape& shape : canvas.shapes()) std::visit(writer, shape);
  text += "</svg>";
  return text;
}

}  // namespace render
