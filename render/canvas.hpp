/// What is to be drawn on one page: a list of shapes, made without OpenGL. Surfaces take it: rasterizer.hpp makes
/// pixels of it, vector.hpp PDF and SVG.
///
/// Conventions, stated once:
///  * Positions and lengths of shapes are page units (see geometry.hpp); what surfaces ask for in pixels says so.
///  * Each shape lies on top of those before it. The borders of a polygon, of lines and discs are smooth.
///  * Lines and discs are never drawn thinner than one pixel. What is not finite is not drawn.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "render/color.hpp"
#include "render/font.hpp"
#include "render/geometry.hpp"

namespace render {

/// Lengths of a dash, round caps included, and of the gap after it, in page units. `gap` 0 is a solid line.
struct Dash {
  double length = 0;
  double gap = 0;

  friend bool operator==(const Dash&, const Dash&) = default;
};

struct Stroke {
  Color color = palette::ink;
  double width = 2;
  Dash dash = {};

  friend bool operator==(const Stroke&, const Stroke&) = default;
};

/// The head of an arrow, in widths of its stroke. Arrows shorter than `whole` widths shrink as a whole.
namespace arrow_head {
inline constexpr double length = 4.5;
inline constexpr double width = 3.6;
inline constexpr double whole = 6;
}  // namespace arrow_head

enum class Align { left, center, right };

inline constexpr double halo_width = 2;  ///< page units

struct TextStyle {
  double size;  ///< em size in page units
  Weight weight = Weight::regular;
  Color color = palette::ink;
  Align align = Align::left;
  Color halo = {0, 0, 0, 0};  ///< an outline halo_width wide behind the letters; transparent for none
};

// ---------------------------------------------------------------------------------------------- shapes

namespace shape {

/// Convex.
struct Polygon {
  std::vector<Vec2> corners;
  Color fill;
};
/// Lines from corner to corner, with round joins and caps; each dash has these caps. Dashes run on around corners.
struct Polyline {
  std::vector<Vec2> corners;
  Stroke stroke;
};
struct Disc {
  Vec2 center;
  double radius;
  Color fill;
};
/// A circle line without dashes.
struct Ring {
  Vec2 center;
  double radius;
  Stroke stroke;
};
struct Text {
  Vec2 position;
  std::string text;
  TextStyle style;
};
/// Nothing that comes after it is drawn outside of the box, up to the next of these.
struct Clip {
  Box box;
};

}  // namespace shape

using Shape = std::variant<shape::Polygon, shape::Polyline, shape::Disc, shape::Ring, shape::Text, shape::Clip>;

/// What a reader may take hold of where a picture is shown that can be changed. It is not drawn.
struct Grip {
  std::string name;                           ///< what it moves, as who draws it calls that
  Vec2 at;                                    ///< page units
  Eigen::Vector3d right, up;                  ///< of the scene: what a page unit to the right and one upwards are there
  std::optional<Eigen::Vector3d> value = {};  ///< of the scene, where it is not what is moved itself
  Box frame = {};                             ///< of the picture in which it lies, where that matters
};

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
  /// Returns: the width of a line of text.
  double width(std::string_view text, const TextStyle& style) const {
    return text_box(Vec2::Zero(), text, style).width();
  }
  /// Returns: `style`, smaller where the text would be wider than `room`.
  TextStyle fitted(std::string_view text, TextStyle style, double room) const;

  /// Nothing outside `box` is drawn until unclip().
  void clip(const Box& box);
  void unclip();

  /// Who draws labels counts here those that found no clear place, and lines of text that had no room.
  void add_crowded(int count) { crowded_ += count; }
  int crowded() const { return crowded_; }

  /// For who shows the picture.
  void add_grip(Grip grip) { grips_.push_back(std::move(grip)); }
  std::span<const Grip> grips() const { return grips_; }

  std::span<const Shape> shapes() const { return shapes_; }
  /// For tests, which draw what is wrong on purpose.
  std::span<Shape> shapes() { return shapes_; }

  // For surfaces.
  Size pixels() const { return pixels_; }
  Color background() const { return background_; }
  Font& font() const { return font_; }
  double scale() const { return scale_; }  ///< pixels per page unit
  Vec2 to_pixels(const Vec2& page) const { return offset_ + scale_ * page; }
  std::vector<Vec2> to_pixels(std::span<const Vec2> page) const;
  /// A line of text ready to draw: `pen` is where its baseline starts, in pixels.
  struct PlacedText {
    TextLine line;
    Vec2 pen;
    /// Returns: that place on whole pixels.
    Vec2 whole_pen() const { return pen.array().round(); }
  };
  PlacedText place(const Vec2& position, std::string_view text, const TextStyle& style) const;

 private:
  Vec2 to_page(const Vec2& pixel) const { return (pixel - offset_) / scale_; }
  TextLine set(std::string_view text, const TextStyle& style) const;
  bool are_drawable(std::span<const Vec2> points) const;
  bool is_drawable(const Vec2& center, double radius, const Stroke& stroke) const;
  Stroke as_drawn(Stroke stroke) const;

  Size pixels_;
  Color background_;
  Font& font_;
  double scale_;
  Vec2 offset_;  // of the page in the image, in pixels
  std::vector<Shape> shapes_;
  std::vector<Grip> grips_;
  int crowded_ = 0;
};

/// Returns: `text` broken at spaces into lines no wider than `width` page units; a longer word stands alone.
std::vector<std::string> wrap(const Canvas& canvas, std::string_view text, const TextStyle& style, double width);

}  // namespace render
