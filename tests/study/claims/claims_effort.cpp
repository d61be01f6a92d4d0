#include <algorithm>

#include "core/gjk.hpp"
#include "tests/study/claims/claims.hpp"
#include "tests/study/methods/method.hpp"
#include "tests/study/pairs/over_pairs.hpp"
#include "tests/study/pairs/pairs.hpp"
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

void ask(const Pair& pair, std::optional<Truth> truly, EffortCounts& sum) {
  const auto a = form_of<double>(pair.a), b = form_of<double>(pair.b);
  Watch watch{{}, Shortcuts(sum)};
  const auto result = gjk::collision<double>(AnyForm<double>{*a}, AnyForm<double>{*b}, gjk::Options<double>{}, watch);
  const Effort kind = kind_of(result.status, truly);
  count(sum[kind], result.iterations);
  if (kind == Effort::hits) count(sum[Effort::hit_cross_products], watch.cross_products.total);
  if (kind == Effort::misses) count(sum[Effort::miss_cross_products], watch.cross_products.total);
  count(sum[Effort::most_in_a_3simplex], watch.cross_products.most_in_a_3simplex);
}

}  // namespace

std::uint64_t Shape::pairs(const ClaimsOptions& options) const {
  const std::uint64_t wanted =
      hardness == Hardness::random ? options.pairs : std::max(options.pairs / 10, std::uint64_t{1});
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
    for (const char* const name : {"flat-1e-6", "flat-1e-9-turned", "needles-1e6"})
      all.push_back(of_family(name, Hardness::hard));
    all.push_back(of_family("coplanar-tilted", Hardness::hard_whole));
    all.push_back(of_family("near-parallel-edges", Hardness::hard));
    for (const char* const name : {"touching-vertex-askew", "touching-edge-askew", "touching-face-askew", "cycles"})
      all.push_back(of_family(name, Hardness::hard_whole));
    for (const char* const name : {"spheres-gap-1e-3", "spheres-gap-1e-6", "spheres-gap-1e-12"})
      all.push_back(of_family(name, Hardness::hard));
    return all;
  }();
  return shapes;
}

EffortCounts count_effort(const Shape& shape, const ClaimsOptions& options) {
  return over_pairs<EffortCounts>(shape.pairs(options), options.threads, [&](EffortCounts& sum, std::uint64_t index) {
    const Pair pair = shape.make(options.seed, index);
    ask(pair, shape.hardness == Hardness::random ? std::nullopt : std::optional(truth(pair)), sum);
  });
}

EffortCounts count_in_fractions(const Shape& shape, const ClaimsOptions& options) {
  const std::uint64_t pairs = std::min(shape.pairs(options), std::max(options.pairs / 50, std::uint64_t{1}));
  return over_pairs<EffortCounts>(pairs, options.threads, [&](EffortCounts& sum, std::uint64_t index) {
    const Pair pair = shape.make(options.seed, index);
    const auto a = form_of<Exact>(pair.a), b = form_of<Exact>(pair.b);
    Shortcuts shortcuts(sum);
    gjk::collision<Exact>(AnyForm<Exact>{*a}, AnyForm<Exact>{*b}, gjk::Options<Exact>{}, shortcuts);
  });
}

}  // namespace study
