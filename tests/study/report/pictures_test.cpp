/// What gnuplot is told to draw.
#include "tests/study/report/pictures.hpp"

#include <cmath>
#include <sstream>

#include "tests/catch.hpp"

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

}  // namespace
}  // namespace study::test
