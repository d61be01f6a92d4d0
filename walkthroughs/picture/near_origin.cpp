#include "walkthroughs/picture/near_origin.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "render/length.hpp"
#include "walkthroughs/story/exact.hpp"

namespace walkthroughs::picture {
namespace {

using gjk::detail::Dyadic;

double rounded(const Dyadic& x) { return near(x, 0).value; }
Point rounded(const ExactPoint& p) { return {rounded(p.x), rounded(p.y), rounded(p.z)}; }

/// Lengths near 1, so that their products neither overflow nor vanish: divided by a power of two, which rounds nothing.
class Unit {
 public:
  Unit(std::initializer_list<Point> points) {
    double largest = 0;
    for (const Point& p : points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
    exponent_ = largest > 0 ? std::ilogb(largest) : 0;
  }
  Point in(const Point& p) const { return scaled(p, -exponent_); }
  Point out(const Point& p) const { return scaled(p, exponent_); }

 private:
  static Point scaled(const Point& p, int by) {
    return p.unaryExpr([by](double x) { return std::ldexp(x, by); });
  }
  int exponent_;
};

}  // namespace

// (P×Q)/|PQ| is the unit vector along PQ turned by a quarter, times the distance.
Point foot_on_line(const Point& P, const Point& Q) {
  if (P == Q) return P;
  const Unit unit{P, Q};
  const Point p = unit.in(P), q = unit.in(Q), along = q - p;
  return unit.out(along.stableNormalized().cross(rounded(cross(exact(p), exact(q))) / render::length_of(along)));
}

Point nearest_of_segment(const Point& P, const Point& Q) {
  const Point along = Q - P;
  if (!(along.dot(P) < 0)) return P;
  return along.dot(Q) > 0 ? foot_on_line(P, Q) : Q;
}

Point foot_on_plane(const Point& on, const Point& normal) {
  const Unit unit{on}, of_normal{normal};
  const Point n = of_normal.in(normal);
  return unit.out(n * (rounded(dot(exact(unit.in(on)), exact(n))) / n.squaredNorm()));
}

FootInTriangle foot_in_triangle(const Point& A, const Point& B, const Point& C) {
  const Unit unit{A, B, C};
  const Point a = unit.in(A), b = unit.in(B), c = unit.in(C), n = (b - a).cross(c - a);
  const Point foot = n * (rounded(dot(exact(a), cross(exact(b), exact(c)))) / n.squaredNorm());
  const auto is_within = [&](const Point& p, const Point& q) { return n.dot((q - p).cross(foot - p)) >= 0; };
  return {unit.out(foot), is_within(a, b) && is_within(b, c) && is_within(c, a)};
}

std::pair<Point, Point> part_near_origin(const Point& P, const Point& Q, double reach) {
  const Point foot = foot_on_line(P, Q), along = (Q - P).stableNormalized();
  const double at_P = along.dot(P - foot), at_Q = along.dot(Q - foot);
  if (at_P > reach || at_Q < -reach) return {P, Q};
  return {at_P < -reach ? Point(foot - along * reach) : P, at_Q > reach ? Point(foot + along * reach) : Q};
}

}  // namespace walkthroughs::picture
