/// From points of a scene to the page of a panel: straight at a plane, or through a camera.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "render/camera.hpp"
#include "walkthroughs/model/plane.hpp"

namespace walkthroughs::picture {

/// A scene of the plane has no camera: its picture is the scene itself. Of a scene in space planes are looked at as well.
struct Lens {
  std::optional<render::Camera> camera;
  Plane plane = {};  ///< where there is no camera

  render::Vec2 operator()(const Point& p) const { return camera ? (*camera)(p) : plane(p); }
  std::vector<render::Vec2> operator()(const std::vector<Point>& points) const {
    std::vector<render::Vec2> picture;
    for (const Point& p : points) picture.push_back((*this)(p));
    return picture;
  }

  /// Returns: the unit vector of the scene along which those points are farthest that are farthest at `angle` (radians,
  /// counter-clockwise from the right) in the picture.
  Point direction(double angle) const {
    const double c = std::cos(angle), s = std::sin(angle);
    if (camera) return camera->right() * c + camera->up() * s;
    return (plane.right * c * plane.stretch.x() + plane.up * s * plane.stretch.y()).normalized();
  }

  /// Returns: whether a face with that outward normal is turned to the viewer.
  bool sees(const Point& outward) const {
    return camera ? camera->sees(outward) : outward.dot(plane.right.cross(plane.up)) > 0;
  }
  /// Returns: their places in the order in which they are drawn; in a plane none is in front of another.
  std::vector<std::size_t> back_to_front(const std::vector<render::Face>& faces) const;
};

/// Returns: a camera for the whole search, from a fixed choice of places around it: the vertices of the simplex and the
/// origin apart from each other, and no face that decides edge-on or straight on.
render::Camera choose_camera(const Trace& trace);

}  // namespace walkthroughs::picture
