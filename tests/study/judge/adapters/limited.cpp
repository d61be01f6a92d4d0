// The report's algorithm with fewer iterations than searches may need, and no other fault: the judge's tests judge it.
//
//     JUDGED_LIMIT=6 judged-limited
#include "core/gjk.hpp"
#include "point_set.hpp"

bool collide(const judge::Points& a, const judge::Points& b) {
  static const gjk::Options<double> options{.iteration_limit = std::atoi(std::getenv("JUDGED_LIMIT"))};
  return gjk::collision<double>(set_of(a), set_of(b), options).status == gjk::Status::intersecting;
}
