/// From points of a scene to the page of a panel: straight at a plane, or through a camera.
#pragma once

#include <optional>

#include "render/camera.hpp"
#include "walkthroughs/model/plane.hpp"

namespace walkthroughs {

/// A scene of the plane has no camera: its picture is the scene itself. Of a scene in space planes are looked at as well.
struct Lens {
  std::optional<render::Camera> camera;
  Plane plane = {};  ///< where there is no camera

  render::Vec2 operator()(const Point& p) const { return camera ? (*camera)(p) : plane(p); }

  /// Returns: the unit vector of the scene that points to `angle` (radians, counter-clockwise from the right) in the picture.
  Point direction(double angle) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return camera ? Point(camera->right() * c + camera->up() * s) : Point(plane.right * c + plane.up * s);
  }
};

/// Returns: a camera for the whole search, from a fixed choice of places around it: the vertices of the simplex and the
/// origin apart from each other, and the face that decides in front, its normal not pointing straight at the viewer. Where
/// the search finds a gap and no iteration is `decisive`, the camera looks along the plane between the objects.
/// `decisive`: the iteration that the walkthrough is about, if there is one.
render::Camera choose_camera(const Trace& trace, std::optional<int> decisive);

}  // namespace walkthroughs
