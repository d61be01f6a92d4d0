#include <algorithm>
#include <numeric>

#include "core/gjk.hpp"
#include "tests/study/claims_measured.hpp"
#include "tests/study/dice.hpp"
#include "tests/study/families.hpp"
#include "tests/study/over_pairs.hpp"

namespace study {
namespace {

Pair balls(std::uint64_t seed, std::uint64_t index) {
  Dice dice(seed, "claims-balls", index);
  const double r = dice.between(0.5, 1), s = dice.between(0.5, 1);
  return {Ball{Vec::Zero(), r}, Ball{dice.between(0, 3) * dice.direction(), s}};
}

template <int family>
Pair of_family(std::uint64_t seed, std::uint64_t index) {
  static const Family& made = family_named(std::array{"triangles", "tetrahedra", "boxes", "hulls-32"}[family]);
  return made.make(seed, index);
}

gjk::PointSet<double> shape_of(const Points& points) { return gjk::PointSet<double>(points); }
gjk::Sphere<double> shape_of(const Ball& ball) { return {ball.center, ball.radius}; }

/// One run, watched by both observers.
struct Watch {
  CrossProducts cross_products;
  Shortcuts& shortcuts;

  template <class E>
  void operator()(const E& event) {
    cross_products(event);
    shortcuts(event);
  }
};

template <class A, class B>
void ask(const A& a, const B& b, ShapeEffort& sum) {
  Watch watch{{}, sum.shortcuts};
  const auto result = gjk::collision<double>(shape_of(a), shape_of(b), gjk::Options<double>{}, watch);
  Cost& effort = result.status == gjk::Status::intersecting ? sum.hits
                 : result.status == gjk::Status::separated  ? sum.misses
                                                            : sum.undecided;
  effort.iterations.add(result.iterations);
  effort.cross_products.add(watch.cross_products.total);
  sum.most_in_a_3simplex.add(watch.cross_products.most_in_a_3simplex);
}

void ask(const Pair& pair, ShapeEffort& sum) {
  if (const Points* const a = std::get_if<Points>(&pair.a))
    ask(*a, std::get<Points>(pair.b), sum);
  else
    ask(std::get<Ball>(pair.a), std::get<Ball>(pair.b), sum);
}

}  // namespace

// -- Distribution -----------------------------------------------------------------------------------------------------

void Distribution::add(int k) {
  const auto i = static_cast<std::size_t>(k);
  if (counts_.size() <= i) counts_.resize(i + 1);
  ++counts_[i];
}

Distribution& Distribution::operator+=(const Distribution& other) {
  counts_.resize(std::max(counts_.size(), other.counts_.size()));
  for (std::size_t i = 0; i < other.counts_.size(); ++i) counts_[i] += other.counts_[i];
  return *this;
}

std::uint64_t Distribution::queries() const {
  return std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0});
}

Rate Distribution::between(int least, int most) const {
  Rate rate{0, queries()};
  for (std::size_t i = 0; i < counts_.size(); ++i)
    if (static_cast<int>(i) >= least && static_cast<int>(i) <= most) rate.count += counts_[i];
  return rate;
}

double Distribution::mean() const {
  double sum = 0;
  for (std::size_t i = 0; i < counts_.size(); ++i) sum += static_cast<double>(i) * static_cast<double>(counts_[i]);
  return queries() == 0 ? 0 : sum / static_cast<double>(queries());
}

int Distribution::percentile_99() const {
  const std::uint64_t all = queries();
  std::uint64_t seen = 0;
  for (std::size_t i = 0; i < counts_.size(); ++i)
    if (100 * (seen += counts_[i]) >= 99 * all) return static_cast<int>(i);
  return 0;
}

int Distribution::max() const {
  const auto last = std::find_if(counts_.rbegin(), counts_.rend(), [](std::uint64_t n) { return n > 0; });
  return last == counts_.rend() ? 0 : static_cast<int>(counts_.rend() - last) - 1;
}

// -- Effort -----------------------------------------------------------------------------------------------------------

Cost& Cost::operator+=(const Cost& other) {
  iterations += other.iterations;
  cross_products += other.cross_products;
  return *this;
}

Distribution ShapeEffort::all_iterations() const {
  Distribution all = hits.iterations;
  all += misses.iterations;
  return all += undecided.iterations;
}

ShapeEffort& ShapeEffort::operator+=(const ShapeEffort& other) {
  hits += other.hits;
  misses += other.misses;
  undecided += other.undecided;
  most_in_a_3simplex += other.most_in_a_3simplex;
  shortcuts += other.shortcuts;
  return *this;
}

const std::vector<Shape>& claim_shapes() {
  static const std::vector<Shape> shapes{
      {"triangles", "family triangles, the report's", of_family<0>},
      {"tetrahedra", "family tetrahedra", of_family<1>},
      {"boxes", "family boxes", of_family<2>},
      {"32-point hulls", "family hulls-32", of_family<3>},
      {"spheres", "radii of 1/2 to 1, centers up to 3 apart", balls},
  };
  return shapes;
}

ShapeEffort measure_effort(const Shape& shape, const ClaimsOptions& options) {
  return over_pairs<ShapeEffort>(options.pairs, options.threads, [&](ShapeEffort& sum, std::uint64_t index) {
    ask(shape.make(options.seed, index), sum);
  });
}

}  // namespace study
