/// Answers that are never wrong and never undecided: the signs of C3, and pairs that plain numbers get wrong. Every answer brings
/// its certificate, which is multiplied out here.
#include "core/certified/certified.hpp"

#include <limits>
#include <map>
#include <tuple>

#include "tests/core/certified_support.hpp"
#include "tests/core/oracle.hpp"

namespace gjk::test {
namespace certified_test {

/// What a change makes of both sets.
template <class S, class Change>
Pair<S> changed(const Pair<S>& pair, const Change& change) {
  const auto all = [&](const PointSet<S>& set) {
    std::vector<Vec3<S>> points;
    for (const Vec3<S>& p : set.points()) points.push_back(Vec3<S>(change(p)));
    return PointSet<S>(points);
  };
  return {all(pair.a), all(pair.b)};
}

/// One to five points each, of a lattice so crowded that many touch, are flat, or are repeated.
template <class S>
Pair<S> crowded_pair(Dice& dice) {
  const Points a = dice.points(dice.between(1, 5), 2), b = dice.points(dice.between(1, 5), 2);
  return pair_of<S>(a, b);
}

// -- C3 ---------------------------------------------------------------------------------------------------------------

constexpr int whole_range = 1100;  // costly: fractions of doubles are thousands of digits long

/// Of a few digits, times a power of two between 2^-`reach` and 2^`reach` that others are likely to share.
template <class S>
S wild_number(Dice& dice, int reach) {
  constexpr int least = std::numeric_limits<S>::min_exponent - std::numeric_limits<S>::digits,
                most = std::numeric_limits<S>::max_exponent - 2;
  const std::array exponents{0, 0, 0, 1, -20, 20, -reach / 2, reach / 2, -reach, reach, reach - 30};
  const int exponent = exponents[static_cast<std::size_t>(dice.between(0, 10))];
  return std::scalbn(static_cast<S>(dice.between(-3, 3)), std::clamp(exponent, least, most));
}
template <class S>
std::vector<Vec3<S>> wild_points(Dice& dice, int reach) {
  std::vector<Vec3<S>> points(static_cast<std::size_t>(dice.between(1, 5)));
  for (Vec3<S>& p : points)
    for (S& x : p) x = wild_number<S>(dice, reach);
  return points;
}
template <class S>
Pair<S> wild_pair(Dice& dice, int reach = 60) {
  const std::vector<Vec3<S>> a = wild_points<S>(dice, reach), b = wild_points<S>(dice, reach);
  return pair_of<S>(a, b);
}

/// Lattices, each axis times a power of two of its own: on one a direction has what is lost when it is made a float.
template <class S>
Pair<S> stretched_pair(Dice& dice, int reach) {
  constexpr int least = std::numeric_limits<S>::min_exponent - std::numeric_limits<S>::digits,
                most = std::numeric_limits<S>::max_exponent - 2;
  std::array<int, 3> exponents;
  for (int& exponent : exponents) exponent = std::clamp(dice.between(-reach, reach), least, most);
  return changed(crowded_pair<S>(dice), [&](const Vec3<S>& p) {
    return Vec3<S>(std::scalbn(p.x(), exponents[0]), std::scalbn(p.y(), exponents[1]),
                   std::scalbn(p.z(), exponents[2]));
  });
}
/// All within few digits of one point: a scan cannot tell which is farther.
template <class S>
Pair<S> clustered_pair(Dice& dice) {
  const Vec3<S> center = vec<S>(dice.point(99)) / S(100) + Vec3<S>(2, -2, 2);
  return changed(crowded_pair<S>(dice),
                 [&](const Vec3<S>& p) { return Vec3<S>(center + p * std::numeric_limits<S>::epsilon()); });
}
/// Coordinates that are a few of the least number: most of what a scan multiplies is lost.
template <class S>
Pair<S> denormal_pair(Dice& dice) {
  return changed(crowded_pair<S>(dice),
                 [](const Vec3<S>& p) { return Vec3<S>(p * std::numeric_limits<S>::denorm_min()); });
}
template <class S>
Pair<S> hard_pair(Dice& dice, int i) {
  const int reach = i % 64 < 4 ? whole_range : 60;
  switch (i % 4) {
    case 0: return wild_pair<S>(dice, reach);
    case 1: return stretched_pair<S>(dice, std::same_as<S, float> ? 150 : reach);
    case 2: return clustered_pair<S>(dice);
    default: return denormal_pair<S>(dice);
  }
}

template <class S>
ExactVec exact_w(const Pair<S>& pair, IndexPair i) {
  return exact(pair.a.points()[static_cast<std::size_t>(i.a)]) - exact(pair.b.points()[static_cast<std::size_t>(i.b)]);
}
template <class S>
std::vector<IndexPair> all_pairs(const Pair<S>& pair) {
  std::vector<IndexPair> all;
  for (int i = 0; i < static_cast<int>(pair.a.points().size()); ++i)
    for (int j = 0; j < static_cast<int>(pair.b.points().size()); ++j) all.push_back({i, j});
  return all;
}

/// Looks along the direction from some simplex of one to three points of the difference: it is known how far each point is.
/// Returns: whether there was such a direction.
template <class S>
bool compare_along(const Pair<S>& pair, Dice& dice) {
  const std::vector<IndexPair> all = all_pairs(pair);
  const detail::ExactDifference<S> difference(pair.a, pair.b);
  detail::ExactSimplex simplex(difference);
  ExactVecs corners;
  for (int i = dice.between(1, 3); i > 0; --i) {
    simplex.add(all[static_cast<std::size_t>(dice.between(0, static_cast<int>(all.size()) - 1))]);
    corners.push_back(exact_w(pair, simplex.vertices()[simplex.size() - 1]));
  }
  if (gram_determinant(corners) == 0) return false;
  const ExactVec d = toward_origin(corners);
  if (d == ExactVec(ExactVec::Zero())) return false;
  const detail::AlongDirection along(difference, simplex);
  bool is_any_across = false;
  for (const IndexPair w : all) {
    const int expected = exact_w(pair, w).dot(d).sign();
    REQUIRE(along.sign(w) == expected);
    is_any_across |= expected >= 0;
  }
  const std::optional<IndexPair> found = along.vertex_across();
  REQUIRE(found.has_value() == is_any_across);
  if (found) REQUIRE(exact_w(pair, *found).dot(d) >= 0);
  return true;
}

TEMPLATE_TEST_CASE("C3: the sign of w·d is the exact one, and no point across the origin is missed", "[certified]",
                   float, double) {
  using S = TestType;
  Dice dice(71);
  int compared = 0;
  for (int i = 0; i < 1600; ++i) {
    INFO("pair " << i);
    compared += compare_along(hard_pair<S>(dice, i), dice);
  }
  REQUIRE(compared > 800);
}

/// Returns: what lies across the origin from the difference of the points with these numbers and the first of b.
template <class S>
std::optional<IndexPair> across_from(const Pair<S>& pair, std::initializer_list<int> points) {
  const detail::ExactDifference<S> difference(pair.a, pair.b);
  detail::ExactSimplex simplex(difference);
  for (const int i : points) simplex.add({i, 0});
  return detail::AlongDirection(difference, simplex).vertex_across();
}

TEST_CASE("C3: where a float loses what a direction has along y, twice that is allowed for", "[certified]") {
  const auto at = [](float x, float y) { return Vec3<float>(x * 0x1p-60F, y * 0x1p100F, 0); };
  // x + 5y in these units is the reach: -1 of the segment, -15.5 of the next, which a scan of x alone finds, 14 of the last.
  const auto pair = pair_of<float>({at(-1, 0), at(-6, 1), at(-0.5F, -3), at(-1, 3)}, {at(0, 0)});
  REQUIRE(across_from(pair, {1, 0}) == IndexPair{3, 0});
}

TEMPLATE_TEST_CASE("C3: a scan adds up the largest numbers without overflow", "[certified]", float, double) {
  using S = TestType;
  using V = Vec3<S>;
  const S most = std::numeric_limits<S>::max();
  // Along (1,1,1) the second point reaches less far than b, the third farther, the sum of y and z of the second farthest.
  for (const auto& [second, third, b] : {std::tuple(0.5, 0.53, 0.172), std::tuple(0.6, 0.8, 0.2326)}) {
    const S y = most * static_cast<S>(second);
    const auto pair = pair_of<S>({V(0, 0, 0), V(-y, y, y), V(most * static_cast<S>(third), 0, 0)},
                                 {V(1, 1, 1) * (most * static_cast<S>(b))});
    REQUIRE(across_from(pair, {0}) == IndexPair{2, 0});
  }
  // All components of direction and point are the largest: their sum is three times as much.
  const auto at = [&](double share) { return V(V(1, 1, 1) * (most * static_cast<S>(share))); };
  REQUIRE(across_from(pair_of<S>({at(0), at(0.96), at(1)}, {at(0.98)}), {0}) == IndexPair{2, 0});
}

TEMPLATE_TEST_CASE("Bounded numbers have their largest coordinate near 1, and no error but what underflowed",
                   "[certified]", float, double) {
  using S = TestType;
  using V = Vec3<S>;
  for (const S size : {std::numeric_limits<S>::max(), S(3e5), S(1), S(1e-5), std::numeric_limits<S>::denorm_min()}) {
    const PointSet<S> large({V(0, -size, size / 3)}), small({V(0, 0, 0), V(size / 4, 0, 0)});
    for (const auto& [a, b] : {std::pair(large, small), std::pair(small, large)}) {
      const detail::ExactDifference<S> difference(a, b);
      const detail::Triple<detail::Bounded> p = difference.template point<detail::Bounded>(large, 0);
      REQUIRE((-2 < p.y.value && p.y.value <= -1));
      REQUIRE((p.x.value == 0 && p.x.error == 0 && p.y.error == 0 && p.z.error == 0));
    }
  }
}

// -- Right answers ----------------------------------------------------------------------------------------------------

// Each is right where its certificate holds, which proven() looks at.

TEMPLATE_TEST_CASE("Point sets of a crowded lattice are proven, in each way", "[certified]", float, double) {
  using S = TestType;
  Dice dice(72);
  std::map<Status, int> seen;
  std::map<Proof, int> proofs;
  for (int i = 0; i < 800; ++i) {
    const Pair<S> pair = crowded_pair<S>(dice);
    INFO("pair " << i);
    const CertifiedResult result = proven(pair);
    ++seen[result.status];
    ++proofs[result.proof];
  }
  REQUIRE(seen[Status::intersecting] > 200);
  REQUIRE(seen[Status::separated] > 200);
  REQUIRE(proofs[Proof::direction] > 50);
  REQUIRE(proofs[Proof::tetrahedron] > 20);
  REQUIRE(proofs[Proof::exact_fallback] > 100);
}

TEMPLATE_TEST_CASE(
    "Sets of wild, stretched, clustered and denormal points are proven, also of so many that they are asked in blocks",
    "[certified]", float, double) {
  using S = TestType;
  Dice dice(73);
  for (int i = 0; i < 400; ++i) {
    INFO("pair " << i);
    const Pair<S> pair = hard_pair<S>(dice, i);
    const Status status = proven(pair).status;
    if (i % 64 < 4) continue;  // costly
    std::vector<Vec3<S>> b = pair.b.points();
    b.insert(b.begin(), 20, b.back());
    REQUIRE(proven(pair_of<S>(b, pair.a.points())).status == status);
  }
}

TEMPLATE_TEST_CASE("Equal sets, and single points, are together exactly where they have a point in common",
                   "[certified]", float, double) {
  using S = TestType;
  using V = Vec3<S>;
  constexpr S most = std::numeric_limits<S>::max(), least = std::numeric_limits<S>::denorm_min();
  for (const V& p : {V(0, 0, 0), V(1, 2, 3), V(least, 0, 0), V(-least, least, 0), V(most, -most, most),
                     V(most, least, 1), V(S(0.1), S(0.2), S(0.3))}) {
    INFO("p = " << p.transpose());
    REQUIRE(proven(pair_of<S>({p}, {p})).status == Status::intersecting);
    REQUIRE(proven(pair_of<S>({p, -p}, {p, -p})).status == Status::intersecting);
    REQUIRE(proven(pair_of<S>({p, V(1, 0, 0), V(0, 1, 0), V(0, 0, 1)}, {p})).status == Status::intersecting);
    for (int i = 0; i < 3; ++i) {
      V near_p = p;
      near_p[i] = std::nextafter(p[i], S(1));
      if (near_p[i] == p[i]) near_p[i] = below(p[i]);
      REQUIRE(proven(pair_of<S>({p}, {near_p})).status == Status::separated);
      REQUIRE(proven(pair_of<S>({near_p}, {p})).status == Status::separated);
      REQUIRE(proven(pair_of<S>({p, near_p}, {near_p})).status == Status::intersecting);
    }
  }
}

// -- C5 ---------------------------------------------------------------------------------------------------------------

enum class Mistake {
  inward,   ///< the normals of a triangle and of one face point to the other side
  rash,     ///< triangles and tetrahedra hold the origin wherever it is
  backward  ///< what did not reach the origin counts as having crossed it
};
struct Wrong : AsIntended {
  static inline Mistake mistake = Mistake::inward;
  static bool is(Mistake one) { return mistake == one; }

  static auto ABCn_of_triangle(const auto& AB, const auto& AC) {
    return is(Mistake::inward) ? AC.cross(AB) : AB.cross(AC);
  }
  static auto ACDn(const auto& AC, const auto& AD) { return is(Mistake::inward) ? AD.cross(AC) : AC.cross(AD); }
  static bool is_beyond_edge(const auto& x) { return !is(Mistake::rash) && AsIntended::is_beyond_edge(x); }
  static Side side_of_triangle(const auto& x) {
    return is(Mistake::rash) ? Side::above : AsIntended::side_of_triangle(x);
  }
  static bool is_above_face(const auto& x) { return !is(Mistake::rash) && AsIntended::is_above_face(x); }
  static bool crossed(const auto& w_d) { return is(Mistake::backward) ? w_d.is_negative() : AsIntended::crossed(w_d); }
};

std::vector<Options<double>> odd_options() {
  constexpr double least = std::numeric_limits<double>::denorm_min();
  std::vector<Options<double>> all(7);
  all[1].iteration_limit = 0;
  all[2].iteration_limit = 1;
  all[3].crossing_test = CrossingTest::off;
  all[4].first_direction = Vec3<double>(least, 0, -least);
  all[5].first_direction = Vec3<double>(0, std::numeric_limits<double>::max(), 1);
  all[6].first_direction = Vec3<double>(0, 0, 0);
  return all;
}

TEST_CASE("C5: the answer is proven with wrong rules, and with any options", "[certified]") {
  Dice dice(80);
  for (const Mistake mistake : {Mistake::inward, Mistake::rash, Mistake::backward}) {
    Wrong::mistake = mistake;
    int second_searches = 0;
    for (int i = 0; i < 60; ++i) {
      const Pair<double> pair = i % 3 > 0 ? crowded_pair<double>(dice) : wild_pair<double>(dice);
      for (const Options<double>& options : odd_options()) {
        INFO("pair " << i << ", limit " << options.iteration_limit << ", d " << options.first_direction.transpose());
        const auto result = examined(certified_collision<double, Wrong>(pair.a, pair.b, options), pair);
        second_searches += result.proof == Proof::exact_fallback;
      }
    }
    REQUIRE(second_searches > 100);
  }
}

/// Wrong: both objects are asked in the same direction.
struct SameDirection : Intended<> {
  template <class S, class A, class B>
  struct Difference {
    const A& a;
    const B& b;
    Vertex<S> vertex(const Vec3<S>& d) const {
      return {a.support(d), b.support(d), a.support(d).point - b.support(d).point};
    }
  };
  template <class S, class A, class B>
  static Difference<S, A, B> difference(const A& a, const B& b) {
    return {a, b};
  }
};

template <class Rules>
concept MayGuess = requires(const PointSet<double>& set) {
  certified_collision<double, Rules>(set, set);
};

TEST_CASE("C5: rules that ask another difference for its farthest points are not taken", "[certified]") {
  STATIC_REQUIRE(MayGuess<AsIntended>);
  STATIC_REQUIRE(MayGuess<Wrong>);
  STATIC_REQUIRE_FALSE(MayGuess<SameDirection>);
}

// -- Which proof ------------------------------------------------------------------------------------------------------

TEMPLATE_TEST_CASE(
    "Sets clearly apart are proven by the direction that the first search found, deep ones by its tetrahedron",
    "[certified]", float, double) {
  for (const Point& by : {Point{4, 5, 6}, Point{2, 1, 1}}) {
    const Pair<TestType> pair = pair_of<TestType>(corner, moved(corner, by));
    const CertifiedResult result = proven(pair);
    const Result<TestType> plain = asked<TestType>(pair.a, pair.b);
    REQUIRE(result.status == plain.status);
    REQUIRE(result.iterations == plain.iterations);
    REQUIRE(result.fallback_iterations == 0);
    if (plain.separation) {
      REQUIRE(result.proof == Proof::direction);
      const SeparatingDirection found{plain.separation->direction.template cast<double>()};
      REQUIRE(result.certificate == Certificate(found));
    } else {
      REQUIRE(result.proof == Proof::tetrahedron);
      IndexPairs corners;
      for (int i = 0; i < 4; ++i) corners.add({*plain.simplex[i].a.index, *plain.simplex[i].b.index});
      REQUIRE(result.certificate == Certificate(CommonSimplex{corners}));
    }
  }
}

}  // namespace certified_test
}  // namespace gjk::test
