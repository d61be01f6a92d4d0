// Answers about sets and shapes that nobody chose are the accepted ones, with how they were found: to the last bit.

#include <array>
#include <cstdio>

#include "core/certified.hpp"
#include "core/certified_balls.hpp"
#include "core/certified_shapes.hpp"
#include "core/rule_sets.hpp"
#include "tests/core/support.hpp"
#include "tests/golden/checksum.hpp"
#include "tests/kit/catch.hpp"

using namespace golden;
using namespace gjk;
using gjk::test::Dice;

namespace {

constexpr int rounds = 400;

class Answers {
 public:
  void add(std::string_view word) { sum_.add(std::string(word) + " "); }
  void add(long number) { sum_.add(number); }
  void add_exactly(double number) {
    char digits[40];
    std::snprintf(digits, sizeof digits, "%a ", number);
    sum_.add(std::string(digits));
  }
  template <class S>
  void add(const Vec3<S>& point) {
    for (int i = 0; i < 3; ++i) add_exactly(double{point[i]});
  }
  template <class S>
  void add(const Result<S>& result) {
    add(to_string(result.status));
    add(to_string(result.reason));
    add(long{result.iterations});
    add(long{result.cycle_start.value_or(-1)});
    for (int i = 0; i < result.simplex.size(); ++i) add(result.simplex[i].w);
    if (result.separation) add(result.separation->direction);
  }
  void add(const IndexPairs& pairs) {
    for (const IndexPair& pair : pairs) {
      add(long{pair.a});
      add(long{pair.b});
    }
  }
  void add(const CertifiedResult& result) {
    add(to_string(result.status));
    add(to_string(result.proof));
    add(long{result.iterations});
    add(long{result.second_iterations});
    if (const auto* direction = std::get_if<SeparatingDirection>(&result.certificate)) add(direction->d);
    if (const auto* feature = std::get_if<SeparatingFeature>(&result.certificate)) add(feature->of);
    if (const auto* simplex = std::get_if<CommonSimplex>(&result.certificate)) add(simplex->of);
  }
  void add(const ShapesResult& result) {
    add(to_string(result.status));
    add(long{result.iterations});
    add_exactly(result.gap);
    add(result.direction);
  }
  std::string text() const { return sum_.text(); }

 private:
  Checksum sum_;
};

/// Crowded lattices, in everyday numbers, in such as rounding decides about, and at the ends of the range; up to 50 points,
/// which are searched in blocks.
template <class S>
PointSet<S> point_set(Dice& dice, int reach, int kind, const test::Point& by) {
  const int count = dice.between(0, 9) == 0 ? dice.between(20, 50) : dice.between(1, 8);
  const test::Points points = test::moved(dice.points(count, reach), by);
  const S scale = kind == 3   ? std::scalbn(S(1), std::numeric_limits<S>::max_exponent / 3)
                  : kind == 4 ? std::numeric_limits<S>::denorm_min() * 64
                              : S(1) / S(7);
  return PointSet<S>(test::seen(points, kind % 2 == 0 ? test::axis_aligned<S>("", scale) : test::skew<S>("", scale)));
}

template <class S>
struct Pair {
  PointSet<S> a, b;
};

template <class S>
Pair<S> pair_of_sets(Dice& dice) {
  const int reach = dice.between(1, 9), kind = dice.between(0, 4);
  const test::Point by = dice.point(reach);
  PointSet<S> a = point_set<S>(dice, reach, kind, {0, 0, 0});
  return {std::move(a), point_set<S>(dice, reach, kind, by)};
}

template <class S>
Options<S> options(Dice& dice, const Pair<S>& pair) {
  Options<S> all;
  if (dice.between(0, 1) == 0) all.first_direction = first_direction_between<S>(pair.a.mean(), pair.b.mean());
  if (dice.between(0, 3) == 0) all.inside = PointOfEach<S>{pair.a.mean(), pair.b.mean()};
  if (dice.between(0, 3) == 0) all.crossing_test = CrossingTest::off;
  if (dice.between(0, 3) == 0) all.iteration_limit = dice.between(0, 6);
  return all;
}

template <class S>
void by_all_rules(Answers& answers, Dice& dice) {
  const Pair<S> pair = pair_of_sets<S>(dice);
  const Options<S> asked = options(dice, pair);
  for (const auto& rules : rule_sets)
    for (const auto& zero_test : zero_tests)
      with_rules(rules.value, zero_test.value, [&]<class Rules>() {
        answers.add(collision<S, Rules>(pair.a, pair.b, asked));
        answers.add(certified_collision<S, Rules>(pair.a, pair.b, asked));
      });
}

double length(Dice& dice) { return dice.between(0, 1) == 0 ? dice.between(1, 8) / 4.0 : dice.between(0.1, 2.0); }

/// No two dice are thrown where a compiler may choose which is first.
Vec3<double> at(Dice& dice) {
  const test::Point point = dice.point(6);
  return test::vec<double>(point) / (dice.between(0, 1) == 0 ? 2 : 3);
}

/// Quarter turns about z and others, without sines: the columns of a rotation in integers, as long as 15.
Pose<double> pose(Dice& dice) {
  Pose<double> pose;
  const auto frame = test::skew<double>("", 1);
  const std::array<test::Point, 3> columns{frame.x, frame.y, frame.z};
  if (dice.between(0, 1) == 0)
    for (int i = 0; i < 3; ++i) pose.rotation.col(i) = test::vec<double>(columns[static_cast<std::size_t>(i)]) / 15;
  pose.translation = at(dice);
  return pose;
}

void round_shapes(Answers& answers, Dice& dice) {
  const double scale = std::ldexp(1.0, dice.between(0, 3) == 0 ? 100 * dice.between(-9, 9) : 0);
  const Vec3<double> one = at(dice), other = at(dice), third = at(dice), axis = test::vec<double>(dice.point(3));
  const double first_radius = length(dice), second_radius = length(dice), height = length(dice);
  const Sphere<double> ball(one * scale, first_radius * scale);
  const Cylinder<double> can(other * scale, axis.isZero() ? Vec3<double>(0, 0, 1) : axis, second_radius * scale,
                             height * scale);
  const PointSet<double> segment({Vec3<double>(one * scale), Vec3<double>(third * scale)});
  const MinkowskiSum<double, PointSet<double>, Sphere<double>> capsule(segment, ball);
  Pose<double> moved = pose(dice);
  moved.translation *= scale;
  answers.add(certified_shapes(ball, can));
  answers.add(certified_shapes(can, Posed<double, Cylinder<double>>(can, moved)));
  answers.add(certified_shapes(capsule, Posed<double, PointSet<double>>(segment, moved)));
  answers.add(to_string(certified_status(segment, ball)));
  answers.add(to_string(certified_status(ball, Sphere<double>(third * scale, second_radius * scale))));
  answers.add(collision<double>(can, capsule));
  answers.add(collision<double, Eager<>>(Posed<double, Cylinder<double>>(can, moved), ball));
}

std::string line_of(const std::string& name, void (*part)(Answers&, Dice&)) {
  Dice dice(43);
  Answers answers;
  for (int i = 0; i < rounds; ++i) part(answers, dice);
  return answers.text() + " " + name;
}

}  // namespace

TEST_CASE("answers about pairs at random are found as accepted") {
  const std::vector<std::string> now{line_of("point sets in double", by_all_rules<double>),
                                     line_of("point sets in float", by_all_rules<float>),
                                     line_of("round shapes", round_shapes)};
  check_lines("answers.txt", now, "answers", [&](std::size_t i, const std::string&) {
    return now[i].substr(9) + ": " + std::to_string(rounds) + " pairs are no longer answered as accepted";
  });
}
