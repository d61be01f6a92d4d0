/// What is true of two objects: the answer that core/certified proves.
///
/// An object is what its numbers say. A pose moves points by its quaternion, or else by its matrix as it stands; radii and
/// heights stay what they are.
#pragma once

#include <optional>

#include "core/certificate.hpp"
#include "core/certified/grown.hpp"
#include "core/certified/shapes.hpp"
#include "core/result.hpp"
#include "walkthroughs/model/scene.hpp"

namespace walkthroughs::model {

struct ExactAnswer {
  gjk::Status status = gjk::Status::undecided;
  /// The certificate: the numbers of the points of a and b whose differences make the feature nearest to the origin, or
  /// the simplex that holds it. Of other objects than gjk::Grown none.
  gjk::IndexPairs nearest = {};
  double gap = 0;  ///< undecided: a bound on how far apart they are, and how deep in each other
};

/// Returns: points, balls, boxes, capsules and sums of these as what is decided exactly; nothing for other shapes, and where
/// numbers are so many or so small that it cannot be said.
/// The points of a sum are numbered as gjk::Grown numbers them. A ball has one point, a capsule two, a box its corners as
/// its ShapeRow makes them.
std::optional<gjk::Grown> exact_shape(const AnyShape& shape, const Pose& pose);

/// Returns: the exact answer about cylinders along one coordinate axis, and balls and capsules along it; nothing for others.
std::optional<gjk::Status> exact_status_of_cylinders(const Object& a, const Object& b);

/// Returns: what can be said of any two objects. Where doubles leave it open, long doubles are asked.
gjk::ShapesResult bounded_answer(const Object& a, const Object& b);

/// Returns: the answer about the objects as their doubles and their poses say them. Undecided where points are only known
/// within a bound, and the objects are nearer than that.
ExactAnswer exact_answer(const Object& a, const Object& b);

/// Returns: whether a search in numbers of that scalar could answer either way, by the rounding of its points alone.
bool is_near_contact(const Object& a, const Object& b, Scalar scalar);

}  // namespace walkthroughs::model
