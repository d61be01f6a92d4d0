/// What is true of a scene, found in another way than the program finds it.
#pragma once

#include "tests/core/oracle.hpp"
#include "tests/walkthroughs/support.hpp"

namespace walkthroughs::test {

/// By linear equations in fractions. Requires: two sets of few points, where they are.
inline gjk::Status truth_about(const Object& a, const Object& b) {
  gjk::test::ExactVecs differences;
  for (const Point& p : vertices_of(a))
    for (const Point& q : vertices_of(b)) differences.push_back(gjk::test::exact(p) - gjk::test::exact(q));
  return gjk::test::contain_origin(differences) ? gjk::Status::intersecting : gjk::Status::separated;
}
inline gjk::Status truth_about(const Scene& scene) { return truth_about(scene.a, scene.b); }

}  // namespace walkthroughs::test
