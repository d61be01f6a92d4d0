#include "walkthroughs/model/run.hpp"

#include "core/gjk.hpp"
#include "walkthroughs/model/run_certified.hpp"
#include "walkthroughs/model/types_of_scene.hpp"
#include "walkthroughs/model/widened.hpp"
#include "walkthroughs/wrong_on_purpose/with_mistake.hpp"

namespace walkthroughs {

Trace run(const Scene& scene) {
  if (scene.certified) return run_certified(scene);
  Trace trace;
  const auto search = [&]<class S, class Rules>() {
    gjk::collision<S, Rules>(AskedObject<S>(scene.a), AskedObject<S>(scene.b), options_in<S>(scene),
                             WidenedInto{trace});
  };
  if (scene.mistake)
    wrong_on_purpose::with_mistake(*scene.mistake, [&]<class Rules>() { search.template operator()<double, Rules>(); });
  else
    with_types_of(scene, search);
  return trace;
}

}  // namespace walkthroughs
