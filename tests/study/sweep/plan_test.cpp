#include "tests/study/sweep/plan.hpp"

#include "tests/kit/catch.hpp"

namespace study::test {
namespace {

TEST_CASE("A shard is written I/N and counted from 0", "[plan]") {
  CHECK(parse_shard("2/8") == Shard{2, 8});
  for (const char* const text : {"8/8", "1", "/", "1/", "/2", "-1/2", "0/0", "1/2/3", "a/b", "", "1 /2"}) {
    INFO(text);
    CHECK_THROWS_AS(parse_shard(text), UsageError);
  }
}

TEST_CASE("The command of a study makes it again", "[plan]") {
  Request request;
  CHECK(command_of(request) == "gjkstep-study run --quick --seed 1");
  request.scope = Scope::full;
  CHECK(command_of(request) == "gjkstep-study run --full --seed 1");
  request.pairs = 50;
  request.seed = 9;
  request.families = {"boxes", "spheres"};
  request.scalars = {"float"};
  request.limits = {5, 20};
  CHECK(command_of(request) ==
        "gjkstep-study run --pairs 50 --seed 9 --families boxes,spheres --scalar float --limit 5,20");
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
  CHECK_THAT(complaint({.limits = {0}}), kit::contains("1 to 1000"));
  CHECK_THAT(complaint({.scalars = {"exact"}, .zero_tests = {"relative"}}), kit::contains("no setting is left"));
  CHECK_THAT(complaint({.rules = {"certifed"}}), kit::contains("'certified'"));
  CHECK_THAT(complaint({.rules = {"certified"}, .scalars = {"exact"}}), kit::contains("no setting is left"));
  CHECK_THAT(complaint({.rules = {"certified"}, .zero_tests = {"relative"}}), kit::contains("no setting is left"));
  CHECK(complaint({}).empty());
}

TEST_CASE("Families that no method can be asked about are left out unless they are named", "[plan]") {
  const auto is_there = [](const Request& request, const std::string& name) {
    const Plan plan = plan_of(request);
    return std::ranges::any_of(plan.parts, [&](const Part& part) { return part.family->name == name; });
  };
  const Request exact{.scalars = {"exact"}};
  CHECK_FALSE(is_there(exact, "spheres"));
  CHECK(is_there(exact, "triangles"));
  CHECK(is_there({.rules = {"certified"}, .scalars = {"float"}}, "scale-1e100"));  // told as beyond float's range
  CHECK(is_there({.scalars = {"exact", "float"}}, "spheres"));
  CHECK(is_there({.rules = {"certified"}}, "spheres"));
  CHECK(is_there({.families = {"spheres"}, .scalars = {"exact"}}, "spheres"));
}

TEST_CASE("Certified answers are chosen as rules are", "[plan]") {
  const auto chosen = [](const Request& request) {
    std::vector<std::string> names;
    for (const Method* const method : plan_of(request).methods) names.push_back(method->name());
    return names;
  };
  using Names = std::vector<std::string>;
  CHECK(chosen({.rules = {"certified"}}) == Names{"certified float exact", "certified double exact"});
  CHECK(chosen({.rules = {"certified-eager", "eager"}, .scalars = {"float"}, .zero_tests = {"exact"}}) ==
        Names{"eager float exact", "certified-eager float exact"});
}

TEST_CASE("A family that can be listed is not asked about more pairs than it has", "[plan]") {
  Request request;
  request.pairs = 1000000000;
  for (const Part& part : plan_of(request).parts) {
    INFO(part.family->name);
    CHECK(part.pairs == part.family->size.value_or(1000000000));
    CHECK(part.slow_pairs <= part.pairs);
  }
}

}  // namespace
}  // namespace study::test
