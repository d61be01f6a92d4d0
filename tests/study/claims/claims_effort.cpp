#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "core/gjk.hpp"
#include "tests/study/claims/claims_measured.hpp"
#include "tests/study/pairs/dice.hpp"
#include "tests/study/pairs/families.hpp"
#include "tests/study/truth/oracle.hpp"
#include "tests/study/pairs/over_pairs.hpp"
#include "tests/study/methods/question.hpp"

namespace study {
namespace {

Pair balls(std::uint64_t seed, std::uint64_t index) {
  Dice dice(seed, "claims-balls", index);
  const double r = dice.between(0.5, 1), s = dice.between(0.5, 1);
  return {Ball{Vec::Zero(), r}, Ball{dice.between(0, 3) * dice.direction(), s}};
}

Shape of_family(const std::string& name, Hardness hardness, const std::string& called = {}) {
  const Family& family = family_named(name);
  return {called.empty() ? name : called, family.what, hardness, family.size, family.make};
}

gjk::PointSet<double> shape_of(const Points& points) { return gjk::PointSet<double>(points); }
gjk::Sphere<double> shape_of(const Ball& ball) { return {ball.center, ball.radius}; }

/// Errors: std::logic_error where a coordinate is not a double.
gjk::Simplex<double> in_doubles(const gjk::Simplex<Exact>& exact) {
  gjk::Simplex<double> simplex;
  for (int i = 0; i < exact.size(); ++i) {
    Vec w;
    for (int k = 0; k < 3; ++k) {
      w[k] = exact[i].w[k].convert_to<double>();
      if (Exact(w[k]) != exact[i].w[k]) throw std::logic_error("a vertex is not of doubles");
    }
    simplex.add({{}, {}, w});
  }
  return simplex;
}

/// A run in fractions.
struct ExactWatch {
  Shortcuts& shortcuts;

  template <class E>
  void operator()(const E&) {}
  void operator()(const gjk::VertexAdded<Exact>& event) { shortcuts.look_at(in_doubles(event.simplex)); }
};

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

/// `truly`: what is true of the pair, where GJK's answer is not taken for it.
Cost& kind_of(gjk::Status status, std::optional<Truth> truly, ShapeEffort& sum) {
  if (status == gjk::Status::undecided) return sum.undecided;
  const Truth answer = status == gjk::Status::intersecting ? Truth::intersecting : Truth::separated;
  if (answer != truly.value_or(answer)) return sum.wrong;
  return answer == Truth::intersecting ? sum.hits : sum.misses;
}

template <class A, class B>
void ask(const A& a, const B& b, std::optional<Truth> truly, ShapeEffort& sum) {
  Watch watch{{}, sum.shortcuts};
  const auto result = gjk::collision<double>(shape_of(a), shape_of(b), gjk::Options<double>{}, watch);
  Cost& cost = kind_of(result.status, truly, sum);
  cost.iterations.add(result.iterations);
  cost.cross_products.add(watch.cross_products.total);
  sum.most_in_a_3simplex.add(watch.cross_products.most_in_a_3simplex);
}

void ask(const Pair& pair, std::optional<Truth> truly, ShapeEffort& sum) {
  if (const Points* const a = std::get_if<Points>(&pair.a))
    ask(*a, std::get<Points>(pair.b), truly, sum);
  else
    ask(std::get<Ball>(pair.a), std::get<Ball>(pair.b), truly, sum);
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

std::uint64_t ShapeEffort::queries() const {
  return hits.iterations.queries() + misses.iterations.queries() + wrong.iterations.queries() +
         undecided.iterations.queries();
}

Rate ShapeEffort::answered_within(int least, int most) const {
  Rate rate;
  for (const Cost* const cost : {&hits, &misses, &wrong}) rate.count += cost->iterations.between(least, most).count;
  rate.trials = queries();
  return rate;
}

ShapeEffort& ShapeEffort::operator+=(const ShapeEffort& other) {
  hits += other.hits;
  misses += other.misses;
  wrong += other.wrong;
  undecided += other.undecided;
  most_in_a_3simplex += other.most_in_a_3simplex;
  shortcuts += other.shortcuts;
  return *this;
}

std::uint64_t Shape::pairs(const ClaimsOptions& options) const {
  const std::uint64_t wanted =
      hardness == Hardness::hard ? std::max(options.pairs / 10, std::uint64_t{1}) : options.pairs;
  return std::min(wanted, size.value_or(wanted));
}

const std::vector<Shape>& claim_shapes() {
  static const std::vector<Shape> shapes = [] {
    std::vector<Shape> all{
        of_family("triangles", Hardness::random),
        of_family("tetrahedra", Hardness::random),
        of_family("boxes", Hardness::random),
        of_family("hulls-32", Hardness::random, "32-point hulls"),
        {"spheres", "radii of 1/2 to 1, centers up to 3 apart", Hardness::random, {}, balls},
    };
    for (const char* const name :
         {"flat-1e-6", "flat-1e-9-turned", "needles-1e6", "coplanar-tilted", "near-parallel-edges",
          "touching-vertex-askew", "touching-edge-askew", "touching-face-askew", "cycles", "spheres-gap-1e-3",
          "spheres-gap-1e-6", "spheres-gap-1e-12"})
      all.push_back(of_family(name, Hardness::hard));
    return all;
  }();
  return shapes;
}

const Shape& claim_shape(const std::string& name) {
  const auto found = std::ranges::find(claim_shapes(), name, &Shape::name);
  if (found == claim_shapes().end()) throw std::invalid_argument("no claim is about " + name);
  return *found;
}

ShapeEffort measure_effort(const Shape& shape, const ClaimsOptions& options) {
  return over_pairs<ShapeEffort>(shape.pairs(options), options.threads, [&](ShapeEffort& sum, std::uint64_t index) {
    const Pair pair = shape.make(options.seed, index);
    ask(pair, shape.hardness == Hardness::hard ? std::optional(truth(pair)) : std::nullopt, sum);
  });
}

const std::vector<std::string>& whole_number_shapes() {
  static const std::vector<std::string> names{"coplanar-tilted", "touching-vertex-askew", "touching-edge-askew",
                                              "touching-face-askew", "cycles"};
  return names;
}

Shortcuts measure_in_fractions(const Shape& shape, const ClaimsOptions& options) {
  const std::uint64_t pairs = std::min(shape.pairs(options), std::max(options.pairs / 50, std::uint64_t{1}));
  return over_pairs<Shortcuts>(pairs, options.threads, [&](Shortcuts& sum, std::uint64_t index) {
    const Pair pair = shape.make(options.seed, index);
    const auto a = form_of<Exact>(pair.a), b = form_of<Exact>(pair.b);
    ExactWatch watch{sum};
    gjk::collision<Exact>(std::get<gjk::PointSet<Exact>>(*a), std::get<gjk::PointSet<Exact>>(*b), gjk::Options<Exact>{},
                          watch);
  });
}

}  // namespace study
