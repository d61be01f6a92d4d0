/// What gnuplot is told to draw.
#include "tests/study/report/pictures.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "render/file.hpp"
#include "render/image.hpp"
#include "tests/kit/catch.hpp"
#include "tests/study/methods/certified.hpp"
#include "tests/walkthroughs/support.hpp"

namespace study::test {
namespace {

/// One family of ten pairs, the first `undecided` of which are that, in one row for each of the rules.
Study ten_pairs(int undecided, const std::vector<std::string>& rules) {
  Study study;
  study.header.limits = {5, 20};
  study.families.push_back({"family", "made up", 10, 0});
  for (const std::string& name : rules) {
    Row row{"family", name, "float", "exact", {}, {{5, {10, 1000}}, {20, {10, 1000}}}};
    for (int i = 0; i < 10; ++i)
      row.tally.count({Truth::separated, Proof::predicates},
                      {i < undecided ? Answer::unusable : Answer::separated, i < 5 ? 3 : 6});
    study.rows.push_back(std::move(row));
  }
  return study;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_CASE("The heat map tells where nothing was seen how much that says", "[pictures]") {
  Study study = ten_pairs(0, {"as-intended"});
  CHECK(has(heat_map(Settings(study)).script, "set label '<0.3' at 0,0"));  // the interval ends at 0.28
  study.families.front().size = 10;
  CHECK(has(heat_map(Settings(study)).script, "set label '0' at 0,0"));
  study = ten_pairs(2, {"as-intended"});
  CHECK(has(heat_map(Settings(study)).script, "set label '0.2' at 0,0"));
}

TEST_CASE("The heat map says that float is judged on the rounded pair", "[pictures]") {
  const Study study = ten_pairs(0, {"as-intended"});
  CHECK(has(heat_map(Settings(study)).script, "the pair as float writes it"));
}

TEST_CASE("The heat map has columns of certified answers and says where nobody was asked", "[pictures]") {
  Study study = ten_pairs(0, {"as-intended", "certified"});
  CHECK(has(heat_map(Settings(study)).script, "'float' 0, 'certified float' 1"));
  CHECK(has(heat_map(Settings(study)).script, "set label '<0.3' at 1,0"));
  study.rows.back().tally = {};
  study.rows.back().tally.not_askable = 10;
  CHECK(has(heat_map(Settings(study)).script, "set label 'not asked' at 1,0"));
  study.rows.back().tally = {};
  for (const Answer answer : {Answer::separated, Answer::in_doubt})
    study.rows.back().tally.count({Truth::separated, Proof::predicates}, {answer, 3});
  CHECK(has(heat_map(Settings(study)).script, "set label '0.5 in doubt' at 1,0"));
  study.rows.back().tally.count({Truth::separated, Proof::predicates}, {Answer::intersecting, 3});
  CHECK(has(heat_map(Settings(study)).script, "set label '0.67' at 1,0"));
  study.rows.back().tally = {};
  study.rows.back().tally.count({Truth::separated, Proof::predicates}, {Answer::in_doubt, 3});
  CHECK(has(heat_map(Settings(study)).script, "set label 'all in doubt' at 1,0"));
}

/// As the study makes it: certified rows are timed once, and tell of their second searches.
Study with_certified(int undecided) {
  Study study = ten_pairs(undecided, {"as-intended", "certified"});
  study.rows.back().timings = {{no_limit, {10, 3000}}};
  return study;
}

TEST_CASE("Certified answers are one point, on the line of zero where none was wrong, with its number", "[pictures]") {
  const Study study = with_certified(0);
  const std::string script = error_vs_time(Settings(study)).script;
  INFO(script);
  CHECK(has(script, "$curve1 << EOD\n300 0\nEOD\n"));
  CHECK(has(script, "set xzeroaxis"));
  CHECK(has(script, "set label '0 wrong' at graph "));
  CHECK(has(script, "title 'certified: 0 of 10 wrong or undecided'"));
}

TEST_CASE("Certified answers that were wrong are drawn and counted where they are", "[pictures]") {
  const Study study = with_certified(2);
  const std::string script = error_vs_time(Settings(study)).script;
  INFO(script);
  CHECK(has(script, "$curve1 << EOD\n300 0.2\nEOD\n"));
  CHECK(has(script, "set label '0.2 wrong' at graph "));
  CHECK(has(script, "title 'certified: 2 of 10 wrong or undecided'"));
}

TEST_CASE("A family that some setting cannot be asked about counts for none of the means, and for no title",
          "[pictures]") {
  Study study = with_certified(0);
  const auto rows = study.rows;
  study.families.push_back({"round", "made up", 10, 0});
  for (Row row : rows) {
    row.family = "round";
    row.tally = {};
    if (is_certified(row.rules)) {
      for (int i = 0; i < 10; ++i) row.tally.count({Truth::separated, Proof::formulas}, {Answer::in_doubt, 3});
    } else {
      row.tally.not_askable = 10;
      row.timings.clear();
    }
    study.rows.push_back(row);
  }
  const std::string script = error_vs_time(Settings(study)).script;
  INFO(script);
  CHECK(has(script, "means of the 1 of 2 families"));
  CHECK(has(script, "$curve0 << EOD\n100 0.5\n100 0\nEOD\n"));
  CHECK(has(script, "title 'certified: 0 of 10 wrong or undecided'"));
}

TEST_CASE("The picture of iterations is as wide as the longest search where there is no limit", "[pictures]") {
  const Study study = ten_pairs(0, {"certified"});
  CHECK(has(iterations(Settings(study)).script, "set xrange [0:8]"));  // of 6 at most
}

struct Label {
  double x, y;
};

std::vector<Label> labels_in(const std::string& script) {
  std::vector<Label> labels;
  std::istringstream lines(script);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find("' at graph ");
    if (!line.starts_with("set label '") || at == std::string::npos) continue;
    std::istringstream numbers(line.substr(at + 11));
    Label label{};
    char comma = 0;
    numbers >> label.x >> comma >> label.y;
    labels.push_back(label);
  }
  return labels;
}

TEST_CASE("Labels beside points keep clear of each other even where curves lie on each other", "[pictures]") {
  const Study study = ten_pairs(2, {"as-intended", "as-printed"});
  const std::vector<Label> labels = labels_in(error_vs_time(Settings(study)).script);
  REQUIRE(labels.size() == 4);  // two limits of two curves
  for (std::size_t i = 0; i < labels.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      CAPTURE(i, j, labels[i].x, labels[i].y, labels[j].x, labels[j].y);
      CHECK((std::abs(labels[i].x - labels[j].x) > 0.03 || std::abs(labels[i].y - labels[j].y) > 0.04));
    }
}

using walkthroughs::test::Folder;

std::vector<std::string> names_in(const Folder& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) names.push_back(entry.path().filename());
  return names;
}

TEST_CASE("A picture is drawn in place of the one before", "[pictures]") {
  const Folder folder;
  std::ofstream(folder.path() / "x.png") << "of other data";
  REQUIRE(draw({"x.png", "set terminal png\nplot x\n"}, folder.path()));
  CHECK(names_in(folder) == std::vector<std::string>{"x.png"});
  CHECK_NOTHROW(render::read_png(folder.path() / "x.png"));
}

TEST_CASE("Where gnuplot fails there is no picture, not that of other data and no half of one", "[pictures]") {
  const Folder folder;
  std::ofstream(folder.path() / "x.png") << "of other data";
  CHECK_FALSE(draw({"x.png", "set terminal png\nplot x\nno such command\n"}, folder.path()));
  CHECK(names_in(folder).empty());
}

TEST_CASE("A picture that cannot be written is an error and no lack of gnuplot", "[pictures]") {
  const Folder folder;
  CHECK_THROWS_AS(draw({"x.png", "set terminal png\nplot x\n"}, folder.path() / "missing"), render::FileError);
}

}  // namespace
}  // namespace study::test
