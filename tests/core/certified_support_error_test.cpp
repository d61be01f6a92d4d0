/// C6: how well support functions know their points, against numbers of a hundred digits.
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <functional>
#include <vector>

#include "core/certified/shapes.hpp"
#include "core/certified/support_error.hpp"
#include "tests/core/any_doubtful.hpp"
#include "tests/core/support.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {
namespace certified_support_error_test {
namespace {

using Long = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_100::backend_type,
                                           boost::multiprecision::et_off>;
using LongVec = std::array<Long, 3>;

template <class S>
LongVec exactly(const Vec3<S>& v) {
  return {Long(v.x()), Long(v.y()), Long(v.z())};
}
Long dot(const LongVec& x, const LongVec& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }
LongVec minus(const LongVec& x, const LongVec& y) { return {x[0] - y[0], x[1] - y[1], x[2] - y[2]}; }
LongVec cross(const LongVec& x, const LongVec& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}
Long length(const LongVec& x) { return sqrt(dot(x, x)); }

// -- What is true -----------------------------------------------------------------------------------------------------

/// A shape as its numbers say: how far it reaches along d, and how far a point is from it, at most.
struct Truth {
  std::function<Long(const LongVec& d)> reach;
  std::function<Long(const LongVec& p)> distance;
};

template <class S>
Truth truth_of(const Sphere<S>& ball) {
  const LongVec c = exactly(ball.center());
  const Long r(ball.radius());
  return {[=](const LongVec& d) -> Long { return dot(c, d) + r * length(d); },
          [=](const LongVec& p) { return std::max(Long(0), Long(length(minus(p, c)) - r)); }};
}
/// `of_axis`: that the cylinder was made with.
template <class S>
Truth truth_of(const Cylinder<S>& can, const Vec3<S>& of_axis) {
  const LongVec c = exactly(can.center()), axis = exactly(of_axis);
  const Long r(can.radius()), H = Long(can.height()) / 2;
  return {[=](const LongVec& d) -> Long {
            return dot(c, d) + (H * abs(dot(axis, d)) + r * length(cross(axis, d))) / length(axis);
          },
          [=](const LongVec& p) {
            const LongVec way = minus(p, c);
            const Long along = abs(dot(way, axis)) / length(axis) - H,
                       across = length(cross(way, axis)) / length(axis) - r;
            return length({std::max(Long(0), along), std::max(Long(0), across), Long(0)});
          }};
}
template <class S>
Truth truth_of(const PointSet<S>& set) {
  std::vector<LongVec> points;
  for (const Vec3<S>& p : set.points()) points.push_back(exactly(p));
  return {[=](const LongVec& d) {
            Long most = dot(points[0], d);
            for (const LongVec& p : points) most = std::max(most, dot(p, d));
            return most;
          },
          [=](const LongVec& p) {
            Long least = length(minus(p, points[0]));
            for (const LongVec& q : points) least = std::min(least, length(minus(p, q)));
            return least;
          }};
}
/// Turned by a matrix that need not be a rotation; its inverse tells points at rest.
template <class S>
Truth truth_of(const Pose<S>& pose, const Truth& rest) {
  const auto column = [&](int i) { return exactly(Vec3<S>(pose.rotation.col(i))); };
  const LongVec x = column(0), y = column(1), z = column(2), by = exactly(pose.translation);
  return {[=](const LongVec& d) -> Long {
            return dot(by, d) + rest.reach({dot(x, d), dot(y, d), dot(z, d)});
          },
          [=](const LongVec& p) {
            const LongVec way = minus(p, by), yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
            const Long det = dot(x, yz);
            return rest.distance({dot(yz, way) / det, dot(zx, way) / det, dot(xy, way) / det});
          }};
}

// -- Dice -------------------------------------------------------------------------------------------------------------

template <class S>
Vec3<S> any_vector(Dice& dice) {
  Vec3<S> v;
  do {
    for (S& x : v) x = static_cast<S>(dice.between(-1.0, 1.0));
  } while (v == Vec3<S>(Vec3<S>::Zero()));
  return v;
}
/// From 1 to 2 in its largest component, as C6 asks.
template <class S>
Vec3<S> direction_along(const Vec3<S>& v) {
  const int exponent = std::ilogb(v.cwiseAbs().maxCoeff());
  return v.unaryExpr([=](S x) { return std::scalbn(x, -exponent); });
}
template <class S>
Vec3<S> moved_by_digits(Vec3<S> v, Dice& dice, int digits) {
  for (S& x : v)
    for (int i = dice.between(0, digits); i > 0; --i) x = std::nextafter(x, S(dice.between(0, 1) ? 9 : -9));
  return v;
}
/// Anywhere; along a vector, or a few digits to many beside it; across it; and with components next to 0.
template <class S>
Vec3<S> any_direction(Dice& dice, const Vec3<S>& special) {
  const Vec3<S> any = any_vector<S>(dice), along = dice.between(0, 1) ? special : Vec3<S>(-special);
  switch (dice.between(0, 6)) {
    case 0: return direction_along<S>(along);
    case 1: return direction_along<S>(along * static_cast<S>(dice.between(0.1, 1.0)));
    case 2: return direction_along<S>(moved_by_digits<S>(along, dice, 20));
    case 3: return direction_along<S>(along + any * std::scalbn(S(1), -dice.between(1, 60)));
    case 4: return direction_along<S>(Vec3<S>(moved_by_digits<S>(special.cross(any), dice, 2)));
    case 5:
      return direction_along<S>(any.cwiseProduct(
          Vec3<S>(1, std::scalbn(S(1), -dice.between(0, 120)), std::scalbn(S(1), -dice.between(0, 120)))));
    default: return direction_along<S>(any);
  }
}
template <class S>
Vec3<S> any_axis(Dice& dice) {
  const Vec3<S> axes[] = {Vec3<S>(0, 0, 1), Vec3<S>(1, -2, 3), Vec3<S>(-1, 1, 1), any_vector<S>(dice)};
  return axes[dice.between(0, 3)];
}
template <class S>
Pose<S> any_pose(Dice& dice, S far) {
  const Vec3<S> axis = any_vector<S>(dice).normalized();
  return {Eigen::AngleAxis<S>(static_cast<S>(dice.between(-3.0, 3.0)), axis).toRotationMatrix(),
          any_vector<S>(dice) * far};
}

/// How much of what C6 allows was needed: of the way to the shape, and of the reach.
struct Needed {
  double distance = 0, reach = 0;
};

template <class S>
void look(const AnyDoubtful<S>& shape, const Truth& truth, const Vec3<S>& d, Needed& needed) {
  const SupportError known = support_error(shape);
  const LongVec p = exactly(near_support(shape, d)), along = exactly(d);
  const Long error(known.error), short_by = (truth.reach(along) - dot(p, along)) / length(along);
  REQUIRE(truth.distance(p) <= error);
  REQUIRE(short_by <= error);
  REQUIRE(truth.reach(along) <= Long(known.size) * length(along));
  needed.distance = std::max(needed.distance, static_cast<double>(truth.distance(p) / error));
  needed.reach = std::max(needed.reach, static_cast<double>(short_by / error));
}

constexpr int directions = 3000;

}  // namespace

TEMPLATE_TEST_CASE("C6: points of a set", "[certified]", float, double, long double) {
  using S = TestType;
  Dice dice(1);
  Needed needed;
  for (int i = 0; i < directions; ++i) {
    const Vec3<S> d = any_direction<S>(dice, Vec3<S>(1, 2, -3)), far = any_vector<S>(dice) * S(i % 3 * 20);
    std::vector<Vec3<S>> list(static_cast<std::size_t>(dice.between(2, 20)));
    for (Vec3<S>& p : list) p = far + any_vector<S>(dice).cross(d);  // which of them is farthest is all but rounding
    const PointSet<S> points(list);
    look<S>(points, truth_of(points), d, needed);
  }
  REQUIRE(needed.distance == 0);
  REQUIRE(needed.reach > 0.05);
}

TEMPLATE_TEST_CASE("C6: balls", "[certified]", float, double, long double) {
  using S = TestType;
  Dice dice(2);
  Needed needed;
  for (int i = 0; i < directions; ++i) {
    const Vec3<S> center = any_vector<S>(dice) * S(i % 3 * 10);
    const Sphere<S> ball(center, static_cast<S>(dice.between(0.5, 2.0)));
    look<S>(ball, truth_of(ball), any_direction<S>(dice, Vec3<S>(1, 1, 1)), needed);
  }
  REQUIRE(needed.distance > 0.1);
  REQUIRE(needed.reach > 0.1);
}

TEMPLATE_TEST_CASE("C6: cylinders, also along their axes and beside them", "[certified]", float, double, long double) {
  using S = TestType;
  Dice dice(3);
  Needed needed;
  for (int i = 0; i < 4 * directions; ++i) {
    const Vec3<S> center = any_vector<S>(dice) * S(i % 3 * 10), axis = any_axis<S>(dice);
    const Cylinder<S> can(center, axis, static_cast<S>(dice.between(0.2, 2.0)), static_cast<S>(dice.between(0.2, 4.0)));
    look<S>(can, truth_of(can, axis), any_direction<S>(dice, can.axis()), needed);
  }
  REQUIRE(needed.distance > 0.02);
  REQUIRE(needed.reach > 0.02);
}

TEMPLATE_TEST_CASE("C6: a cylinder asked within sixteen roundings of its axis answers with the middle of a cap",
                   "[certified]", float, double, long double) {
  using S = TestType;
  using V = Vec3<S>;
  const Cylinder<S> can(V(0, 0, 0), V(0, 0, 1), S(1), S(2));
  const S bound = 8 * std::numeric_limits<S>::epsilon();
  for (const S side : {S(1), S(-1)}) {
    REQUIRE(near_support(can, V(bound, 0, side)) == V(0, 0, side));
    REQUIRE(near_support(can, V(0, -bound, side)) == V(0, 0, side));
    REQUIRE(near_support(can, V(std::nextafter(bound, S(1)), 0, side)) == V(1, 0, side));
  }
}

TEMPLATE_TEST_CASE("C6: what a pose moves", "[certified]", float, double, long double) {
  using S = TestType;
  Dice dice(4);
  Needed points_needed, can_needed;
  for (int i = 0; i < directions; ++i) {
    const Pose<S> pose = any_pose<S>(dice, S(i % 3 * 10));
    std::vector<Vec3<S>> list(5);
    for (Vec3<S>& p : list) p = any_vector<S>(dice);
    const PointSet<S> points(list);
    const Vec3<S> axis = any_axis<S>(dice), d = any_direction<S>(dice, Vec3<S>(pose.rotation * axis));
    look<S>(Posed<S, PointSet<S>>(points, pose), truth_of(pose, truth_of(points)), d, points_needed);
    const Cylinder<S> can(list[0], axis, S(1), S(0.5));
    look<S>(Posed<S, Cylinder<S>>(can, pose), truth_of(pose, truth_of(can, axis)), d, can_needed);
  }
  for (const Needed& needed : {points_needed, can_needed}) {
    REQUIRE(needed.distance > 0.01);
    REQUIRE(needed.reach > 0.01);
  }
}

TEST_CASE("C6: what a matrix turns that is no rotation is not known", "[certified]") {
  Pose<double> pose;
  const PointSet<double> point({Vec3<double>(1, 0, 0)});
  pose.rotation(0, 0) = std::sqrt(1 + 0.999e-3);
  REQUIRE(std::isfinite(support_error(Posed<double, PointSet<double>>(point, pose)).error));
  pose.rotation(0, 0) = std::sqrt(1 + 1.001e-3);
  REQUIRE(std::isinf(support_error(Posed<double, PointSet<double>>(point, pose)).error));
}

TEST_CASE("C6: how many roundings each shape is given, as its derivation ends", "[certified]") {
  using V = Vec3<double>;
  constexpr double u = 0x1p-53, lost = 16 * 0x1p-1074;
  const auto is = [](const SupportError& known, double size, double error) {
    CHECK(known.size == size);
    CHECK(known.error == error);
  };
  const Sphere<double> ball(V(1, -2, 3), 2);
  const Cylinder<double> can(V(1, 0, -1), V(0, 0, 1), 3, 4);
  is(support_error(PointSet<double>({V(3, 0, 0), V(-4, 5, 0)})), 9, 8 * 9 * u + lost);
  is(support_error(ball), 6 + 2, (8 * 2 + 2 * 6) * u + lost);
  is(support_error(can), 2 + 3 + 2, (64 * (3 + 2) + 4 * 2) * u + lost);
  is(support_error(MinkowskiSum<double, Sphere<double>, Cylinder<double>>(ball, can)), 8 + 7,
     2 * (8 + 7) * u + lost + (support_error(ball).error + support_error(can).error));
  Pose<double> pose;
  pose.translation = V(1, 2, -3);
  const double stretched = 1.002;
  is(support_error(Posed<double, Sphere<double>>(ball, pose)), stretched * 8 + 6,
     (18 * 8 + 2 * 6) * u + lost + stretched * support_error(ball).error);
}

TEMPLATE_TEST_CASE("C6: a sum reaches as far as both, and lies where their points do", "[certified]", float, double,
                   long double) {
  using S = TestType;
  Dice dice(5);
  for (int i = 0; i < directions; ++i) {
    const Sphere<S> ball(any_vector<S>(dice), S(0.5));
    const Vec3<S> axis = any_axis<S>(dice), d = any_direction<S>(dice, axis);
    const Cylinder<S> can(any_vector<S>(dice) * S(30), axis, S(1), S(0.5));
    const MinkowskiSum<S, Sphere<S>, Cylinder<S>> sum(ball, can);
    const LongVec along = exactly(d), p = exactly(near_support(sum, d));
    const Long error(support_error(sum).error), reach = truth_of(ball).reach(along) + truth_of(can, axis).reach(along);
    REQUIRE(reach - dot(p, along) <= error * length(along));
    const LongVec rounded = minus(minus(p, exactly(near_support(ball, d))), exactly(near_support(can, d)));
    REQUIRE(length(rounded) <= error - Long(support_error(ball).error) - Long(support_error(can).error));
    REQUIRE(reach <= Long(support_error(sum).size) * length(along));
  }
}

TEMPLATE_TEST_CASE(
    "C6: where products might overflow nothing is known, and of the least numbers sixteen are allowed for",
    "[certified]", float, double) {
  using S = TestType;
  const S most = std::numeric_limits<S>::max() * S(0x1p-20), least = std::numeric_limits<S>::denorm_min();
  const auto error = [](S size) { return support_error(PointSet<S>({Vec3<S>(size, 0, 0)})).error; };
  REQUIRE(std::isinf(error(most)));
  REQUIRE(std::isfinite(error(std::nextafter(most, S(0)))));
  REQUIRE(error(least) >= 16 * static_cast<double>(least));
  REQUIRE(error(least) < 32 * static_cast<double>(least));
}

TEST_CASE("C6: of long doubles below all doubles the error is not lost", "[certified]") {
  const Sphere<long double> ball({0, 0, 0}, 1e-310L), tiny({0, 0, 0}, 1e-330L), far({1e-329L, 0, 0}, 1e-330L);
  REQUIRE(support_error(ball).error > 0);
  REQUIRE(support_error(far).size >= 1.1e-329L);
  const ShapesResult result = certified_shapes<long double>(tiny, far);
  REQUIRE(result.status == Status::undecided);
  REQUIRE(result.gap >= 8e-330L);
}

}  // namespace certified_support_error_test
}  // namespace gjk::test
