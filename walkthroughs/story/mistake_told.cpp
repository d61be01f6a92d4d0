#include "walkthroughs/story/mistake_told.hpp"

#include <algorithm>
#include <optional>

#include "walkthroughs/story/pseudocode.hpp"
#include "walkthroughs/story/truth_told.hpp"
#include "walkthroughs/wrong_on_purpose/mistakes.hpp"

namespace walkthroughs::story {
namespace {

using wrong_on_purpose::WrongLine;

constexpr const char* none_along_axes = "begun along an axis this is no mistake";

/// What a frame about that event would want the reader to look at; only what the pseudo-code asks.
Focus focus_on(const gjk::Event<double>& event) {
  if (std::holds_alternative<gjk::RegionTested<double>>(event)) return Focus::region;
  if (std::holds_alternative<gjk::SimplexReduced<double>>(event)) return Focus::reduction;
  if (std::holds_alternative<gjk::DirectionChosen<double>>(event)) return Focus::direction;
  return Focus::crossing;
}

const gjk::Result<double>& result_of(const Trace& trace) {
  return std::get<gjk::Finished<double>>(trace.events.back()).result;
}

/// `truth`: of what the right search answers, where nothing is known that says otherwise.
std::string how_search_ended(const gjk::Result<double>& mistaken, const gjk::Result<double>& right, gjk::Status truth) {
  const bool meet = truth == gjk::Status::intersecting;
  if (mistaken.status == gjk::Status::undecided)
    return (mistaken.cycle_start ? "It goes round for ever" : "It ends without an answer") +
           std::string(meet ? ", and Algorithm 1 then says no. " : ", which happens to do no harm. ") +
           as_sentence("in truth they " + in_truth(truth));
  if (mistaken.status != truth) return "A wrong answer: in truth they " + in_truth(truth);
  return "The same answer, found " + std::string(mistaken.iterations > right.iterations ? "later" : "sooner") +
         ": that is why such a mistake passes tests";
}

/// Returns: how many random pairs it takes to notice that mistake: without the full stop.
std::string how_long_unnoticed(Mistake mistake) {
  using wrong_on_purpose::TestPairs;
  if (is_none_along_axes(mistake)) return none_along_axes;
  const auto thrown = pairs_to_notice(mistake, TestPairs::triangles),
             touching = pairs_to_notice(mistake, TestPairs::grid_triangles);
  const std::string words = "it takes " + thrown.text() + " random pairs of triangles to find it";
  return thrown.is_more && !touching.is_more ? words + ", but " + touching.text() + " on a grid, where they touch"
                                             : words;
}

std::string how_it_ended(Mistake mistake, const gjk::Result<double>& mistaken, const gjk::Result<double>& right,
                         gjk::Status truth) {
  if (is_none_along_axes(mistake) && mistaken.status == right.status)
    return std::string("The same answer, found sooner, and proven: ") + none_along_axes;
  return how_search_ended(mistaken, right, truth) + ". " + as_sentence(how_long_unnoticed(mistake));
}

std::string both_lines(const WrongLine& line, const Names& names) {
  const CodeLine right{0, std::string(line.right)};
  return "Algorithm " + std::to_string(line.algorithm) + ": " + line_in_letters(line.algorithm, right, names) +
         "; here: " + wrong_text(line, names);
}

}  // namespace

const WrongLine* line_gone_wrong(Mistake mistake, const Trace& right, std::size_t event) {
  const Moment now = replay(right, event + 1);
  const Focus focus = focus_on(right.events.at(event));
  const int number = running_algorithm(now, focus);
  const std::vector<CodeLine>& code = algorithm(number, RuleSet::as_intended);
  const std::optional<std::size_t> current = current_line(code, now, focus);
  const WrongLine* found = nullptr;
  for (const WrongLine& each : wrong_on_purpose::description_of(mistake).lines)
    if (each.algorithm == number && (!found || (current && code[*current].text == each.right))) found = &each;
  return found;
}

std::string wrong_text(const WrongLine& line, const Names& names) {
  return line.algorithm == 1 ? std::string(line.wrong) : names.translate(line.wrong);  // that of B is no vertex
}

std::optional<ToldMistake> mistake_told(const Story& story, std::size_t common) {
  const std::optional<Mistake> mistake = story.tellings[0].scene.mistake;
  const Trace &mistaken = story.tellings[0].trace, &right = story.tellings[1].trace;
  if (!mistake || common == mistaken.events.size()) return std::nullopt;
  const Moment parting = replay(right, common + 1);
  const Names names(story.walkthrough.naming, story.tellings[1].hull, parting);
  const gjk::Status known = story.tellings[0].truth.answer.status;
  const gjk::Status truth = known == gjk::Status::undecided ? result_of(right).status : known;
  ToldMistake told{.meaning = names.translate(wrong_on_purpose::description_of(*mistake).meaning),
                   .lines = {},
                   .ending = how_it_ended(*mistake, result_of(mistaken), result_of(right), truth),
                   .is_wrong_there = !is_none_along_axes(*mistake),
                   .ends_wrongly = result_of(mistaken).status != truth};
  if (const WrongLine* const line = line_gone_wrong(*mistake, right, common)) told.lines = both_lines(*line, names);
  return told;
}

}  // namespace walkthroughs::story
