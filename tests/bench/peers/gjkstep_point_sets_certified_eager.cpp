#include "core/certified.hpp"
#include "tests/bench/peers/gjkstep_call.hpp"

namespace peers {

template <>
Answer asked_of_point_sets<Certified<gjk::Eager<>>>(const PointSet& a, const PointSet& b,
                                                    const gjk::Options<double>& options) {
  return answer_of(gjk::certified_collision<double, gjk::Eager<>>(a, b, options).status);
}

}  // namespace peers
