#include <algorithm>
#include <utility>
#include <variant>

#include "walkthroughs/page/questions.hpp"
#include "walkthroughs/story/mistake_told.hpp"
#include "walkthroughs/story/pseudocode.hpp"

namespace walkthroughs::page {
namespace {

using Kind = Decision::Kind;
using Region = gjk::RegionTested<double>;

bool is_answer(LineKind kind) {
  return kind == LineKind::intersecting || kind == LineKind::separated || kind == LineKind::undecided;
}

/// Whether a step has come to a line: setting out, the tests that were made, and what followed from the last. Of Algorithm 1 all
/// that do something in every iteration; where one that answers is wrong, these, too.
bool has_run(const CodeLine& line, const std::vector<CodeLine>& code, const wrong_on_purpose::WrongLine& wrong,
             const Moment& now, Focus focus) {
  if (wrong.algorithm == 1) {
    const bool answers_wrongly = is_answer(std::ranges::find(code, wrong.right, &CodeLine::text)->kind);
    return line.kind != LineKind::plain && (!is_answer(line.kind) || answers_wrongly);
  }
  const std::optional<std::size_t> current = current_line(code, now, focus);
  return (current && &line == &code[*current]) || line.kind == LineKind::plain || test_of(line, now) != nullptr;
}

/// What a search says of what it has done last in a frame; nothing where that is nothing, or without a fact.
std::optional<Frame> said_in(const Story& story, const Frame& frame, std::size_t scene) {
  const std::optional<Frame>& said = story.tellings[scene].said[frame.events[scene].last];
  return said && !said->facts.empty() ? said : std::nullopt;
}

/// Returns: what both say of the same thing, the mistaken search and the right one: the first of which they have different numbers.
/// Where they have something for the variable that the wrong line sets, it is that.
std::pair<std::string, std::string> said_of_same(const Frame& mistaken, const Frame& right,
                                                 const wrong_on_purpose::WrongLine& wrong) {
  for (const Fact& first : mistaken.facts)
    for (const Fact& second : right.facts)
      if (!first.asked.empty() && first.asked == second.asked && first.value != second.value)
        return {first.text, second.text};
  const Fact &one = mistaken.facts[0], &other = right.facts[0];
  if (one.asked.empty() || other.asked.empty() || wrong.sets.empty()) return {one.text, other.text};
  const auto with_variable = [&](const Fact& fact) {
    std::string text = fact.text;
    return text.replace(text.find(fact.asked), fact.asked.size(), wrong.sets);
  };
  return {with_variable(one), with_variable(other)};
}

/// Returns: what both searches find where they part, which the frame before does not show: without it one could only guess. Their
/// numbers, or where these do not differ what they make of them. Of the first point only the mistaken search says anything.
std::string what_each_finds(const Story& story, const Frame& parting, const wrong_on_purpose::WrongLine& wrong) {
  const std::optional<Frame> mistaken = said_in(story, parting, 0), right = said_in(story, parting, 1);
  if (!mistaken || !right) return " " + parting.facts[0].text;
  const auto& [first, second] = said_of_same(*mistaken, *right, wrong);
  const bool is_same = mistaken->facts[0].value == right->facts[0].value && !right->facts[0].value.empty();
  const auto says = [&](std::size_t scene, const std::string& what) {
    return story.tellings[scene].scene.name + ": " + what;
  };
  const auto without_full_stop = [](const std::string& caption) { return caption.substr(0, caption.size() - 1); };
  return is_same ? " " + says(0, without_full_stop(mistaken->caption)) + "; " + says(1, right->caption)
                 : " " + says(0, first) + "; " + says(1, second) + ".";
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
  Question question{{Kind::line, wrong.algorithm - 1, std::string(wrong_on_purpose::description_of(mistake).word)},
                    0,
                    parting.events[0].last,
                    "In which line of Algorithm " + std::to_string(wrong.algorithm) + " is the mistake?" +
                        what_each_finds(story, parting, wrong),
                    {},
                    0};
  const auto choose_among_run = [&](Focus focus) {
    question.choices.clear();
    for (const CodeLine& line : code) {
      const std::string text = line_in_letters(wrong.algorithm, line, names);
      if (line.text == wrong.right) {
        question.right = question.choices.size();
        add_once(question.choices, {text, "here: " + wrong_text(wrong, names)});
      } else if (has_run(line, code, wrong, now, focus) && !is_otherwise(line)) {
        add_once(question.choices, {text, "this line is as in the report", "this line is as in the report"});
      }
    }
  };
  choose_among_run(std::holds_alternative<Region>(right.trace.events[event]) ? Focus::region : Focus::direction);
  if (question.choices.size() < 2) choose_among_run(Focus::direction);  // and what follows from the test
  return question;
}

}  // namespace walkthroughs::page
