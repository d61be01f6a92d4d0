/// What is proven without being a method of the study, on its families: searches that start inside.
#include <algorithm>

#include "core/certificate_check.hpp"
#include "core/certified.hpp"
#include "tests/kit/catch.hpp"
#include "tests/study/pairs/families.hpp"
#include "tests/study/truth/oracle.hpp"

namespace study::test {
TEST_CASE("Starting inside changes no certified answer on any family, and its certificates hold", "[certified]") {
  const auto mean = [](const Points& points) {
    return walkthroughs::middle<double>(
        walkthroughs::converted<double>(walkthroughs::AnyShape(points), walkthroughs::Cast<double>{}));
  };
  int by_mean = 0;
  for (const Family& family : families())
    for (std::uint64_t i = 0; i < std::min<std::uint64_t>(family.size.value_or(40), 40); ++i) {
      const Pair pair = family.make(7, i);
      const auto *a = std::get_if<Points>(&pair.a), *b = std::get_if<Points>(&pair.b);
      if (!a || !b) break;
      INFO(family.name << ", pair " << i);
      const gjk::PointSet<double> one(*a), other(*b);
      gjk::Options<double> options{.iteration_limit = 100};
      options.inside = gjk::PointOfEach<double>{mean(*a), mean(*b)};
      CHECK((options.inside->a == one.mean() || !one.mean().allFinite()));
      const gjk::CertifiedResult result = gjk::certified_collision(one, other, options);
      CHECK((result.status == gjk::Status::intersecting) == (truth(pair) == Truth::intersecting));
      CHECK(result.status != gjk::Status::undecided);
      CHECK(gjk::holds(result.certificate, one, other));
      if (const auto* simplex = std::get_if<gjk::CommonSimplex>(&result.certificate))
        by_mean += std::ranges::count(simplex->of, gjk::IndexPair{gjk::IndexPair::mean, gjk::IndexPair::mean}) > 0;
    }
  CHECK(by_mean > 100);
}

}  // namespace study::test
