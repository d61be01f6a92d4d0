/// What is true of the objects of a scene, beside what its search answers.
#pragma once

#include <optional>

#include "walkthroughs/model/exact_shape.hpp"

namespace walkthroughs::model {

struct Truth {
  ExactAnswer answer = {};  ///< about the objects as read: before their numbers were rounded to float
  /// The exact answer about the objects as their shortest decimals say them, where that is another; undecided where it is not
  /// known: of round shapes and boxes whose decimals have more digits than doubles hold.
  std::optional<gjk::Status> of_decimals = {};
  /// Whether they are so near to contact that rounding the matrix of a turn may have decided.
  bool by_rounded_turn = false;
  /// What the search answers with a and b exchanged, from the same first direction, where that is another.
  std::optional<gjk::Status> exchanged = {};
};

/// Returns: the truth about a scene whose search has answered `shown`. Nothing is computed of a scene that leaves it out.
Truth truth_of(const Scene& scene, gjk::Status shown);

/// Returns: whether it is known that the answer `shown` is not the true one, be it no answer at all.
inline bool is_otherwise(const Truth& truth, gjk::Status shown) {
  return truth.answer.status != gjk::Status::undecided && truth.answer.status != shown;
}

/// Returns: whether it was asked, and nothing can be proven.
inline bool is_open(const Truth& truth) { return truth.answer.gap > 0; }

/// Returns: whether there is more to tell than what the search answers.
inline bool says_more(const Truth& truth, gjk::Status shown) {
  return is_otherwise(truth, shown) || is_open(truth) || truth.of_decimals || truth.by_rounded_turn || truth.exchanged;
}

/// The objects as read.
inline const Object& a_as_read(const Scene& scene) { return scene.a_as_read ? *scene.a_as_read : scene.a; }
inline const Object& b_as_read(const Scene& scene) { return scene.b_as_read ? *scene.b_as_read : scene.b; }

}  // namespace walkthroughs::model
