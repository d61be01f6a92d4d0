// The walkthroughs of mistakes: where each parts from the report's search, how it ends, what is said of it.

#include "walkthroughs/wrong_on_purpose/mistakes.hpp"

#include <cmath>
#include <map>
#include <sstream>

#include "tests/kit/catch.hpp"
#include "tests/kit/places.hpp"
#include "tests/kit/text.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/page/questions.hpp"
#include "walkthroughs/story/pseudocode.hpp"

namespace mistakes_test {

using namespace walkthroughs;
using namespace walkthroughs::program;
using namespace walkthroughs::test;
using gjk::Status;
using kit::has;
using wrong_on_purpose::PairsToNotice;
using wrong_on_purpose::TestPairs;

namespace {

/// In which iteration the two searches part, and how both end.
struct Seen {
  const char* name;
  int iteration;
  Status mistaken, right;
};

constexpr Status meet = Status::intersecting, apart = Status::separated, undecided = Status::undecided;

const Seen seen[] = {
    {"m1-wrong-side-of-b", 2, apart, meet},
    {"m2-first-point-tested", 1, apart, apart},
    {"m3-touching-is-apart", 2, apart, meet},
    {"m4-as-printed", 3, meet, apart},
    {"m5-origin-at-vertex", 1, undecided, meet},
    {"m6-origin-on-segment", 2, undecided, meet},
    {"m7-direction-from-vertex", 2, meet, apart},
    {"m8-triangle-normal-reversed", 3, undecided, meet},
    {"m9-abn-inward", 3, undecided, meet},
    {"m10-acn-inward", 3, undecided, meet},
    {"m11-edge-normal-as-direction", 3, apart, apart},
    {"m12-two-dimensions-only", 3, meet, apart},
    {"m13-origin-in-triangle", 3, meet, meet},
    {"m14-order-below-triangle", 3, meet, meet},
    {"m15-face-abcn-inward", 4, meet, apart},
    {"m16-face-acdn-inward", 4, meet, apart},
    {"m17-face-adbn-inward", 4, undecided, meet},
    {"m18-edge-normals-reused", 4, meet, meet},
    {"m19-abn-reused", 4, meet, meet},
    {"m20-order-of-face-adb", 4, meet, meet},
    {"m21-origin-in-face", 5, undecided, meet},
};

Status status_of(const Telling& telling) {
  return std::get<gjk::Finished<double>>(telling.trace.events.back()).result.status;
}

std::vector<const Walkthrough*> about_mistakes() {
  std::vector<const Walkthrough*> all = find_walkthroughs("mistakes");
  std::erase_if(all, [](const Walkthrough* w) { return w->layout == Layout::diagrams; });
  return all;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream row(line);
  for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
  return cells;
}

std::string without_subscripts(std::string text) {
  std::erase(text, '_');
  return text;
}

}  // namespace

TEST_CASE("There is a walkthrough for each mistake, in the report's order, behind the picture of all") {
  CHECK(find_walkthroughs("mistakes").front()->name == "mistakes/survival");
  const std::vector<const Walkthrough*> all = about_mistakes();
  REQUIRE(all.size() == std::size(seen));
  REQUIRE(all.size() == wrong_on_purpose::all().size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    CHECK(all[i]->name == "mistakes/" + std::string(seen[i].name));
    CHECK(all[i]->scenes.at(0).mistake == static_cast<Mistake>(i));
    CHECK_FALSE(all[i]->scenes.at(1).mistake);
    CHECK(all[i]->scenes[0].name == "M" + std::to_string(i + 1));
  }
}

TEST_CASE("Each mistake parts from the report's search where it says and ends as it says") {
  for (const Seen& each : seen) {
    INFO(each.name);
    const Walkthrough& w = walkthrough("mistakes/" + std::string(each.name));
    const Story story = tell(w);
    CHECK(status_of(story.tellings[0]) == each.mistaken);
    CHECK(status_of(story.tellings[1]) == each.right);
    REQUIRE(std::ranges::count(story.frames, Focus::parting, &Frame::focus) == 1);
    const Frame& parting = story.frames.at(story.parting().value());
    CHECK(parting.moments[0].iteration == each.iteration);
    CHECK(parting.own_focus.size() == 2);  // each is drawn by what it finds
    CHECK(std::ranges::count(parting.own_focus, Focus::parting) == 0);
    // How many pairs notice it is told, as it was measured.
    const Mistake mistake = *w.scenes[0].mistake;
    const PairsToNotice thrown = pairs_to_notice(mistake, TestPairs::triangles);
    const bool is_told = has(story.frames.back().caption, "It takes " + thrown.text() + " random pairs of triangles");
    CHECK(is_told == !is_none_along_axes(mistake));
  }
}

TEST_CASE("Lines of mistakes are lines of the report's pseudo-code and have another text") {
  for (const auto& known : wrong_on_purpose::all()) {
    INFO(known.word);
    CHECK_FALSE(known.lines.empty());
    CHECK(known.word.starts_with("m" + wrong_on_purpose::number_of(known.value).substr(1) + "-"));
    for (const auto& line : known.lines) {
      INFO(line.right);
      const std::vector<CodeLine>& code = algorithm(line.algorithm, RuleSet::as_intended);
      CHECK(std::ranges::count(code, std::string(line.right), &CodeLine::text) > 0);
      CHECK(line.right != line.wrong);
      CHECK(std::ranges::count(code, std::string(line.wrong), &CodeLine::text) == 0);
    }
  }
}

TEST_CASE("Of each mistake one thing is asked: the line, and one choice has it") {
  for (const Walkthrough* w : about_mistakes()) {
    INFO(w->name);
    const Story story = tell(*w);
    const std::vector<Question> questions = questions_of(story);
    REQUIRE(questions.size() == 1);
    const Question& question = questions.front();
    CHECK(question.decision.kind == Decision::Kind::line);
    CHECK(question.event == story.frames.at(story.parting().value()).events[0].last);
    const auto& lines = wrong_on_purpose::description_of(*w->scenes[0].mistake).lines;
    const auto is_wrong = [&](const Choice& choice) {
      return std::ranges::count(lines, without_subscripts(choice.text), [](const auto& l) { return l.right; }) > 0;
    };
    CHECK(std::ranges::count_if(question.choices, is_wrong) == 1);
    CHECK(is_wrong(question.choices.at(question.right)));
    CHECK((question.choices.size() >= 2 && question.choices.size() <= 9));  // as many as there are keys
  }
}

// -- How long they survive --------------------------------------------------------------------------------------------

/// Returns: of how many pairs at least one shows a mistake in 95 of 100 tests, to two digits.
double pairs_to_see(double share) {
  const double pairs = share >= 1 ? 1 : std::ceil(std::log(0.05) / std::log1p(-share));
  const double unit = std::pow(10, std::max(0.0, std::floor(std::log10(pairs)) - 1));
  return std::floor(pairs / unit + 0.5) * unit;
}

TEST_CASE("How many pairs it takes to notice a mistake is what the study has counted") {
  std::istringstream counts(bytes_of(kit::source("tests/study/results/claims-mistakes.csv")));
  const std::map<std::string, TestPairs> kinds{
      {"triangles", TestPairs::triangles}, {"tetrahedra", TestPairs::tetrahedra}, {"grid", TestPairs::grid_triangles}};
  std::size_t rows = 0;
  for (std::string line; std::getline(counts, line);) {
    const auto cells = cells_of(line);
    const auto kind = kinds.find(cells[0]);
    if (kind == kinds.end()) continue;
    const auto mistake = static_cast<Mistake>(std::stoi(cells[1].substr(1)) - 1);
    const double asked = std::stod(cells[cells.size() - 11]), fails = std::stod(cells[cells.size() - 10]);
    constexpr double z = 1.959964;  // Wilson's interval of 95 in 100, where none has failed
    const PairsToNotice needed = pairs_to_notice(mistake, kind->second);
    INFO(line);
    CHECK(needed.is_more == (fails == 0));
    CHECK(needed.count == pairs_to_see(fails == 0 ? z * z / (asked + z * z) : fails / asked));
    ++rows;
  }
  CHECK(rows == 3 * wrong_on_purpose::all().size());
}

}  // namespace mistakes_test
