#include <algorithm>
#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <limits>

#include "core/gjk.hpp"
#include "tests/study/claims_measured.hpp"
#include "tests/study/dice.hpp"
#include "tests/study/families.hpp"
#include "tests/study/oracle.hpp"
#include "tests/study/over_pairs.hpp"
#include "tests/study/random_triangles.hpp"

namespace study {
namespace {

using moller_1997::Distances;
using moller_1997::Triangle;

using Exact = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

template <class S>
struct Triangles {
  Triangle<S> a, b;
};

template <class S>
Triangle<S> triangle_of(const Body& body) {
  const Points& points = std::get<Points>(body);
  Triangle<S> triangle;
  for (std::size_t i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) triangle[i][k] = S(points[i][k]);
  return triangle;
}

template <class S>
Triangles<S> triangles_of(const Pair& pair) {
  return {triangle_of<S>(pair.a), triangle_of<S>(pair.b)};
}

Pair rounded_to_float(Pair pair) {
  for (Body* const body : {&pair.a, &pair.b})
    for (Vec& p : std::get<Points>(*body)) p = p.cast<float>().cast<double>();
  return pair;
}

bool truly_meet(const Pair& pair) { return truth(pair) == Truth::intersecting; }

template <class S, class Rules>
gjk::Status ask_gjk(const Triangles<S>& t) {
  const auto set = [](const Triangle<S>& corners) { return gjk::PointSet<S>({corners[0], corners[1], corners[2]}); };
  return gjk::collision<S, Rules>(set(t.a), set(t.b)).status;
}

template <class S>
bool ask_moller(const Triangles<S>& t, Distances treatment) {
  return moller_1997::meet(t.a, t.b, treatment);
}

/// By MollerWay.
std::array<bool, ways> ask_all_mollers(const Triangles<double>& t, const Triangles<float>& f) {
  return {ask_moller(t, Distances::as_computed), ask_moller(f, Distances::as_computed),
          ask_moller(t, Distances::small_ones_snapped), ask_moller(f, Distances::small_ones_snapped)};
}

/// How far the intervals overlap as a share of the shorter one, exactly.
double depth_of(const Triangles<Exact>& t) {
  const auto finding = moller_1997::find(t.a, t.b, Distances::as_computed);
  if (finding.how != moller_1997::How::intervals) return std::numeric_limits<double>::quiet_NaN();
  const auto& i = finding.first;
  const auto& j = finding.second;
  const Exact shared = std::min(i.most, j.most) - std::max(i.least, j.least);
  const Exact shorter = std::min(Exact(i.most - i.least), Exact(j.most - j.least));
  return shorter == 0 ? 0 : Exact(shared / shorter).convert_to<double>();
}

void compare_all(const std::array<bool, ways>& gjk, const std::array<bool, ways>& moller, bool truth,
                 bool truth_of_float, MollerCounts& sum) {
  for (std::size_t g = 0; g < ways; ++g)
    for (std::size_t m = 0; m < ways; ++m)
      sum.compared[g][m].add(gjk[g], moller[m], g % 2 == 1 && m % 2 == 1 ? truth_of_float : truth);
}

void ask_about(const Pair& pair, std::uint64_t index, MollerCounts& sum) {
  const Triangles<double> t = triangles_of<double>(pair);
  const Triangles<float> f = triangles_of<float>(pair);
  const bool meet = truly_meet(pair), floats_meet = truly_meet(rounded_to_float(pair));
  const gjk::Status status = ask_gjk<double, gjk::AsIntended>(t);
  const auto yes = [](gjk::Status s) { return s == gjk::Status::intersecting; };
  const std::array<bool, ways> gjk{yes(status), yes(ask_gjk<float, gjk::AsIntended>(f)),
                                   yes(ask_gjk<double, gjk::AsPrinted>(t)), yes(ask_gjk<float, gjk::AsPrinted>(f))};
  const std::array<bool, ways> moller = ask_all_mollers(t, f);
  compare_all(gjk, moller, meet, floats_meet, sum);
  sum.meet += meet ? 1 : 0;
  sum.undecided += status == gjk::Status::undecided ? 1 : 0;
  sum.rounding_changes_truth += meet != floats_meet ? 1 : 0;
  for (std::size_t m = 0; m < ways; ++m)
    if (gjk[0] != moller[m])
      sum.disagreements.push_back({index, static_cast<MollerWay>(m), gjk[0], meet, status == gjk::Status::undecided,
                                   depth_of(triangles_of<Exact>(pair))});
}

// -- Coarse coordinates -----------------------------------------------------------------------------------------------

bool nearly_touch(const Triangles<double>& t) {
  const auto finding = moller_1997::find(t.a, t.b, Distances::as_computed);
  if (finding.how != moller_1997::How::intervals) return false;
  const auto &i = finding.first, &j = finding.second;
  const double size = std::max({std::fabs(i.least), std::fabs(i.most), std::fabs(j.least), std::fabs(j.most)});
  return std::min(std::fabs(i.most - j.least), std::fabs(j.most - i.least)) <= 1e-9 * size;
}

/// One common point, inside an edge of each, and not in one plane: no corner lies in the other's plane, so that the ends
/// of the intervals lie inside edges, and an end of one is an end of the other.
bool edges_touch(const Triangles<Exact>& t) {
  const auto finding = moller_1997::find(t.a, t.b, Distances::as_computed);
  if (finding.how != moller_1997::How::intervals) return false;
  for (const auto& distances : {finding.first_distances, finding.second_distances})
    if (std::ranges::count(distances, Exact(0)) > 0) return false;
  return finding.first.most == finding.second.least || finding.second.most == finding.first.least;
}

void ask_about(const Pair& pair, const Pair& in_float, TouchCounts& sum) {
  const Triangles<double> t = triangles_of<double>(pair);
  const Triangles<float> f = triangles_of<float>(in_float);
  const bool meet = truly_meet(pair), floats_meet = truly_meet(in_float);
  const bool gjk = ask_gjk<double, gjk::AsIntended>(t) == gjk::Status::intersecting;
  const bool float_gjk = ask_gjk<float, gjk::AsIntended>(f) == gjk::Status::intersecting;
  const std::array<bool, ways> moller = ask_all_mollers(t, f);
  const bool touch = nearly_touch(t) && edges_touch(triangles_of<Exact>(pair));
  ++sum.pairs;
  sum.edges_touch.add(touch);
  for (std::size_t m = 0; m < ways; ++m) {
    const bool in_floats = m % 2 == 1, says = in_floats ? float_gjk : gjk;
    sum.compared[m].add(says, moller[m], in_floats ? floats_meet : meet);
    if (touch && says && !moller[m]) ++sum.edges_touch_only_gjk[m];
  }
}

}  // namespace

void Comparison::add(bool gjk, bool moller, bool truth) {
  if (gjk == moller)
    ++(gjk ? both_yes : both_no);
  else if (gjk)
    only_gjk.add(truth);
  else
    only_moller.add(truth);
}

Comparison& Comparison::operator+=(const Comparison& other) {
  both_yes += other.both_yes;
  both_no += other.both_no;
  only_gjk += other.only_gjk;
  only_moller += other.only_moller;
  return *this;
}

MollerCounts& MollerCounts::operator+=(const MollerCounts& other) {
  for (std::size_t g = 0; g < ways; ++g)
    for (std::size_t m = 0; m < ways; ++m) compared[g][m] += other.compared[g][m];
  meet += other.meet;
  undecided += other.undecided;
  rounding_changes_truth += other.rounding_changes_truth;
  disagreements.insert(disagreements.end(), other.disagreements.begin(), other.disagreements.end());
  return *this;
}

MollerCounts measure_moller(const ClaimsOptions& options) {
  const Family& triangles = family_named("triangles");
  MollerCounts counts = over_pairs<MollerCounts>(
      options.pairs, options.threads,
      [&](MollerCounts& sum, std::uint64_t index) { ask_about(triangles.make(options.seed, index), index, sum); });
  std::ranges::sort(counts.disagreements, {}, [](const Disagreement& d) { return std::pair(d.index, d.moller); });
  return counts;
}

const std::vector<Coarseness>& coarsenesses() {
  static const std::vector<Coarseness> all{{11, 1},   {31, 1},    {101, 1},     {131, 1},      {201, 1},
                                           {1001, 1}, {101, 100}, {1001, 1000}, {32768, 32767}};
  return all;
}

TouchCounts& TouchCounts::operator+=(const TouchCounts& other) {
  pairs += other.pairs;
  edges_touch += other.edges_touch;
  for (std::size_t m = 0; m < ways; ++m) {
    compared[m] += other.compared[m];
    edges_touch_only_gjk[m] += other.edges_touch_only_gjk[m];
  }
  return *this;
}

TouchCounts measure_touches(const Coarseness& coarseness, const ClaimsOptions& options) {
  return over_pairs<TouchCounts>(options.pairs, options.threads, [&](TouchCounts& sum, std::uint64_t index) {
    Dice dice(options.seed, "coarse-triangles", index);
    const Pair pair = coarse_triangles(dice, coarseness.levels, coarseness.divisor);
    ask_about(pair, rounded_to_float(pair), sum);
  });
}

}  // namespace study
