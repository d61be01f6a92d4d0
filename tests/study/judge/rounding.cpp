#include "tests/study/judge/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/gjk.hpp"
#include "tests/study/judge/starts.hpp"
#include "tests/study/methods/question.hpp"
#include "tests/study/truth/oracle.hpp"

namespace study {
namespace {

template <class S>
gjk::PointSet<S> set_in(const Points& points) {
  std::vector<gjk::Vec3<S>> list;
  for (const Vec& p : points) list.push_back(p.cast<S>());
  return gjk::PointSet<S>(std::move(list));
}

struct WrongAnswer {
  const Points &a, &b;
  Truth truth;
  gjk::Vec3<double> between;  ///< the centers
};

/// Whether the report's algorithm in these numbers answers it wrongly as well.
template <class S>
bool misleads_the_report(const WrongAnswer& wrong) {
  const gjk::PointSet<S> a = set_in<S>(wrong.a), b = set_in<S>(wrong.b);
  return std::ranges::any_of(starts(), [&](const Start& start) {
    const gjk::Options<S> options{.first_direction = start.direction_of(wrong.between).template cast<S>()};
    const bool meet = gjk::collision<S>(a, b, options).status == gjk::Status::intersecting;
    return meet != (wrong.truth == Truth::intersecting);
  });
}

/// A product such as ((AB×AO)×AB)·P has four factors, each a difference, and sums of three.
template <class S>
bool rounds(const Points& points) {
  const double most = std::ldexp(1.0, (std::numeric_limits<S>::digits - 8) / 4);
  return std::ranges::any_of(
      points, [&](const Vec& p) { return p.cwiseAbs().maxCoeff() > most || p != p.array().round().matrix(); });
}

/// As the core measures it, for its relative zero test.
double largest(const Points& points) {
  double most = 0;
  for (const Vec& p : points) most = std::max(most, p.lpNorm<1>());
  return most;
}

/// Whether the truth hangs on the last bits of these numbers.
template <class S>
bool hangs_on_bits(const WrongAnswer& wrong) {
  if (!rounds<S>(wrong.a) && !rounds<S>(wrong.b)) return false;
  const double length = 16 * double{std::numeric_limits<S>::epsilon()} * (largest(wrong.a) + largest(wrong.b));
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        Points moved = wrong.a;
        for (Vec& p : moved) p += length * Vec(x, y, z);
        const bool is_finite = std::ranges::all_of(moved, [](const Vec& p) { return p.allFinite(); });
        if (is_finite && truth(Pair{moved, wrong.b}) != wrong.truth) return true;
      }
  return false;
}

template <class S>
bool overflows(const Points& points) {
  return std::ranges::any_of(points, [](const Vec& p) { return !p.cast<S>().allFinite(); });
}

template <class S>
bool is_laid_to_rounding(const WrongAnswer& wrong) {
  return overflows<S>(wrong.a) || overflows<S>(wrong.b) || misleads_the_report<S>(wrong) || hangs_on_bits<S>(wrong);
}

}  // namespace

LaidToRounding laid_to_rounding(const std::vector<Judged>& pairs) {
  LaidToRounding rounding;
  for (const Judged& judged : pairs) {
    if (judged.verdict != Verdict::wrong_yes && judged.verdict != Verdict::wrong_no) continue;
    const Pair& pair = judged.named.pair;
    const auto *a = std::get_if<Points>(&pair.a), *b = std::get_if<Points>(&pair.b);
    if (!a || !b) continue;
    const WrongAnswer wrong{*a, *b, judged.truth, between_centers<double>(pair)};
    ++rounding.wrong;
    rounding.in_doubles += is_laid_to_rounding<double>(wrong);
    rounding.in_floats += is_laid_to_rounding<float>(wrong);
  }
  return rounding;
}

}  // namespace study
