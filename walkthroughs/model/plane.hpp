/// A plane of a scene that is looked at straight on.
#pragma once

#include "render/geometry.hpp"
#include "walkthroughs/model/scene.hpp"

namespace walkthroughs::model {

struct Plane {
  Point on = Point::Zero();                           ///< where the page has its zero
  Point right = Point::UnitX(), up = Point::UnitY();  ///< on the page: unit vectors, at right angles
  render::Vec2 stretch = {1, 1};                      ///< what lies along `right`, `up` is drawn so many times as long

  /// Through `on`, `right` along `first`, `up` toward `side`. Requires: the two are not parallel.
  static Plane spanned(const Point& on, const Point& first, const Point& side) {
    const Point right = first.stableNormalized();
    return {on, right, (side - right * right.dot(side)).stableNormalized(), {1, 1}};
  }

  render::Vec2 operator()(const Point& p) const {
    return {stretch.x() * right.dot(p - on), stretch.y() * up.dot(p - on)};
  }
  /// Returns: the point of the plane that is drawn there.
  Point out(const render::Vec2& p) const { return on + right * (p.x() / stretch.x()) + up * (p.y() / stretch.y()); }
};

}  // namespace walkthroughs::model
