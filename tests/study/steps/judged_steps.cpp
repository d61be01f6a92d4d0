#include "tests/study/steps/judged_steps.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>

#include "tests/study/claims/claims_text.hpp"
#include "tests/study/judge/run_program.hpp"
#include "tests/study/methods/mistakes.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/text/text_file.hpp"

namespace study {
namespace {

constexpr std::size_t most_lines = 10'000;  // of one search

/// What programs look for before they write steps.
class StepsWanted {
 public:
  StepsWanted() { ::setenv("JUDGE_STEPS", "1", 1); }
  ~StepsWanted() { ::unsetenv("JUDGE_STEPS"); }
  StepsWanted(const StepsWanted&) = delete;
  StepsWanted& operator=(const StepsWanted&) = delete;
};

bool is_followed(const Judged& judged) {
  const bool is_answer = judged.verdict == Verdict::wrong_yes || judged.verdict == Verdict::wrong_no ||
                         judged.verdict == Verdict::undecided;
  return is_answer && std::holds_alternative<Points>(judged.named.pair.a) &&
         std::holds_alternative<Points>(judged.named.pair.b);
}

JudgedSteps steps_on(const AskedProgram& program, const NamedPair& named) {
  const std::vector<std::string> question{question_line(named.pair)};
  const RunOfProgram run = run_program(program.words, question, program.limit, most_lines);
  std::string text = question.front() + "\n";
  for (const std::string& line : run.lines) text += line + "\n";
  try {
    std::vector<ToldRun> told = read_told_runs(text, "line");
    if (told.size() != 1 || told.front().steps.empty()) return {named.name, {}, "it tells no steps"};
    return {named.name, check_steps(told.front()), {}};
  } catch (const walkthroughs::InputError& error) {
    return {named.name, {}, error.what()};
  }
}

std::string mistakes_in_words(const StepsChecked& checked) {
  std::string words;
  for (const std::size_t m : checked.mistakes)
    words += (words.empty() ? "" : "; ") + std::string("M") + std::to_string(m + 1) + ": " + mistakes()[m].name;
  return words.empty() ? "–" : words;
}

}  // namespace

std::vector<JudgedSteps> steps_of_failures(const AskedProgram& program, const ProgramJudged& judged, std::size_t most) {
  const StepsWanted wanted;
  std::vector<JudgedSteps> all;
  std::set<std::string> families;
  for (const Judged& each : judged.pairs) {
    if (all.size() == most) break;
    if (is_followed(each) && families.insert(each.named.family).second) all.push_back(steps_on(program, each.named));
  }
  return all;
}

std::string steps_markdown(const std::vector<JudgedSteps>& all) {
  if (all.empty()) return "";
  std::ostringstream out;
  out << "## The first wrong step\n\n";
  heading(out, {"Pair", "Iteration", "What is wrong", "That is what follows from"}, 4);
  for (const JudgedSteps& each : all) {
    Cells cells{walkthroughs::printable(each.pair), "–", walkthroughs::printable(each.why), "–"};
    if (each.checked && each.checked->iteration == 0)
      cells[2] = "every step is one that the report's algorithm may make: rounding, or a cycle";
    else if (each.checked)
      cells = {cells[0], std::to_string(each.checked->iteration), each.checked->words,
               mistakes_in_words(*each.checked)};
    row(out, cells);
  }
  out << '\n';
  return out.str();
}

}  // namespace study
