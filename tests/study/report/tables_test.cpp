#include "tests/study/report/tables.hpp"

#include <algorithm>
#include <sstream>

#include "tests/kit/catch.hpp"
#include "tests/study/methods/certified.hpp"
#include "tests/study/support.hpp"
#include "tests/study/sweep/plan.hpp"
#include "tests/study/sweep/study_file.hpp"

namespace study::test {
namespace {

Study small_study(const Request& request) {
  const Plan plan = plan_of(request);
  return study_of(request, plan, sweep(plan).rows);
}

Request two_families() {
  Request request;
  request.pairs = 60;
  request.families = {"triangles", "spheres"};
  return request;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST_CASE("Rates are told with their interval and where nothing was seen with its upper end", "[tables]") {
  CHECK(in_words({0, 1000000}) == "0 (< 3.8e-6)");
  CHECK(in_words({5, 10}) == "0.5 (0.24 – 0.76)");
  CHECK(in_words({1, 2, Extent::census}) == "0.5 of all");
  CHECK(in_words({0, 2, Extent::census}) == "0 of all");
  CHECK(in_words({0, 0, Extent::census}) == "no pairs");
  CHECK(in_short(3.14e-5) == "3.1e-5");
  CHECK(in_short(0.0031) == "0.0031");
  CHECK(in_short(2e-12) == "2e-12");
}

TEST_CASE("Each line of the CSV file has a field for each heading", "[tables]") {
  const Study study = small_study(two_families());
  const Settings settings(study);
  for (const std::string& text : {counts_csv(settings), timings_csv(settings)}) {
    const std::vector<std::string> lines = lines_of(text);
    REQUIRE(lines.size() > 10);
    CHECK(lines[0] == "# gjkstep-study run --pairs 60 --seed 1 --families triangles,spheres");
    CHECK(lines[1].starts_with("# seed 1; gjkstep-study "));
    const auto heading = std::ranges::find_if(lines, [](const std::string& line) { return !line.starts_with('#'); });
    for (auto line = heading; line != lines.end(); ++line)
      CHECK(std::ranges::count(*line, ',') == std::ranges::count(*heading, ','));
  }
  const auto certified = static_cast<std::size_t>(
      std::ranges::count_if(all_methods(), [](const Method& method) { return is_certified(method.rules); }));
  const std::size_t lines = (all_methods().size() - certified) * std::size(limits) + certified;
  CHECK(lines_of(counts_csv(settings)).size() == 3 + 2 * lines);
}

TEST_CASE("The tables name the command and the seed and have a row for each family", "[tables]") {
  const Study study = small_study(two_families());
  const std::string text = counts_markdown(Settings(study));
  CHECK(text.find("`gjkstep-study run --pairs 60 --seed 1 --families triangles,spheres` with seed 1") !=
        std::string::npos);
  for (const char* const family : {"| triangles |", "| spheres |"}) {
    std::size_t rows = 0;
    for (const std::string& line : lines_of(text)) rows += line.starts_with(family);
    CHECK(rows == 2);  // one each in the tables of families and of iterations
  }
}

TEST_CASE("Families in which nothing was seen are named below the table", "[tables]") {
  const Study study = small_study(two_families());
  const std::string text = counts_markdown(Settings(study));
  CHECK(text.find("Nothing was seen in: triangles, spheres.") != std::string::npos);
  CHECK(text.find("| --- |\n\nNothing was seen") == std::string::npos);  // no table without rows
}

/// Ten pairs of one family: 6 apart, of which 3 are found together, and 4 that meet, of which 1 is undecided.
Study counted_by_hand() {
  Study study;
  study.header.limits = {20};
  study.families.push_back({"family", "made up", 10, 0});
  Tally tally;
  for (int i = 0; i < 6; ++i)
    tally.count({Truth::separated, Proof::predicates}, {i < 3 ? Answer::intersecting : Answer::separated, 2});
  for (int i = 0; i < 4; ++i)
    tally.count({Truth::intersecting, Proof::predicates}, {i < 1 ? Answer::unusable : Answer::intersecting, 2});
  study.rows.push_back({"family", "as-intended", "double", "exact", tally, {}});
  return study;
}

TEST_CASE("Errors of either kind are told of the pairs with which they can happen", "[tables]") {
  Study study = counted_by_hand();
  CHECK(errors_markdown(Settings(study)).find("| family | 0.5 (0.19 – 0.81) | 0 (< 0.49) | 0.1 (0.018 – 0.4) |") !=
        std::string::npos);
  study.rows.front().tally.queries[0] = {};  // leaves no pair that is apart
  CHECK(errors_markdown(Settings(study)).find("| family | no pairs | 0 (< 0.49) | 0.25 (") != std::string::npos);
}

TEST_CASE("A rule with a sign flipped shows in the tables", "[tables]") {
  const Method wrong =
      method_of<double, OneNormalInward>("one-normal-inward", "exact", scalar_called<double>("double"));
  const Plan plan = plan_for({&family_named("tetrahedra")}, {&wrong, &method_named("as-intended double exact")}, 500);
  const Study study = study_of(Request{}, plan, sweep(plan).rows);
  const std::string text = settings_markdown(Settings(study));
  INFO(text);
  CHECK(text.find("| family | one-normal-inward | as-intended |") != std::string::npos);
  CHECK(text.find("| tetrahedra | 0.56 (0.51 – 0.6) | 0 (< 0.0076) |") != std::string::npos);
}

TEST_CASE("CSV and JSON tell each rate with its interval", "[tables]") {
  const Study study = counted_by_hand();
  const std::string csv = counts_csv(Settings(study)), json = to_json(study);
  INFO(csv << json);
  for (const char* const part : {",10,4,0.4,0.168", ",3,0.5,0.187", ",0,0,0,0.489", ",1,0.1,0.0178"})
    CHECK(csv.find(part) != std::string::npos);
  for (const char* const part :
       {R"("hit":{"rate":0.4,"low":0.168)", R"("false_positive":{"rate":0.5,"low":0.187)",
        R"("false_negative":{"rate":0.0,"low":0.0,"high":0.489)", R"("undecided":{"rate":0.1,"low":0.0178)"})
    CHECK(json.find(part) != std::string::npos);
}

TEST_CASE("A family asked to its last pair has rates without intervals", "[tables]") {
  Study study = counted_by_hand();
  study.families.front().size = 10;
  CHECK(errors_markdown(Settings(study)).find("| family | 0.5 of all | 0 of all | 0.1 of all |") != std::string::npos);
  CHECK(counts_csv(Settings(study)).find(",10,4,0.4,,,3,0.5,,,0,0,,,1,0.1,,,") != std::string::npos);
  CHECK(to_json(study).find(R"("hit":{"rate":0.4},"false_positive":{"rate":0.5})") != std::string::npos);
  study.families.front().size = 11;  // one was not asked
  CHECK(errors_markdown(Settings(study)).find("of all |") == std::string::npos);
}

TEST_CASE("A list is a census where all of it is asked and a sample where a run asks some", "[tables]") {
  Request request;
  request.families = {"cycles", "grid-tetrahedra"};
  request.scalars = {"double", "exact"};
  request.pairs = 50;
  const Study study = small_study(request);
  const Settings settings(study);
  const auto extent = [&](const std::string& family, const std::string& scalar) {
    Setting setting = settings.usual();
    setting.scalar = scalar;
    return settings.counts(family, setting)->extent;
  };
  CHECK(extent("cycles", "double") == Extent::census);
  CHECK(extent("cycles", "exact") == Extent::sample);  // which is asked about a 50th
  CHECK(extent("grid-tetrahedra", "double") == Extent::sample);
  CHECK(counts_markdown(settings).find("in every order | 48, all |") != std::string::npos);
}

TEST_CASE("Timings tell the processor and the number of threads and the clock", "[tables]") {
  const Request request = two_families();
  Plan plan = plan_of(request);
  plan.threads = 3;
  const Study study = study_of(request, plan, sweep(plan).rows);
  const Settings settings(study);
  for (const std::string& text : {timings_markdown(settings), timings_csv(settings)}) {
    CHECK(text.find(", 3 threads") != std::string::npos);
    CHECK(text.find("the CPU clock of the thread that asks") != std::string::npos);
  }
}

TEST_CASE("Why float is slower is told where it is and not where it is faster", "[tables]") {
  Study study = counted_by_hand();
  study.header.compiler = "GNU 12.2.0 -O3";
  study.rows.push_back(study.rows.front());
  study.rows.back().scalar = "float";
  study.rows[0].timings[20] = {10, 1000};
  study.rows[1].timings[20] = {10, 1200};
  CHECK(timings_markdown(Settings(study)).find("(family: 2.00 in float, 2.00 in double)") != std::string::npos);
  study.rows[1].timings[20] = {10, 900};
  CHECK(timings_markdown(Settings(study)).find("Float is not") == std::string::npos);
  study.rows[1].timings[20] = {10, 1200};
  study.header.compiler = "Clang 17 -O3";  // of which nothing was measured
  CHECK(timings_markdown(Settings(study)).find("Float is not") == std::string::npos);
}

TEST_CASE("The table of families tells what proves the truths", "[tables]") {
  Study study = counted_by_hand();
  CHECK(counts_markdown(Settings(study)).find("| predicates |") != std::string::npos);
  study.rows.front().tally.proven = {7, 0, 3};
  CHECK(counts_markdown(Settings(study)).find("| predicates 7, certificates 3 |") != std::string::npos);
}

/// As counted_by_hand(), and a row of certified answers, one of ten of which took a second search of four iterations and one
/// of eight.
Study with_certified() {
  Study study = counted_by_hand();
  Row row{"family", "certified", "double", "exact", {}, {{no_limit, {10, 1230}}}};
  for (int i = 0; i < 10; ++i)
    row.tally.count({i < 6 ? Truth::separated : Truth::intersecting, Proof::predicates},
                    {i < 6 ? Answer::separated : Answer::intersecting, 25});
  row.tally.second_iterations = {8, 0, 0, 0, 1, 0, 0, 0, 1};
  row.tally.certificates = 7;
  study.rows.push_back(row);
  study.rows.front().timings[20] = {10, 1000};
  return study;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_CASE("Certified answers have a column beside the scalars and beside the rules", "[tables]") {
  const Study study = with_certified();
  const Settings settings(study);
  CHECK(has(counts_markdown(settings), "| family | double | certified double |\n"));
  CHECK(has(counts_markdown(settings), "| family | 0.4 (0.17 – 0.69) | 0 (< 0.28) |\n"));
  CHECK(has(errors_markdown(settings), "| family | double | certified double |\n"));
  CHECK(has(settings_markdown(settings), "| family | as-intended | certified |\n"));
  CHECK(has(timings_markdown(settings), "| family | double, exact | certified double |\n"));
  CHECK(has(timings_markdown(settings), "| family | 100 | 123 |\n"));
}

TEST_CASE("Certified answers have a table: what they are worth, how often a second search, what it takes", "[tables]") {
  Study study = with_certified();
  study.rows.back().alone = {{8, 1600}, {2, 6002}, 7, 4321};
  const std::string text = certified_markdown(Settings(study));
  INFO(text);
  CHECK(has(text, "\n## certified double\n"));
  CHECK(
      has(text,
          "\n10 pairs: 0 wrong, 0 undecided. 7 certificates, those of the first pairs of each family, were multiplied "
          "out in fractions: all hold. 0.2 of the pairs took a second search, of 6.00 iterations in the mean and 8 at "
          "most. Without it a query took 200 ns. With it a query took 3001 ns. The slowest, pair 7 of family, took "
          "4.3 µs.\n"));
  CHECK(has(text, "\n| family | 10 | 0 | 0 | 0.2 | 6.00, 8 | 200 | 3001 | 4.3: 7 |\n"));
}

TEST_CASE("The table of certified answers tells what is wrong, and leaves out what was not measured", "[tables]") {
  Study study = with_certified();
  Row& row = study.rows.back();
  row.tally.count({Truth::separated, Proof::predicates}, {Answer::intersecting, 3});
  row.tally.second_iterations = {11};
  row.tally.false_certificates = 2;
  const std::string text = certified_markdown(Settings(study));
  INFO(text);
  CHECK(has(text, "\n11 pairs: 1 wrong, 0 undecided. 7 certificates"));
  CHECK(has(text, "in fractions: 2 do not hold. 0 of the pairs took a second search.\n"));
  CHECK(has(text, "\n| family | 11 | 1 | 0 | 0 |  |  |  |  |\n"));
  row.tally = {};
  row.tally.not_askable = 10;
  CHECK(has(certified_markdown(Settings(study)), "\nNo pair was asked.\n"));
  CHECK(has(certified_markdown(Settings(study)), "\n| family |  |  |  |  |  |  |  |  |\n"));
  study.rows.pop_back();
  CHECK(certified_markdown(Settings(study)).empty());
}

TEST_CASE("Certified answers have one line in CSV, without a limit and without the calls that are not counted",
          "[tables]") {
  const Study study = with_certified();
  const std::string csv = counts_csv(Settings(study));
  INFO(csv);
  CHECK(has(csv, "\nfamily,certified,double,exact,none,10,4,"));
  CHECK(has(csv, ",25,25,25,25,25,25,,0,0,0,0,10,0,0,2,6,8,7,0\n"));
  CHECK(has(csv, ",10,0,0,,,,,\n"));  // of the row that certifies nothing
  CHECK(has(timings_csv(Settings(study)), "\nfamily,certified,double,exact,none,10,123\n"));
}

TEST_CASE("Tables with certified answers say what is proven of round shapes, and how many are in doubt", "[tables]") {
  Study study = with_certified();
  study.rows.back().tally.count({Truth::intersecting, Proof::formulas}, {Answer::in_doubt, 30});
  const Settings settings(study);
  const std::string why = "about cylinders, whose points are computed, they are where these are known too badly.";
  CHECK(has(counts_markdown(settings), why));
  CHECK(has(timings_markdown(settings), why));
  CHECK(has(errors_markdown(settings), "; 1 in doubt |"));
  CHECK(has(counts_csv(settings), ",0,0,1,"));  // neither a cycle nor without a direction
  CHECK(has(counts_markdown(settings), "how often a second follows, and its iterations, is in certified.md."));
  study.rows.pop_back();
  CHECK_FALSE(has(counts_markdown(Settings(study)), "certified.md"));
}

TEST_CASE("Errors of each kind are told of certified answers, too", "[tables]") {
  Study study = with_certified();
  study.rows.back().tally.count({Truth::separated, Proof::predicates}, {Answer::intersecting, 3});
  const std::string text = errors_markdown(Settings(study));
  INFO(text);
  CHECK(has(text, "\n## In double\n"));
  CHECK(has(text.substr(text.find("\n## certified double\n")), "| family | 0.14 ("));
}

TEST_CASE("A study of certified answers alone has tables of these", "[tables]") {
  Request request = two_families();
  request.rules = {"certified"};
  Study study = small_study(request);
  study.rows.back().tally.count({Truth::separated, Proof::predicates}, {Answer::in_doubt, 3});
  const Settings settings(study);
  CHECK(settings.usual().rules == "certified");
  CHECK(has(counts_markdown(settings), "| family | certified float | certified double |\n"));
  CHECK(has(counts_markdown(settings), "says otherwise: double, rules certified. "));
  CHECK(has(settings_markdown(settings), "Certified answers have no limit."));
  CHECK(has(timings_markdown(settings), "| family | certified float | certified double |\n"));
  CHECK_FALSE(has(timings_markdown(settings), "| spheres |  |  |\n"));
}

TEST_CASE("A study of few settings has tables of these", "[tables]") {
  Request request = two_families();
  request.scalars = {"float"};
  request.rules = {"as-printed"};
  request.limits = {3, 6};
  const Study study = small_study(request);
  const Settings settings(study);
  CHECK(settings.usual().rules == "as-printed");
  CHECK(settings.usual().scalar == "float");
  CHECK(settings.usual().limit == 6);
  CHECK(settings_markdown(settings).find("| family | at most 3 | at most 6 |") != std::string::npos);
}

}  // namespace
}  // namespace study::test
