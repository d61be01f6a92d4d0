/// Shards, files, and what is refused.
#include "tests/study/sweep/study.hpp"

#include "tests/catch.hpp"
#include "tests/study/report/tables.hpp"
#include "tests/study/support.hpp"
#include "tests/study/sweep/plan.hpp"

namespace study::test {
namespace {

Request small_request() {
  Request request;
  request.seed = 3;
  request.pairs = 101;  // which 3 does not divide
  request.families = {"triangles", "coplanar-tilted", "spheres", "cycles"};
  return request;
}

Study made(const Request& request, const Shard& shard = {}) {
  Plan plan = plan_of(request);
  plan.shard = shard;
  return study_of(request, plan, sweep(plan).rows);
}

/// Returns: all shards, written and read again.
std::vector<NamedStudy> shards_of(const Request& request, std::uint64_t count) {
  std::vector<NamedStudy> shards;
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::string name = "shard" + std::to_string(i);
    shards.push_back({name, from_json(to_json(made(request, {i, count})), name)});
  }
  return shards;
}

std::string refusal(std::vector<NamedStudy> shards) {
  try {
    merged(std::move(shards));
  } catch (const StudyError& error) {
    return error.what();
  }
  return "";
}

std::string refusal(const std::string& text) {
  try {
    from_json(text, "a.json");
  } catch (const StudyError& error) {
    return error.what();
  }
  return "";
}

using Catch::Matchers::Contains;

TEST_CASE("Shards merged in any order give the tables of one run", "[study]") {
  const Study one = made(small_request());
  std::vector<NamedStudy> shards = shards_of(small_request(), 3);
  std::swap(shards[0], shards[2]);
  const Study sum = merged(std::move(shards));
  CHECK(counts_csv(Settings(sum)) == counts_csv(Settings(one)));
  CHECK(counts_markdown(Settings(sum)) == counts_markdown(Settings(one)));
  CHECK(errors_markdown(Settings(sum)) == errors_markdown(Settings(one)));
  CHECK(settings_markdown(Settings(sum)) == settings_markdown(Settings(one)));
  for (std::size_t row = 0; row < one.rows.size(); ++row) CHECK(sum.rows[row].tally == one.rows[row].tally);
}

TEST_CASE("Merging counts each pair once", "[study]") {
  const Study sum = merged(shards_of(small_request(), 3));
  CHECK(counts_at(sum.rows.front().tally, 20).pairs == 101);
}

TEST_CASE("Shards of different studies are refused", "[study]") {
  const std::vector<NamedStudy> good = shards_of(small_request(), 2);
  CHECK(refusal(good).empty());
  const auto changed = [&](auto change) {
    std::vector<NamedStudy> shards = good;
    change(shards[1].study);
    return refusal(shards);
  };
  CHECK_THAT(changed([](Study& s) { s.header.seed = 4; }), Contains("their seeds are 3 and 4"));
  CHECK_THAT(changed([](Study& s) { s.header.version = "9"; }), Contains("versions"));
  CHECK_THAT(changed([](Study& s) { s.header.compiler = "other"; }), Contains("compiled by"));
  CHECK_THAT(changed([](Study& s) { s.header.command += " --limit 5"; }), Contains("they are shards of '"));
  CHECK_THAT(changed([](Study& s) { s.header.limits.pop_back(); }), Contains("differ"));
  CHECK_THAT(changed([](Study& s) { s.families.pop_back(); }), Contains("differ"));
  CHECK_THAT(changed([](Study& s) { s.rows.pop_back(); }), Contains("differ"));
  CHECK_THAT(changed([](Study& s) { s.shard.count = 3; }), Contains("shards of 2 and of 3"));
}

TEST_CASE("A wrong answer in exact numbers is a contradiction and in others it is none", "[study]") {
  Study study = made(small_request());
  CHECK(contradiction(study).empty());  // although floating point was wrong
  const auto exact = std::ranges::find_if(study.rows, [](const Row& row) {
    return row.family == "coplanar-tilted" && row.scalar == "exact" && row.rules == "as-intended";
  });
  exact->tally.count({Truth::separated, Proof::predicates}, {Answer::unusable, 3});
  CHECK(contradiction(study).empty());
  exact->tally.count({Truth::separated, Proof::predicates}, {Answer::intersecting, 3});
  CHECK_THAT(contradiction(study), Contains("family coplanar-tilted: in exact numbers GJK was wrong on 1 of 4 pairs"));
}

TEST_CASE("A shard that is missing or there twice is refused by its number", "[study]") {
  std::vector<NamedStudy> shards = shards_of(small_request(), 3);
  const std::vector<NamedStudy> without_1{shards[0], shards[2]};
  CHECK_THAT(refusal(without_1), Contains("shard 1 of 3 is missing") && Contains("--shard 1/3"));
  shards.push_back(shards[1]);
  CHECK_THAT(refusal(shards), Contains("both are shard 1"));
}

TEST_CASE("A file that was changed by hand is refused", "[study]") {
  Request request = small_request();
  request.families = {"triangles"};
  request.scalars = {"double"};
  const std::string sound = to_json(made(request));
  struct Change {
    std::string from, to, said;
  };
  const std::vector<Change> changes{
      {"\"limits\":[5,8,10,20,50]", "\"limits\":[]", "not ascending"},
      {"\"limits\":[5,8,10,20,50]", "\"limits\":[5,8,10,20,2000000000]", "not ascending"},
      {"\"limits\":[5,8,10,20,50]", "\"limits\":[5,8,10,20,49]", "49"},
      {"\"out_of_range\":0", "\"out_of_range\":-5", "no whole number"},
      {"\"out_of_range\":0", "\"out_of_range\":1.7", "no whole number"},
      {"\"seed\":3", "\"seed\":-1", "no whole number"},
      {"\"family\":\"triangles\"", "\"family\":\"boxes\"", "row 0"},
      {"\"rules\":\"as-intended\"", "\"rules\":\"as-printed\"", "row"},
      {"gjkstep-study run", "x\\n!touch here\\n#", "control characters"},
  };
  for (const Change& change : changes) {
    INFO(change.from << " becomes " << change.to);
    std::string text = sound;
    REQUIRE(text.find(change.from) != std::string::npos);
    text.replace(text.find(change.from), change.from.size(), change.to);
    CHECK_THAT(refusal(text), Contains("a.json is damaged") && Contains(change.said));
  }
}

TEST_CASE("Files that are none of the study's are refused with their name", "[study]") {
  const std::string good = to_json(made(small_request()));
  CHECK(refusal(good).empty());
  CHECK_THAT(refusal(good.substr(0, good.size() / 2)), Contains("a.json is not JSON, or is cut off"));
  CHECK_THAT(refusal("[]"), Contains("not a file of gjkstep-study"));
  CHECK_THAT(refusal(R"({"gjkstep_study":99})"), Contains("format 99"));
  CHECK_THAT(refusal(R"({"gjkstep_study":3})"), Contains("damaged"));
  CHECK_THAT(refusal(R"({"gjkstep_study":3,"header":[]})"), Contains("damaged"));
}

}  // namespace
}  // namespace study::test
