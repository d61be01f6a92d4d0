/// Shards, files, and what is refused.
#include "tests/study/sweep/study.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <regex>

#include "tests/kit/catch.hpp"
#include "tests/study/report/tables.hpp"
#include "tests/study/support.hpp"
#include "tests/study/sweep/checksum.hpp"
#include "tests/study/sweep/plan.hpp"
#include "tests/study/sweep/study_file.hpp"

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

TEST_CASE("Merging adds up what certified answers took, each alone", "[study]") {
  Request request = small_request();
  request.rules = {"certified"};
  request.scalars = {"double"};
  const std::vector<NamedStudy> shards = shards_of(request, 3);
  std::uint64_t slowest = 0;
  for (const NamedStudy& each : shards) slowest = std::max(slowest, each.study.rows.front().alone.slowest);
  const TimesAlone sum = merged(shards).rows.front().alone;
  CHECK(sum.one_search.queries + sum.two_searches.queries == 101);
  CHECK(sum.slowest == slowest);
}

TEST_CASE("Shards of different studies are refused", "[study]") {
  const std::vector<NamedStudy> good = shards_of(small_request(), 2);
  CHECK(refusal(good).empty());
  const auto changed = [&](auto change) {
    std::vector<NamedStudy> shards = good;
    change(shards[1].study);
    return refusal(shards);
  };
  CHECK_THAT(changed([](Study& s) { s.header.seed = 4; }), kit::contains("their seeds are 3 and 4"));
  CHECK_THAT(changed([](Study& s) { s.header.version = "9"; }), kit::contains("versions"));
  CHECK_THAT(changed([](Study& s) { s.header.compiler = "other"; }), kit::contains("compiled by"));
  CHECK_THAT(changed([](Study& s) { s.header.command += " --limit 5"; }), kit::contains("they are shards of '"));
  CHECK_THAT(changed([](Study& s) { s.header.limits.pop_back(); }), kit::contains("differ"));
  CHECK_THAT(changed([](Study& s) { s.families.pop_back(); }), kit::contains("differ"));
  CHECK_THAT(changed([](Study& s) { s.rows.pop_back(); }), kit::contains("differ"));
  CHECK_THAT(changed([](Study& s) { s.shard.count = 3; }), kit::contains("shards of 2 and of 3"));
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
  CHECK_THAT(contradiction(study),
             kit::contains("family coplanar-tilted: in exact numbers GJK was wrong on 1 of 4 pairs"));
}

TEST_CASE("A certified answer that is wrong, none or without a proof is a contradiction", "[study]") {
  Request request = small_request();
  request.rules = {"certified"};
  request.families = {"triangles", "spheres"};
  const Study sound = made(request);
  CHECK(contradiction(sound).empty());
  const auto said = [&](auto change) {
    Study study = sound;
    change(study.rows.at(1).tally);
    return contradiction(study);
  };
  const auto counted = [](Answer answer) {
    return [=](Tally& tally) { tally.count({Truth::separated, Proof::predicates}, {answer, 30, 0}); };
  };
  CHECK_THAT(
      said(counted(Answer::intersecting)),
      kit::contains("family triangles: 1 of 102 certified answers in double were wrong, none, or without a proof"));
  CHECK(said(counted(Answer::separated)).empty());
  CHECK(said(counted(Answer::in_doubt)).empty());
  CHECK_THAT(said(counted(Answer::unusable)), kit::contains("1 of 102 certified answers"));
  CHECK_THAT(said([](Tally& tally) { ++tally.exceptions; }), kit::contains("1 of 102 certified answers"));
  CHECK_THAT(said([](Tally& tally) { ++tally.false_certificates; }), kit::contains("1 of 101 certified answers"));
}

TEST_CASE("A shard that is missing or there twice is refused by its number", "[study]") {
  std::vector<NamedStudy> shards = shards_of(small_request(), 3);
  const std::vector<NamedStudy> without_1{shards[0], shards[2]};
  CHECK_THAT(refusal(without_1), kit::contains("shard 1 of 3 is missing") && kit::contains("--shard 1/3"));
  shards.push_back(shards[1]);
  CHECK_THAT(refusal(shards), kit::contains("both are shard 1"));
}

/// Returns: a shard of one family and one method, as its file says it.
std::string one_row(const std::string& scalar = "double", const std::string& rules = "as-intended") {
  Request request = small_request();
  request.families = {"triangles"};
  request.rules = {rules};
  request.scalars = {scalar};
  request.zero_tests = {"exact"};
  request.limits = {5, 20};
  return to_json(made(request, {1, 3}));
}

/// Returns: the text with the first `from` replaced, and the checksum that it then has.
std::string resealed(std::string text, const std::string& from, const std::string& to) {
  REQUIRE(text.find(from) != std::string::npos);
  text.replace(text.find(from), from.size(), to);
  return with_checksum(text.substr(0, text.rfind(',')) + "}");
}

TEST_CASE("A shard of which any byte has changed is refused", "[study]") {
  const std::string sound = one_row();
  REQUIRE(refusal(sound).empty());
  std::mt19937 random(1);
  for (std::size_t i = 0; i < sound.size(); ++i) {
    std::string text = sound;
    text[i] = static_cast<char>(text[i] ^ (1 + random() % 255));
    CAPTURE(i, text[i], sound[i]);
    REQUIRE_THAT(refusal(text), kit::starts_with("a.json is "));
    text[i] = sound[i] == '7' ? '3' : '7';  // which often leaves JSON
    REQUIRE_THAT(refusal(text), kit::starts_with("a.json is "));
  }
}

TEST_CASE("A shard whose counts were changed by hand is refused by its checksum", "[study]") {
  std::string text = one_row();
  text.replace(text.find("\"seed\":3"), 8, "\"seed\":4");
  CHECK(refusal(text) ==
        "a.json is damaged: its checksum is not that of what it says; "
        "make it again with 'gjkstep-study run'");
  CHECK(refusal(resealed(one_row(), "\"seed\":3", "\"seed\":4")).empty());
}

TEST_CASE("A shard that makes no sense is refused though its checksum is right", "[study]") {
  const std::string sound = one_row();
  struct Change {
    std::string from, to, said;
  };
  const std::vector<Change> changes{
      {"\"limits\":[5,20]", "\"limits\":[]", "not ascending"},
      {"\"limits\":[5,20]", "\"limits\":[20,5]", "not ascending"},
      {"\"limits\":[5,20]", "\"limits\":[0,20]", "'0' not found"},
      {"\"limits\":[5,20]", "\"limits\":[5,4294967316]", "'2147483646' not found"},
      {"\"limits\":[5,20]", "\"limits\":[5,19.5]", "no whole number"},
      {"\"limits\":[5,20]", "\"limits\":[5,19]", "19"},
      {"\"seed\":3", "\"seed\":-1", "no whole number"},
      {"\"index\":1", "\"index\":3", "there is no such shard"},
      {"\"index\":1", "\"index\":2", "its tally is of 34 pairs, and the shard asks 33"},
      {"\"processors\":[\"", "\"processors\":[],\"x\":[\"", "the processor is missing"},
      {"\"name\":\"triangles\"", "\"name\":\"tringles\"", "there is no family 'tringles'"},
      {"\"size\":null", "\"size\":101", "its size is another one"},
      {"\"pairs\":101", "\"pairs\":1000000000001", "more pairs than there are"},
      {"\"pairs\":101", "\"pairs\":98", "its tally is of 34 pairs, and the shard asks 33"},
      {"\"slow_pairs\":2", "\"slow_pairs\":102", "more pairs than there are"},
      {"\"rows\":[", "\"rows\":[],\"x\":[", "rows are missing"},
      {"\"family\":\"triangles\"", "\"family\":\"boxes\"", "row 0 is not the one"},
      {"\"rules\":\"as-intended\"", "\"rules\":\"as-you-like\"",
       "rules as-you-like, scalar double, zero test exact: there is"},
      {"gjkstep-study run", "x\\n!touch here\\n#", "control characters"},
      {"\"out_of_range\":0", "\"out_of_range\":-5", "no whole number"},
      {"\"out_of_range\":0", "\"out_of_range\":1.7", "no whole number"},
      {"\"out_of_range\":0", "\"out_of_range\":1", "its tally is of 35 pairs, and the shard asks 34"},
      {"\"not_askable\":0", "\"not_askable\":1", "its tally is of 35 pairs"},
      {"\"exceptions\":0", "\"exceptions\":1", "its tally is of 35 pairs"},
      {"\"exceptions\":0", "\"exceptions\":18446744073709551615", "a count is above 1000000000000"},
      {"\"truth_changed\":0", "\"truth_changed\":35", "the truth changed of more pairs"},
      {"\"predicates\":34", "\"predicates\":33", "34 pairs were answered, and the truth is proven of 33"},
      {"\"returns\":[]", "\"returns\":[0,0,1]", "more queries came back"},
      {"\"separated\":[0,", "\"separated\":[1,", "its tally is of 35 pairs"},
      {"\"at_limit\":[]", "\"at_limit\":[0,1]", "stopped before the largest iteration limit"},
      {"\"at_limit\":[]", "\"at_limit\":[0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1]", "more than 20 iterations"},
      {"\"queries\":34", "\"queries\":0", "a time is of queries that were not asked"},
      {"\"queries\":34", "\"queries\":35", "a time is of queries that were not asked"},
      {"\"queries\":34", "\"queries\":33", "a time is of queries that were not asked"},
  };
  for (const Change& change : changes) {
    INFO(change.from << " becomes " << change.to);
    CHECK_THAT(refusal(resealed(sound, change.from, change.to)),
               kit::starts_with("a.json is damaged: ") && kit::contains(change.said));
  }
  const std::string slow =
      std::regex_replace(sound, std::regex("\"nanoseconds\":[0-9]+"), "\"nanoseconds\":999999999999999");
  CHECK_THAT(refusal(resealed(slow, "", "")), kit::contains("a query took more than an hour"));
}

TEST_CASE("A shard of certified answers that makes no sense is refused though its checksum is right", "[study]") {
  const std::string sound = one_row("double", "certified");
  REQUIRE(refusal(sound).empty());
  const std::vector<std::pair<std::string, std::string>> changes{
      {"\"second_iterations\":[", "\"second_iterations\":[1,"},
      {"\"second_iterations\":[", "\"second\":["},
      {"\"certificates\":1", "\"certificates\":35"},
      {"\"certificates\":1", "\"certificates\":0.5"},
      {"\"false_certificates\":0", "\"false_certificates\":2"},
      {"\"unusable\":[]", "\"unusable\":[0,1]"},
      {"\"timings\":{\"none\"", "\"timings\":{\"20\""},
      {"\"one_search\":{\"queries\":", "\"one_search\":{\"queries\":1"},
      {"\"one_search\":{\"queries\":", "\"one_search\":{\"asked\":"},
      {"\"two_searches\":{\"queries\":", "\"two_searches\":{\"queries\":1"},
      {"\"slowest\":{\"pair\":", "\"slowest\":{\"pair\":999"},
      {"\"rules\":\"certified\"", "\"rules\":\"as-intended\""}};
  for (const auto& [from, to] : changes) {
    INFO(from << " becomes " << to);
    CHECK_THAT(refusal(resealed(sound, from, to)), kit::starts_with("a.json is damaged: "));
  }
  const std::regex slowest("(\"slowest\":[{]\"pair\":[0-9]+,\"nanoseconds\":)[0-9]+");
  REQUIRE(std::regex_search(sound, slowest));
  CHECK_THAT(refusal(resealed(std::regex_replace(sound, slowest, "$019999999999999999"), "", "")),
             kit::contains("the slowest pair was not asked, or took more than an hour"));
  std::string plain = one_row();
  CHECK_THAT(refusal(resealed(plain, "\"rules\":\"as-intended\"", "\"rules\":\"certified\"")),
             kit::starts_with("a.json is damaged: "));
}

TEST_CASE("A shard of an earlier version, which timed no certified answer alone, is read", "[study]") {
  std::string text = one_row("double", "certified");
  const std::size_t start = text.find(",\"alone\":");
  REQUIRE(start != std::string::npos);
  CHECK(refusal(resealed(text, text.substr(start, text.find("}}", start) + 2 - start), "")).empty());
}

TEST_CASE("Certified answers may take more iterations than the limits of a study", "[study]") {
  Request request = small_request();
  request.rules = {"certified"};
  request.limits = {1};
  CHECK(refusal(to_json(made(request))).empty());
}

TEST_CASE("Shards that the fuzzer begins with are read or refused as their names say", "[study]") {
  for (const auto& entry : std::filesystem::directory_iterator(GJKSTEP_SHARDS)) {
    INFO(entry.path());
    std::ifstream file(entry.path());
    const std::string text(std::istreambuf_iterator<char>(file), {});
    CHECK(refusal(text).empty() == entry.path().filename().string().starts_with("ok-"));
  }
}

TEST_CASE("Slow scalars are asked about the first pairs, which a shard of them adds up to", "[study]") {
  const std::string sound = one_row("exact");
  CHECK(refusal(sound).empty());
  CHECK_THAT(refusal(resealed(sound, "\"slow_pairs\":2", "\"slow_pairs\":1")),
             kit::contains("its tally is of 1 pairs, and the shard asks 0"));
}

TEST_CASE("Files that are none of the study's are refused with their name", "[study]") {
  const std::string good = to_json(made(small_request()));
  CHECK(refusal(good).empty());
  CHECK_THAT(refusal(good.substr(0, good.size() / 2)), kit::contains("a.json is not JSON, or is cut off"));
  CHECK_THAT(refusal("[]"), kit::contains("not a file of gjkstep-study"));
  CHECK_THAT(refusal(R"({"gjkstep_study":99})"), kit::contains("format 99"));
  CHECK_THAT(refusal(R"({"gjkstep_study":5})"), kit::contains("damaged"));
  CHECK_THAT(refusal(with_checksum(R"({"gjkstep_study":5,"header":[]})")), kit::contains("damaged"));
}

}  // namespace
}  // namespace study::test
