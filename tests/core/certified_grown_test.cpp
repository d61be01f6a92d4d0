/// C10: certified_collision() of grown sets, against distances in fractions and against what is true by construction.
/// Every certificate is multiplied out.
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/certified/check_grown.hpp"
#include "core/certified/grown.hpp"
#include "tests/core/certified_support.hpp"
#include "tests/core/oracle.hpp"
#include "tests/core/support.hpp"
#include "tests/kit/catch.hpp"
#include "tests/kit/dice.hpp"

namespace gjk::test {
namespace certified_grown_test {
namespace {

constexpr auto apart = Status::separated, together = Status::intersecting;

/// Returns: the answer. Requires, as all answers must be: its certificate holds.
GrownResult proven(const Grown& a, const Grown& b) {
  const GrownResult result = certified_collision(a, b);
  REQUIRE(holds(result, a, b));
  return result;
}

/// Of balls and sets of points.
Status certified_status(const auto& a, const auto& b) { return proven(Grown(a), Grown(b)).status; }

/// Returns: the square of the distance of the origin from the hull of some points: the least over all their subsets whose
/// point nearest to it, on the line or plane through them, is a combination without a weight below 0.
Rational squared_distance_of_hull(const ExactVecs& points) {
  Rational least = -1;
  for (unsigned subset = 1; subset < 1U << points.size(); ++subset) {
    ExactVecs some;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (subset >> i & 1U) some.push_back(points[i]);
    if (some.size() > 4 || gram_determinant(some) == 0) continue;
    const auto weights = coordinates_of_origin(some);
    const Rational squared = toward_origin(some).squaredNorm();
    const bool is_inside = std::ranges::all_of(weights, [](const Rational& w) { return w >= 0; });
    if (is_inside && (least < 0 || squared < least)) least = squared;
  }
  return least;
}

template <class S>
ExactVecs seen_from(const Sphere<S>& ball, const PointSet<S>& points) {
  ExactVecs differences = exact(points.points());
  for (ExactVec& w : differences) w -= exact(ball.center());
  return differences;
}

}  // namespace

TEMPLATE_TEST_CASE("Two balls meet where their centers are at most the sum of their radii apart, exactly",
                   "[certified]", float, double) {
  using S = TestType;
  Dice dice(1);
  int touching = 0;
  for (int i = 0; i < 5000; ++i) {
    const auto point = [&] { return vec<S>(dice.point(6)); };
    const Sphere<S> a(point(), static_cast<S>(dice.between(1, 6)));
    const Sphere<S> b(point(), static_cast<S>(dice.between(1, 4)) + (i % 2 ? std::scalbn(S(1), -15) : S(0)));
    const ExactVec way = exact(a.center()) - exact(b.center());
    const Rational reach = Rational(a.radius()) + Rational(b.radius());
    INFO("pair " << i);
    touching += way.dot(way) == reach * reach;
    REQUIRE(certified_status(a, b) == (way.dot(way) <= reach * reach ? together : apart));
    REQUIRE(certified_status(b, a) == certified_status(a, b));
  }
  REQUIRE(touching > 10);
}

TEMPLATE_TEST_CASE("A ball and a set of points meet where its center is at most a radius from their hull, exactly",
                   "[certified]", float, double) {
  using S = TestType;
  Dice dice(2);
  int touching = 0, inside = 0;
  for (int i = 0; i < 1500; ++i) {
    std::vector<Vec3<S>> list;
    for (int more = dice.between(1, 6); more > 0; --more) list.push_back(vec<S>(dice.point(3)));
    const PointSet<S> points(list);
    const Sphere<S> ball(vec<S>(dice.point(5)), i % 4 ? S(dice.between(1, 4)) : std::sqrt(S(dice.between(1, 30))));
    const Rational squared = squared_distance_of_hull(seen_from(ball, points));
    const Rational radius(ball.radius());
    INFO("pair " << i);
    touching += squared == radius * radius;
    inside += squared == 0;
    REQUIRE(certified_status(points, ball) == (squared <= radius * radius ? together : apart));
    REQUIRE(certified_status(ball, points) == certified_status(points, ball));
  }
  REQUIRE(touching > 5);
  REQUIRE(inside > 5);
}

TEMPLATE_TEST_CASE("A radius smaller by one unit in the last place no longer reaches", "[certified]", float, double) {
  using S = TestType;
  const auto require_edge = [](const auto& other, const Vec3<S>& center, S radius) {
    REQUIRE(certified_status(other, Sphere<S>(center, radius)) == together);
    REQUIRE(certified_status(other, Sphere<S>(center, std::nextafter(radius, S(0)))) == apart);
  };
  const int range = std::numeric_limits<S>::max_exponent - 6;
  for (const int power : {0, 1, -1, range, -range}) {
    const S one = std::scalbn(S(1), power);
    INFO("times 2^" << power);
    require_edge(Sphere<S>({0, 0, 0}, one), {3 * one, 4 * one, 12 * one}, 12 * one);
    require_edge(PointSet<S>({{0, 0, 0}}), {3 * one, 4 * one, 12 * one}, 13 * one);                        // a vertex
    require_edge(PointSet<S>({{-one, 0, 0}, {one, 0, 0}}), {0, 3 * one, 4 * one}, 5 * one);                // an edge
    require_edge(PointSet<S>({{-one, 0, 0}, {one, 0, 0}, {0, one, 0}}), {0, one / 4, -3 * one}, 3 * one);  // a face
  }
}

TEST_CASE("Balls are told apart from sets far smaller and far larger than they", "[certified]") {
  const double huge = 1e300, tiny = 1e-300;
  const PointSet<double> small({{tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny}});
  REQUIRE(certified_status(small, Sphere<double>({huge, 0, 0}, huge)) == together);
  REQUIRE(certified_status(small, Sphere<double>({-huge, 0, 0}, huge)) ==
          apart);  // which touches the plane x = 0 at 0 only
  const PointSet<double> beyond({{tiny, 0, 0}, {tiny, tiny, 0}});
  REQUIRE(certified_status(beyond, Sphere<double>({-huge, 0, 0}, huge)) == apart);
  REQUIRE(certified_status(Sphere<double>({tiny, 0, 0}, tiny), Sphere<double>({-huge, 0, 0}, huge)) == together);
  REQUIRE(certified_status(Sphere<double>({3 * tiny, 0, 0}, tiny), Sphere<double>({-huge, 0, 0}, huge)) == apart);
}

// -- Families ---------------------------------------------------------------------------------------------------------

namespace {

using V = Vec3<double>;

/// Where a motion of the families puts whole numbers it makes whole numbers of them, times `stretch`.
struct WholeMotion {
  Motion motion;
  double stretch = 1;

  /// Returns: where the point comes to lie, found without the code that is tried.
  V operator()(const V& p) const {
    const detail::Fractions moved = detail::moved(motion, p);
    return {moved[0].convert_to<double>(), moved[1].convert_to<double>(), moved[2].convert_to<double>()};
  }
};

/// A turn by quarters about coordinate axes, as a matrix or a quaternion.
Matrix3 quarter_turn(Dice& dice) {
  std::array<int, 3> axes{0, 1, 2};
  for (int i = 2; i > 0; --i)
    std::swap(axes[static_cast<std::size_t>(i)], axes[static_cast<std::size_t>(dice.between(0, i))]);
  Matrix3 turn = Matrix3::Zero();
  for (int i = 0; i < 3; ++i) turn(i, axes[static_cast<std::size_t>(i)]) = dice.coin() ? 1 : -1;
  if (turn.determinant() < 0) turn.row(0) *= -1;
  return turn;
}

/// By cosine 3/5 or 0 or 1 about a coordinate axis. Points of whole multiples of 5 stay whole.
Quaternion five_turn(Dice& dice) {
  std::array<double, 3> about{};
  about[static_cast<std::size_t>(dice.between(0, 2))] = dice.coin() ? 1 : -1;
  const double w = dice.between(0, 2), length = std::ldexp(dice.coin() ? 1.0 : 0.1, dice.between(-30, 30));
  return {w * length, about[0] * length, about[1] * length, about[2] * length};
}

WholeMotion whole_motion(Dice& dice, double unit) {
  WholeMotion moved;
  moved.motion.translation = unit * 5 * V(dice.between(-4, 4), dice.between(-4, 4), dice.between(-4, 4));
  switch (dice.between(0, 3)) {
    case 0: moved.motion.turn = quarter_turn(dice); break;
    case 1: moved.motion.turn = five_turn(dice); break;
    case 2: {
      Matrix3 turn;
      turn << 3, -4, 0, 4, 3, 0, 0, 0, 5;
      moved.motion.turn = Matrix3(quarter_turn(dice) * turn);
      moved.stretch = 5;
      break;
    }
    default: break;
  }
  return moved;
}

/// One to three sets of one to five points, some of which coincide, whole multiples of 5 units.
std::vector<MovedPoints> whole_sets(Dice& dice, const Motion& motion, double unit) {
  std::vector<MovedPoints> sets(static_cast<std::size_t>(dice.between(1, 3)));
  for (MovedPoints& set : sets) {
    const int range = dice.between(0, 3);
    for (int more = dice.between(1, 5); more > 0; --more)
      set.points.push_back(unit * 5 *
                           V(dice.between(-range, range), dice.between(-range, range), dice.between(-range, range)));
    set.motion.turn = motion.turn;
  }
  sets[0].motion.translation = motion.translation;
  return sets;
}

/// Returns: the point of the core farthest along n, in whole numbers of doubles.
V farthest(const std::vector<MovedPoints>& sets, const V& n) {
  V sum = V::Zero();
  for (const MovedPoints& set : sets) {
    const WholeMotion moved{set.motion};
    V best = moved(set.points[0]);
    for (const V& p : set.points)
      if (const V q = moved(p); q.dot(n) > best.dot(n)) best = q;
    sum += best;
  }
  return sum;
}

struct GrownPair {
  std::string family;
  std::vector<MovedPoints> a, b;
  double r, s;
  std::optional<Status> known = {};
};

/// Two cores whose distance is |n| = 13 (or 0), n·p being largest in one and least in the other where they are nearest.
/// The radii reach just that far, or not quite.
GrownPair touching(Dice& dice, int exponent) {
  const double unit = std::ldexp(1.0, exponent);
  const WholeMotion of_a = whole_motion(dice, unit), of_b = whole_motion(dice, unit);
  GrownPair pair{"touching", whole_sets(dice, of_a.motion, unit), whole_sets(dice, of_b.motion, unit), 0, 0};
  const V n = quarter_turn(dice) * V(3, 4, 12);
  const bool touching_cores = dice.between(0, 3) == 0;
  const V from = farthest(pair.a, n), to = from + (touching_cores ? V(V::Zero()) : V(unit * n));
  // One more summand of b, a point, brings its nearest to where it should be.
  pair.b.push_back({{to - farthest(pair.b, -n)}});
  const double reach = touching_cores ? 0 : 13 * unit;
  if (!touching_cores) pair.r = unit / 8 * dice.between(0, 8 * 13), pair.s = reach - pair.r;
  pair.known = together;
  if (dice.coin()) {
    if (touching_cores)
      pair.b.push_back({{std::ldexp(unit, -20) * n}});
    else
      (pair.s > 0 ? pair.s : pair.r) = std::nextafter(pair.s > 0 ? pair.s : pair.r, 0.0);
    if (!touching_cores || std::ldexp(unit, -20) > 0) pair.known = apart;
  }
  return pair;
}

Matrix3 any_turn(Dice& dice) {
  const V axis = V(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0));
  return Matrix3(Eigen::AngleAxisd(dice.between(-3.0, 3.0), axis.normalized()));
}

/// Turned by any angle or quaternion, with coordinates some roundings apart: what is true is not known beforehand.
GrownPair clustered(Dice& dice, int exponent) {
  const double unit = std::ldexp(1.0, exponent);
  const auto sets = [&] {
    std::vector<MovedPoints> sets(static_cast<std::size_t>(dice.between(1, 2)));
    Motion motion;
    if (dice.coin())
      motion.turn = any_turn(dice);
    else
      motion.turn = Quaternion{dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), 1};
    for (MovedPoints& set : sets) {
      const V around = dice.coin() ? V(V::Zero()) : V(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), 1);
      const double spread = std::ldexp(1.0, -dice.between(0, 1) * dice.between(20, 52));
      for (int more = dice.between(1, 4); more > 0; --more)
        set.points.push_back(
            unit * (around + spread * V(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), dice.between(-1.0, 1.0))));
      set.motion = motion;
    }
    return sets;
  };
  GrownPair pair{"clustered", sets(), sets(), 0, 0};
  if (dice.coin()) {  // the second is the first, or moved by some roundings
    pair.b = pair.a;
    pair.b[0].motion.translation = unit * std::ldexp(1.0, -dice.between(45, 60)) *
                                   V(dice.between(-2, 2), dice.between(-2, 2), dice.between(-2, 2));
  }
  if (dice.coin()) pair.r = unit * dice.between(0.0, 0.5);
  if (dice.coin() && dice.coin()) pair.s = pair.r;
  return pair;
}

GrownPair any_pair(Dice& dice) {
  // One in sixty of 1e±150, of denormal numbers, or near the largest: these are slow to check in fractions.
  constexpr std::array extremes{500, -500, -1000, -1060, 1000};
  const int exponent =
      dice.between(0, 59) == 0 ? extremes[static_cast<std::size_t>(dice.between(0, 4))] : dice.between(-7, 3);
  return dice.between(0, 4) == 0 ? clustered(dice, exponent) : touching(dice, exponent);
}

/// Returns: the square of the distance of the cores, by all subsets; none where these would be too many.
std::optional<Rational> squared_distance(const Grown& a, const Grown& b) {
  const auto count = [](const Grown& grown) {
    int points = 1;
    for (const auto& set : grown.sets()) points *= set.size();
    return points;
  };
  if (count(a) * count(b) > 4) return std::nullopt;
  ExactVecs points;
  for (int i = 0; i < count(a); ++i)
    for (int j = 0; j < count(b); ++j) {
      const detail::Fractions p = *detail::core_point(a, i), q = *detail::core_point(b, j);
      points.push_back({p[0] - q[0], p[1] - q[1], p[2] - q[2]});
    }
  return squared_distance_of_hull(points);
}

struct Tally {
  int known = 0, by_subsets = 0, together = 0, inside = 0;
  std::array<int, 5> sizes{};
};

/// `known`: where the truth is known by construction it is all that is asked. To check certificates takes longer.
enum class Checks { all, known };

void require_right(const GrownPair& pair, Checks checks, Tally& tally) {
  const Grown a(pair.a, pair.r), b(pair.b, pair.s);
  const GrownResult result = certified_collision(a, b);
  if (checks == Checks::all || !pair.known) {
    const GrownResult exchanged = certified_collision(b, a);
    REQUIRE(exchanged.status == result.status);
    const bool certificate_holds = result.iterations % 2 == 0 ? holds(result, a, b) : holds(exchanged, b, a);
    REQUIRE(certificate_holds);
  }
  if (pair.known) REQUIRE(result.status == *pair.known);
  if (const auto square = squared_distance(a, b)) {
    const Rational reach = Rational(pair.r) + Rational(pair.s);
    REQUIRE(result.status == (*square <= reach * reach ? together : apart));
    ++tally.by_subsets;
  }
  tally.known += pair.known.has_value();
  tally.together += result.status == together;
  ++tally.sizes[static_cast<std::size_t>(result.nearest.size())];
}

void require_all_right(std::uint64_t seed, int pairs, Checks checks) {
  Dice dice(seed);
  Tally tally;
  for (int i = 0; i < pairs; ++i) {
    const GrownPair pair = any_pair(dice);
    INFO("pair " << i << " of seed " << seed << ", " << pair.family);
    require_right(pair, checks, tally);
  }
  CHECK(tally.known > pairs / 3);
  CHECK(tally.by_subsets > pairs / 50);
  CHECK(tally.together > pairs / 4);
  CHECK(tally.together < 3 * pairs / 4);
  for (std::size_t size = 1; size <= 4; ++size) CHECK(tally.sizes[size] > pairs / 500);
}

}  // namespace

TEST_CASE("C10: grown sets are decided rightly, each with a certificate that holds", "[certified]") {
  require_all_right(10, 1000, Checks::all);
}

TEST_CASE("C10: so are very many", "[certified][unsanitized][full]") { require_all_right(11, 10000, Checks::all); }

TEST_CASE("C10: so are a million", "[.][million]") {
  for (std::uint64_t seed = 100; seed < 120; ++seed) require_all_right(seed, 50000, Checks::known);
}

// -- One by one -------------------------------------------------------------------------------------------------------

namespace {

const std::vector<V> unit_box{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};

}  // namespace

TEST_CASE("A quaternion turns exactly, whatever its length", "[certified]") {
  // By cosine 3/5 about z: (5, 0, 0) comes to (3, 4, 0).
  for (const double length : {1.0, 0.1, 1e-150, 1e150, 0x1p-1060}) {
    const Grown turned({{{{5, 0, 0}}, {Quaternion{2 * length, 0, 0, length}}}});
    REQUIRE(proven(turned, Grown(PointSet<double>({{3, 4, 0}}))).status == together);
    REQUIRE(proven(turned, Grown(PointSet<double>({{3, above(4.0), 0}}))).status == apart);
    REQUIRE(proven(Grown(PointSet<double>({{3, 4, 0x1p-1074}})), turned).status == apart);
  }
}

TEST_CASE("Each set has its own quaternion, and its square divides that set alone", "[certified]") {
  const Motion fifth{Quaternion{2, 0, 0, 1}}, thirteenth{Quaternion{3, 0, 0, 2}};  // cosines 3/5 and 5/13
  const Grown a({{{{5, 0, 0}}, fifth}, {{{13, 0, 0}}, thirteenth}});               // (3, 4, 0) + (5, 12, 0)
  REQUIRE(proven(a, Grown(PointSet<double>({{8, 16, 0}}))).status == together);
  REQUIRE(proven(a, Grown(PointSet<double>({{8, below(16.0), 0}}))).status == apart);
  const Grown b({{{{-5, 0, 0}}, {Quaternion{2, 0, 0, 1}, {11, 20, 0}}}});  // (8, 16, 0)
  REQUIRE(proven(a, b).status == together);
  REQUIRE(proven(b, a).status == together);
}

TEST_CASE("A matrix is taken as it stands, and does not change the radius", "[certified]") {
  Matrix3 stretched = Matrix3::Identity();
  stretched(0, 0) = above(1.0);
  const Grown a({{{{-1, 0, 0}, {1, 0, 0}}, {stretched}}}, 0.5);
  REQUIRE(proven(a, Grown(Sphere<double>({2, 0, 0}, 0.5))).status == together);
  REQUIRE(proven(a, Grown(Sphere<double>({2, 0, 0}, 0.5 - 0x1p-52))).status == together);
  REQUIRE(proven(a, Grown(Sphere<double>({2, 0, 0}, below(0.5 - 0x1p-52)))).status == apart);
}

TEST_CASE("The points of a sum have numbers, the last set fastest", "[certified]") {
  const Grown sum({{{{0, 0, 0}, {10, 0, 0}}}, {{{0, 0, 0}, {0, 5, 0}, {0, 7, 0}}}});
  REQUIRE(proven(sum, Grown(Sphere<double>({11, 8, 0}, 1))).nearest[0] == IndexPair{5, 0});
  REQUIRE(proven(Grown(Sphere<double>({11, -1, 0}, 1)), sum).nearest[0] == IndexPair{0, 3});
  REQUIRE(proven(sum, Grown(Sphere<double>({-1, 8, 0}, 1))).nearest[0] == IndexPair{2, 0});
}

TEST_CASE("Capsules, rounded boxes and points in one place meet where they touch", "[certified]") {
  const Grown capsule({{{{0, 0, 0}, {0, 0, 2}}}}, 1), short_one({{{{3, 1, 0}, {3, 1, 0}}}}, 1);
  const Grown floor(
      PointSet<double>({{-40, -9, -40}, {40, -9, 40}, {-40, 0, -40}, {-40, 0, 40}, {40, 0, -40}, {40, 0, 40}}));
  const Grown rounded({{unit_box}}, 0.125);
  const auto wall = [](double x) { return Grown(PointSet<double>({{x, -5, -5}, {x, 5, -5}, {x, 5, 5}, {x, -5, 5}})); };
  REQUIRE(proven(short_one, floor).status == together);
  REQUIRE(proven(rounded, wall(1.125)).status == together);
  REQUIRE(proven(rounded, wall(above(1.125))).status == apart);
  REQUIRE(proven(capsule, wall(-1)).status == together);
  REQUIRE(proven(capsule, wall(below(-1.0))).status == apart);
}

namespace {

Matrix3 quarter_turn_about_z() {
  Matrix3 turn;
  turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  return turn;
}

IndexPairs pairs(std::initializer_list<IndexPair> list) {
  IndexPairs pairs;
  for (const IndexPair pair : list) pairs.add(pair);
  return pairs;
}

}  // namespace

TEST_CASE("A certificate that proves nothing does not hold", "[certified]") {
  const Grown a({{unit_box}}, 0.125), b({{unit_box, {quarter_turn_about_z(), {3, 0, 0}}}}, 0.5);
  const GrownResult good = proven(a, b);
  GrownResult other = good;
  other.status = good.status == apart ? together : apart;
  REQUIRE_FALSE(holds(other, a, b));
  for (const IndexPairs& wrong :
       {pairs({}), pairs({{0, 0}}), pairs({{8, 0}}), pairs({{-1, 0}}), pairs({{1, 0}, {1, 0}})}) {
    other = good;
    other.nearest = wrong;
    REQUIRE_FALSE(holds(other, a, b));
  }
}

TEST_CASE("What is no grown set is refused", "[certified]") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const auto refuses = [](std::vector<MovedPoints> sets, double radius) {
    REQUIRE_THROWS_AS(Grown(std::move(sets), radius), std::invalid_argument);
  };
  refuses({}, 0);
  refuses({{}}, 0);
  refuses({{unit_box}, {}}, 0);
  refuses({{unit_box}}, -1);
  refuses({{unit_box}}, nan);
  refuses({{unit_box}}, inf);
  refuses({{{{nan, 0, 0}}}}, 0);
  refuses({{unit_box, {Quaternion{0, 0, 0, 0}}}}, 0);
  refuses({{unit_box, {Quaternion{1, nan, 0, 0}}}}, 0);
  refuses({{unit_box, {Matrix3(Matrix3::Constant(inf))}}}, 0);
  refuses({{unit_box, {Matrix3(Matrix3::Identity()), {0, inf, 0}}}}, 0);
  refuses(std::vector<MovedPoints>(11, {unit_box}), 0);  // 2^33 points
  REQUIRE_NOTHROW(Grown(std::vector<MovedPoints>(10, {unit_box})));
}

static_assert(!std::constructible_from<Grown, PointSet<long double>>, "it would be rounded");
static_assert(!std::constructible_from<Grown, Sphere<long double>>);

TEST_CASE("C10: a small turn whose quaternion has a square that rounds to 1 is not exact", "[certified]") {
  const Motion motion{Quaternion{1, 0x1p-28, 0, 0}, {0, 1, 0}};  // (0, 1, 0) → (0, 2/(1 + 2^-56), 2^-27/(1 + 2^-56))
  const Grown a({{{{0, 1, 0}}, motion}});
  REQUIRE(proven(a, Grown({{{{0, 2, 0x1p-27}}}})).status == apart);
  REQUIRE(proven(a, Grown({{{{0, 2 - 0x1p-52, 0x1p-27}}}}, 0x1.ep-53)).status == together);
  kit::Dice dice(28);
  for (int i = 0; i < 2000; ++i) {
    const auto small = [&] { return std::ldexp(dice.between(-1.0, 1.0), dice.between(-60, -26)); };
    const auto power = [&] { return std::ldexp(1.0, dice.between(-3, 3)); };
    const MovedPoints point{{{power(), power(), power()}}, {Quaternion{1, small(), small(), small()}, {power(), 0, 0}}};
    const Vec3<double> near = Grown({point}).sets()[0].near().points()[0];
    const double unit = std::ldexp(1.0, Grown({point}).sets()[0].unit());
    proven(Grown({point}), Grown({{{unit * near}}}));
    proven(Grown({point}), Grown({{{unit * near}}}, 0x1p-53 * power()));
  }
}

}  // namespace certified_grown_test
}  // namespace gjk::test
