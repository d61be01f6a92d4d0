/// What is proven without being a method of the study, on its families: searches that start inside, and shapes whose points are
/// computed.
#include <algorithm>
#include <map>

#include "core/certificate_check.hpp"
#include "core/certified.hpp"
#include "core/certified_shapes.hpp"
#include "core/complete.hpp"
#include "tests/kit/catch.hpp"
#include "tests/study/pairs/families.hpp"
#include "tests/study/truth/oracle.hpp"
#include "walkthroughs/model/exact_number.hpp"

namespace study::test {
namespace {

using walkthroughs::Exact;
constexpr std::uint64_t seed = 7;

std::uint64_t at_most(const Family& family, std::uint64_t pairs) {
  return std::min(family.size.value_or(pairs), pairs);
}

gjk::Status status_of(Truth truth) {
  return truth == Truth::intersecting ? gjk::Status::intersecting : gjk::Status::separated;
}

template <class S>
gjk::Options<S> inside(const Points& a, const Points& b) {
  const auto mean = [](const Points& points) {
    return walkthroughs::middle<S>(walkthroughs::converted<S>(walkthroughs::AnyShape(points), walkthroughs::Cast<S>{}));
  };
  gjk::Options<S> options;
  options.iteration_limit = 100;
  options.inside = gjk::PointOfEach<S>{mean(a), mean(b)};
  return options;
}

/// Calls look(a, b, truth) for the first pairs of points of each family.
template <class Look>
void for_each_pair_of_points(std::uint64_t pairs, const Look& look) {
  for (const Family& family : families())
    for (std::uint64_t i = 0; i < at_most(family, pairs); ++i) {
      const Pair pair = family.make(seed, i);
      const auto *a = std::get_if<Points>(&pair.a), *b = std::get_if<Points>(&pair.b);
      if (!a || !b) break;
      INFO(family.name << ", pair " << i);
      look(*a, *b, status_of(truth(pair)));
    }
}

}  // namespace

TEST_CASE("Starting inside changes no certified answer on any family, and its certificates hold", "[certified]") {
  int by_mean = 0;
  for_each_pair_of_points(40, [&](const Points& a, const Points& b, gjk::Status expected) {
    const gjk::PointSet<double> one(a), other(b);
    const auto options = inside<double>(a, b);
    CHECK((options.inside->a == one.mean() || !one.mean().allFinite()));
    const gjk::CertifiedResult result = gjk::certified_collision(one, other, options);
    CHECK(result.status == expected);
    CHECK(gjk::holds(result.certificate, one, other));
    if (const auto* simplex = std::get_if<gjk::CommonSimplex>(&result.certificate))
      by_mean += std::ranges::count(simplex->of, gjk::IndexPair{gjk::IndexPair::mean, gjk::IndexPair::mean}) > 0;
  });
  CHECK(by_mean > 100);
}

TEST_CASE("Starting inside, exact searches answer rightly on every family", "[inside]") {
  std::map<gjk::Status, int> seen;
  for_each_pair_of_points(4, [&](const Points& a, const Points& b, gjk::Status expected) {
    const auto exact = [](const Points& points) {
      std::vector<gjk::Vec3<Exact>> list;
      for (const Vec& p : points) list.push_back(walkthroughs::Cast<Exact>{}.point(p));
      return gjk::PointSet<Exact>(list);
    };
    const auto result = gjk::collision<Exact, gjk::Complete<>>(exact(a), exact(b), inside<Exact>(a, b));
    CHECK(result.status == expected);
    ++seen[result.status];
  });
  CHECK(seen.size() == 2);
}

TEST_CASE("Cylinders and balls are decided on every family, rightly, also in flat contact", "[certified]") {
  int families_of_round = 0;
  for (const Family& family : families()) {
    std::map<gjk::Status, int> seen;
    for (std::uint64_t i = 0; i < at_most(family, 100); ++i) {
      const Pair pair = family.make(seed, i);
      if (std::holds_alternative<Points>(pair.a) || std::holds_alternative<Points>(pair.b)) break;
      const walkthroughs::Asked<double> a(std::visit([](auto one) { return walkthroughs::AnyShape(one); }, pair.a)),
          b(std::visit([](auto one) { return walkthroughs::AnyShape(one); }, pair.b));
      const gjk::ShapesResult result = std::visit(
          [](const auto& one, const auto& other) {
            if constexpr (gjk::DoubtfulShape<decltype(one), double> && gjk::DoubtfulShape<decltype(other), double>)
              return gjk::certified_shapes(one, other);
            else
              return gjk::ShapesResult{};
          },
          a.form(), b.form());
      INFO(family.name << ", pair " << i);
      CHECK(result.status == status_of(truth(pair)));
      ++seen[result.status];
    }
    families_of_round += !seen.empty();
  }
  CHECK(families_of_round >= 10);
}

}  // namespace study::test
