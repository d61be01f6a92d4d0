#include "walkthroughs/pairs/graded.hpp"

#include <algorithm>
#include <cmath>

#include "core/certified/check.hpp"
#include "walkthroughs/model/exact_shape.hpp"
#include "walkthroughs/pairs/families.hpp"

namespace walkthroughs::pairs {
namespace {

double length_of(const Vec& v) { return std::sqrt(v.dot(v)); }

double width_along(const Points& points, const Vec& direction) {
  const auto along = [&](const Vec& p) { return p.dot(direction); };
  const auto [least, most] = std::ranges::minmax(points, {}, along);
  return along(most) - along(least);
}

void move(Points& points, const Vec& by) {
  for (Vec& p : points) p += by;
}

PointPair moved_until(PointPair pair, std::uint64_t index) {
  move(pair.b, Vec(8, 1, 2));  // far apart first
  const Vec v = nearest_point(pair);
  const double length = length_of(v);
  const Vec direction = v / length;
  const double half_width = std::min(width_along(pair.a, direction), width_along(pair.b, direction)) / 2;
  const double gap = std::stod("1e-" + std::to_string(index / 2 % 16)) * half_width * (index % 2 == 0 ? 1 : -1);
  move(pair.b, (length - gap) * direction);
  return pair;
}

}  // namespace

Vec nearest_point(const PointPair& pair) {
  gjk::SeparatingFeature feature;
  for (const gjk::IndexPair each : exact_answer({"a", pair.a}, {"b", pair.b}).nearest) feature.of.add(each);
  const auto toward = gjk::direction_of(feature, gjk::PointSet<double>(pair.a), gjk::PointSet<double>(pair.b));
  if (!toward) return Vec::Zero();
  const auto number = [&](std::size_t i) { return -static_cast<double>((*toward)[i]); };
  return {number(0), number(1), number(2)};
}

Family graded(const Family& base) {
  const auto make = [base](std::uint64_t seed, std::uint64_t index) {
    const PointPair pair = moved_until(*points_of(base.make(seed, index)), index);
    return Pair{pair.a, pair.b};
  };
  return {"graded-" + base.name, base.what + ", then moved until 1 to 1e-15 apart or deep", base.size, make};
}

const std::vector<Family>& graded_families() {
  static const std::vector<Family> all = [] {
    std::vector<Family> list;
    for (const char* const name : {"triangles", "tetrahedra", "boxes", "hulls-8", "hulls-32"})
      list.push_back(graded(family_named(name)));
    return list;
  }();
  return all;
}

}  // namespace walkthroughs::pairs
