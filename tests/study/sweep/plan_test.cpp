#include "tests/study/sweep/plan.hpp"

#include "tests/kit/catch.hpp"

namespace study::test {
namespace plan_test {

TEST_CASE("A shard is written I/N and counted from 0", "[plan]") {
  CHECK(parse_shard("2/8") == Shard{2, 8});
  for (const char* const text : {"8/8", "1", "/", "1/", "/2", "-1/2", "0/0", "1/2/3", "a/b", "", "1 /2"}) {
    INFO(text);
    CHECK_THROWS_AS(parse_shard(text), UsageError);
  }
}

TEST_CASE("A command names the extent of a study, and what was chosen", "[plan]") {
  CHECK(command_of({}) == "gjkstep-study run --quick --seed 1");
  CHECK(command_of({.is_full = true, .rules = {"eager", "complete"}, .limits = {5, 20}}) ==
        "gjkstep-study run --full --seed 1 --rules eager,complete --limit 5,20");
}

TEST_CASE("Names that nobody knows are refused with the one that was probably meant", "[plan]") {
  const auto complaint = [](const Request& request) -> std::string {
    try {
      plan_of(request);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  };
  CHECK_THAT(complaint({.families = {"triangle"}}), kit::contains("no family 'triangle'; did you mean 'triangles'?"));
  CHECK_THAT(complaint({.rules = {"printed"}}), kit::contains("'as-printed'"));
  CHECK_THAT(complaint({.scalars = {"dubble"}}), kit::contains("'double'"));
  CHECK_THAT(complaint({.zero_tests = {"exct"}}), kit::contains("'exact'"));
  CHECK_THAT(complaint({.scalars = {"exact"}, .zero_tests = {"relative"}}), kit::contains("no setting is left"));
  CHECK_THAT(complaint({.rules = {"certifed"}}), kit::contains("'certified'"));
  CHECK_THAT(complaint({.rules = {"certified"}, .scalars = {"exact"}}), kit::contains("no setting is left"));
  CHECK_THAT(complaint({.rules = {"certified"}, .zero_tests = {"relative"}}), kit::contains("no setting is left"));
  CHECK(complaint({}).empty());
}

}  // namespace plan_test
}  // namespace study::test
