#include "walkthroughs/model/run.hpp"

#include "core/gjk.hpp"
#include "walkthroughs/model/run_certified.hpp"
#include "walkthroughs/model/types_of_scene.hpp"
#include "walkthroughs/model/widened.hpp"
#include "walkthroughs/wrong_on_purpose/with_mistake.hpp"

namespace walkthroughs {
namespace {

/// One shape for whoever answers, so that each search is compiled once.
template <class S>
struct Answering {
  const std::function<gjk::SupportPoint<double>(const Point&)>& answer;

  gjk::SupportPoint<S> support(const gjk::Vec3<S>& d) const {
    const gjk::SupportPoint<double> found = answer(d.template cast<double>());
    return {found.point.template cast<S>(), found.index};
  }
};

/// In numbers of S, which the doubles that carry them hold.
template <class S>
std::function<gjk::SupportPoint<double>(const Point&)> asking(const Object& object) {
  return
      [shape = AskedObject<S>(object)](const Point& d) { return Widening<S>{}(shape.support(d.template cast<S>())); };
}

SupportFunctions asking_the_objects_of(const Scene& scene) {
  switch (scene.scalar) {
    case Scalar::binary32: return {asking<float>(scene.a), asking<float>(scene.b)};
    case Scalar::binary64: break;
  }
  return {asking<double>(scene.a), asking<double>(scene.b)};
}

}  // namespace

Trace run(const Scene& scene) {
  return scene.certified ? run_certified(scene) : run(scene, asking_the_objects_of(scene));
}

Trace run(const Scene& scene, const SupportFunctions& supports) {
  Trace trace;
  const auto search = [&]<class S, class Rules>() {
    gjk::collision<S, Rules>(Answering<S>{supports.a}, Answering<S>{supports.b}, options_in<S>(scene),
                             WidenedInto{trace});
  };
  if (scene.mistake)
    wrong_on_purpose::with_mistake(*scene.mistake, [&]<class Rules>() { search.template operator()<double, Rules>(); });
  else
    with_types_of(scene, search);
  return trace;
}

}  // namespace walkthroughs
