#include "tests/study/truth/oracle_round.hpp"

#include "tests/study/truth/round_numbers.hpp"

namespace study {
namespace {

Truth meeting(bool meet) { return meet ? Truth::intersecting : Truth::separated; }

/// Parallel axes: the distance of the axes, and the overlap along them.
bool parallel_meet(const Can& a, const Can& b, const RationalVec& d, std::size_t axis) {
  const Rational across = square(d[(axis + 1) % 3]) + square(d[(axis + 2) % 3]);
  return across <= square(fraction(a.radius) + fraction(b.radius)) &&
         2 * absolute(d[axis]) <= fraction(a.height) + fraction(b.height);
}

/// Axes at right angles. Cut square to the third direction at y, A is a rectangle: the width of its disc there, by its
/// height; so is B. They meet where b's stretch along b's axis comes within half the chord of A's disc of A's axis, and
/// the other way round. That leaves A with |y| <= √S, B with |y - d| <= √T.
bool crossed_meet(const Can& a, const Can& b, const RationalVec& d, std::size_t a_axis, std::size_t b_axis) {
  const Rational S = square(fraction(a.radius)) - square(beyond(d[b_axis], fraction(b.height) / 2));
  const Rational T = square(fraction(b.radius)) - square(beyond(d[a_axis], fraction(a.height) / 2));
  return S >= 0 && T >= 0 && roots_reach(S, T, square(d[3 - a_axis - b_axis]));
}

}  // namespace

Truth truth_of_round(const Ball& a, const Ball& b) {
  const RationalVec d = difference(a.center, b.center);
  return meeting(square(d[0]) + square(d[1]) + square(d[2]) <= square(fraction(a.radius) + fraction(b.radius)));
}

/// Seen along the axis the ball is a disc, cut where it is nearest to the cylinder's stretch.
Truth truth_of_round(const Ball& a, const Can& b) {
  const std::size_t axis = along(b);
  const RationalVec d = difference(a.center, b.center);
  const Rational across = square(d[(axis + 1) % 3]) + square(d[(axis + 2) % 3]);
  const Rational cut = square(fraction(a.radius)) - square(beyond(d[axis], fraction(b.height) / 2));
  return meeting(cut >= 0 && roots_reach(cut, square(fraction(b.radius)), across));
}

Truth truth_of_round(const Can& a, const Can& b) {
  const std::size_t a_axis = along(a), b_axis = along(b);
  const RationalVec d = difference(a.center, b.center);
  return meeting(a_axis == b_axis ? parallel_meet(a, b, d, a_axis) : crossed_meet(a, b, d, a_axis, b_axis));
}

}  // namespace study
