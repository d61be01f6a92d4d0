/// The exact fallback of certified.hpp, a search for the min-norm point (Wolfe 1976). It walks to the feature of the
/// difference of two sets of points that is nearest to the origin, or into the origin. Each of its decisions is exact
/// (C3, C4).
///
/// Signs are taken of doubles that know their error (dynamic error bounds). Where that leaves a doubt they are taken of
/// whole numbers. Needs Eigen and Boost.Multiprecision.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "../certificate.hpp"
#include "../nearest.hpp"
#include "boost_whole_numbers.hpp"
#include "bounded.hpp"
#include "dyadic.hpp"
#include "telling.hpp"
#include "usual_arithmetic.hpp"

namespace gjk::detail {

/// Multiplies doubles by a power of two. One double may not hold it, and std::scalbn() is slow.
class PowerOfTwo {
 public:
  explicit PowerOfTwo(int exponent)
      : factors_{std::scalbn(1.0, exponent / 2), std::scalbn(1.0, exponent - exponent / 2)} {}

  /// Requires: of a product that is not far above 1, so that the error covers what underflow loses.
  Bounded operator()(double x) const {
    const double value = x * factors_[0] * factors_[1];
    return {value, std::abs(value) < 0x1p-960 && x != 0 ? 1e-300 : 0.0};  // it may have lost digits
  }

 private:
  std::array<double, 2> factors_;
};

/// Two sets of points and the points of their difference, in either kind of number. Whole numbers are the coordinates
/// times one power of two. Doubles are the coordinates times another, which brings the largest near 1: so no polynomial
/// overflows. Floats are widened.
///
/// The search asks no more of a difference than what stands here. That of grown.hpp is another.
template <class S>
class ExactDifference {
 public:
  using Scalar = S;

  ExactDifference(const PointSet<S>& a, const PointSet<S>& b)
      : a_(a), b_(b), exponent_(exponent_for(a.extent().cwiseMax(b.extent()).maxCoeff())), scaled_(exponent_) {}

  const PointSet<S>& a() const { return a_; }
  const PointSet<S>& b() const { return b_; }
  /// Returns: the exponent of the power of two with which bounded numbers are multiplied.
  int exponent() const { return exponent_; }

  template <class N>
  Triple<N> w(IndexPair pair) const {
    return point<N>(a_, pair.a) - point<N>(b_, pair.b);
  }
  template <class N>
  Triple<N> point(const PointSet<S>& set, int i) const {
    const Vec3<S>& p = set.points()[static_cast<std::size_t>(i)];
    return {number<N>(p.x()), number<N>(p.y()), number<N>(p.z())};
  }
  /// Returns: that point as a search in S has it.
  Vertex<S> vertex(IndexPair pair) const {
    const auto support_point = [](const PointSet<S>& set, int i) {
      return SupportPoint<S>{set.points()[static_cast<std::size_t>(i)], i};
    };
    Vertex<S> vertex{support_point(a_, pair.a), support_point(b_, pair.b), {}};
    vertex.w = vertex.a.point - vertex.b.point;
    return vertex;
  }
  Simplex<S> simplex(const IndexPairs& pairs) const {
    Simplex<S> simplex;
    for (const IndexPair pair : pairs) simplex.add(vertex(pair));
    return simplex;
  }

  // -- As a search along a direction asks

  /// Calls look(set, index, sign) for both sets: their sum, each with its sign, is the difference. `pair`: numbers one
  /// point of each. Returns: what they return, as such a pair.
  template <class Look>
  IndexPair for_each_set(IndexPair pair, Look&& look) const {
    return {look(a_, pair.a, +1), look(b_, pair.b, -1)};
  }
  /// Returns: the points that doubles are multiplied with to find the farthest of a set.
  static const PointSet<S>& scanned(const PointSet<S>& set) { return set; }
  /// Returns: how much farther than one of these another may truly be. `along`: the direction. `doubt`: how far its
  /// components may mislead, for coordinates of 1.
  static double slack(const PointSet<S>& set, const Vec3<S>&, const Vec3<double>& doubt) {
    return doubt.dot(set.extent().template cast<double>()) +
           8 * static_cast<double>(std::numeric_limits<S>::denorm_min());
  }

  /// Returns: the powers of two with which a polynomial of that degree is multiplied where it is computed. That of
  /// whole numbers is known once whole numbers were made.
  Powers powers(int degree) const { return {degree * exponent_, least_exponent_ ? -degree * *least_exponent_ : 0}; }

  /// Requires: a coordinate.
  template <class N>
  N number(S coordinate) const {
    const double x = static_cast<double>(coordinate);
    if constexpr (std::same_as<N, Bounded>) {
      return scaled_(x);
    } else {
      return Dyadic(x).over_power(least_exponent());
    }
  }

 private:
  static int exponent_for(S largest) { return largest == S(0) ? 0 : -std::ilogb(static_cast<double>(largest)); }

  int least_exponent() const {
    if (!least_exponent_) {
      int least = std::numeric_limits<int>::max();
      const auto look_at = [&least](const Vec3<S>& v) {
        for (const S x : v)
          if (x != 0) least = std::min(least, BinaryFraction(static_cast<double>(x)).e);
      };
      for (const PointSet<S>* set : {&a_, &b_}) std::for_each(set->points().begin(), set->points().end(), look_at);
      least_exponent_ = least;
    }
    return *least_exponent_;
  }

  const PointSet<S>&a_, &b_;
  int exponent_;
  PowerOfTwo scaled_;
  mutable std::optional<int> least_exponent_;
};

/// The vectors from A, the newest vertex of a simplex, to the origin and to the others.
template <class N>
struct FromA {
  Triple<N> AO{};
  std::array<Triple<N>, 4> to{};  ///< by role; of A nothing

  const Triple<N>& operator[](Role X) const { return to[static_cast<std::size_t>(X)]; }
};

/// −v times a positive factor. v is the point nearest to the origin of the hull of at most three vertices, and lies in
/// its interior. `side`: of the triangle, on which the origin lies.
template <class N>
Triple<N> toward_origin(const FromA<N>& A, int size, int side) {
  const auto &AO = A.AO, &AB = A[Role::B];
  if (size == 1) return AO;
  if (size == 2) return dot(AB, AB) * AO - dot(AB, AO) * AB;  // (AB×AO)×AB
  const Triple<N> ABCn = cross(AB, A[Role::C]);
  return side > 0 ? ABCn : -ABCn;
}

/// A simplex, by the indices of its vertices, that tells where the origin is. The whole numbers are made where the
/// first sign is in doubt.
template <class Difference, class Obs = const NobodyListens>
class ExactSimplex {
 public:
  using Tell = FallbackTeller<typename Difference::Scalar, Obs>;

  explicit ExactSimplex(const Difference& difference, const Tell& tell = Tell())
      : difference_(difference), tell_(tell) {}

  const IndexPairs& vertices() const { return vertices_; }
  int size() const { return vertices_.size(); }

  /// Makes it the newest.
  void add(IndexPair vertex) {
    vertices_.add(vertex);
    bounded_ = from_A<Bounded>();
    whole_.reset();
    if constexpr (tells) tell_.name_anew();
  }
  /// Requires: A is kept, and last.
  void keep(const Roles& order) {
    IndexPairs kept;
    for (const Role role : order) kept.add(vertices_[size() - 1 - static_cast<int>(role)]);
    vertices_ = kept;
    bounded_ = only(bounded_, order, size());
    if (whole_) whole_ = only(*whole_, order, size());
    if constexpr (tells) tell_.keep(order);
  }

  /// C3. `polynomial`: of the vectors from A, in either kind of number, of degree `degree`.
  /// `words`: makes what is told of it.
  /// Returns: −1, 0 or 1. The sign is taken of doubles that know their error where that leaves no doubt. Where there is
  /// a doubt it is taken of whole numbers.
  template <class Polynomial, class Words>
  int sign(const Polynomial& polynomial, int degree, const Words& words) const {
    const Bounded quick = polynomial(bounded_);
    if (quick.has_certain_sign()) {
      tell_.sign(words, difference_.powers(degree), quick, nullptr);
      return sign_of(quick);
    }
    const Whole exact = polynomial(whole());
    tell_.sign(words, difference_.powers(degree), quick, &exact);
    return sign_of(exact);
  }
  /// The sign of a polynomial that is not told.
  template <class Polynomial>
  int sign(const Polynomial& polynomial) const {
    const Bounded quick = polynomial(bounded_);
    return quick.has_certain_sign() ? sign_of(quick) : sign_of(polynomial(whole()));
  }

  const Tell& tell() const { return tell_; }

  // -- As nearest_with_A() asks

  bool is_toward(Role X) const {
    return sign([=](const auto& A) { return dot(A[X], A.AO); }, 2, [&] { return product(tell_.edge(X), AO); }) > 0;
  }
  bool is_beyond(Role X, Role Y) const {
    const auto AXn_AO = [=](const auto& A) {
      return dot(A[X], A.AO) * dot(A[X], A[Y]) - dot(A[Y], A.AO) * dot(A[X], A[X]);
    };
    return sign(AXn_AO, 4, [&] { return product(tell_.normal(X), AO, tell_.face(X, Y)); }) >= 0;
  }
  bool is_above(Role X, Role Y, Role Z) const {
    const int of_origin = side_of_origin(X, Y);
    const auto AXYn_AZ = [=](const auto& A) { return dot(cross(A[X], A[Y]), A[Z]); };
    const int of_fourth = sign(AXYn_AZ, 3, [&] { return product(tell_.normal(X, Y), tell_.edge(Z)); });
    return of_origin * of_fourth < 0;
  }

  /// Returns: the sign of AXYn·AO.
  int side_of_origin(Role X, Role Y) const {
    const auto AXYn_AO = [=](const auto& A) { return dot(cross(A[X], A[Y]), A.AO); };
    return sign(AXYn_AO, 3, [&] { return product(tell_.normal(X, Y), AO); });
  }

  /// Requires: the point of the simplex nearest to the origin lies in its interior. Returns: whether that point is the
  /// origin.
  bool contains_origin() const {
    switch (size()) {
      case 1:
        return is_zero([](const auto& A) { return A.AO; }, 1,
                       [](int axis) { return Expression(Expression::Form::component, AO, {}, axis); });
      case 2:
        return is_zero([](const auto& A) { return cross(A[Role::B], A.AO); }, 2,
                       [&](int axis) {
                         return Expression(Expression::Form::component_of_product, tell_.edge(Role::B), AO, axis);
                       });
      case 3: return side_of_origin(Role::B, Role::C) == 0;
      default: return true;
    }
  }

  /// Returns: the words for toward_origin(), in the letters from before the others were dropped.
  Expression words_of_direction() const {
    if (size() == 1) return AO;
    if (size() == 2) return {Expression::Form::triple, tell_.edge(Role::B), AO};
    const NamedVector ABCn = tell_.normal(Role::B, Role::C);
    return {side_of_origin(Role::B, Role::C) > 0 ? Expression::Form::vector : Expression::Form::negative, ABCn};
  }
  /// Returns: the degree of the polynomials that the components of that direction are.
  int degree_of_direction() const { return size() == 2 ? 3 : size() == 3 ? 2 : 1; }

  template <class N>
  Triple<N> toward_origin() const {
    const int side = size() == 3 ? side_of_origin(Role::B, Role::C) : 0;
    if constexpr (std::same_as<N, Bounded>)
      return detail::toward_origin(bounded_, size(), side);
    else
      return detail::toward_origin(whole(), size(), side);
  }

 private:
  static constexpr bool tells = Tell::somebody_listens;

  static SignWords product(const NamedVector& X, const NamedVector& Y, const Roles& face = {}) {
    return {{Expression::Form::dot, X, Y}, face};
  }

  /// `component`: what the component of an axis is called.
  template <class VectorOf, class Component>
  bool is_zero(const VectorOf& vector_of, int degree, const Component& component) const {
    return sign([&](const auto& A) { return vector_of(A).x; }, degree, [&] { return SignWords{component(0)}; }) == 0 &&
           sign([&](const auto& A) { return vector_of(A).y; }, degree, [&] { return SignWords{component(1)}; }) == 0 &&
           sign([&](const auto& A) { return vector_of(A).z; }, degree, [&] { return SignWords{component(2)}; }) == 0;
  }

  const FromA<Whole>& whole() const {
    if (!whole_) whole_ = from_A<Whole>();
    return *whole_;
  }

  template <class N>
  FromA<N> from_A() const {
    const Triple<N> A = difference_.template w<N>(vertices_[size() - 1]);
    FromA<N> vectors;
    vectors.AO = -A;
    for (int i = 1; i < size(); ++i)
      vectors.to[static_cast<std::size_t>(i)] = difference_.template w<N>(vertices_[size() - 1 - i]) - A;
    return vectors;
  }
  template <class N>
  static FromA<N> only(const FromA<N>& all, const Roles& order, int size) {
    FromA<N> kept;
    kept.AO = all.AO;
    int i = size;
    for (const Role role : order) kept.to[static_cast<std::size_t>(--i)] = all[role];
    return kept;
  }

  const Difference& difference_;
  Tell tell_;
  IndexPairs vertices_;
  FromA<Bounded> bounded_;
  mutable std::optional<FromA<Whole>> whole_;
};

/// A vector of whole numbers times 2^-cut, so that the largest has 60 bits at most.
struct HighestBits {
  Triple<Bounded> vector;
  unsigned cut;
};

/// What is cut off is less than 1. Doubles round what is left by half a step, which is u of its power of two. Half a
/// step plus 1 is a double. So the sum made here, where it is rounded, is no less.
inline HighestBits highest_bits(const Triple<Whole>& d) {
  const auto bits = [](const Whole& x) { return x == 0 ? 0U : static_cast<unsigned>(msb(abs(x))) + 1; };
  const unsigned most = std::max({bits(d.x), bits(d.y), bits(d.z)}), cut = most > 60 ? most - 60 : 0;
  const auto number = [cut](const Whole& x) {
    const double size = static_cast<double>(static_cast<std::int64_t>(Whole(abs(x)) >> cut));
    return Bounded{x < 0 ? -size : size, 1 + roundoff * size};
  };
  return {{number(d.x), number(d.y), number(d.z)}, cut};
}

/// Looks for points of the difference along a direction that is known exactly: that from a simplex toward the origin.
template <class Difference, class Obs = const NobodyListens>
class AlongDirection {
  using S = typename Difference::Scalar;

 public:
  AlongDirection(const Difference& difference, const ExactSimplex<Difference, Obs>& from)
      : difference_(difference),
        from_(from),
        bounded_(from.template toward_origin<Bounded>()),
        power_(difference.powers(from.degree_of_direction()).bounded) {
    if (!is_precise(bounded_)) {
      const HighestBits highest = highest_bits(whole());
      bounded_ = highest.vector;
      power_ = difference.powers(from.degree_of_direction()).whole - static_cast<int>(highest.cut);
    }
    aim();
    from_.tell()([&] { return DirectionChosen<S>{.expression = from_.words_of_direction(), .direction = told()}; });
  }

  /// C3. Returns: the sign of w·d.
  int sign(IndexPair vertex) const {
    const Bounded quick = reach(vertex);
    if (quick.has_certain_sign()) return tell(vertex, "w·d", quick), sign_of(quick);
    const Whole exact = dot(difference_.template w<Whole>(vertex), whole());
    return tell(vertex, "w·d", quick, &exact), sign_of(exact);
  }

  /// Returns: w·d, and its error.
  Bounded reach(IndexPair vertex) const { return dot(difference_.template w<Bounded>(vertex), bounded_); }

  /// Returns: a point of the difference with w·d >= 0, not always the support point. None where there is none.
  std::optional<IndexPair> vertex_across() const {
    const IndexPair found = near_farthest();
    from_.tell()([&] { return SupportFound<S>{.direction = told(), .vertex = difference_.vertex(found)}; });
    const Bounded w_d = reach(found);
    if (w_d.has_certain_sign() && w_d.value >= 0) return tell(found, "w·d", w_d), found;
    const int power = exponent_ + difference_.exponent();
    const double most = std::scalbn(w_d.value + w_d.error, -power);
    const double missed = slack(difference_.a()) + slack(difference_.b());
    if (most < -missed)
      return tell(found, "max w·d", {w_d.value, w_d.error + std::scalbn(missed, power)}), std::nullopt;
    const IndexPair farthest = farthest_beside(found);
    const Whole exact = dot(difference_.template w<Whole>(farthest), whole());
    const Bounded most_reach = reach(farthest);
    tell(farthest, "max w·d", {most_reach.value, most_reach.error + std::scalbn(missed, power)}, &exact);
    return sign_of(exact) >= 0 ? std::optional(farthest) : std::nullopt;
  }

  /// Returns: a point of the difference nearer to the origin than all of the simplex, (w − A)·d > 0. None where there
  /// is none.
  std::optional<IndexPair> vertex_nearer() const {
    const IndexPair found = near_farthest();
    if (is_nearer(found)) return found;
    const Candidates candidates = candidates_beside(found);
    if (candidates.sums > most_candidates) {
      const IndexPair farthest = farthest_beside(found);
      return is_nearer(farthest) ? std::optional(farthest) : std::nullopt;
    }
    for (int i = 0; i < candidates.sums; ++i)
      if (const IndexPair pair = candidate(candidates, i, found); is_nearer(pair)) return pair;
    return std::nullopt;
  }

 private:
  /// Along d the vertices of the simplex reach equally far, for d is perpendicular to all of its edges.
  bool is_nearer(IndexPair vertex) const {
    const IndexPairs& vertices = from_.vertices();
    if (std::find(vertices.begin(), vertices.end(), vertex) != vertices.end()) return false;
    const IndexPair A = vertices[from_.size() - 1];
    const auto nearer = [&]<class N>(const Triple<N>& d) {
      return dot(difference_.template w<N>(vertex) - difference_.template w<N>(A), d);
    };
    const Bounded quick = nearer(bounded_);
    return (quick.has_certain_sign() ? sign_of(quick) : sign_of(nearer(whole()))) > 0;
  }

  /// The points of each set of which one may be the farthest, in the order in which the sets are looked at.
  struct Candidates {
    std::vector<std::vector<int>> of_sets;
    int sums = 1;
  };
  /// To compare so many sums in doubles takes less time than to compare a few points exactly.
  static constexpr int most_candidates = 64;

  Candidates candidates_beside(IndexPair found) const {
    Candidates all;
    difference_.for_each_set(found, [&](const auto& set, int near_farthest, int sign) {
      std::vector<int>& candidates = all.of_sets.emplace_back(1, near_farthest);
      for_each_candidate(set, near_farthest, sign, [&](int i) {
        if (candidates.size() <= most_candidates) candidates.push_back(i);
      });
      all.sums = std::min(all.sums * static_cast<int>(candidates.size()), most_candidates + 1);
      return near_farthest;
    });
    return all;
  }
  IndexPair candidate(const Candidates& candidates, int number, IndexPair found) const {
    std::size_t k = 0;
    return difference_.for_each_set(found, [&](const auto&, int, int) {
      const std::vector<int>& of_set = candidates.of_sets[k++];
      const int i = number % static_cast<int>(of_set.size());
      number /= static_cast<int>(of_set.size());
      return of_set[static_cast<std::size_t>(i)];
    });
  }

  void tell(IndexPair vertex, const Expression& what, const Bounded& w_d, const Whole* exact = nullptr) const {
    if constexpr (ExactSimplex<Difference, Obs>::Tell::somebody_listens)
      from_.tell().sign([&] { return SignWords{what}; },
                        {power_ + difference_.exponent(), difference_.powers(from_.degree_of_direction() + 1).whole},
                        w_d, exact, difference_.vertex(vertex));
  }

  /// Returns: the direction in which the support functions are asked. What it was divided by is undone, where that is
  /// exact.
  Vec3<S> told() const {
    const Vec3<S> own = rough_.unaryExpr([this](S x) { return std::scalbn(x, exponent_ - power_); });
    const auto is_kept = [](S before, S after) { return before == 0 || std::isnormal(after); };
    return is_kept(rough_.x(), own.x()) && is_kept(rough_.y(), own.y()) && is_kept(rough_.z(), own.z()) ? own : rough_;
  }

  IndexPair near_farthest() const {
    return difference_.for_each_set({}, [this](const auto& set, int, int sign) {
      return *difference_.scanned(set).support(sign > 0 ? rough_ : Vec3<S>(-rough_)).index;
    });
  }
  IndexPair farthest_beside(IndexPair found) const {
    return difference_.for_each_set(
        found, [this](const auto& set, int near_farthest, int sign) { return farthest_of(set, near_farthest, sign); });
  }

  static std::array<Bounded, 3> components(const Triple<Bounded>& d) { return {d.x, d.y, d.z}; }

  static bool is_precise(const Triple<Bounded>& d) {
    double largest = 0, error = 0;
    for (const Bounded& c : components(d)) {
      largest = std::max(largest, std::abs(c.value));
      error = std::max(error, c.error);
    }
    return error < 0x1p-20 * largest;
  }

  /// Makes the direction in which the support functions are asked. It is so small that none of their products
  /// overflows. Also computes how far the support functions may be off.
  ///
  /// Let p be a point, and p* the one that was found. p·d − p*·d is at most the sum of
  ///  - 2Σ r|d − rough|;
  ///  - two roundings of p·rough in the scan, 6uΣ r|rough|;
  ///  - as much again where candidates are compared in doubles: 12u, and 16u with what is rounded here;
  ///  - what underflows in a scan: at most three times half the least denormal number, twice.
  void aim() {
    double largest = 0;
    for (const Bounded& c : components(bounded_)) largest = std::max(largest, std::abs(c.value));
    exponent_ = std::ilogb(largest) + 3;
    int i = 0;
    for (const Bounded& c : components(bounded_)) {
      rough_[i] = static_cast<S>(std::scalbn(c.value, -exponent_));
      const double lost = std::abs(c.value - std::scalbn(static_cast<double>(rough_[i]), exponent_));
      doubt_[i] =
          2 * std::scalbn(lost + c.error, -exponent_) + 16 * roundoff_of<S> * std::abs(static_cast<double>(rough_[i]));
      ++i;
    }
  }

  /// Returns: by how much some point of the set may lie farther along d than the one that its support function finds.
  double slack(const auto& set) const { return difference_.slack(set, rough_, doubt_); }

  /// Calls use(i) for each other point of the set that may lie as far along d (where `toward` is −1, along −d) as the
  /// point found by its support function.
  void for_each_candidate(const auto& set, int near_farthest, int toward, auto&& use) const {
    const auto& points = difference_.scanned(set).points();
    const Vec3<double> along = toward * rough_.template cast<double>();
    const auto roughly = [&](int i) { return points[static_cast<std::size_t>(i)].template cast<double>().dot(along); };
    const double enough = roughly(near_farthest) - slack(set);
    for (int i = 0; i < static_cast<int>(points.size()); ++i)
      if (i != near_farthest && !(roughly(i) < enough)) use(i);  // what is not a number is looked at
  }

  /// Returns: the support point of the set along d (where `toward` is −1, along −d), exactly.
  /// `near_farthest`: the point found by its support function.
  int farthest_of(const auto& set, int near_farthest, int toward) const {
    const auto exactly = [&](int i) {
      const Whole reach = dot(difference_.template point<Whole>(set, i), whole());
      return toward > 0 ? reach : Whole(-reach);
    };
    int farthest = near_farthest;
    std::optional<Whole> most;  // of one that is alone it is not asked
    for_each_candidate(set, near_farthest, toward, [&](int i) {
      if (!most) most = exactly(farthest);
      const Whole here = exactly(i);
      if (here > *most) {
        most = here;
        farthest = i;
      }
    });
    return farthest;
  }

  const Triple<Whole>& whole() const {
    if (!whole_) whole_ = from_.template toward_origin<Whole>();
    return *whole_;
  }

  const Difference& difference_;
  const ExactSimplex<Difference, Obs>& from_;
  Triple<Bounded> bounded_;
  int power_;  // of two, with which bounded_ is multiplied
  mutable std::optional<Triple<Whole>> whole_;
  Vec3<S> rough_;       // d, times 2^-exponent_
  Vec3<double> doubt_;  // how far the components of rough_ may mislead, for coordinates of 1
  int exponent_ = 0;
};

/// Walks to the feature of the difference that is nearest to the origin, or into the origin. Each vertex that it adds
/// brings it nearer (C4). Each decision is exact (C3). `offered`: at least one vertex, to begin with; good ones save
/// scans.
template <class S, class Obs>
[[gnu::noinline]] void decide_exactly(const PointSet<S>& a, const PointSet<S>& b, const IndexPairs& offered,
                                      Teller<Obs>& tell, CertifiedResult& result) {
  const ExactDifference<S> difference(a, b);
  ExactSimplex<ExactDifference<S>, Obs> simplex(difference, FallbackTeller<S, Obs>(tell));
  IndexPair next = offered[0];
  while (true) {
    tell.enter_iteration(result.iterations + ++result.fallback_iterations);
    simplex.add(next);
    tell([&] { return VertexAdded<S>{.simplex = difference.simplex(simplex.vertices())}; });
    const IndexPairs before = simplex.vertices();
    const Roles order = nearest_with_A(simplex, simplex.size());
    simplex.keep(order);
    const bool contains_origin = simplex.contains_origin();
    tell([&] { return kept<S>(difference.simplex(before), order, contains_origin); });
    if (contains_origin) {
      result.status = Status::intersecting;
      result.certificate = CommonSimplex{simplex.vertices()};
      return;
    }
    const AlongDirection along(difference, simplex);
    const auto is_nearer = [&](IndexPair p, IndexPair q) { return along.reach(p).value < along.reach(q).value; };
    next = *std::max_element(offered.begin(), offered.end(), is_nearer);
    if (along.sign(next) >= 0) continue;
    const std::optional<IndexPair> found = along.vertex_across();
    if (!found) {
      result.status = Status::separated;
      result.certificate = SeparatingFeature{simplex.vertices()};
      return;
    }
    next = *found;
  }
}

}  // namespace gjk::detail
