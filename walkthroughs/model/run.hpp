/// Asking GJK about a scene.
#pragma once

#include <functional>

#include "walkthroughs/model/scene.hpp"

namespace walkthroughs::model {

/// Returns: every event of GJK on the two objects, computed in the scene's scalar; a double holds every float. Of a scene that
/// is certified those of the proofs, too.
Trace run(const Scene& scene);

/// Who answers for the objects of a scene: a farthest point along `d`.
struct SupportFunctions {
  std::function<gjk::SupportPoint<double>(const Point&)> a, b;
};

/// Returns: the same, the objects being asked through `supports`. Requires: a scene that is not certified.
Trace run(const Scene& scene, const SupportFunctions& supports);

}  // namespace walkthroughs::model
