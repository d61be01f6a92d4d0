/// What the scalars of scenes cannot tell apart.
#pragma once

#include <limits>

#include "walkthroughs/model/scene.hpp"

namespace walkthroughs {

struct Precision {
  double epsilon;       ///< from 1 to the next number
  double least_normal;  ///< below it numbers lose digits
  double least;         ///< the smallest number above 0
  double largest;       ///< beyond it there is only infinity
};

template <class S>
constexpr Precision precision_in() {
  using Limits = std::numeric_limits<S>;
  return {Limits::epsilon(), Limits::min(), Limits::denorm_min(), Limits::max()};
}

constexpr Precision precision_of(Scalar scalar) {
  return scalar == Scalar::binary32 ? precision_in<float>() : precision_in<double>();
}

}  // namespace walkthroughs
