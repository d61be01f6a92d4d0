#include <algorithm>
#include <stdexcept>

#include "core/gjk.hpp"
#include "tests/study/claims/claims.hpp"
#include "tests/study/methods/question.hpp"
#include "tests/study/pairs/dice.hpp"
#include "tests/study/pairs/families.hpp"
#include "tests/study/pairs/over_pairs.hpp"
#include "tests/study/truth/oracle.hpp"

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
  Shortcuts shortcuts;

  template <class E>
  void operator()(const E&) {}
  void operator()(const gjk::VertexAdded<Exact>& event) { shortcuts.look_at(in_doubles(event.simplex)); }
};

/// One run, watched by both observers.
struct Watch {
  CrossProducts cross_products;
  Shortcuts shortcuts;

  template <class E>
  void operator()(const E& event) {
    cross_products(event);
    shortcuts(event);
  }
};

/// `truly`: what is true of the pair, where GJK's answer is not taken for it.
Effort kind_of(gjk::Status status, std::optional<Truth> truly) {
  if (status == gjk::Status::undecided) return Effort::undecided;
  const Truth answer = status == gjk::Status::intersecting ? Truth::intersecting : Truth::separated;
  if (answer != truly.value_or(answer)) return Effort::wrong;
  return answer == Truth::intersecting ? Effort::hits : Effort::misses;
}

template <class A, class B>
void ask(const A& a, const B& b, std::optional<Truth> truly, EffortCounts& sum) {
  Watch watch{{}, Shortcuts(sum)};
  const auto result = gjk::collision<double>(shape_of(a), shape_of(b), gjk::Options<double>{}, watch);
  const Effort kind = kind_of(result.status, truly);
  count(sum[kind], result.iterations);
  if (kind == Effort::hits) count(sum[Effort::hit_cross_products], watch.cross_products.total);
  if (kind == Effort::misses) count(sum[Effort::miss_cross_products], watch.cross_products.total);
  count(sum[Effort::most_in_a_3simplex], watch.cross_products.most_in_a_3simplex);
}

void ask(const Pair& pair, std::optional<Truth> truly, EffortCounts& sum) {
  if (const Points* const a = std::get_if<Points>(&pair.a))
    ask(*a, std::get<Points>(pair.b), truly, sum);
  else
    ask(std::get<Ball>(pair.a), std::get<Ball>(pair.b), truly, sum);
}

}  // namespace

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

EffortCounts count_effort(const Shape& shape, const ClaimsOptions& options) {
  return over_pairs<EffortCounts>(shape.pairs(options), options.threads, [&](EffortCounts& sum, std::uint64_t index) {
    const Pair pair = shape.make(options.seed, index);
    ask(pair, shape.hardness == Hardness::hard ? std::optional(truth(pair)) : std::nullopt, sum);
  });
}

const std::vector<std::string>& whole_number_shapes() {
  static const std::vector<std::string> names{"coplanar-tilted", "touching-vertex-askew", "touching-edge-askew",
                                              "touching-face-askew", "cycles"};
  return names;
}

EffortCounts count_in_fractions(const Shape& shape, const ClaimsOptions& options) {
  const std::uint64_t pairs = std::min(shape.pairs(options), std::max(options.pairs / 50, std::uint64_t{1}));
  return over_pairs<EffortCounts>(pairs, options.threads, [&](EffortCounts& sum, std::uint64_t index) {
    const Pair pair = shape.make(options.seed, index);
    const auto a = form_of<Exact>(pair.a), b = form_of<Exact>(pair.b);
    ExactWatch watch{Shortcuts(sum)};
    gjk::collision<Exact>(std::get<gjk::PointSet<Exact>>(*a), std::get<gjk::PointSet<Exact>>(*b), gjk::Options<Exact>{},
                          watch);
  });
}

}  // namespace study
