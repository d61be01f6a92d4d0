/// Collision tests of points that a pose moves, of their sums, and of both grown by a ball: balls, boxes, capsules,
/// rounded boxes. They are exact: never wrong, never undecided. Needs what certified.hpp needs.
///
///     const gjk::Grown capsule({{{{0, 0, 0}, {0, 0, 2}}}}, 0.5);
///     const gjk::Grown box({{corners, {gjk::Quaternion{2, 1, 0, 0}, {0, 0, 3}}}});
///     const gjk::GrownResult result = gjk::certified_collision(capsule, box);
///
/// The first is a segment, grown by 0.5. The second is turned, then moved. The result has the answer and why: see
/// GrownResult. holds() of check_grown.hpp multiplies it out.
///
/// The assumptions are those of certified.hpp. The core of a grown set is the hull of its points, without the ball.
///  C10. Two grown sets meet where their cores are at most the sum of the radii apart. The exact fallback walks to the
///       feature of the difference of the cores that is nearest to the origin (C4). Then |v|² is compared with the
///       square of that sum. Each sign on the way is that of the exact number (C3).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include "../certificate.hpp"
#include "../shapes.hpp"
#include "dyadic.hpp"
#include "exact_fallback.hpp"
#include "usual_arithmetic.hpp"

namespace gjk {

using Matrix3 = Eigen::Matrix<double, 3, 3>;

/// p ↦ M p + t, not rounded. M is that matrix as it stands, be it a rotation or not, or that of the quaternion.
struct Motion {
  std::variant<Matrix3, Quaternion> turn = Matrix3(Matrix3::Identity());
  Vec3<double> translation = Vec3<double>::Zero();
};

struct MovedPoints {
  std::vector<Vec3<double>> points;  ///< at least one; finite
  Motion motion = {};                ///< of finite numbers
};

namespace detail {

// -- One set of points -----------------------------------------------------------------------------------------------

/// M p + t in numbers that do not round: all of it times one number above 0, the square of the quaternion.
class ExactMotion {
 public:
  explicit ExactMotion(const Motion& motion) {
    if (const auto* quaternion = std::get_if<Quaternion>(&motion.turn))
      turn_by(*quaternion);
    else
      for (int i = 0; i < 3; ++i) rows_[static_cast<std::size_t>(i)] = dyadic(std::get<Matrix3>(motion.turn).row(i));
    translation_ = divisor_ * dyadic(motion.translation);
  }

  Triple<Dyadic> operator()(const Vec3<double>& point) const {
    const Triple<Dyadic> p = dyadic(point);
    const auto& [x, y, z] = translation_;
    return {dot(rows_[0], p) + x, dot(rows_[1], p) + y, dot(rows_[2], p) + z};
  }
  const Dyadic& divisor() const { return divisor_; }

  /// `of_points`: the least exponent of their coordinates. Returns: one that no coordinate goes below.
  int least_exponent(int of_points) const {
    constexpr int none = std::numeric_limits<int>::max();
    int of_matrix = none, least = none;
    for (const Triple<Dyadic>& row : rows_) of_matrix = std::min(of_matrix, lesser_exponent(row));
    if (of_matrix != none && of_points != none) least = of_matrix + of_points;
    return std::min(least, lesser_exponent(translation_));
  }

  /// Returns: the least of those that are not 0.
  static int lesser_exponent(const Triple<Dyadic>& p) {
    int least = std::numeric_limits<int>::max();
    for (const Dyadic* x : {&p.x, &p.y, &p.z})
      if (x->m != 0) least = std::min(least, x->e);
    return least;
  }

 private:
  static Triple<Dyadic> dyadic(const auto& v) { return {v[0], v[1], v[2]}; }

  /// The rows of the matrix of a quaternion, times its square.
  void turn_by(const Quaternion& q) {
    const Dyadic w = q.w, x = q.x, y = q.y, z = q.z, two = 2;
    const Dyadic ww = w * w, xx = x * x, yy = y * y, zz = z * z;
    rows_ = {{{ww + xx - yy - zz, two * (x * y - w * z), two * (x * z + w * y)},
              {two * (x * y + w * z), ww - xx + yy - zz, two * (y * z - w * x)},
              {two * (x * z - w * y), two * (y * z + w * x), ww - xx - yy + zz}}};
    divisor_ = ww + xx + yy + zz;
  }

  std::array<Triple<Dyadic>, 3> rows_;
  Triple<Dyadic> translation_;
  Dyadic divisor_ = 1;
};

/// Points where their motion puts them. Doubles have them in a unit of their own, a power of two. It brings the largest
/// coordinate near 1.
class MovedSet {
 public:
  /// Errors: std::invalid_argument where the points are none, or numbers are not finite, or the quaternion is zero;
  /// std::runtime_error as certified_collision().
  explicit MovedSet(MovedPoints given)
      : given_(checked(std::move(given))), near_(is_at_rest(given_.motion) ? scaled() : moved()) {}

  const MovedPoints& given() const { return given_; }
  int size() const { return static_cast<int>(given_.points.size()); }

  /// In units of 2^unit().
  const PointSet<double>& near() const { return near_; }
  int unit() const { return unit_; }
  /// Returns: by how much their coordinates may be off.
  const Vec3<double>& error() const { return error_; }

  /// Returns: the square of the quaternion; 1 where there is none.
  Dyadic divisor() const { return motion_ ? motion_->divisor() : Dyadic(1); }
  /// Returns: that point times the divisor.
  Triple<Dyadic> exactly(std::size_t i) const {
    const Vec3<double>& p = given_.points[i];
    return motion_ ? moved_[i] : Triple<Dyadic>{p.x(), p.y(), p.z()};
  }
  /// Returns: an exponent that none of these goes below.
  int least_exponent() const {
    int of_points = std::numeric_limits<int>::max();
    for (const Vec3<double>& p : given_.points)
      for (const double x : p)
        if (x != 0) of_points = std::min(of_points, BinaryFraction(x).e);
    return motion_ ? motion_->least_exponent(of_points) : of_points;
  }

 private:
  static MovedPoints checked(MovedPoints given) {
    expect_usual_arithmetic();
    const auto is_finite = [](const Vec3<double>& p) { return p.allFinite(); };
    bool good =
        !given.points.empty() && std::ranges::all_of(given.points, is_finite) && is_finite(given.motion.translation);
    if (const auto* q = std::get_if<Quaternion>(&given.motion.turn))
      good = good && std::isfinite(q->w) && is_finite({q->x, q->y, q->z}) && *q != Quaternion{0, 0, 0, 0};
    else
      good = good && std::get<Matrix3>(given.motion.turn).allFinite();
    if (!good) throw std::invalid_argument("a set of moved points needs a point, finite numbers and a rotation");
    return given;
  }

  static bool is_at_rest(const Motion& motion) {
    const auto* matrix = std::get_if<Matrix3>(&motion.turn);
    return matrix && *matrix == Matrix3::Identity() && motion.translation == Vec3<double>::Zero();
  }

  PointSet<double> scaled() {
    double largest = 0;
    for (const Vec3<double>& p : given_.points) largest = std::max(largest, p.cwiseAbs().maxCoeff());
    if (largest != 0) unit_ = std::ilogb(largest);
    const PowerOfTwo scaled(-unit_);
    return all([&](const Vec3<double>& p, int i) { return scaled(p[i]); });
  }

  PointSet<double> moved() {
    motion_.emplace(given_.motion);
    moved_.reserve(given_.points.size());
    for (const Vec3<double>& p : given_.points) moved_.push_back((*motion_)(p));
    const auto unit_of = [](const std::vector<Triple<Dyadic>>& points) {
      std::optional<int> unit;
      for (const auto& [x, y, z] : points)
        for (const Dyadic* c : {&x, &y, &z})
          if (c->m != 0) unit = std::max(unit.value_or(exponent_of(*c)), exponent_of(*c));
      return unit.value_or(0);
    };
    // The divisor d and what it divides are off by 2u each, and the quotient by another u. A divisor that is 1 but for rounding is
    // one of these.
    const int of_divisor = exponent_of(motion_->divisor()), of_points = unit_of(moved_);
    const Bounded divisor = gjk::detail::near(motion_->divisor(), of_divisor);
    const bool is_one = divisor.value == 1 && divisor.error == 0;
    unit_ = of_points - of_divisor;
    auto point = moved_.begin();
    return all([&](const Vec3<double>&, int i) -> Bounded {
      const Triple<Dyadic>& p = i < 2 ? *point : *point++;
      const Bounded times_divisor = gjk::detail::near(i == 0 ? p.x : i == 1 ? p.y : p.z, of_points);
      if (is_one) return times_divisor;
      return {times_divisor.value / divisor.value, times_divisor.error + 4 * roundoff * std::abs(times_divisor.value)};
    });
  }

  /// `coordinate`: makes each in its turn. Returns: all points.
  template <class Coordinate>
  PointSet<double> all(const Coordinate& coordinate) {
    std::vector<Vec3<double>> points;
    points.reserve(given_.points.size());
    for (const Vec3<double>& p : given_.points) {
      Vec3<double>& q = points.emplace_back();
      for (int i = 0; i < 3; ++i) {
        const Bounded c = coordinate(p, i);
        q[i] = c.value;
        error_[i] = std::max(error_[i], c.error);
      }
    }
    return PointSet<double>(std::move(points));
  }

  MovedPoints given_;
  std::optional<ExactMotion> motion_;  // none where it is at rest
  std::vector<Triple<Dyadic>> moved_;  // by the motion, times the divisor
  int unit_ = 0;
  Vec3<double> error_ = Vec3<double>::Zero();
  PointSet<double> near_;
};

}  // namespace detail

// -- The shape -------------------------------------------------------------------------------------------------------

/// The Minkowski sum of sets of moved points and of balls around the origin.
///
/// Its points have numbers: those of each set in their order, the last set fastest. No list of them is ever made.
class Grown {
 public:
  static constexpr std::int64_t most_points = 1 << 30;

  /// `radius`: of the ball; no motion changes it.
  /// Requires: at least one set, and none without points; at most `most_points` sums of these. Finite numbers, no
  /// quaternion of zeros, no radius below 0.
  /// Errors: std::invalid_argument.
  explicit Grown(std::vector<MovedPoints> summands, double radius = 0)
      : Grown(std::move(summands), std::vector<double>{radius}) {}
  /// Of several balls, whose sum is not rounded.
  Grown(std::vector<MovedPoints> summands, std::vector<double> radii) : radii_(std::move(radii)) {
    for (const double radius : radii_)
      if (!(radius >= 0 && std::isfinite(radius)))
        throw std::invalid_argument("a grown set needs a finite radius that is not negative");
    std::int64_t points = 1;
    sets_.reserve(summands.size());
    for (MovedPoints& each : summands) {
      const auto size = static_cast<std::int64_t>(each.points.size());
      if (size > most_points || (points *= std::max(size, std::int64_t{1})) > most_points)
        throw std::invalid_argument("a grown set has too many points");
      sets_.emplace_back(std::move(each));
    }
    if (sets_.empty()) throw std::invalid_argument("a grown set needs at least one set of points");
  }
  /// Of numbers that doubles hold.
  template <class S>
  requires(std::same_as<S, float> || std::same_as<S, double>) explicit Grown(const PointSet<S>& points,
                                                                             double radius = 0)
      : Grown(at_rest(points.points()), radius) {}
  template <class S>
  requires(std::same_as<S, float> || std::same_as<S, double>) explicit Grown(const Sphere<S>& ball)
      : Grown(at_rest<S>({ball.center()}), static_cast<double>(ball.radius())) {}

  const std::vector<detail::MovedSet>& sets() const { return sets_; }
  const std::vector<double>& radii() const { return radii_; }

 private:
  template <class S>
  static std::vector<MovedPoints> at_rest(const std::vector<Vec3<S>>& points) {
    std::vector<MovedPoints> one(1);
    one[0].points.reserve(points.size());
    for (const Vec3<S>& p : points) one[0].points.push_back(p.template cast<double>());
    return one;
  }

  std::vector<detail::MovedSet> sets_;
  std::vector<double> radii_;
};

struct GrownResult {
  Status status = Status::undecided;  ///< never that, once it is returned
  /// The certificate, by the numbers of points of both cores. One to three points of their difference span the feature
  /// that is nearest to the origin. One to four hold the origin, where the cores themselves meet.
  IndexPairs nearest;
  int iterations = 0;
  friend bool operator==(const GrownResult&, const GrownResult&) = default;
};

namespace detail {

// -- The difference of the cores -------------------------------------------------------------------------------------

/// The difference of two cores, as the exact fallback asks it: see ExactDifference. It is the sum of all of their sets,
/// those of b with their sign changed. Doubles are in a unit that brings the largest coordinate or radius near 1. Whole numbers
/// are times the squares of all quaternions and a power of two.
class GrownDifference {
 public:
  using Scalar = double;

  /// One of the sets.
  struct Term {
    const MovedSet* set;
    int sign;
    PowerOfTwo scaled;   ///< from its own unit
    Vec3<double> error;  ///< in the common unit
    Dyadic times = 1;    ///< the squares of the quaternions of other sets; for whole numbers
  };

  GrownDifference(const Grown& a, const Grown& b) : a_(a), b_(b), of_a_(a.sets().size()) {
    std::optional<int> unit;
    const auto make_room = [&unit](int other) { unit = std::max(unit.value_or(other), other); };
    for (const Grown* grown : {&a, &b}) {
      for (const MovedSet& set : grown->sets()) make_room(set.unit());
      for (const double radius : grown->radii())
        if (radius != 0) make_room(std::ilogb(radius));
    }
    unit_ = *unit;
    terms_.reserve(of_a_ + b.sets().size());
    for (const MovedSet& set : a.sets()) terms_.push_back(term(set, +1));
    for (const MovedSet& set : b.sets()) terms_.push_back(term(set, -1));
  }

  template <class N>
  Triple<N> w(IndexPair pair) const {
    Triple<N> sum{};
    bool is_first = true;
    for_each_set(pair, [&](const Term& term, int i, int sign) {
      const Triple<N> p = point<N>(term, i);
      sum = is_first ? (sign > 0 ? p : -p) : sign > 0 ? sum - -p : sum - p;
      is_first = false;
      return i;
    });
    return sum;
  }
  template <class N>
  Triple<N> point(const Term& term, int i) const {
    const auto index = static_cast<std::size_t>(i);
    if constexpr (std::same_as<N, Bounded>) {
      const Vec3<double>& p = term.set->near().points()[index];
      const auto coordinate = [&](int axis) {
        Bounded c = term.scaled(p[axis]);
        if (term.error[axis] != 0) c.error += term.error[axis];
        return c;
      };
      return {coordinate(0), coordinate(1), coordinate(2)};
    } else {
      const int least = least_exponent();
      const auto [x, y, z] = term.set->exactly(index);
      return {(term.times * x).over_power(least), (term.times * y).over_power(least),
              (term.times * z).over_power(least)};
    }
  }
  /// Returns: the sum of the radii.
  template <class N>
  N reach() const {
    if constexpr (std::same_as<N, Bounded>) {
      const PowerOfTwo scaled(-unit_);
      Bounded sum;
      for_each_radius([&](double radius) { sum = sum + scaled(radius); });
      return sum;
    } else {
      const int least = least_exponent();
      Dyadic sum;
      for_each_radius([&](double radius) { sum = sum + radius; });
      return (divisor_ * sum).over_power(least);
    }
  }
  /// Nobody is told.
  Powers powers(int) const { return {}; }

  template <class Look>
  IndexPair for_each_set(IndexPair pair, Look&& look) const {
    return {for_each_set(0, of_a_, pair.a, look), for_each_set(of_a_, terms_.size(), pair.b, look)};
  }
  static const PointSet<double>& scanned(const Term& term) { return term.set->near(); }
  /// In the unit of the set. Both points may be off.
  static double slack(const Term& term, const Vec3<double>& along, const Vec3<double>& doubt) {
    return doubt.dot(term.set->near().extent()) + 2.5 * along.cwiseAbs().dot(term.set->error()) +
           8 * std::numeric_limits<double>::denorm_min();
  }

 private:
  Term term(const MovedSet& set, int sign) const {
    const PowerOfTwo scaled(set.unit() - unit_);
    Vec3<double> error = Vec3<double>::Zero();
    for (int i = 0; i < 3; ++i)
      if (set.error()[i] != 0) error[i] = scaled(set.error()[i]).value * (1 + 8 * roundoff) + 1e-300;
    return {&set, sign, scaled, error};
  }

  /// Of the terms from `first` on, before `last`. `number`: of a point of their sum.
  int for_each_set(std::size_t first, std::size_t last, int number, auto& look) const {
    if (last == first + 1) return look(terms_[first], number, terms_[first].sign);
    int place = 1, found = 0;
    for (std::size_t k = last; k-- > first;) {
      const int size = terms_[k].set->size();
      found += place * look(terms_[k], number % size, terms_[k].sign);
      number /= size;
      place *= size;
    }
    return found;
  }

  template <class Use>
  void for_each_radius(const Use& use) const {
    for (const Grown* grown : {&a_, &b_}) std::for_each(grown->radii().begin(), grown->radii().end(), use);
  }

  /// The whole numbers are known from here on.
  int least_exponent() const {
    if (least_exponent_) return *least_exponent_;
    std::vector<const MovedSet*> turned;  // one for each quaternion
    const auto quaternion = [](const MovedSet& set) { return std::get_if<Quaternion>(&set.given().motion.turn); };
    for (const Term& term : terms_) {
      const auto* q = quaternion(*term.set);
      if (q && std::ranges::none_of(turned, [&](const MovedSet* other) { return *quaternion(*other) == *q; }))
        turned.push_back(term.set);
    }
    for (const MovedSet* set : turned) divisor_ = divisor_ * set->divisor();
    int least = std::numeric_limits<int>::max();
    const auto make_room = [&](const Dyadic& factor, int exponent) {
      if (exponent != std::numeric_limits<int>::max()) least = std::min(least, factor.e + exponent);
    };
    for (Term& term : terms_) {
      const auto* own = quaternion(*term.set);
      for (const MovedSet* set : turned)
        if (!own || *quaternion(*set) != *own) term.times = term.times * set->divisor();
      make_room(term.times, term.set->least_exponent());
    }
    for_each_radius([&](double radius) {
      if (radius != 0) make_room(divisor_, BinaryFraction(radius).e);
    });
    least_exponent_ = least;
    return least;
  }

  const Grown &a_, &b_;
  std::size_t of_a_;  // so many of the terms
  int unit_ = 0;
  mutable std::vector<Term> terms_;
  mutable Dyadic divisor_ = 1;  // of all that is a whole number
  mutable std::optional<int> least_exponent_;
};

/// Requires: the feature of the difference that is nearest to the origin. v is the nearest point of it.
/// Returns: whether |v| is at most the sum of the radii. Both sides are squared and multiplied by the square of what
/// v's distance is measured along. For an edge |AB×AO|² is |v|²|AB|². For a triangle (ABCn·AO)² is |v|²|ABCn|².
inline bool is_within_reach(const ExactSimplex<GrownDifference>& nearest, const GrownDifference& difference) {
  const auto excess = [&]<class N>(const FromA<N>& A) {
    const N reach = difference.reach<N>(), reach_squared = reach * reach;
    const auto &AO = A.AO, &AB = A[Role::B];
    if (nearest.size() == 1) return dot(AO, AO) - reach_squared;
    const Triple<N> across = cross(AB, nearest.size() == 2 ? AO : A[Role::C]);
    if (nearest.size() == 2) return dot(across, across) - reach_squared * dot(AB, AB);
    const N height = dot(across, AO);
    return height * height - reach_squared * dot(across, across);
  };
  return nearest.sign(excess) <= 0;
}

}  // namespace detail

/// Do they have a point in common? The answer is exact (C10). Touching is intersecting.
///
/// Returns: the answer with its certificate. Never undecided. Errors: std::runtime_error as certified_collision() of
/// sets of points.
inline GrownResult certified_collision(const Grown& a, const Grown& b) {
  detail::expect_usual_arithmetic();
  const detail::GrownDifference difference(a, b);
  detail::ExactSimplex simplex(difference);
  GrownResult result;
  result.status = Status::intersecting;
  for (std::optional<IndexPair> next = IndexPair{}; next;) {
    ++result.iterations;
    simplex.add(*next);
    simplex.keep(nearest_with_A(simplex, simplex.size()));
    if (simplex.contains_origin()) break;
    next = detail::AlongDirection(difference, simplex).vertex_nearer();
    if (!next && !is_within_reach(simplex, difference)) result.status = Status::separated;
  }
  result.nearest = simplex.vertices();
  return result;
}

}  // namespace gjk
