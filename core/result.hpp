/// The answer of a query, and the options it was asked with.
#pragma once

#include <optional>
#include <string_view>

#include "simplex.hpp"

namespace gjk {

/// Three values, because running out of iterations proves nothing (the report answers "no collision" there).
enum class Status { intersecting, separated, undecided };

enum class Reason {
  simplex_contains_origin,  ///< intersecting: Algorithms 2-5 found the origin in the simplex
  origin_not_crossed,       ///< separated: w·d < 0 (Eq. 9)
  no_new_vertex,            ///< crossing test off: the support function returned a vertex that the simplex had before
  iteration_limit,          ///< undecided
  cycle,                    ///< undecided: the search has come back to where it was, and would go round for ever
  unusable_direction,  ///< undecided: the search direction, or how far it reached, is zero, infinite or not a number
};

enum class CrossingTest {
  on,   ///< stop as soon as the origin was not crossed (Section 3.1.3)
  off,  ///< go on until the support function has no new vertex to offer (Section 3.1.2)
};

/// A point of each set, best well inside, such as PointSet::mean(). A search answers for the sets with these points
/// added. Such a point may lie outside its set by rounding, as it may of flat sets. Then so much may be found that the
/// sets do not have.
template <class S>
struct PointOfEach {
  Vec3<S> a, b;
};

template <class S>
struct Options {
  Vec3<S> first_direction =
      Vec3<S>(S(1), S(0), S(0));  ///< any length but zero; not looked at where a search starts inside
  int iteration_limit = 20;       ///< Algorithm 1; below 1 nothing is tried
  CrossingTest crossing_test = CrossingTest::on;
  /// Where given, the search starts inside, with the vertex inside->a − inside->b. That vertex has no indices, and no
  /// support function is asked for it. It spares half an iteration to a whole one.
  std::optional<PointOfEach<S>> inside = {};
};

/// Returns: a first direction that often separates sets that are apart. It leads from a point inside A to one inside B,
/// such as their centers. It is +x where these coincide. Between two balls all vertices that it leads to lie on one
/// line, to rounding. A few of a thousand such queries end undecided.
template <class S>
Vec3<S> first_direction_between(const Vec3<S>& center_a, const Vec3<S>& center_b) {
  return center_a == center_b ? Options<S>{}.first_direction : Vec3<S>(center_b - center_a);
}

/// Proof of separation: every point w of the difference has w·direction <= support_value < 0.
///
/// In floating point it is a proof where support_value < -6ε(r(A) + r(B)). Here ε is the scalar's epsilon. With d, the
/// direction, r is the largest |x d.x| + |y d.y| + |z d.z| of the points (x, y, z) of a set. Sets that are nearer to each
/// other may be found a rounding error apart.
///
/// The reason, with u = ε/2 and r(w) <= r(A) + r(B), and but for terms of u²:
///  1. w = a - b is off by a factor 1 ± u in each component.
///  2. Its product with d has three products and two sums. It is off by 3u r(w).
///  3. So support_value differs from (a - b)·d by at most 4u r(w).
///  4. a was found by comparing such products, each off by 3u r(A) at most. So no point of A reaches farther than a by
///     more than 6u r(A). Likewise for B.
///  5. Together that is 10u (r(A) + r(B)) = 5ε (r(A) + r(B)). The sixth ε is for what is left out.
///
/// This holds for point sets whose products neither overflow nor vanish. Other shapes add the error of the points that
/// they compute.
template <class S>
struct Separation {
  Vec3<S> direction;
  Vertex<S> vertex;  ///< the farthest one, not necessarily part of the simplex: vertex.w·direction = support_value
  S support_value;
  friend bool operator==(const Separation&, const Separation&) = default;
};

template <class S>
struct Result {
  Status status = Status::undecided;
  Reason reason = Reason::iteration_limit;
  int iterations = 0;                       ///< how many times each of the two support functions was called
  Simplex<S> simplex;                       ///< the last one; the claim is that it contains the origin, if intersecting
  std::optional<Separation<S>> separation;  ///< present exactly when separated
  std::optional<int> cycle_start;  ///< present exactly at a cycle: the next iteration would begin as this one did
  friend bool operator==(const Result&, const Result&) = default;
};

constexpr std::string_view to_string(Status status) {
  switch (status) {
    case Status::intersecting: return "intersecting";
    case Status::separated: return "separated";
    case Status::undecided: return "undecided";
  }
  return "";
}

constexpr std::string_view to_string(Reason reason) {
  switch (reason) {
    case Reason::simplex_contains_origin: return "simplex-contains-origin";
    case Reason::origin_not_crossed: return "origin-not-crossed";
    case Reason::no_new_vertex: return "no-new-vertex";
    case Reason::iteration_limit: return "iteration-limit";
    case Reason::cycle: return "cycle";
    case Reason::unusable_direction: return "unusable-direction";
  }
  return "";
}

}  // namespace gjk
