#include "tests/study/steps/judged_steps.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <tuple>

#include "tests/study/judge/drawn_frame.hpp"
#include "tests/study/judge/run_program.hpp"
#include "tests/study/steps/check_steps.hpp"
#include "tests/study/steps/parting.hpp"
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

/// Returns: its search, step by step; nothing, and why, where it tells none.
std::optional<ToldRun> told_run(const AskedProgram& program, const NamedPair& named, std::string& why) {
  const std::vector<std::string> question{question_line(named.pair)};
  const RunOfProgram run = run_program(program.words, question, program.limit, most_lines);
  std::string text = question.front() + "\n";
  for (const std::string& line : run.lines) text += line + "\n";
  try {
    std::vector<ToldRun> told = read_told_runs(text, "line");
    if (told.size() == 1 && !told.front().steps.empty()) return std::move(told.front());
    why = "it tells no steps";
  } catch (const walkthroughs::text::InputError& error) {
    why = error.what();
  }
  return {};
}

/// What is looked at first has the fewest points, then whole numbers, then the smallest.
auto effort_to_read(const Pair& pair) {
  const Points &a = std::get<Points>(pair.a), &b = std::get<Points>(pair.b);
  bool is_whole = true;
  for (const Points* const points : {&a, &b})
    for (const Vec& p : *points) is_whole = is_whole && p == p.array().round().matrix();
  return std::tuple(a.size() + b.size(), !is_whole, std::max(largest_number(pair.a), largest_number(pair.b)));
}

/// Returns: of each family the failure that is easiest to read, these in the same order.
std::vector<const Judged*> easiest_failures(const std::vector<Judged>& pairs) {
  std::vector<const Judged*> all;
  for (const Judged& each : pairs)
    if (each.has_search()) all.push_back(&each);
  std::ranges::stable_sort(all, {}, [](const Judged* each) { return effort_to_read(each->named.pair); });
  std::set<std::string> families;
  std::erase_if(all, [&](const Judged* each) { return !families.insert(each->named.family).second; });
  return all;
}

}  // namespace

std::vector<JudgedSteps> steps_of_failures(const AskedProgram& program, const ProgramJudged& judged, std::size_t most,
                                           std::size_t pictures) {
  const StepsWanted wanted;
  std::vector<JudgedSteps> all;
  std::optional<FrameDrawing> drawing;
  for (const Judged* const each : easiest_failures(judged.pairs)) {
    if (all.size() == most) break;
    JudgedSteps& steps = all.emplace_back(JudgedSteps{.pair = each->named.name});
    const std::optional<ToldRun> run = told_run(program, each->named, steps.words);
    if (!run) continue;
    StepsChecked checked = check_steps(*run);
    steps.iteration = checked.iteration;
    steps.words = checked.iteration == 0
                      ? "every step is one that the report's algorithm may make: rounding, or a cycle"
                      : checked.words;
    steps.mistakes = checked.mistakes;
    steps.may_be_rounding = checked.may_be_rounding;
    if (checked.iteration == 0 || pictures == 0) continue;
    if (!drawing) drawing.emplace();
    steps.drawn = (*drawing)(parting_of(*run, checked)->story());
    --pictures;
  }
  return all;
}

}  // namespace study
