/// Proven answers about two sets of points that move little from one question to the next. See ../moving.hpp.
#pragma once

#include <variant>

#include "../moving.hpp"
#include "certified.hpp"

namespace gjk {

namespace detail {

template <class S>
LastFound<S> found_in(const CertifiedResult& result) {
  LastFound<S> found;
  if (const auto* separating = std::get_if<SeparatingDirection>(&result.certificate))
    found.direction = separating->d.template cast<S>();
  const auto* common = std::get_if<CommonSimplex>(&result.certificate);
  if (common && common->of.size() == 4) found.corners = common->of;
  return found;
}

}  // namespace detail

/// As certified_collision() of certified.hpp, but what has proven the last answer is tried first. See collision() of
/// ../moving.hpp. The filters look at the tetrahedron, or the direction, as the objects are now (C1, C2, C5).
///
/// `last`: of the same two sets; becomes what is found now.
template <class S, class Rules = AsIntended>
CertifiedResult certified_collision(const PointSet<S>& a, const PointSet<S>& b, LastFound<S>& last,
                                    const Options<S>& options = {}) {
  if (last.corners.size() == 4) {
    detail::expect_usual_arithmetic();
    const Simplex<S> simplex = detail::moved<S>(last.corners, a, b);
    if (simplex.size() == 4 &&
        detail::ContainmentFilter<S>(simplex[0].w, simplex[1].w, simplex[2].w, simplex[3].w).holds())
      return {.status = Status::intersecting,
              .certificate = CommonSimplex{last.corners},
              .proof = Proof::tetrahedron,
              .iterations = 0,
              .fallback_iterations = 0};
    last.direction = detail::toward_origin(simplex);
  }
  const CertifiedResult result =
      certified_collision<S, detail::FirstPointTested<Rules>>(a, b, detail::begun_along(last.direction, options));
  last = detail::found_in<S>(result);
  return result;
}

}  // namespace gjk
