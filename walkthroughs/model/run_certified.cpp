#include "walkthroughs/model/run_certified.hpp"

#include <variant>

#include "core/certified/certified.hpp"
#include "walkthroughs/model/types_of_scene.hpp"
#include "walkthroughs/model/widened.hpp"

namespace walkthroughs {
namespace {

template <class S>
gjk::PointSet<S> set_of(const Object& object) {
  std::vector<gjk::Vec3<S>> points;
  for (const Point& p : std::get<Points>(object.form)) points.push_back(p.cast<S>());
  return gjk::PointSet<S>(std::move(points));
}

}  // namespace

Trace run_certified(const Scene& scene) {
  Trace trace;
  with_types_of(scene, [&]<class S, class Rules>() {
    gjk::certified_collision<S, Rules>(set_of<S>(scene.a), set_of<S>(scene.b), options_in<S>(scene),
                                       WidenedInto{trace});
  });
  return trace;
}

}  // namespace walkthroughs
