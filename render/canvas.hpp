/// What is to be drawn on one page: a list of shapes, made without OpenGL.
///
/// Every method adds on top of what was drawn before. All positions and lengths are page units (see geometry.hpp).
/// Edges are anti-aliased by coverage computed from the distance to the edge (256 levels, no multisampling).
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/color.hpp"
#include "render/font.hpp"
#include "render/geometry.hpp"

namespace render {

/// Lengths of a dash, round caps included, and of the gap after it, in page units. `gap` 0 is a solid line.
struct Dash {
  double length = 0;
  double gap = 0;
};

struct Stroke {
  Color color = palette::ink;
  double width = 2;
  Dash dash = {};
};

/// The head of an arrow, in widths of its stroke. Arrows shorter than `whole` widths shrink as a whole.
namespace arrow_head {
inline constexpr double length = 4.5;
inline constexpr double width = 3.6;
inline constexpr double whole = 6;
}  // namespace arrow_head

enum class Align { left, center, right };

struct TextStyle {
  double size;  ///< em size in page units
  Weight weight = Weight::regular;
  Color color = palette::ink;
  Align align = Align::left;
  Color halo = {0, 0, 0, 0};  ///< an outline two page units wide behind the letters; transparent for none
};

/// A vertex of the one triangle list that the rasterizer draws. `u` and `v` mean what `kind` says.
struct CanvasVertex {
  enum class Kind : std::uint32_t {
    fill,     ///< u: coverage (see coverage.hpp)
    capsule,  ///< (u,v): position along and across, in pixels, from the middle of a line with round caps
    ring,     ///< (u,v): position in pixels from the middle of a circle line
    glyph,    ///< (u,v): position in the font's atlas, in texels
  };
  float x, y;  ///< pixels from the top left corner of the image
  float u, v;
  float half_length;  ///< of a capsule, in pixels, 0 for a disc; for a ring the radius of the circle
  float radius;       ///< of capsule and ring: half the width of the line, in pixels
  Color color;
  Kind kind;
};

/// Lines and discs are never drawn thinner than one pixel. What is not finite is not drawn.
class Canvas {
 public:
  /// A page of `page` units drawn on `pixels`: scaled evenly until it fits, centred, the rest in the background colour.
  /// Requires: all sizes >= 1. `font` must outlive the canvas.
  Canvas(Size pixels, Size page, Color background, Font& font);

  /// Requires: a simple polygon of at least 3 corners, convex, either sense.
  void polygon(std::span<const Vec2> corners, Color fill);
  /// A line with round caps (each dash has them).
  void line(const Vec2& from, const Vec2& to, const Stroke& stroke);
  /// Lines from corner to corner with round joins; dashes run on around corners.
  void polyline(std::span<const Vec2> corners, const Stroke& stroke);
  /// As polyline, back to the first corner; dashes are stretched so that a whole number of them fits around.
  void outline(std::span<const Vec2> corners, const Stroke& stroke);
  /// A line that ends in a filled, pointed head whose tip is exactly `to`. Nothing is drawn where from == to.
  void arrow(const Vec2& from, const Vec2& to, const Stroke& stroke);
  void disc(const Vec2& center, double radius, Color fill);
  /// A circle line; dashed as outline() is.
  void circle(const Vec2& center, double radius, const Stroke& stroke);
  /// An upright plus sign; `half` is the length of an arm.
  void plus(const Vec2& center, double half, const Stroke& stroke);
  void rectangle(const Box& box, Color fill);
  /// `position`: on the baseline, at the left end, the middle or the right end of the text, as `style.align` says.
  void text(const Vec2& position, std::string_view text, const TextStyle& style);

  /// Returns: the box from ascent to descent that text() would fill, around its position.
  Box text_box(const Vec2& position, std::string_view text, const TextStyle& style) const;
  /// Returns: the box that the letters themselves fill; an empty box at `position` where there are none.
  Box ink_box(const Vec2& position, std::string_view text, const TextStyle& style) const;
  /// Returns: the height of capitals.
  double cap_height(const TextStyle& style) const;

  /// Returns: the em size of the smallest text so far, in page units; infinity where there is none.
  double smallest_text() const { return smallest_text_; }

  /// Nothing outside `box` is drawn until unclip().
  void clip(const Box& box);
  void unclip();

  /// For the rasterizer: triangles in drawing order, in runs that share a clip rectangle.
  struct Run {
    int first = 0;                                 ///< index of the first vertex
    int left = 0, top = 0, right = 0, bottom = 0;  ///< clip rectangle in pixels
  };
  std::span<const CanvasVertex> vertices() const { return vertices_; }
  /// For tests, which draw what is wrong on purpose.
  std::span<CanvasVertex> vertices() { return vertices_; }
  std::span<const Run> runs() const { return runs_; }
  Size pixels() const { return pixels_; }
  Color background() const { return background_; }
  const Font& font() const { return font_; }

 private:
  /// A line of text ready to draw: `pen` is the pixel where its baseline starts.
  struct PlacedText {
    TextLine line;
    int pen_x, pen_y;
  };

  Vec2 to_pixels(const Vec2& page) const { return offset_ + scale_ * page; }
  Vec2 to_page(const Vec2& pixel) const { return (pixel - offset_) / scale_; }
  double half_width(const Stroke& stroke) const;
  TextLine set(std::string_view text, const TextStyle& style) const;
  PlacedText place(const Vec2& position, std::string_view text, const TextStyle& style) const;
  Box clip_box() const;

  // All of these take pixels.
  void add_polygon(std::span<const Vec2> corners, Color color);
  void add_segment(const Vec2& from, const Vec2& to, double travelled, const Stroke& stroke);
  void add_capsule(const Vec2& from, const Vec2& to, double radius, Color color);
  void add_quad(const Vec2& center, const Vec2& along, const Vec2& half_size, CanvasVertex look);
  void add_glyphs(const PlacedText& text, int shift_x, int shift_y, Color color);

  Size pixels_;
  Color background_;
  Font& font_;
  double scale_;  // pixels per page unit
  Vec2 offset_;   // of the page in the image, in pixels
  double smallest_text_ = std::numeric_limits<double>::infinity();
  std::vector<CanvasVertex> vertices_;
  std::vector<Run> runs_;
};

/// Returns: `text` broken at spaces into lines no wider than `width` page units; a longer word stands alone.
std::vector<std::string> wrap(const Canvas& canvas, std::string_view text, const TextStyle& style, double width);

}  // namespace render
