#include "tests/study/methods/mistakes.hpp"

#include <set>

#include "tests/kit/catch.hpp"
#include "tests/study/claims/claims.hpp"

namespace study {
namespace {

TEST_CASE("Every mistake changes some runs, and all have names of their own", "[mistakes]") {
  const ClaimsOptions options{.pairs = 3000, .seed = 1, .threads = 2};
  MistakeCounts all = count_mistakes("grid", options);
  all += count_mistakes("tetrahedra", options);
  std::set<std::string> names;
  for (std::size_t i = 0; i < mistakes().size(); ++i) {
    INFO(mistakes()[i].name);
    REQUIRE(all[i][OfMistake::changed] > 0);
    REQUIRE(names.insert(mistakes()[i].name).second);
  }
}

TEST_CASE("A mistake that is asked about a pair by hand: the zero direction, the first point, the wrong side",
          "[mistakes]") {
  const auto ask = [](const std::string& part, const Points& a, const Points& b) {
    for (const Mistake& mistake : mistakes())
      if (mistake.name.find(part) != std::string::npos)
        return mistake.ask(gjk::PointSet<double>(a), gjk::PointSet<double>(b)).status;
    throw std::invalid_argument("no mistake is called " + part);
  };
  const Points origin{{0, 0, 0}};
  using gjk::Status;
  REQUIRE(ask("first vertex", origin, origin) == Status::undecided);
  REQUIRE(ask("the segment is not", {{1, 0, 0}, {-1, 0, 0}}, origin) == Status::undecided);
  REQUIRE(ask("first point", {{-1, 0, 0}, {-2, 0, 0}}, origin) == Status::separated);
  REQUIRE(ask("first point", {{1, 0, 0}, {-2, 0, 0}}, origin) == Status::intersecting);
  REQUIRE(ask("<=", {{1, 0, 0}, {0, 0, 0}}, origin) == Status::separated);
  REQUIRE(ask("as printed", {{5, 0, 0}}, origin) == Status::intersecting);
  REQUIRE(ask("support(B, d)", {{3, 0, 0}, {2, 0, 0}}, {{0, 0, 0}, {2.5, 0, 0}}) == Status::separated);
}

}  // namespace
}  // namespace study
