#include "walkthroughs/steps/differences.hpp"

#include <algorithm>

#include "core/gjk.hpp"

namespace walkthroughs::steps {
namespace {

constexpr double same_place = 1e-9;  // of the size
constexpr double same_rounded = 4e-6, roundings_of_floats = 0x1p+29;
constexpr double same_direction = 1e-4;  // 1 - cosine
constexpr std::size_t most_differences = 1'000'000, most_of_farthest = 100;

bool are_too_many(const Points& a, const Points& b) { return a.size() * b.size() > most_differences; }

/// Whether each step that adds a vertex to others has it first, and two steps at least do so.
bool is_newest_first(const std::vector<ToldStep>& steps) {
  int seen = 0;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const Vertices &before = steps[i - 1].simplex, &now = steps[i].simplex;
    const auto is_new = [&](const Vec& v) { return std::ranges::find(before, v) == before.end(); };
    if (now.size() < 2 || std::ranges::count_if(now, is_new) != 1) continue;
    if (!is_new(now.front())) return false;
    ++seen;
  }
  return seen >= 2;
}

/// Where two vertices come in the first step, the older one is that from which this step's direction leads to the origin.
void tell_first_point(ToldRun& run, const Differences& differences) {
  if (run.steps.empty() || run.steps.front().simplex.size() != 2 || !run.steps.front().is_of_numbers()) return;
  ToldStep& second = run.steps.front();
  if (const Vec& last = second.simplex.back();
      parallel(second.direction, -last) && !differences.reaches(last, second.direction))
    std::ranges::reverse(second.simplex);
  const Vec first = second.simplex.front();
  if (const std::optional<Vec> d = differences.direction_to(first)) run.steps.insert(run.steps.begin(), {*d, {first}});
}

}  // namespace

bool parallel(const Vec& x, const Vec& y) {
  const double lengths = x.stableNorm() * y.stableNorm();
  return lengths > 0 && x.dot(y) >= (1 - same_direction) * lengths;
}

Differences::Differences(const Points& a, const Points& b) : a_(a), b_(b) {
  Vec low = a.front(), high = a.front();
  for (const Points* const points : {&a, &b})
    for (const Vec& p : *points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  size_ = (high - low).maxCoeff();
}

Vec Differences::nearest(const Vec& v) const {
  if (are_too_many(a_, b_)) return v;
  double least = same_rounded * size_;
  Vec nearest = v;
  for (const Vec& p : a_)
    for (const Vec& q : b_)
      if (const double off = (p - q - v).cwiseAbs().maxCoeff(); off < least) {
        least = off;
        nearest = p - q;
      }
  return nearest;
}

bool Differences::are_same(const Vec& x, const Vec& y) const {
  return (x - y).cwiseAbs().maxCoeff() <= same_place * size_;
}

bool Differences::has(const Vertices& vertices, const Vec& v) const {
  return std::ranges::any_of(vertices, [&](const Vec& each) { return are_same(each, v); });
}

Points Differences::farthest(const Points& points, const Vec& d) const {
  double reach = points[0].dot(d);
  for (const Vec& p : points) reach = std::max(reach, p.dot(d));
  const double tolerance = same_place * size_ * d.stableNorm();
  Points all;
  for (const Vec& p : points)
    if (p.dot(d) >= reach - tolerance) all.push_back(p);
  return all;
}

Vertices Differences::farthest(const Vec& d, const Vec& d_of_b) const {
  Points a = farthest(a_, d), b = farthest(b_, d_of_b);
  for (Points* const some : {&a, &b}) some->resize(std::min(some->size(), most_of_farthest));
  Vertices all;
  for (const Vec& p : a)
    for (const Vec& q : b) all.push_back(p - q);
  return all;
}

bool Differences::reaches(const Vec& v, const Vec& d) const {
  const double most = farthest(a_, d).front().dot(d) - farthest(b_, -d).front().dot(d);
  return v.dot(d) >= most - same_place * size_ * d.stableNorm() && contain(v);
}

bool Differences::is_farthest(const Vec& v, const Vec& d, const Vec& d_of_b) const {
  const Points a = farthest(a_, d), b = farthest(b_, d_of_b);
  return !are_too_many(a, b) && is_between(a, b, v);
}

std::optional<Vec> Differences::direction_to(const Vec& v) const {
  for (Eigen::Index axis = 0; axis < 3; ++axis)  // most begin along one
    for (const double sign : {1, -1})
      if (const Vec d = sign * Vec::Unit(axis); reaches(v, d)) return d;
  if (are_too_many(a_, b_)) return std::nullopt;
  Points others;
  for (const Vec& p : a_)
    for (const Vec& q : b_)
      if (!are_same(p - q, v)) others.push_back(p - q);
  const gjk::PointSet<double> all(others), one({v});
  const auto apart = gjk::collision<double>(all, one).separation;
  if (!apart || !reaches(v, apart->direction)) return std::nullopt;
  return apart->direction;
}

bool Differences::contain(const Vec& v) const { return are_too_many(a_, b_) || is_between(a_, b_, v); }

bool Differences::is_between(const Points& a, const Points& b, const Vec& v) const {
  return std::ranges::any_of(
      a, [&](const Vec& p) { return std::ranges::any_of(b, [&](const Vec& q) { return are_same(p - q, v); }); });
}

void bring_to_differences(ToldRun& run) {
  const Differences differences(run.pair.a, run.pair.b);
  for (ToldStep& step : run.steps)
    for (Vec& v : step.simplex) {
      if (!v.allFinite()) continue;
      const Vec exact = differences.nearest(v);
      if (!differences.are_same(exact, v)) run.roundings = roundings_of_floats;
      v = exact;
    }
  if (is_newest_first(run.steps))
    for (ToldStep& step : run.steps) std::ranges::reverse(step.simplex);
  tell_first_point(run, differences);
}

}  // namespace walkthroughs::steps
