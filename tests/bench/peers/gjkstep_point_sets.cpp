#include "tests/bench/peers/gjkstep_call.hpp"

namespace peers {

template <class Rules>
Answer asked_of_point_sets(const PointSet& a, const PointSet& b) {
  return asked<Rules>(a, b);
}

template Answer asked_of_point_sets<gjk::AsIntended>(const PointSet&, const PointSet&);
template Answer asked_of_point_sets<Relative>(const PointSet&, const PointSet&);

}  // namespace peers
