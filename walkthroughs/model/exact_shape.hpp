/// What is true of two objects: the answer that core/certified proves.
#pragma once

#include "core/certificate.hpp"
#include "core/result.hpp"
#include "walkthroughs/model/scene.hpp"

namespace walkthroughs::model {

struct ExactAnswer {
  gjk::Status status = gjk::Status::undecided;
  /// The certificate: the numbers of the points of a and b whose differences make the feature nearest to the origin, or
  /// the simplex that holds it. Of objects that are no points none.
  gjk::IndexPairs nearest = {};
};

/// Returns: the answer about the objects as their doubles and the matrix of their pose say them. Undecided where their
/// points are only known within a bound, and they are nearer than that.
ExactAnswer exact_answer(const Object& a, const Object& b);

/// Returns: whether a search in numbers of that scalar could answer either way, by the rounding of its points alone.
bool is_near_contact(const Object& a, const Object& b, Scalar scalar);

}  // namespace walkthroughs::model
