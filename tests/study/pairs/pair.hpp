/// What the study asks about: two convex bodies, written in doubles.
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <variant>

#include "walkthroughs/model/any_shape.hpp"

namespace study {

using Vec = gjk::Vec3<double>;

using Points = walkthroughs::model::Points;
using Ball = walkthroughs::model::Ball;
using Can = walkthroughs::model::Cylinder;

/// The shapes that the truth is known about.
using Body = std::variant<Points, Ball, Can>;

struct Pair {
  Body a, b;
};

/// Returns: the largest magnitude of all numbers of a body.
inline double largest_number(const Body& body) {
  double most = 0;
  const auto look = [&most](auto /*field*/, const auto& value) {
    if constexpr (requires { value.cwiseAbs(); })
      most = std::max(most, value.cwiseAbs().maxCoeff());
    else if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(value)>>)
      most = std::max(most, std::abs(value));
    else
      for (const Vec& point : value) most = std::max(most, point.cwiseAbs().maxCoeff());
  };
  walkthroughs::model::visit_fields(look, body);
  return most;
}

/// Sets are closed: touching is intersecting.
enum class Truth { separated, intersecting };

}  // namespace study
