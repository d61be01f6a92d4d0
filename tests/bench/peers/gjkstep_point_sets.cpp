#include "tests/bench/peers/gjkstep_call.hpp"

namespace peers {

Answer asked_of_point_sets(const PointSet& a, const PointSet& b) { return asked(a, b); }

}  // namespace peers
