/// Two real objects and how to ask GJK about them; and what came of it.
#pragma once

#include <string>
#include <vector>

#include "core/gjk.hpp"

namespace walkthroughs {

using Point = gjk::Vec3<double>;

/// A convex object: the hull of its vertices, given in any order.
struct Object {
  std::string name;  ///< as a caption calls it: "triangle"
  std::vector<Point> vertices;
};

/// Everything that decides a run. Lengths are in the scene's own unit.
struct Scene {
  std::string name;  ///< tells the scenes of one walkthrough apart: "left"
  Object a, b;
  gjk::Options<double> options = {};
};

using Trace = gjk::Trace<double>;

/// Returns: every event of GJK on the two objects.
Trace run(const Scene& scene);

}  // namespace walkthroughs
