/// What a program is asked about: two convex bodies, written in doubles.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>
#include <variant>

#include "walkthroughs/model/any_shape.hpp"

namespace walkthroughs::pairs {

using Vec = gjk::Vec3<double>;

using Can = Cylinder;

/// The shapes that the truth is known about.
using Body = std::variant<Points, Ball, Can>;

struct Pair {
  Body a, b;
};

/// A pair of sets of points: what adapters ask about.
struct PointPair {
  Points a, b;
};

/// Returns: the pair, if it is of points.
inline std::optional<PointPair> points_of(const Pair& pair) {
  const auto *a = std::get_if<Points>(&pair.a), *b = std::get_if<Points>(&pair.b);
  return a && b ? std::optional(PointPair{*a, *b}) : std::nullopt;
}

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
  visit_fields(look, body);
  return most;
}
inline double largest_number(const PointPair& pair) { return std::max(largest_number(pair.a), largest_number(pair.b)); }

}  // namespace walkthroughs::pairs
