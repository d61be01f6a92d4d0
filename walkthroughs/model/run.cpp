#include "walkthroughs/model/run.hpp"

#include <variant>

#include "core/certified/certified.hpp"
#include "core/gjk.hpp"
#include "core/rule_sets.hpp"
#include "walkthroughs/model/widened.hpp"
#include "walkthroughs/wrong_on_purpose/rules.hpp"

namespace walkthroughs::model {
namespace {

/// The one place where what a scene says becomes template arguments.
/// Calls run.template operator()<S, Rules>() with the scalar and the rules of a scene.
template <class Run>
void with_types_of(const Scene& scene, Run&& run) {
  const auto in = [&]<class S>(S) {
    gjk::with_rules(scene.rules, scene.zero_test, [&]<class Rules>() { run.template operator()<S, Rules>(); });
  };
  switch (scene.scalar) {
    case Scalar::binary64: return in(double{});
    case Scalar::binary32: return in(float{});
  }
}

template <class S>
gjk::Options<S> options_in(const Scene& scene) {
  return {.first_direction = scene.options.first_direction.cast<S>(),
          .iteration_limit = scene.options.iteration_limit,
          .crossing_test = scene.options.crossing_test};
}

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

// -- Scenes whose answer is proven ------------------------------------------------------------------------------------

template <class S>
gjk::PointSet<S> set_of(const Object& object) {
  std::vector<gjk::Vec3<S>> points;
  for (const Point& p : std::get<Points>(object.form)) points.push_back(p.cast<S>());
  return gjk::PointSet<S>(std::move(points));
}

/// Requires: of both objects points, where they are asked for; see objection_to_proof().
/// Returns: every event of certified_collision(), computed in the scene's scalar.
Trace run_certified(const Scene& scene) {
  Trace trace;
  with_types_of(scene, [&]<class S, class Rules>() {
    gjk::certified_collision<S, Rules>(set_of<S>(scene.a), set_of<S>(scene.b), options_in<S>(scene),
                                       WidenedInto{trace});
  });
  return trace;
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

}  // namespace walkthroughs::model
