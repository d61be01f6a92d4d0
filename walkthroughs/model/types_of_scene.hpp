/// The one place where what a scene says becomes template arguments.
#pragma once

#include <utility>

#include "core/rule_sets.hpp"
#include "walkthroughs/model/scene.hpp"

namespace walkthroughs {

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

}  // namespace walkthroughs
