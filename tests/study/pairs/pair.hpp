/// What the study asks about: two convex bodies, written in doubles.
#pragma once

#include <variant>
#include <vector>

#include "core/shapes.hpp"

namespace study {

using Vec = gjk::Vec3<double>;

/// The convex hull of these points: at least one, in any order; they may coincide or be coplanar.
using Points = std::vector<Vec>;

/// A closed ball.
struct Ball {
  Vec center;
  double radius;
};

/// A closed cylinder with flat caps; `axis` of any length but zero, `height` from cap to cap.
struct Can {
  Vec center, axis;
  double radius, height;
};

using Body = std::variant<Points, Ball, Can>;

struct Pair {
  Body a, b;
};

/// Sets are closed: touching is intersecting.
enum class Truth { separated, intersecting };

}  // namespace study
