#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Intersections_3/Tetrahedron_3_Tetrahedron_3.h>
#include <CGAL/Intersections_3/Tetrahedron_3_Triangle_3.h>
#include <CGAL/Intersections_3/Triangle_3_Triangle_3.h>
#include <CGAL/version.h>

#include <variant>

#include "tests/bench/peers/contender.hpp"

namespace peers {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Solid = std::variant<std::monostate, Kernel::Triangle_3, Kernel::Tetrahedron_3>;

/// Returns: std::monostate for what is neither a triangle nor a tetrahedron, or flat.
Solid solid(const study::Body& body) {
  const auto* const points = std::get_if<study::Points>(&body);
  if (!points || (points->size() != 3 && points->size() != 4)) return {};
  const auto p = [&](std::size_t i) { return Kernel::Point_3((*points)[i][0], (*points)[i][1], (*points)[i][2]); };
  if (points->size() == 3) return CGAL::collinear(p(0), p(1), p(2)) ? Solid() : Kernel::Triangle_3(p(0), p(1), p(2));
  if (CGAL::coplanar(p(0), p(1), p(2), p(3))) return {};
  return Kernel::Tetrahedron_3(p(0), p(1), p(2), p(3));
}

struct Ask {
  template <class A, class B>
  Answer operator()(const A& a, const B& b) const {
    if constexpr (std::is_same_v<A, std::monostate> || std::is_same_v<B, std::monostate>)
      return Answer::not_asked;
    else
      return CGAL::do_intersect(a, b) ? Answer::intersecting : Answer::separated;
  }
};

class Query {
 public:
  explicit Query(const study::Pair& pair) : a_(solid(pair.a)), b_(solid(pair.b)) {}
  Answer operator()() const { return std::visit(Ask{}, a_, b_); }

 private:
  Solid a_, b_;
};

}  // namespace

std::vector<Contender> cgal_contenders() {
  return {
      {.name = exact_peer,
       .how = "CGAL " CGAL_VERSION_STR
              ", `CGAL::do_intersect` of triangles and tetrahedra that are not flat, with exact predicates "
              "(`Exact_predicates_inexact_constructions_kernel`). Other shapes are not asked. It has a test of its own "
              "for each two of these shapes. So it is not one of the peers below, which know convex sets by their "
              "support.",
       .prepare = batch_of<Query>,
       .is_peer = false}};
}

}  // namespace peers
