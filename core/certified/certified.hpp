/// Collision tests whose answer is proven: exact geometric computation by filtered predicates. This header is the one
/// to begin with.
///
///     const gjk::CertifiedResult result = gjk::certified_collision(set_a, set_b);
///     result.status;        // intersecting or separated
///     result.certificate;   // why: see certificate.hpp; holds() of check.hpp multiplies it out
///
/// What to call for which sets:
///  - Hulls of points: certified_collision(). Never wrong, never undecided; with a certificate.
///  - Points that a pose moves, sums of these, balls, capsules, rounded boxes: certified_collision() of grown.hpp.
///    Never wrong, never undecided; with a certificate.
///  - Cylinders along the same coordinate axis, also with balls and capsules along it: certified_status() of
///    cylinders.hpp. Never wrong, never undecided; without a certificate.
///  - All else: certified_shapes() of shapes.hpp. Never wrong; undecided near contact, with a bound on it.
///
/// How it works:
///  1. collision() runs in S. It may find a separating axis or a tetrahedron around the origin.
///  2. The filter (filter.hpp) tries that against a static error bound.
///  3. Where that does not suffice the exact fallback (exact_fallback.hpp) searches for the min-norm point, like
///     Wolfe's algorithm. It goes by signs that are exact. Dynamic error bounds come first, whole numbers of any length
///     where these leave a doubt.
///
/// The filter costs a few products. Of random pairs some ten in a million need the fallback. Of touching ones all do,
/// and then take some microseconds (measured: tests/study/results/timings.md).
///
/// Needs Eigen and, for whole numbers of any length, Boost.Multiprecision (headers of another project). Within
/// core only this folder needs Boost.
///
/// What is proven, under which assumptions, as numbered properties. The tests quote them. The assumptions: IEEE
/// arithmetic, rounded to nearest, no denormal numbers flushed to zero, finite coordinates. (Contracted products do no
/// harm.)
///  In these, u is the unit roundoff of S. A set of n points has r: on each axis the largest |coordinate|. s and M lie
///  within Range<S>, so that no product overflows or vanishes; else the filter proves nothing.
///  C1. A direction d is a proof where −w·d > 16u·s. Here w is the support point found along d, and s = Σ (r_A +
///      r_B)|d|. See SeparationFilter.
///  C2. Four points are a proof where four determinants are larger than 64uM³, M being their largest |coordinate|. Each
///      is that of the origin and three of the points, positive where the origin lies inside. See ContainmentFilter. One
///      of the points may be the difference of the means of the sets, which is known less well. Then the determinants
///      have to be larger than 64uM³ + 8(n_A max r_A + n_B max r_B)uM², see error_of_mean().
///  C3. Each sign that the exact fallback goes by is that of the exact number. See exact_fallback.hpp.
///  C4. The exact fallback ends. |v|, the distance of the simplex from the origin, falls strictly. v depends only on
///      the feature that is kept, and there are finitely many features.
///  C5. Whatever the first search does, wrong rules included, costs time and never truth. Of it only points of the
///      difference and one direction with the support point found along it are taken. What they prove is looked at
///      anew. Of a search that starts inside, the first vertex is not taken: nobody knows whether the caller's points lie
///      inside. It is taken where they are the means of the sets.
#pragma once

#include <concepts>
#include <limits>
#include <utility>

#include "../certificate.hpp"
#include "../gjk.hpp"
#include "exact_fallback.hpp"
#include "filter.hpp"
#include "usual_arithmetic.hpp"

namespace gjk {

namespace detail {

// -- Both searches ---------------------------------------------------------------------------------------------------

/// Whether rules ask the difference itself for its support points, as Eq. 8 does. What is proven rests on that, and on
/// nothing else of the rules.
template <class Rules, class S>
concept AsksTheDifference = std::same_as<decltype(Rules::template difference<S>(std::declval<const PointSet<S>&>(),
                                                                                std::declval<const PointSet<S>&>())),
                                         MinkowskiDifference<S, PointSet<S>, PointSet<S>>>;

/// Of a search that started inside. Returns: how far the components of the vertex that it started from may be off. It
/// is 0 where that vertex is dropped. It is infinite where that vertex is not the difference of the means, for
/// which there is no IndexPair.
template <class S>
double error_of_start(const Simplex<S>& simplex, const PointSet<S>& a, const PointSet<S>& b) {
  for (const Vertex<S>& vertex : simplex) {
    if (vertex.a.index) continue;
    if (vertex.a.point != a.mean() || vertex.b.point != b.mean()) return std::numeric_limits<double>::infinity();
    return error_of_mean(a.points().size(), a.extent().maxCoeff()) +
           error_of_mean(b.points().size(), b.extent().maxCoeff());
  }
  return 0;
}

template <class S>
void add_vertices(IndexPairs& pairs, const Simplex<S>& simplex) {
  for (const auto& [a, b, w] : simplex)
    pairs.add({a.index.value_or(IndexPair::mean), b.index.value_or(IndexPair::mean)});
}

/// Adds the vertices that support functions have found. Adds one at least, whichever.
template <class S>
void add_found_vertices(IndexPairs& pairs, const Simplex<S>& simplex) {
  for (const auto& [a, b, w] : simplex)
    if (a.index) pairs.add({*a.index, *b.index});
  if (pairs.size() == 0) pairs.add({});
}

/// What certified_collision() does after its first search. It does not ask for the rules of that search, so it is
/// compiled once for all of them.
template <class S, class Obs>
CertifiedResult prove(const Result<S>& guess, const PointSet<S>& a, const PointSet<S>& b, const Options<S>& options,
                      Obs& observer) {
  Teller<Obs> tell(observer, options.crossing_test);
  CertifiedResult result;
  result.iterations = guess.iterations;
  tell.enter_iteration(guess.iterations);
  if (guess.separation) {
    const SeparationFilter<S> proof(guess.separation->direction, guess.separation->support_value, a.extent(),
                                    b.extent());
    tell([&] { return proof.told(); });
    if (proof.holds()) {
      result.status = Status::separated;
      result.proof = Proof::direction;
      result.certificate = SeparatingDirection{guess.separation->direction.template cast<double>()};
      return result;
    }
  }
  const Simplex<S>& simplex = guess.simplex;
  if (simplex.size() == 4) {
    const double mean_error = options.inside ? error_of_start(simplex, a, b) : 0;
    const ContainmentFilter<S> proof(simplex[0].w, simplex[1].w, simplex[2].w, simplex[3].w, mean_error);
    tell([&] { return proof.told(); });
    if (proof.holds()) {
      result.status = Status::intersecting;
      result.proof = Proof::tetrahedron;
      add_vertices(result.certificate.template emplace<CommonSimplex>().of, simplex);
      return result;
    }
  } else if (!guess.separation) {
    tell([] { return FilterTried<S>{.proof = Proof::tetrahedron}; });
  }
  IndexPairs found;
  add_found_vertices(found, simplex);
  decide_exactly(a, b, found, tell, result);
  return result;
}

template <class S, class Rules, class Obs>
CertifiedResult certify(const PointSet<S>& a, const PointSet<S>& b, const Options<S>& options, Obs& observer) {
  return prove(collision<S, Rules>(a, b, options, observer), a, b, options, observer);
}

}  // namespace detail

/// Do the convex hulls of two sets of points have a point in common? collision() is asked, with any rules. What it
/// finds is proven in S. Where that fails it is decided anew, exactly. There is no iteration limit and no tolerance.
/// Touching is intersecting.
///
/// `observer`: is told the events of collision(), then the proofs, the exact fallback and the end. Without one no event
/// is made. With an observer collision() finds a cycle at once. Of a pair that goes round, the numbers of iterations
/// and the certificate may then be others.
/// Requires: finite coordinates. Any S but float and double would need its own bounds.
/// Returns: the answer with its certificate. Never undecided.
/// Errors: std::runtime_error where denormal numbers are flushed to zero or rounding is not to nearest.
template <class S, class Rules = AsIntended, class Obs = const NobodyListens>
requires((std::same_as<S, float> ||
          std::same_as<S, double>)&&detail::AsksTheDifference<Rules, S>&& CertifiedObserver<Obs, S>) CertifiedResult
    certified_collision(const PointSet<S>& a, const PointSet<S>& b, const Options<S>& options = {},
                        Obs&& observer = NobodyListens{}) {
  using Listener = std::remove_reference_t<Obs>;
  detail::expect_usual_arithmetic();
  if constexpr (detail::Teller<Listener>::somebody_listens) {
    detail::OneRun<S, Listener> run(observer);
    const CertifiedResult result = detail::certify<S, Rules>(a, b, options, run);
    detail::Teller tell(run, options.crossing_test);
    tell.enter_iteration(result.iterations + result.fallback_iterations);
    tell([&] { return Certified<S>{.result = result}; });
    return result;
  } else {
    return detail::certify<S, Rules>(a, b, options, observer);
  }
}

}  // namespace gjk
