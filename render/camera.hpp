/// How a picture looks at space: an orthographic camera.
///
/// Space is right-handed, z up. A camera maps a point of space to the picture's scene units (x right, y up), so that
/// everything a Panel can draw in the plane it can draw in space; a length at right angles to the line of sight keeps its
/// length. Points with a larger depth lie farther from the viewer.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "render/geometry.hpp"

namespace render {

using Vec3 = Eigen::Vector3d;

class Camera {
 public:
  /// Looks from `azimuth` (degrees around z, 0 = from +x, 90 = from +y) and `elevation` (degrees above the plane z = 0).
  /// Requires: -90 < elevation < 90, so that z points up in the picture.
  Camera(double azimuth, double elevation);

  Vec2 operator()(const Vec3& point) const { return {right_.dot(point), up_.dot(point)}; }
  double depth(const Vec3& point) const { return -toward_viewer_.dot(point); }
  /// Returns: whether a surface with this outward normal shows its front.
  bool sees(const Vec3& outward) const { return toward_viewer_.dot(outward) > 0; }

  const Vec3& right() const { return right_; }
  const Vec3& up() const { return up_; }
  const Vec3& toward_viewer() const { return toward_viewer_; }
  /// Returns: this camera, moved around the vertical axis by `degrees`, and by `rise` of them upwards, but not to where z no
  /// longer points up.
  Camera turned(double degrees, double rise = 0) const;

 private:
  double azimuth_, elevation_;
  Vec3 right_, up_, toward_viewer_;
};

/// A flat, convex face in space.
struct Face {
  std::vector<Vec3> corners;  ///< in order around the face, counter-clockwise seen from outside

  /// Returns: the outward normal, of any length (Newell's sum; zero for a face without area).
  Vec3 outward() const;
  /// Returns: the mean of the corners. Requires: at least one.
  Vec3 middle() const;
};

/// Returns: the order in which to draw translucent faces: of two that overlap in the picture the farther one first, where
/// faces do not run through each other and do not overlap in a circle; among faces that may come in any order the
/// farthest middle first, equals in the order given. The faces of one convex surface are always in order.
/// Faces that overlap in the picture are compared in pairs: meant for thousands, not for millions.
std::vector<std::size_t> back_to_front(const std::vector<Face>& faces, const Camera& camera);

/// An edge of a closed convex surface, once. The outline of the picture is made of edges that are not hidden.
struct Edge {
  Vec3 from, to;
  bool hidden;  ///< no face that meets it shows its front
};

/// Returns: the edges of the surface that `faces` close, in the order in which they first appear.
/// Requires: faces that meet share the coordinates of their corners exactly.
std::vector<Edge> edges_of(const std::vector<Face>& faces, const Camera& camera);

}  // namespace render
