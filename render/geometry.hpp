/// Places, sizes and boxes on a page.
///
/// Conventions of the whole of render/, stated once:
///  * A page has a size in *page units* (see Canvas): x to the right, y DOWN, (0,0) the top left corner.
///    One page unit is one pixel when the page is drawn at its own size; `Canvas` scales it to any other size.
///  * A scene is drawn in *scene units*, x to the right, y UP. `View` is the one place that turns y over.
///  * Line widths, radii and text sizes are page units, so they do not change when a scene is zoomed.
///  * Images keep their top row first.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

namespace render {

using Vec2 = Eigen::Vector2d;

/// Width and height in pixels.
struct Size {
  int width = 0;
  int height = 0;
  friend bool operator==(const Size&, const Size&) = default;
};

/// The smallest and largest picture that can be drawn, each way.
inline constexpr int min_pixels = 16;
inline constexpr int max_pixels = 8192;

/// A box; on a page `min` is the top left corner.
struct Box {
  Vec2 min = Vec2::Zero();
  Vec2 max = Vec2::Zero();

  /// Returns: the smallest box that holds these points. Requires: at least one.
  static Box around(std::span<const Vec2> points) {
    Box box{points.front(), points.front()};
    for (const Vec2& each : points) box.add(each);
    return box;
  }
  /// Makes it as large as it must be to hold the point.
  void add(const Vec2& point) {
    min = min.cwiseMin(point);
    max = max.cwiseMax(point);
  }
  double width() const { return max.x() - min.x(); }
  double height() const { return max.y() - min.y(); }
  double longer_side() const { return (max - min).maxCoeff(); }
  Vec2 center() const { return (min + max) / 2; }
  /// Returns: the corners, all around.
  std::vector<Vec2> corners() const { return {min, {max.x(), min.y()}, max, {min.x(), max.y()}}; }
  /// Returns this box made larger by `margin` on every side (smaller where negative).
  Box grown(double margin) const { return grown(Vec2(margin, margin)); }
  Box grown(const Vec2& margin) const { return {min - margin, max + margin}; }
  bool overlaps(const Box& other) const {
    return min.x() < other.max.x() && other.min.x() < max.x() && min.y() < other.max.y() && other.min.y() < max.y();
  }
};

/// A part of a line segment, as fractions of its length: 0 is its start, 1 its end.
struct Interval {
  double from = 0;
  double to = 1;
};

/// Returns: the part of the segment that lies in `box` (border included), or nothing where none does.
std::optional<Interval> clip_segment(const Vec2& from, const Vec2& to, const Box& box);

/// Returns: the area of the parallelogram of `u` and `v`, negative where `v` turns from `u` from y to x.
inline double turn(const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); }
/// Returns: the area of a convex polygon, negative where it turns from y to x.
double signed_area(std::span<const Vec2> polygon);

double distance_to_segment(const Vec2& p, const Vec2& from, const Vec2& to);

/// Returns: the part of a convex polygon where `gradient`·p + `offset` >= 0.
std::vector<Vec2> clip_polygon(std::span<const Vec2> polygon, const Vec2& gradient, double offset);
/// Returns: the part of a convex polygon that lies in `box`.
std::vector<Vec2> clip_polygon(std::span<const Vec2> polygon, const Box& box);

/// Returns: corners of a polygon, so many that none of the others lies farther than `tolerance` from the lines between them.
std::vector<Vec2> simplified(std::span<const Vec2> polygon, double tolerance);

}  // namespace render
