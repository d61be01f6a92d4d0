/// Asks proven answers about pairs that are hard, and prints how many there were and one number that stands for all of them: it must
/// not depend on how this was compiled. same_answers.sh compiles it in many ways.
///
/// The pairs are whole numbers, each rounded once at most, so that they are the same however products are contracted; and no two
/// dice are thrown where a compiler may choose which is first.
#include <cstdio>
#include <cstdlib>
#include <map>

#include "core/certified/certified.hpp"
#include "core/certified/check.hpp"
#include "core/certified/grown.hpp"
#include "core/certified/shapes.hpp"
#include "core/rule_sets.hpp"
#include "tests/core/support.hpp"

namespace {

using namespace gjk;
using test::Dice;
using test::Frame;
using test::PairOfHulls;

struct Answers {
  std::uint64_t sum = 1469598103934665603U;  ///< FNV-1a
  std::map<Status, int> count;

  void add(Status status) {
    sum = (sum ^ static_cast<std::uint64_t>(status)) * 1099511628211U;
    ++count[status];
  }
};

void require(bool holds, const char* what, int pair) {
  if (holds) return;
  std::printf("pair %d: %s\n", pair, what);
  std::exit(1);
}

/// Crowded lattices, which touch and are flat; turned and divided by 7, so that rounding decides; moved by single digits; of wild
/// sizes; and far from the origin.
template <class S>
std::vector<Vec3<S>> placed(const test::Points& points, int kind, Dice& dice) {
  const Frame<S> frame = kind % 2 == 0 ? test::axis_aligned<S>("1", S(1)) : test::skew<S>("1/7", S(1) / S(7));
  std::vector<Vec3<S>> list = test::seen(points, frame);
  for (Vec3<S>& p : list)
    for (S& x : p) {
      if (kind / 2 == 1 && dice.between(0, 2) == 0) x = std::nextafter(x, static_cast<S>(1000 * dice.between(-1, 1)));
      if (kind / 2 == 2) x = std::scalbn(x, 20 * dice.between(-2, 2));
      if (kind / 2 == 3) x += std::scalbn(S(1), std::numeric_limits<S>::digits - 4);
    }
  return list;
}

template <class S>
void ask_about_points(int pair, Dice& dice, Answers& answers) {
  const int reach = dice.between(1, 9), sizes = dice.between(0, 63), kind = dice.between(0, 7);
  const test::Point by = dice.point(reach);
  const PairOfHulls hulls{dice.points(1 + sizes % 8, reach), dice.points(1 + sizes / 8, reach)};
  const PointSet<S> a(placed<S>(hulls.a, kind, dice)), b(placed<S>(test::moved(hulls.b, by), kind, dice));
  Options<S> inside;
  inside.inside = PointOfEach<S>{a.mean(), b.mean()};
  const CertifiedResult result = certified_collision(a, b), again = certified_collision<S, Eager<>>(b, a, inside);
  answers.add(result.status);
  require(again.status == result.status, "started inside, and exchanged, the answer is another", pair);
  if (pair % 16 == 0) {
    require(holds(result.certificate, a, b), "the certificate does not hold", pair);
    require(holds(again.certificate, b, a), "the certificate of the search from inside does not hold", pair);
  }
  const ShapesResult rounded = certified_shapes<S>(a, b);
  require(rounded.status == Status::undecided || rounded.status == result.status,
          "the points taken as rounded have another", pair);
  for (double x : rounded.direction) {
    volatile S in_scalar = static_cast<S>(x);  // volatile: GCC 12 has left the rounding out
    require(in_scalar == x, "the direction is not the one that the support functions were asked along", pair);
  }
  const Sphere<S> ball(b.points()[0], static_cast<S>(dice.between(1, 20)) / S(7));
  answers.add(certified_collision(Grown(a), Grown(ball)).status);
  answers.add(certified_collision(Grown(Sphere<S>(a.points()[0], S(1))), Grown(ball)).status);
}

/// Far from where they would be undecided.
void ask_about_cans(Dice& dice, Answers& answers) {
  const int x = dice.between(-1, 1), y = dice.between(-1, 1), halves = dice.between(1, 4), height = dice.between(1, 4);
  const Vec3<double> axis(x, y, 1);
  const Cylinder<double> a(Vec3<double>(0, 0, 0), axis, halves * 0.5, height);
  const double sign = dice.between(0, 1) ? 1 : -1, gap = std::ldexp(sign, -dice.between(4, 32)), reach = a.radius() + 1;
  const Vec3<double> across(axis.z(), 0,
                            -axis.x());  // at right angles to the axis, and as long as 1 or √2 of its square
  const double length = across.squaredNorm() == 1 ? 1 : std::sqrt(2.0);
  answers.add(certified_shapes(a, Sphere<double>(across * ((reach + gap) / length), 1)).status);
}

}  // namespace

int main(int, char** arguments) {
  const int pairs = std::atoi(arguments[1]);
  Answers answers;
  Dice dice(7474);
  for (int i = 0; i < pairs; ++i) {
    ask_about_points<double>(i, dice, answers);
    ask_about_points<float>(i, dice, answers);
    ask_about_cans(dice, answers);
  }
  std::printf("%016llx: %d intersecting, %d separated, %d undecided\n", static_cast<unsigned long long>(answers.sum),
              answers.count[Status::intersecting], answers.count[Status::separated], answers.count[Status::undecided]);
}
