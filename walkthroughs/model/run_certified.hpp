/// Scenes whose answer is proven.
#pragma once

#include "walkthroughs/model/scene.hpp"

namespace walkthroughs {

/// Requires: of both objects points, where they are asked for; see objection_to_proof().
/// Returns: every event of certified_collision(), computed in the scene's scalar.
Trace run_certified(const Scene& scene);

}  // namespace walkthroughs
