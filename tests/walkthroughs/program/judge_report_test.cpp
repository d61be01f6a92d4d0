// The page of gjkstep judge --report, of findings made by hand.
#include "walkthroughs/program/judge_report.hpp"

#include "tests/kit/catch.hpp"
#include "tests/kit/folder.hpp"
#include "tests/kit/text.hpp"
#include "walkthroughs/judge/report_page.hpp"

namespace walkthroughs::program {
namespace judge_report_test {

using kit::bytes_of, kit::has, kit::listing;

/// Two points that are apart, and a program that says yes.
judge::Judged wrong_yes(const std::string& name) {
  judge::Judged judged{.asked = {name, "points", {{{0, 0, 0}}, {{1, 0, 0}}}, gjk::Status::separated},
                       .said = judge::Said::intersecting,
                       .verdict = judge::Verdict::wrong_yes};
  judged.how_far = {.length = 1, .relative = 1};
  return judged;
}

judge::Report report_in(const std::filesystem::path& folder, const std::vector<judge::Judged>& worst) {
  judge::Report report{.program = "./mine '<b>'", .options = "--seed 2 ", .shown = folder.string()};
  judge::Judgement& found = report.judgement;
  found.all.family = "all";
  for (const char* const family : {"points", "boxes"}) {
    judge::Tally tally{.family = family};
    judge::Judged each = wrong_yes(family);
    each.verdict = judge::Verdict::right;
    for (judge::Tally* const to : {&tally, &found.all}) to->add(each);
    if (std::string(family) == "points")
      for (const judge::Judged& wrong : worst)
        for (judge::Tally* const to : {&tally, &found.all}) to->add(wrong);
    found.families.push_back(tally);
  }
  found.worst = worst;
  if (!worst.empty()) report.causes = {{"contact & <i>", "wrong on 2 of 2", 0.95, "m3-touching", ""}};
  return report;
}

std::filesystem::path written(const ReportFolder& to, const judge::Report& report) {
  to.expect_possible();
  return to.write(report);
}

TEST_CASE("Report: the worst pairs are saved, drawn and told of, and texts of others are text") {
  const kit::Folder folder;
  const ReportFolder to{folder.path().string()};
  const judge::Report report = report_in(folder.path(), {wrong_yes("</title><script>"), wrong_yes("second")});
  const std::string html = bytes_of(written(to, report));
  for (const char* const part :
       {"<h1>./mine '&lt;b&gt;': not right on 2 of 4 pairs: 2 wrong yes</h1>",
        "<strong>contact &amp; &lt;i&gt;</strong>", "agreement 95 %",
        "<code>gjkstep render mistakes/m3-touching</code>", "&lt;/title&gt;&lt;script&gt;</h3>",
        "they are apart by 1 of their size, and it says yes", "href=\"1/index.html\"", "href=\"2.json\"",
        "<summary>Without a fault: 1</summary>", "gjkstep judge --seed 2 --report "})
    CHECK_THAT(html, kit::contains(part));
  CHECK_FALSE(has(html, "<script"));
  CHECK_FALSE(has(html, "The first wrong step"));
  CHECK(has(bytes_of(folder / "1/story.js"), "\"live\":{\"scene\":") == !page_programs().empty());
  CHECK(has(bytes_of(folder / "1/index.html"), "<a href=\"../report.html\">The report</a>"));
  CHECK(bytes_of(folder / "1/1.json") == bytes_of(folder / "1.json"));
  CHECK(bytes_of(written(to, report)) == html);

  SECTION("What an earlier report has left and this one does not show is gone, but no file of others") {
    kit::write(folder / "2/notes.txt", "of somebody else");
    written(to, report_in(folder.path(), {wrong_yes("first")}));
    CHECK(has(bytes_of(folder / "index.html"), "1/index.html"));
    CHECK_FALSE(has(bytes_of(folder / "index.html"), "2/index.html"));
    CHECK(listing(folder / "2") == std::vector<std::string>{"notes.txt"});
    CHECK_FALSE(std::filesystem::exists(folder / "2.json"));
  }
  SECTION("Where nothing is wrong there is nothing but a page that says so") {
    CHECK(
        has(bytes_of(written(to, report_in(folder.path(), {}))), "<h1>./mine '&lt;b&gt;': right on all 2 pairs</h1>"));
    CHECK(listing(folder.path()) == std::vector<std::string>{"report.html"});
  }
}

TEST_CASE("Report: the first wrong step stands above the worst pairs, with its own page") {
  const kit::Folder folder;
  const ReportFolder to{folder.path().string()};
  // M14: an order that should have been changed.
  const ToldRun run{"m14 & 1",
                    {{{0, 1, 1}, {0, -1, -1}}, {{1, 0, 1}, {0, 1, 0}, {-1, -1, -1}}},
                    {{{1, 0, 0}, {{1, 2, 2}}},
                     {{-1, -2, -2}, {{1, 2, 2}, {-1, -1, -2}}},
                     {{3, -10, 6}, {{1, 2, 2}, {-1, -1, -2}, {0, -2, -1}}},
                     {{-7, -2, 5}, {{0, -2, -1}, {-1, 1, 0}}}},
                    gjk::Status::separated};
  judge::Report report = report_in(folder.path(), {wrong_yes("first")});
  report.steps.found = {{run, check_steps(run).findings}};
  const auto parting = judge::parting_of(report.steps);
  REQUIRE(parting);
  const std::size_t place = parting->story().parting().value();
  const std::string html = bytes_of(written(to, report));
  const std::string number = std::to_string(place + 1);
  CHECK(has(html, "<p>m14 &amp; 1, iteration 3: keeps [C, B, A] where the report keeps [C, A, B]"));
  CHECK(html.find("<h2>The first wrong step</h2>") < html.find("<h2>The worst pairs</h2>"));
  CHECK(has(html, "href=\"first-wrong-step/index.html#" + number + "\""));
  CHECK(has(html,
            "first-wrong-step/" + std::string(3 - std::to_string(place).size(), '0') + std::to_string(place) + ".png"));
  const std::string page = bytes_of(folder / "first-wrong-step/index.html");
  CHECK(has(page, "Made by <code>gjkstep judge --seed 2 --report "));
  CHECK(has(page, "<a href=\"trace.jsonl\">"));
  CHECK_FALSE(has(page, "gjkstep trace"));
  CHECK(has(bytes_of(folder / "first-wrong-step/story.js"), "\"live\":null"));
  CHECK(has(bytes_of(folder / "index.html"), "first-wrong-step/index.html"));

  written(to, report_in(folder.path(), {wrong_yes("first")}));
  CHECK_FALSE(std::filesystem::exists(folder / "first-wrong-step"));
}

}  // namespace judge_report_test
}  // namespace walkthroughs::program
