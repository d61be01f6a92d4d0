/// What the study asks about: two convex bodies, written in doubles.
#pragma once

#include <variant>

#include "walkthroughs/model/any_shape.hpp"

namespace study {

using Vec = gjk::Vec3<double>;

using Points = walkthroughs::Points;
using Ball = walkthroughs::Ball;
using Can = walkthroughs::Cylinder;

/// The shapes that the truth is known about.
using Body = std::variant<Points, Ball, Can>;

struct Pair {
  Body a, b;
};

/// Sets are closed: touching is intersecting.
enum class Truth { separated, intersecting };

}  // namespace study
