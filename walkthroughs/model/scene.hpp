/// Two real objects and how to ask GJK about them; and what came of it.
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "core/events.hpp"
#include "core/rule_sets.hpp"
#include "core/shapes.hpp"

namespace walkthroughs {

using Point = gjk::Vec3<double>;
using Points = gjk::PointSet<double>;
using Ball = gjk::Sphere<double>;
using Cylinder = gjk::Cylinder<double>;
using Pose = gjk::Pose<double>;

/// A convex object of a scene; a shape of core/ as it says itself.
struct Object {
  std::string name;  ///< as a caption calls it: "triangle"
  std::variant<Points, Ball, Cylinder> form;
  Pose pose = {};

  /// Returns: whether the pose leaves everything where it is. The sign of zero counts: it decides that of the points found.
  bool is_at_rest() const;

  /// Counts itself, so that a test can see who asks.
  gjk::SupportPoint<double> support(const Point& d) const;
  mutable std::size_t support_calls = 0;
};

/// Returns: the convex hull of `vertices`, given in any order.
inline Points points(std::vector<Point> vertices) { return Points(std::move(vertices)); }

/// Returns: the vertices of a point set where the pose puts them; none for other shapes.
std::vector<Point> vertices_of(const Object& object);

/// Returns: a point inside: the center where there is one, the mean of a point set; where the pose puts it.
Point center_of(const Object& object);

using gjk::RuleSet;
using ZeroTest = gjk::ZeroTestKind;

/// In which numbers the search computes: double or float. The words are those of IEEE 754.
enum class Scalar { binary64, binary32 };

/// Scenes of the plane z = 0 are drawn flat; those of space through a camera.
enum class Dimension { plane, space };

/// Everything that decides a run. Lengths are in the scene's own unit.
struct Scene {
  std::string name;  ///< tells the scenes of one walkthrough apart: "left"
  Object a, b;
  gjk::Options<double> options = {};
  Dimension dimension = Dimension::plane;
  RuleSet rules = RuleSet::as_intended;
  ZeroTest zero_test = ZeroTest::exact;
  Scalar scalar = Scalar::binary64;  ///< binary32: every number of the scene is a float, see in_float()
};

/// Returns: the scene with every number rounded to the nearest float, to be searched in float. So the objects that are
/// drawn are those that are searched, and what goes wrong is the search's doing.
/// Errors: std::range_error, with the number, where one is beyond all floats or a length or direction vanishes.
Scene in_float(Scene scene);

/// Returns: the scene with the first direction from the center of a to that of b; with the usual one where there is none.
Scene from_center_to_center(Scene scene);

using Trace = gjk::Trace<double>;

/// Returns: every event of GJK on the two objects, computed in the scene's scalar; a double holds every float.
Trace run(const Scene& scene);

}  // namespace walkthroughs
