#include "walkthroughs/judge/told_steps.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <span>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "walkthroughs/steps/differences.hpp"
#include "walkthroughs/steps/mistakes.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/wrong_on_purpose/mistakes.hpp"

namespace walkthroughs::judge {
namespace {

constexpr std::size_t most_of_kind = 60;        // samples of right answers, and of wrong ones
constexpr std::size_t most_steps_of_one = 200;  // told of a search
constexpr int easily_followed = 20;             // iterations

/// Says so to what this process starts, as long as it lives.
class AsksForSteps {
 public:
  AsksForSteps() { ::setenv("JUDGE_STEPS", "1", 1); }
  ~AsksForSteps() { ::unsetenv("JUDGE_STEPS"); }
  AsksForSteps(const AsksForSteps&) = delete;
  AsksForSteps& operator=(const AsksForSteps&) = delete;
};

class Looking {
 public:
  explicit Looking(const AskedProgram& program) : program_(program) { looked_.by_mistake.resize(mistakes().size()); }

  /// In one run of the program.
  void ask(std::span<const Judged* const> pairs) {
    if (pairs.empty()) return;
    std::vector<std::string> questions;
    for (const Judged* const each : pairs) questions.push_back(question_line({each->asked.pair.a, each->asked.pair.b}));
    const RunOfProgram run = run_program(
        program_.words, questions, program_.limit,
        [&](std::string_view line) { return program_.is_answer(line) || is_meant_as_step(line); }, most_steps_of_one);
    auto line = run.lines.begin();
    for (const Judged* const each : pairs) {
      ToldRun told{each->asked.name, each->asked.pair};
      for (; line != run.lines.end() && !told.said; ++line) take(*line, *each, told);
      take(std::move(told), *each);
    }
  }

  StepsLooked take_all() {
    std::ranges::stable_sort(looked_.found, {}, [](const LookedSearch& each) {
      const StepFinding* const wrong = first_wrong(each.findings);
      return std::tuple(each.is_answered_rightly, wrong && wrong->iteration > easily_followed,
                        each.run.pair.a.size() + each.run.pair.b.size());
    });
    return std::move(looked_);
  }

 private:
  void take(const std::string& line, const Judged& about, ToldRun& told) {
    if (is_meant_as_step(line)) {
      try {
        told.steps.push_back(read_step(line));
      } catch (const std::invalid_argument& error) {
        if (looked_.complaint.empty()) looked_.complaint = error.what() + (": " + in_quotes(line));
      }
      return;
    }
    const ProgramAnswer answer = read_answer(line, {about.asked.pair.a, about.asked.pair.b});
    told.said = answer.said == Said::intersecting ? gjk::Status::intersecting
                : answer.said == Said::separated  ? gjk::Status::separated
                                                  : gjk::Status::undecided;
    told.seeks_distance = answer.distance.has_value();
  }

  void take(ToldRun told, const Judged& about) {
    if (told.steps.empty()) return;
    bring_to_differences(told);
    ++looked_.searches;
    looked_.steps += told.steps.size();
    StepFindings findings = check_steps(told);
    looked_.otherwise +=
        static_cast<std::size_t>(std::ranges::count(findings, StepFinding::otherwise, &StepFinding::kind));
    const bool is_right = about.verdict == Verdict::right;
    if (const StepFinding* const first = first_wrong(findings); first && first->kind == StepFinding::wrong) {
      ++looked_.wrong;
      looked_.repaired += is_right;
      for (const std::size_t m : first->mistakes) ++looked_.by_mistake[m];
    } else if (first) {
      ++looked_.rounding;
    }
    if (!findings.empty()) looked_.found.push_back({std::move(told), std::move(findings), is_right});
  }

  const AskedProgram& program_;
  StepsLooked looked_;
};

/// Returns: at most so many of the samples that are right, or that are not, evenly among them all, and none twice.
void add_some(const std::vector<Judged>& samples, bool right, std::set<std::string>& known,
              std::vector<const Judged*>& some) {
  std::vector<const Judged*> all;
  for (const Judged& each : samples)
    if ((each.verdict == Verdict::right) == right && !known.contains(each.asked.name)) all.push_back(&each);
  const std::size_t count = std::min(all.size(), most_of_kind);
  for (std::size_t i = 0; i < count; ++i) {
    some.push_back(all[i * all.size() / count]);
    known.insert(some.back()->asked.name);
  }
}

}  // namespace

const LookedSearch* StepsLooked::shown() const {
  const auto has_wrong = [](const LookedSearch& each) {
    return std::ranges::count(each.findings, StepFinding::wrong, &StepFinding::kind) > 0;
  };
  const auto first = std::ranges::find_if(found, has_wrong);
  return first == found.end() ? nullptr : &*first;
}

StepsLooked look_at_steps(const AskedProgram& program, const Judgement& judgement) {
  const AsksForSteps asks;
  Looking looking(program);
  for (const Judged& each : judgement.failed) {  // may not come to its end: each in a run of its own
    const Judged* const one = &each;
    looking.ask(std::span(&one, 1));
  }
  std::vector<const Judged*> some;
  std::set<std::string> known;
  for (const Judged& each : judgement.worst) {
    some.push_back(&each);
    known.insert(each.asked.name);
  }
  for (const bool right : {false, true}) add_some(judgement.samples, right, known, some);
  looking.ask(some);
  return looking.take_all();
}

std::optional<Parting> parting_of(const StepsLooked& looked) {
  const LookedSearch* const shown = looked.shown();
  return shown ? steps::parting_of(shown->run, *first_wrong(shown->findings)) : std::nullopt;
}

std::string words_of_first_wrong(const LookedSearch& search) {
  const StepFinding& wrong = *first_wrong(search.findings);
  return message_line(search.run.name) + ", iteration " + std::to_string(wrong.iteration) + ": " +
         message_line(wrong.words);
}

void add_cause(const StepsLooked& looked, std::vector<Cause>& causes) {
  if (looked.wrong == looked.repaired) return;
  const auto most = std::ranges::max_element(looked.by_mistake);
  const auto of = [](std::size_t some, std::size_t all) { return std::to_string(some) + " of " + std::to_string(all); };
  const double share = static_cast<double>(*most) / static_cast<double>(looked.wrong);
  if (share < enough_agreement) {
    causes.push_back(
        {"wrong steps", of(looked.wrong, looked.searches) + " searches have one", 1, "", "--report report"});
    return;
  }
  const auto& known = wrong_on_purpose::all()[static_cast<std::size_t>(most - looked.by_mistake.begin())];
  Cause cause{wrong_on_purpose::number_of(known.value) + ": " + std::string(known.meaning),
              "the first wrong step of " + of(*most, looked.wrong) + " searches follows from it", share,
              std::string(known.word)};
  if (const auto same = std::ranges::find(causes, cause.mistake, &Cause::mistake); same != causes.end()) {
    cause.evidence += "; " + same->evidence;
    causes.erase(same);
  }
  causes.insert(causes.begin(), std::move(cause));
}

}  // namespace walkthroughs::judge
