/// Questions about objects that move: whatever the last one has left, the answer is the one without it.
#include "core/certified/moving.hpp"

#include "core/certified/check.hpp"
#include "core/moving.hpp"
#include "tests/core/support.hpp"
#include "tests/kit/catch.hpp"
#include "tests/kit/dice.hpp"

namespace gjk::test {
namespace moving_test {

using V = Vec3<double>;
using Points = PointSet<double>;
using kit::Dice;

std::vector<V> cloud(Dice& dice, int count) {
  std::vector<V> points(static_cast<std::size_t>(count));
  for (V& p : points)
    for (double& x : p) x = dice.between(-1.0, 1.0);
  return points;
}

Pose<double> pose(double angle, const V& place) {
  return {Eigen::AngleAxisd(angle, V(1, 2, 3).normalized()).toRotationMatrix(), place};
}

/// Through the other object and out again, with steps of any size.
V place(int frame) { return {3 * std::cos(0.05 * frame), 0.2 * std::sin(0.3 * frame), 0.1}; }

TEST_CASE("Objects that move are answered as if nobody had asked before", "[moving]") {
  Dice dice(7474);
  for (const int count : {3, 4, 8, 32}) {
    const Points a(cloud(dice, count)), at_rest(cloud(dice, count));
    LastFound<double> last, proven;
    int together = 0, apart = 0;
    for (int frame = 0; frame < 200; ++frame) {
      const Posed<double, Points> b(at_rest, pose(0.03 * frame, place(frame)));
      std::vector<V> points;
      for (const V& p : at_rest.points()) points.push_back(b.pose()(p));
      const Points moved(points);
      const CertifiedResult anew = certified_collision(a, moved), again = certified_collision(a, moved, proven);
      const Result<double> plain = collision(a, b, last);
      INFO(count << " points, frame " << frame);
      REQUIRE(again.status == anew.status);
      REQUIRE(holds(again.certificate, a, moved));
      REQUIRE(plain.status == anew.status);
      ++(anew.status == Status::intersecting ? together : apart);
    }
    CHECK(together > 5);
    CHECK(apart > 20);
  }
}

TEST_CASE("What does not move is answered by what was found: with one point, or none", "[moving]") {
  const Points a({V(0, 0, 0), V(2, 0, 0), V(0, 2, 0), V(0, 0, 2)});
  const Points near({V(0.2, 0.2, 0.2), V(3, 0, 0), V(0, 3, 0), V(0, 0, 3)}), far({V(5, 5, 5), V(6, 5, 5), V(5, 6, 4)});
  LastFound<double> plain, proven;
  for (const bool is_first : {true, false}) {
    const Result<double> result = collision(a, near, plain);
    CHECK(result.status == Status::intersecting);
    CHECK(result.simplex.size() == 4);
    CHECK((result.iterations == 0) == !is_first);
    const CertifiedResult certain = certified_collision(a, near, proven);
    CHECK(certain.status == Status::intersecting);
    CHECK((certain.iterations == 0) == !is_first);
    CHECK(holds(certain.certificate, a, near));
  }
  for (int i = 0; i < 3; ++i) {
    const Result<double> result = collision(a, far, plain);
    CHECK(result.status == Status::separated);
    const CertifiedResult certain = certified_collision(a, far, proven);
    CHECK(certain.status == Status::separated);
    CHECK(holds(certain.certificate, a, far));
    if (i == 0) continue;
    CHECK(result.iterations == 1);
    CHECK(certain.iterations == 1);
  }
}

TEST_CASE("What other objects have left, corners that are not there and no direction at all do no harm", "[moving]") {
  const Points a({V(0, 0, 0), V(2, 0, 0), V(0, 2, 0), V(0, 0, 2)}), b({V(0.1, 0.1, 0.1), V(1, 1, 1)}),
      far({V(9, 9, 9)});
  LastFound<double> strange;
  for (const int i : {0, 2, 7, -1}) strange.corners.add({i, i});
  for (const Points* other : {&b, &far}) {
    LastFound<double> last = strange, proven = strange;
    CHECK(collision(a, *other, last).status == collision(a, *other).status);
    CHECK(certified_collision(a, *other, proven).status == certified_collision(a, *other).status);
  }
  LastFound<double> none, proven;
  none.direction = proven.direction = V::Zero();
  CHECK(certified_collision(a, b, proven).status == Status::intersecting);
  CHECK(collision(a, b, none).status == Status::intersecting);
}

TEST_CASE("A tetrahedron that has become flat proves nothing: its sides are of rounding", "[moving]") {
  Dice dice(3);
  const auto one = [&] { return dice.between(-1.0, 1.0); };
  const auto turn = [&] { return Eigen::Quaterniond(one(), one(), one(), one()).normalized().toRotationMatrix(); };
  int flat = 0;
  for (int i = 0; i < 20'000; ++i) {
    const auto corners = [&] {
      return Points({{one(), one(), 0}, {one(), one(), 0}, {one(), one(), 0}, {one(), one(), 0}});
    };
    Posed<double, Points> a(corners(), {turn(), V(0.1 * one(), 0.1 * one(), 0.1 * one())}),
        b(corners(), {turn(), V::Zero()});
    LastFound<double> last;
    collision(a, b, last);
    if (last.corners.size() != 4) continue;
    ++flat;
    const Eigen::Matrix3d plane = turn();  // both into one plane, and apart in it
    a.move_to({plane, V::Zero()});
    b.move_to({plane, plane * V(3, 1.5, 0)});
    CHECK(collision(a, b, last).status != Status::intersecting);
  }
  CHECK(flat > 5'000);
}

TEST_CASE("Shapes without corners remember the direction that separated them", "[moving]") {
  const Posed<double, Sphere<double>> moved(Sphere<double>(V(0, 0, 0), 1), pose(1, V(3, 1, 0)));
  LastFound<double> of_moved;
  CHECK(collision(Sphere<double>(V(0, 0, 0), 1), moved, of_moved).status == Status::separated);
  LastFound<double> last;
  for (int frame = 0; frame < 4; ++frame) {
    const Sphere<double> a(V(0, 0, 0), 1), b(V(3, 1, 0.1 * frame), 1);
    const Result<double> result = collision(a, b, last);
    CHECK(result.status == Status::separated);
    if (frame > 0) CHECK(result.iterations == 1);
  }
  CHECK(collision(Sphere<double>(V(0, 0, 0), 1), Sphere<double>(V(0.5, 0.1, 0), 1), last).status ==
        Status::intersecting);
  CHECK(last.corners.empty());
}

}  // namespace moving_test
}  // namespace gjk::test
