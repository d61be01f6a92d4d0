// What a run leaves, as other programs read it.
#include "tests/study/sweep/results.hpp"

#include "tests/kit/catch.hpp"
#include "tests/kit/folder.hpp"
#include "tests/kit/text.hpp"
#include "tests/study/methods/certified.hpp"
#include "tests/study/support.hpp"

namespace study::test {
namespace {

Request small_request() {
  Request request;
  request.seed = 3;
  request.pairs = 101;  // which 3 does not divide
  request.families = {"triangles", "coplanar-tilted", "spheres", "cycles"};
  return request;
}

/// Of one family and two methods, counted by hand.
Plan plan_by_hand() {
  Plan plan = plan_for({&family_named("grid-segments")}, {}, 10, 2);
  plan.seed = 5;
  plan.limits = {5, 20};
  return plan;
}
std::vector<Row> rows_by_hand() {
  Row plain{"grid-segments", "as-intended", "float", "exact", {}, {{5, {8, 800}}, {20, {8, 1000}}}, {}};
  const auto count = [](Row& row, Truth truth, Answer answer, int k) {
    row.tally.count({truth, Proof::predicates}, {answer, k, 0});
  };
  count(plain, Truth::intersecting, Answer::intersecting, 3);
  count(plain, Truth::intersecting, Answer::separated, 6);
  count(plain, Truth::separated, Answer::separated, 2);
  count(plain, Truth::separated, Answer::intersecting, 4);
  count(plain, Truth::separated, Answer::unusable, 4);
  count(plain, Truth::separated, Answer::at_limit, 20);
  plain.tally.proven = {1, 2, 3};
  plain.tally.returns = {0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
  plain.tally.out_of_range = 11;
  plain.tally.not_askable = 12;
  plain.tally.truth_changed = 13;
  plain.tally.exceptions = 14;
  Row certified{
      "grid-segments", "certified", "double", "exact", {}, {{no_limit, {7, 900}}}, {{4, 400}, {1, 300}, 9, 310}};
  count(certified, Truth::intersecting, Answer::in_doubt, 30);
  certified.tally.second_iterations = {4, 0, 0, 1};
  certified.tally.certificates = 3;
  certified.tally.false_certificates = 1;
  return {plain, certified};
}

std::string text_of(const std::string& name) {
  for (const Csv& csv : csv_of(small_request(), plan_by_hand(), rows_by_hand()))
    if (csv.name == name) return csv.text.substr(csv.text.find("\nfamily,") + 1);
  return "";
}

TEST_CASE("Counts are a line for each limit, and one without for certified answers", "[results]") {
  CHECK(text_of("counts.csv") ==
        "family,rules,scalar,zero_test,limit,pairs,hits,false_positives,false_negatives,undecided,cycles,unusable,"
        "in_doubt,out_of_range,not_askable,truth_changed,exceptions,by_predicates,by_formulas,by_certificates,"
        "certificates,false_certificates\n"
        "grid-segments,as-intended,float,exact,5,6,2,1,0,3,0,1,0,11,12,13,14,1,2,3,0,0\n"
        "grid-segments,as-intended,float,exact,20,6,2,1,1,2,1,1,0,11,12,13,14,1,2,3,0,0\n"
        "grid-segments,certified,double,exact,none,1,1,0,0,1,0,0,1,0,0,0,0,1,0,0,3,1\n");
}

TEST_CASE("Iterations are told of hits, misses and second searches; times by limit and of queries alone", "[results]") {
  CHECK(text_of("iterations.csv") ==
        "family,rules,scalar,zero_test,of,queries_by_iterations\n"
        "grid-segments,as-intended,float,exact,hits,3:1 6:1\n"
        "grid-segments,as-intended,float,exact,misses,2:1 4:2 20:1\n"
        "grid-segments,certified,double,exact,hits,30:1\n"
        "grid-segments,certified,double,exact,misses,\n"
        "grid-segments,certified,double,exact,second searches,0:4 3:1\n");
  CHECK(text_of("timings.csv") ==
        "family,rules,scalar,zero_test,limit,queries,nanoseconds\n"
        "grid-segments,as-intended,float,exact,5,8,800\n"
        "grid-segments,as-intended,float,exact,20,8,1000\n"
        "grid-segments,certified,double,exact,none,7,900\n");
  CHECK(kit::has(text_of("alone.csv"), "\ngrid-segments,certified,double,exact,4,400,1,300,310,9\n"));
  const Family& family = family_named("grid-segments");
  CHECK(kit::lines(text_of("families.csv")).at(1) ==
        "grid-segments,10,2," + std::to_string(*family.size) + ",\"" + family.what + '"');
}

TEST_CASE("Each file says how it was made, and those of times on what", "[results]") {
  Plan plan = plan_by_hand();
  plan.shard = {1, 3};
  for (const Csv& csv : csv_of(small_request(), plan, rows_by_hand())) {
    INFO(csv.name);
    CHECK(csv.text.starts_with(
        "# command: gjkstep-study run --pairs 101 --seed 3 --families triangles,coplanar-tilted,"));
    CHECK(kit::has(csv.text, "\n# seed: 3\n# version: gjkstep-study "));
    CHECK(kit::has(csv.text, "\n# shard: 1 of 3\n"));
    CHECK(kit::has(csv.text, "# processor: " + processor() + ", 1 thread\n") ==
          (csv.name == "timings.csv" || csv.name == "alone.csv"));
  }
}

TEST_CASE("The files that are written are those that were announced, those of a shard in a folder of their own",
          "[results]") {
  const kit::Folder folder;
  Plan plan = plan_by_hand();
  plan.shard = {1, 3};
  write_csv(folder.path(), small_request(), plan, rows_by_hand());
  CHECK(kit::listing(folder.path()).size() == 5);
  for (const auto& file : csv_files(folder.path(), plan.shard)) CHECK(std::filesystem::exists(file));
  CHECK(csv_files("out", {1, 3}).back() == "out/shard-1-of-3/counts.csv");
  CHECK(csv_files("out", {}).front() == "out/families.csv");
}

TEST_CASE("Shards ask about each pair once: their tallies add up to those of one run", "[results]") {
  Plan plan = plan_of(small_request());
  const std::vector<Row> one = sweep(plan).rows;
  std::vector<Tally> sums(one.size());
  for (plan.shard = {0, 3}; plan.shard.index < 3; ++plan.shard.index) {
    const std::vector<Row> some = sweep(plan).rows;
    for (std::size_t row = 0; row < one.size(); ++row) sums[row] += some[row].tally;
  }
  for (std::size_t row = 0; row < one.size(); ++row) {
    INFO(one[row].family << " " << one[row].rules << " " << one[row].scalar);
    CHECK(sums[row] == one[row].tally);
  }
}

TEST_CASE("A wrong answer in exact numbers is a contradiction and in others it is none", "[results]") {
  const Plan plan = plan_by_hand();
  std::vector<Row> rows = rows_by_hand();
  rows.pop_back();
  CHECK(contradiction(plan, rows).empty());  // although float was wrong
  rows[0].scalar = "exact";
  CHECK_THAT(contradiction(plan, rows),
             kit::contains("family grid-segments: in exact numbers GJK was wrong on 2 of 6 pairs"));
  rows[0].rules = "as-printed";
  CHECK(contradiction(plan, rows).empty());
  rows[0].rules = "as-intended";
  rows[0].tally = {};
  rows[0].tally.count({Truth::separated, Proof::predicates}, {Answer::unusable, 3});
  CHECK(contradiction(plan, rows).empty());
}

TEST_CASE("A certified answer that is wrong, none or without a proof is a contradiction", "[results]") {
  const auto said = [](auto change) {
    Row row{"grid-segments", "certified", "double", "exact", {}, {}, {}};
    change(row.tally);
    return contradiction(plan_by_hand(), {row});
  };
  const auto counted = [](Answer answer) {
    return [=](Tally& tally) { tally.count({Truth::separated, Proof::predicates}, {answer, 30, 0}); };
  };
  const auto one = kit::contains("1 certified answers in double were wrong, none, or without a proof");
  CHECK_THAT(said(counted(Answer::intersecting)), one);
  CHECK(said(counted(Answer::separated)).empty());
  CHECK(said(counted(Answer::in_doubt)).empty());
  CHECK_THAT(said(counted(Answer::unusable)), one);
  CHECK_THAT(said([](Tally& tally) { ++tally.exceptions; }), one);
  CHECK_THAT(said([](Tally& tally) { ++tally.false_certificates; }), one);
}

}  // namespace
}  // namespace study::test
