#include "tests/study/truth/proofs.hpp"

#include <algorithm>
#include <stdexcept>

#include "tests/study/truth/round_numbers.hpp"

namespace study {
namespace {

RationalVec exact(const Vec& v) { return {fraction(v[0]), fraction(v[1]), fraction(v[2])}; }

Rational dot(const RationalVec& u, const RationalVec& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

RationalVec plus(const RationalVec& u, const RationalVec& v, const Rational& times = 1) {
  return {u[0] + times * v[0], u[1] + times * v[1], u[2] + times * v[2]};
}

Rational sign(const Rational& x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }

// -- How far a body reaches -------------------------------------------------------------------------------------------

/// The largest p·d of a body: rational + √root_squared.
struct Reach {
  Rational rational, root_squared = 0;
};

Reach reach(const Points& points, const RationalVec& d) {
  Rational most = dot(exact(points.at(0)), d);
  for (const Vec& p : points) most = std::max(most, dot(exact(p), d));
  return {most};
}

Reach reach(const Ball& ball, const RationalVec& d) {
  return {dot(exact(ball.center), d), square(fraction(ball.radius)) * dot(d, d)};
}

Reach reach(const Can& can, const RationalVec& d) {
  const std::size_t axis = along(can);
  const Rational across = dot(d, d) - square(d[axis]);
  return {dot(exact(can.center), d) + fraction(can.height) / 2 * absolute(d[axis]),
          square(fraction(can.radius)) * across};
}

Reach reach(const Body& body, const RationalVec& d) {
  return std::visit([&](const auto& shape) { return reach(shape, d); }, body);
}

// -- Which bodies hold a point ----------------------------------------------------------------------------------------

bool holds_point(const Points& points, const RationalVec& point) { return hull_contains(points, point); }

bool holds_point(const Ball& ball, const RationalVec& point) {
  const RationalVec d = plus(point, exact(ball.center), -1);
  return dot(d, d) <= square(fraction(ball.radius));
}

bool holds_point(const Can& can, const RationalVec& point) {
  const std::size_t axis = along(can);
  const RationalVec d = plus(point, exact(can.center), -1);
  return 2 * absolute(d[axis]) <= fraction(can.height) && dot(d, d) - square(d[axis]) <= square(fraction(can.radius));
}

// -- Where round bodies are apart, and where they meet ----------------------------------------------------------------

/// Returns: √x, rounded down to so many binary digits after the point.
Rational root(const Rational& x, unsigned digits) {
  using Whole = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
  const Whole unit = Whole(1) << digits;
  const Whole floor = numerator(x) * unit * unit / denominator(x);
  return Rational(Whole(sqrt(floor)), unit);
}

/// Two cylinders whose axes are at right angles: along i and j, and k across both. Seen from A's center B's axis comes as
/// near as u along j, and seen from B's center A's axis as near as v along i: there A's disc has half a chord of √S, B's of √T.
struct Crossed {
  std::size_t i, j, k;
  RationalVec d;  ///< from the center of A to that of B
  Rational u, v, S, T;

  Crossed(const Can& a, const Can& b) : i(along(a)), j(along(b)), k(3 - i - j), d(difference(b.center, a.center)) {
    u = sign(d[j]) * beyond(d[j], fraction(b.height) / 2);
    v = -sign(d[i]) * beyond(d[i], fraction(a.height) / 2);
    S = square(fraction(a.radius)) - u * u;
    T = square(fraction(b.radius)) - v * v;
  }
};

/// The normals of both discs where they come nearest agree with it.
RationalVec direction_between(const Crossed& c, unsigned digits) {
  RationalVec direction{0, 0, 0};
  if (c.S <= 0) direction[c.j] = sign(c.d[c.j]);
  if (c.S > 0 && c.T <= 0) direction[c.i] = sign(c.d[c.i]);
  if (c.S <= 0 || c.T <= 0) return direction;
  const Rational s = root(c.S, digits), t = root(c.T, digits);
  if (s == 0 || t == 0) return direction;  // more digits are needed
  direction[c.k] = sign(c.d[c.k]);
  direction[c.j] = c.u / s;
  direction[c.i] = -c.v / t;
  return direction;
}

/// In the middle of where both chords are, seen along k.
RationalVec common_point(const Crossed& c, const Can& a, const Can& b, unsigned digits) {
  const Rational s = root(c.S, digits), t = root(c.T, digits);
  const Rational least = std::max(Rational(-s), Rational(c.d[c.k] - t)), most = std::min(s, Rational(c.d[c.k] + t));
  RationalVec point = exact(a.center);
  point[c.i] = fraction(b.center[static_cast<Eigen::Index>(c.i)]) + c.v;
  point[c.j] += c.u;
  point[c.k] += (least + most) / 2;
  return point;
}

RationalVec direction_between(const Ball& a, const Ball& b, unsigned) { return difference(b.center, a.center); }

RationalVec direction_between(const Can& a, const Can& b, unsigned digits) {
  const std::size_t axis = along(a);
  if (axis != along(b)) return direction_between(Crossed(a, b), digits);
  RationalVec d = difference(b.center, a.center);
  if (2 * absolute(d[axis]) <= fraction(a.height) + fraction(b.height)) {
    d[axis] = 0;
    return d;
  }
  RationalVec along_axis{0, 0, 0};
  along_axis[axis] = sign(d[axis]);
  return along_axis;
}

/// On the way from center to center, as the radii divide it.
RationalVec common_point(const Ball& a, const Ball& b, unsigned) {
  const Rational radius = fraction(a.radius);
  return plus(exact(a.center), difference(b.center, a.center), radius / (radius + fraction(b.radius)));
}

RationalVec common_point(const Can& a, const Can& b, unsigned digits) {
  const std::size_t axis = along(a);
  if (axis != along(b)) return common_point(Crossed(a, b), a, b, digits);
  RationalVec point = common_point(Ball{a.center, a.radius}, Ball{b.center, b.radius}, digits);
  const auto k = static_cast<Eigen::Index>(axis);
  const Rational a_half = fraction(a.height) / 2, b_half = fraction(b.height) / 2;
  point[axis] = (std::max(Rational(fraction(a.center[k]) - a_half), Rational(fraction(b.center[k]) - b_half)) +
                 std::min(Rational(fraction(a.center[k]) + a_half), Rational(fraction(b.center[k]) + b_half))) /
                2;
  return point;
}

/// Returns: the first that proves what it should, of some with more and more digits.
template <class Find, class Proves>
RationalVec proven(const Pair& pair, const Find& find, const Proves& proves) {
  for (const unsigned digits : {16U, 64U, 256U, 1024U}) {
    const auto found = [&](const auto& a, const auto& b) -> RationalVec {
      if constexpr (std::same_as<decltype(a), decltype(b)> && !std::same_as<decltype(a), const Points&>)
        return find(a, b, digits);
      else
        throw std::invalid_argument("only of two balls or two cylinders");
    };
    const RationalVec vector = std::visit(found, pair.a, pair.b);
    if (proves(vector)) return vector;
  }
  throw std::logic_error("no fractions prove what the oracle says of these two");
}

}  // namespace

/// min B > max A: rational parts apart by more than both roots.
bool separates(const RationalVec& d, const Pair& pair) {
  const Reach a = reach(pair.a, d), b = reach(pair.b, {-d[0], -d[1], -d[2]});
  const Rational room = -b.rational - a.rational;
  return room > 0 && !roots_reach(a.root_squared, b.root_squared, square(room));
}

bool contains(const Body& body, const RationalVec& point) {
  return std::visit([&](const auto& shape) { return holds_point(shape, point); }, body);
}

bool only_touch(const Pair& pair) {
  if (const auto* a = std::get_if<Points>(&pair.a), *b = std::get_if<Points>(&pair.b); a && b)
    return hulls_only_touch(*a, *b);
  const auto *a = std::get_if<Ball>(&pair.a), *b = std::get_if<Ball>(&pair.b);
  if (!a || !b) return false;
  const RationalVec d = difference(a->center, b->center);
  return dot(d, d) == square(fraction(a->radius) + fraction(b->radius));
}

RationalVec direction_between(const Pair& round) {
  return proven(
      round, [](const auto& a, const auto& b, unsigned digits) { return direction_between(a, b, digits); },
      [&](const RationalVec& d) { return separates(d, round); });
}

RationalVec common_point(const Pair& round) {
  return proven(
      round, [](const auto& a, const auto& b, unsigned digits) { return common_point(a, b, digits); },
      [&](const RationalVec& point) { return contains(round.a, point) && contains(round.b, point); });
}

}  // namespace study
