// The report's algorithm with fewer iterations than searches may need, and no other fault: the judge's tests judge it.
//
//     JUDGED_LIMIT=6 judged-limited
#include "core/gjk.hpp"
#include "judge_main.hpp"

static gjk::PointSet<double> set_of(const judge::Points& points) {
  std::vector<gjk::Vec3<double>> list;
  for (const auto& [x, y, z] : points) list.emplace_back(x, y, z);
  return gjk::PointSet<double>(std::move(list));
}

bool collide(const judge::Points& a, const judge::Points& b) {
  static const gjk::Options<double> options{.iteration_limit = std::atoi(std::getenv("JUDGED_LIMIT"))};
  return gjk::collision<double>(set_of(a), set_of(b), options).status == gjk::Status::intersecting;
}
