/// A part of the page that shows a scene: scene units in, page units out, nothing drawn outside, labels kept clear.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "render/canvas.hpp"

namespace render {

/// Maps scene units (y up) to page units (y down), with one scale for both axes.
class View {
 public:
  /// Returns: the view that shows the scene's box `low`..`high` centred in `frame`, with at most `max_scale` page units
  /// per scene unit.
  /// Requires: low <= high, which may coincide; all finite; 0 < max_scale.
  static View fit(const Vec2& low, const Vec2& high, const Box& frame,
                  double max_scale = std::numeric_limits<double>::infinity());

  Vec2 page(const Vec2& scene) const { return center_page_ + scale_ * turned_over(scene - center_scene_); }
  Vec2 scene(const Vec2& page) const { return center_scene_ + turned_over(page - center_page_) / scale_; }
  /// Returns: the same middle at another scale.
  View with_scale(double scale) const {
    View other = *this;
    other.scale_ = scale;
    return other;
  }
  /// Returns: the view that shows in `to` what this one shows in `from`. Requires: neither is empty.
  View into(const Box& from, const Box& to) const;
  double scale() const { return scale_; }  ///< page units per scene unit

 private:
  static Vec2 turned_over(const Vec2& v) { return {v.x(), -v.y()}; }

  Vec2 center_scene_ = Vec2::Zero();
  Vec2 center_page_ = Vec2::Zero();
  double scale_ = 1;
};

/// Draws in scene units. Lines, arrows and discs are remembered as obstacles; labels are placed last, by place_labels(),
/// where they cover none of them (or as little as possible). Lines thinner than two page units do not hinder much: a
/// label's halo interrupts them where there is no better place.
class Panel {
 public:
  /// Clips the canvas to `frame` until the panel is destroyed.
  Panel(Canvas& canvas, const Box& frame, const View& view);
  ~Panel();
  Panel(const Panel&) = delete;
  Panel& operator=(const Panel&) = delete;

  void polygon(std::span<const Vec2> corners, Color fill);  ///< not an obstacle: labels may stand on fills
  void line(const Vec2& from, const Vec2& to, const Stroke& stroke);
  void outline(std::span<const Vec2> corners, const Stroke& stroke);
  void arrow(const Vec2& from, const Vec2& to, const Stroke& stroke);
  void disc(const Vec2& center, double radius, Color fill);              ///< radius in page units
  void circle(const Vec2& center, double radius, const Stroke& stroke);  ///< radius in page units
  void plus(const Vec2& center, double half, const Stroke& stroke);      ///< half in page units
  /// Fine parallel lines across a convex area, `spacing` page units apart and fixed to the page, so that areas side by
  /// side are hatched alike; no obstacles. Nothing is drawn where `spacing` is below 3.
  void hatch(std::span<const Vec2> corners, double spacing, const Stroke& stroke);
  /// Fine lines, one each way through `through` and the others at whole multiples of `step` scene units from there; no
  /// obstacles.
  void grid(double step, const Stroke& stroke, const Vec2& through = Vec2::Zero());

  /// Names the point `anchor`. The label stands near it, if possible on the side of `toward` (scene units, any length;
  /// of length 0: above and to the right). `style.align` is not used.
  /// `gap`: page units between label and anchor, if that place is free; the usual one clears a ring around a point. Where
  /// only a place farther away is free, a thin line leads from there to the anchor. No label leaves the frame: one that is wider
  /// is smaller than `style` says, and what lies outside has none where it would not be whole.
  void label(const Vec2& anchor, const Vec2& toward, std::string text, const TextStyle& style, double gap = 18);
  /// As label(), and rather on that side of each line on which the anchor is, where the line does not lead to it.
  void label_on_its_side(const Vec2& anchor, const Vec2& toward, std::string text, const TextStyle& style);
  /// Names a convex area: the label stands inside it, well clear of everything else where there is room.
  /// `shorter`: what to write instead where it does not fit, the first that does; nothing where an empty one is reached. Where
  /// none fits the first of them stands beside the area, with a thin line to its middle.
  void name_area(std::span<const Vec2> corners, std::string text, const TextStyle& style,
                 std::vector<std::string> shorter = {});
  /// Leaves out the names that were asked for so far.
  void drop_labels();
  /// No label is to stand there. `box`: page units.
  void keep_clear(const Box& box) { kept_clear_.push_back(box); }
  /// Draws all labels in the order in which they came, those of points before those of areas. Deterministic. Call once,
  /// after everything else. Where they do not all find a clear place in their size they are tried in smaller ones, all in the
  /// same, down to `smallest` of it.
  /// Requires: 0 < smallest <= 1.
  /// Returns: how many of them could not be kept clear of lines, of each other, and of the frame.
  int place_labels(double smallest = 1);

  const View& view() const { return view_; }
  /// Returns: whether a point is in the frame, at least `margin` page units from its border.
  bool holds(const Vec2& point, double margin) const;
  /// Returns: the four corners of the frame in scene units.
  std::vector<Vec2> corners() const;

 private:
  struct Obstacle {
    Vec2 from, to;  ///< page units
    double radius;  ///< half the width of the line, or the radius of the disc
  };
  struct Label {
    Vec2 anchor, toward;  ///< page units; `toward` of length 1
    std::string text;
    TextStyle style;
    double gap;
    bool stays_on_its_side = false;
  };
  struct AreaName {
    std::vector<Vec2> corners;  ///< page units
    std::string text;
    std::vector<std::string> shorter;
    TextStyle style;
  };
  class Arrangement;

  std::vector<Vec2> to_page(std::span<const Vec2> scene) const;
  void avoid_outline(std::span<const Vec2> page, double radius);
  void avoid(const Obstacle& obstacle);

  Canvas& canvas_;
  Box frame_;
  View view_;
  std::vector<Obstacle> obstacles_, fine_lines_;
  std::vector<Label> labels_;
  std::vector<AreaName> area_names_;
  std::vector<Box> kept_clear_;
};

}  // namespace render
