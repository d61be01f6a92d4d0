#include "tests/study/truth/oracle_cgal.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Intersections_3/Tetrahedron_3_Tetrahedron_3.h>
#include <CGAL/Intersections_3/Tetrahedron_3_Triangle_3.h>
#include <CGAL/Intersections_3/Triangle_3_Triangle_3.h>

#include <algorithm>
#include <variant>

namespace study {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;  // which do_intersect needs no constructions of
using Solid = std::variant<std::monostate, Kernel::Triangle_3, Kernel::Tetrahedron_3>;

Solid solid(const Points& points) {
  if (!std::ranges::all_of(points, [](const Vec& p) { return p.allFinite(); })) return {};
  const auto p = [&](std::size_t i) { return Kernel::Point_3(points[i][0], points[i][1], points[i][2]); };
  if (points.size() == 3 && !CGAL::collinear(p(0), p(1), p(2))) return Kernel::Triangle_3(p(0), p(1), p(2));
  if (points.size() == 4 && !CGAL::coplanar(p(0), p(1), p(2), p(3)))
    return Kernel::Tetrahedron_3(p(0), p(1), p(2), p(3));
  return {};
}

struct Judge {
  template <class A, class B>
  std::optional<Truth> operator()(const A& a, const B& b) const {
    if constexpr (std::is_same_v<A, std::monostate> || std::is_same_v<B, std::monostate>)
      return {};
    else
      return CGAL::do_intersect(a, b) ? Truth::intersecting : Truth::separated;
  }
};

}  // namespace

std::optional<Truth> truth_by_cgal(const Points& a, const Points& b) { return std::visit(Judge{}, solid(a), solid(b)); }

}  // namespace study
