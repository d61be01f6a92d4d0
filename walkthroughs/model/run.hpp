/// Asking GJK about a scene.
#pragma once

#include "walkthroughs/model/scene.hpp"

namespace walkthroughs {

/// Returns: every event of GJK on the two objects, computed in the scene's scalar; a double holds every float. Of a scene that
/// is certified those of the proofs, too.
Trace run(const Scene& scene);

}  // namespace walkthroughs
