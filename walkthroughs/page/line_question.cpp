#include "walkthroughs/page/line_question.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "walkthroughs/story/captions.hpp"
#include "walkthroughs/story/mistake_told.hpp"
#include "walkthroughs/story/pseudocode.hpp"

namespace walkthroughs {
namespace {

using Kind = Decision::Kind;
using Region = gjk::RegionTested<double>;

bool is_answer(const std::string& line) { return line == "intersecting" || line == "separated" || line == "undecided"; }

/// To which lines a step has come: setting out, the tests that were made, and what followed from the last. Of Algorithm 1 all that
/// do something in every iteration; where one that answers is wrong, these, too.
struct LinesRun {
  const std::vector<CodeLine>& code;
  const wrong_on_purpose::WrongLine& wrong;
  const Moment& now;
  Focus focus;

  bool has(std::size_t i) const {
    const CodeLine& line = code[i];
    if (wrong.algorithm == 1)
      return line.kind != LineKind::plain && (!is_answer(line.text) || is_answer(std::string(wrong.right)));
    if (i == current_line(code, now, focus)) return true;
    return line.kind == LineKind::plain ? !line.text.starts_with("else") : test_of(line, now) != nullptr;
  }
};

/// Returns: "0" of "R3: ABn·AO = 0 ≤ 0"; what has no number as it is.
std::string value_told(const std::string& text) {
  const std::size_t at = text.rfind(" = ");
  if (at == std::string::npos) return text;
  const std::string value = text.substr(at + 3, text.find_first_of("≤>≠:", at + 3) - at - 3);
  return value.substr(0, value.find_last_not_of(' ') + 1);
}

/// What a search says of what it has done last in a frame.
std::vector<Fact> facts_of(const Story& story, const Frame& frame, std::size_t scene) {
  const Telling& telling = story.tellings[scene];
  const std::size_t event = frame.events[scene].last;
  const auto told = caption(telling.trace.events[event], story, telling, replay(telling.trace, event + 1));
  return told ? told->facts : std::vector<Fact>();
}

/// "AO" of "R3 or R4: AO = (2, −1) ≠ 0", and what stands around it.
struct Told {
  explicit Told(const std::string& text) {
    const std::size_t colon = text.find(": "), begin = colon == std::string::npos ? 0 : colon + 2;
    const std::size_t end = std::min(text.find(" = ", begin), text.size());
    label = text.substr(0, begin);
    asked = text.substr(begin, end - begin);
    found = text.substr(end);
  }
  std::string label, asked, found;
};

/// Returns: what both say of the same thing, the mistaken search and the right one: the first of which they have different numbers.
/// Where they have something for the variable that the wrong line sets, it is that.
std::pair<std::string, std::string> said_of_same(const std::vector<Fact>& mistaken, const std::vector<Fact>& right,
                                                 const wrong_on_purpose::WrongLine& wrong) {
  for (const Fact& first : mistaken)
    for (const Fact& second : right)
      if (Told(first.text).asked == Told(second.text).asked && Told(first.text).found != Told(second.text).found)
        return {first.text, second.text};
  const Told one(mistaken[0].text), other(right[0].text);
  const std::string line(wrong.right), variable = line.substr(0, line.find(" ← "));
  if (one.label.empty() || one.label != other.label || variable == line) return {mistaken[0].text, right[0].text};
  return {one.label + variable + one.found, other.label + variable + other.found};
}

/// Returns: what both searches find where they part, which the frame before does not show: without it one could only guess. Their
/// numbers, or where these do not differ what they make of them. Of the first point only the mistaken search says anything.
std::string what_each_finds(const Story& story, const Frame& parting, const wrong_on_purpose::WrongLine& wrong) {
  const std::vector<Fact>& facts = parting.facts;  // of each what it finds, with its name, then its numbers
  if (facts.size() < 4) return " " + facts[0].text;
  const auto words = [&](std::size_t i) { return facts[i].text.substr(0, facts[i].text.size() - 1); };  // no full stop
  const auto name = [&](std::size_t i) { return facts[i].text.substr(0, facts[i].text.find(": ") + 2); };
  const bool is_same = value_told(facts[1].text) == value_told(facts[3].text);
  if (is_same) return " " + words(0) + "; " + words(2) + ".";
  const auto [mistaken, right] = said_of_same(facts_of(story, parting, 0), facts_of(story, parting, 1), wrong);
  return " " + name(0) + mistaken + "; " + name(2) + right + ".";
}

}  // namespace

std::optional<Question> question_of_line(const Story& story) {
  const std::optional<std::size_t> place = story.parting();
  if (!place) return std::nullopt;
  const Frame& parting = story.frames[*place];
  const Telling& right = story.tellings[1];
  const Mistake mistake = *story.tellings[0].scene.mistake;
  const std::size_t event = parting.events[1].last;
  const auto* const found = line_gone_wrong(mistake, right.trace, event);
  if (!found) return std::nullopt;
  const wrong_on_purpose::WrongLine& wrong = *found;
  const Moment& now = parting.moments[1];
  const Names names(story.walkthrough.naming, right.hull, now);
  const std::vector<CodeLine>& code = algorithm(wrong.algorithm, RuleSet::as_intended);
  const auto is_otherwise = [&](const CodeLine& line) {
    return std::ranges::any_of(wrong_on_purpose::description_of(mistake).lines, [&](const auto& each) {
      return each.algorithm == wrong.algorithm && each.right == line.text;
    });
  };
  Question question{
      {Kind::line, wrong.algorithm - 1, std::string(wrong_on_purpose::description_of(mistake).word)},
      0,
      parting.events[0].last,
      "In which line of Algorithm " + std::to_string(wrong.algorithm) + " is the mistake?" + what_each_finds(story, parting, wrong),
      {},
      0};
  const auto choose_among = [&](const LinesRun& run) {
    question.choices.clear();
    for (std::size_t i = 0; i < code.size(); ++i) {
      const std::string text = line_in_letters(wrong.algorithm, code[i], names);
      if (code[i].text == wrong.right) {
        question.right = question.choices.size();
        add_once(question.choices, {text, "here: " + wrong_text(wrong, names), ""});
      } else if (run.has(i) && !is_otherwise(code[i])) {
        add_once(question.choices, {text, "this line is as in the report", "this line is as in the report"});
      }
    }
  };
  const bool is_test = std::holds_alternative<Region>(right.trace.events[event]);
  choose_among({code, wrong, now, is_test ? Focus::region : Focus::direction});
  if (question.choices.size() < 2)
    choose_among({code, wrong, now, Focus::direction});  // and what follows from the test
  return question;
}

}  // namespace walkthroughs
