/// What the tests of the core share: the exact number, frames, shapes of any kind, runs, and dice.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <concepts>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "core/gjk.hpp"
#include "tests/kit/dice.hpp"

namespace gjk::test {

/// Exact: no rounding, no overflow, no underflow.
using Rational =
    boost::multiprecision::number<boost::multiprecision::cpp_rational_backend, boost::multiprecision::et_off>;

/// A point with integer coordinates.
using Point = std::array<int, 3>;
using Points = std::vector<Point>;

template <class S>
Vec3<S> vec(const Point& p) {
  return {S(p[0]), S(p[1]), S(p[2])};
}

template <class S>
PointSet<S> point_set(const Points& points) {
  std::vector<Vec3<S>> converted;
  for (const Point& p : points) converted.push_back(vec<S>(p));
  return PointSet<S>(converted);
}

inline PointSet<double> scaled(const Points& points, double scale) {
  std::vector<Vec3<double>> placed;
  for (const Point& p : points) placed.push_back(vec<double>(p) * scale);
  return PointSet<double>(placed);
}

inline Points moved(Points points, const Point& by) {
  for (Point& p : points)
    for (std::size_t i = 0; i < 3; ++i) p[i] += by[i];
  return points;
}

inline const Points cube{{-1, -1, -1}, {-1, -1, 1}, {-1, 1, -1}, {-1, 1, 1},
                         {1, -1, -1},  {1, -1, 1},  {1, 1, -1},  {1, 1, 1}};
inline const Points corner{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {0, 0, 6}};

/// Algorithm 5 takes the first face that sees the origin, and comes back to the same simplex for ever.
inline const Points cycling_apart_a{{-2, 3, 3}, {1, 3, 1}, {3, -2, -1}, {-4, -5, -2}};
inline const Points cycling_apart_b{{-1, 3, 2}, {0, 10, 4}, {8, 9, 0}};
inline const Points cycling_meeting_a{{274, -351, 0}, {95, -20, 0}, {104, 344, 0}, {346, 81, -2}};
inline const Points cycling_meeting_b{{70, 207, -1}, {-168, -26, 0}, {144, -198, -1}, {112, 1, 0}};

// -- Frames -----------------------------------------------------------------------------------------------------------

/// Where the unit vectors go, right-handed and of equal length, and a scale on top.
template <class S>
struct Frame {
  std::string name;
  Point x, y, z;
  S scale;

  Vec3<S> operator()(const Point& p) const {
    Vec3<S> image;
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      image[i] = scale * S(p[0] * x[k] + p[1] * y[k] + p[2] * z[k]);
    }
    return image;
  }
};

template <class S>
Frame<S> axis_aligned(const std::string& name, S scale) {
  return {"axis-aligned, " + name, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, scale};
}

/// A rotation about (1,-2,3) in integers: its columns are 15 long, so that nothing is rounded.
template <class S>
Frame<S> skew(const std::string& name, S scale) {
  return {"turned about (1,-2,3), " + name, {-11, 2, 10}, {-10, -5, -10}, {2, -14, 5}, scale};
}

template <class S>
std::vector<Frame<S>> frames() {
  const S thousand(1000), one(1), thousandth = one / thousand;
  return {axis_aligned("1e-3", thousandth), axis_aligned("1", one), axis_aligned("1e3", thousand),
          skew("1e-3", thousandth),         skew("1", one),         skew("1e3", thousand)};
}

/// Frames in which integers of one digit stay exact through every product of Algorithms 2-5. Floating point recognises
/// "exactly on" only there: products of askew edges are rounded.
template <class S>
std::vector<Frame<S>> frames_without_rounding() {
  return {axis_aligned("1/1024", S(1) / S(1024)), axis_aligned("1", S(1)), axis_aligned("1024", S(1024))};
}
template <>
inline std::vector<Frame<Rational>> frames_without_rounding() {
  return frames<Rational>();
}

template <class S>
std::vector<Vec3<S>> seen(const Points& points, const Frame<S>& frame) {
  std::vector<Vec3<S>> placed;
  for (const Point& p : points) placed.push_back(frame(p));
  return placed;
}

// -- Shapes of any kind, and runs -------------------------------------------------------------------------------------

/// A shape of any kind, so that a search is compiled once for all kinds. Refers to it. Throws where a direction breaks P1.
template <class S>
class AnyShape {
 public:
  template <class A>
  requires(!std::same_as<A, AnyShape> && Shape<A, S>) AnyShape(const A& shape)
      : shape_(&shape), support_([](const void* any, const Vec3<S>& d) -> SupportPoint<S> {
          return static_cast<const A*>(any)->support(d);
        }) {}

  SupportPoint<S> support(const Vec3<S>& d) const {
    if (!is_usable_direction(d)) throw std::logic_error("P1: the support function was given no direction");
    ++times_asked_;
    return support_(shape_, d);
  }
  int times_asked() const { return times_asked_; }

 private:
  const void* shape_;
  SupportPoint<S> (*support_)(const void*, const Vec3<S>&);
  mutable int times_asked_ = 0;
};

template <class S>
struct Run {
  Result<S> result;
  std::vector<Event<S>> events;
};

/// One step of Algorithms 2-5.
template <class S>
struct ToldStep {
  std::optional<Vec3<S>> direction;  ///< the next; empty where the simplex contains the origin
  std::vector<Event<S>> events;
};

/// What searches.cpp compiles, and for which scalars and rules it does.
template <class S, class Rules>
struct Searches {
  static Result<S> asked(const AnyShape<S>& a, const AnyShape<S>& b, const Options<S>& options);
  static Run<S> observed(const AnyShape<S>& a, const AnyShape<S>& b, const Options<S>& options);
  static ToldStep<S> step(Simplex<S>& simplex, CrossingTest crossing_test);
};

/// Returns: the answer of a plain run.
template <class S, class Rules = AsIntended>
Result<S> asked(const AnyShape<S>& a, const AnyShape<S>& b, const Options<S>& options = {}) {
  return Searches<S, Rules>::asked(a, b, options);
}
template <class S, class Rules = AsIntended>
Run<S> observed(const AnyShape<S>& a, const AnyShape<S>& b, const Options<S>& options = {}) {
  return Searches<S, Rules>::observed(a, b, options);
}
/// `simplex`: becomes what is kept of it.
template <class Rules = AsIntended, class S>
ToldStep<S> step(Simplex<S>& simplex, CrossingTest crossing_test = CrossingTest::on) {
  return Searches<S, Rules>::step(simplex, crossing_test);
}

template <class E, class S>
std::vector<E> events_of_kind(const std::vector<Event<S>>& events) {
  std::vector<E> found;
  for (const Event<S>& event : events)
    if (const E* e = std::get_if<E>(&event)) found.push_back(*e);
  return found;
}

template <class S>
Options<S> without_crossing_test() {
  Options<S> options;
  options.crossing_test = CrossingTest::off;
  return options;
}

template <class S>
std::vector<Vec3<S>> places(const Simplex<S>& simplex) {
  std::vector<Vec3<S>> points;
  for (int i = 0; i < simplex.size(); ++i) points.push_back(simplex[i].w);
  return points;
}

// -- Dice -------------------------------------------------------------------------------------------------------------

/// Points with integer coordinates no farther out than `reach` on each axis.
class Dice : public kit::Dice {
 public:
  using kit::Dice::Dice;
  Point point(int reach) { return {between(-reach, reach), between(-reach, reach), between(-reach, reach)}; }
  Points points(int count, int reach) {
    Points points;
    for (int i = 0; i < count; ++i) points.push_back(point(reach));
    return points;
  }
};

/// Two hulls of one to eight points, from crowded lattices (touching, flat, repeated points) to roomy ones.
struct PairOfHulls {
  Points a, b;
};
inline PairOfHulls random_pair(Dice& dice) {
  const int reach = dice.between(1, 3) * dice.between(1, 4);
  PairOfHulls pair{dice.points(dice.between(1, 8), reach), dice.points(dice.between(1, 8), reach)};
  pair.b = moved(pair.b, dice.point(reach));
  return pair;
}

}  // namespace gjk::test
