#include "walkthroughs/scene.hpp"

namespace walkthroughs {

Trace run(const Scene& scene) {
  Trace trace;
  gjk::collision<double>(gjk::PointSet<double>(scene.a.vertices), gjk::PointSet<double>(scene.b.vertices),
                         scene.options, trace);
  return trace;
}

}  // namespace walkthroughs
