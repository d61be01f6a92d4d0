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
constexpr std::size_t most_of_run = 40;         // pairs
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

  /// In one run of the program. `must_answer`: whether it has answered all of these before.
  void ask(std::span<const Judged* const> pairs, bool must_answer) {
    std::vector<std::string> questions;
    for (const Judged* const each : pairs) questions.push_back(question_line({each->asked.pair.a, each->asked.pair.b}));
    const RunOfProgram run = run_program(program_.words, questions, program_.limit, program_.is_answer,
                                         {is_meant_as_step, most_steps_of_one});
    if (must_answer && run.answers < pairs.size())
      complain("asked for its steps it does not answer all: " +
               (run.how.empty() ? "it is too late, or tells too many" : run.how));
    auto line = run.lines.begin();
    std::vector<ToldRun> all;
    for (const Judged* const each : pairs) {
      all.push_back({each->asked.name, each->asked.pair});
      ToldRun& told = all.back();
      for (; line != run.lines.end() && !told.said; ++line) take(*line, *each, told);
    }
    if (line != run.lines.end())
      return complain("steps come after the answer about their pair; they are to come before it");
    for (std::size_t i = 0; i < all.size(); ++i) take(std::move(all[i]), *pairs[i]);
  }

  StepsLooked take_all() {
    const auto agreement = [this](const StepsLooked::Mistake& one) { return looked_.agreement_of(one); };
    const auto most = std::ranges::max_element(looked_.by_mistake, {}, agreement);
    if (looked_.wrong > looked_.repaired && agreement(*most) >= enough_agreement)
      looked_.mistake = static_cast<std::size_t>(most - looked_.by_mistake.begin());
    std::ranges::stable_sort(looked_.found, {}, [this](const LookedSearch& each) {
      const StepFinding* const wrong = first_wrong(each.findings);
      const bool is_by_it = wrong && looked_.mistake && std::ranges::count(wrong->mistakes, *looked_.mistake) > 0;
      return std::tuple(each.is_answered_rightly, !is_by_it, wrong && wrong->iteration > easily_followed,
                        each.run.pair.a.size() + each.run.pair.b.size());
    });
    return std::move(looked_);
  }

 private:
  void complain(const std::string& reason) {
    if (looked_.complaint.empty()) looked_.complaint = reason;
  }

  void take(const std::string& line, const Judged& about, ToldRun& told) {
    if (is_meant_as_step(line)) {
      try {
        told.steps.push_back(read_step(line));
      } catch (const std::invalid_argument& error) {
        complain("a line is meant as a step and is none: " + (error.what() + (": " + in_quotes(line))));
      }
      return;
    }
    const ProgramAnswer answer = read_answer(line, {about.asked.pair.a, about.asked.pair.b});
    told.said = answer.said == Said::intersecting ? gjk::Status::intersecting
                : answer.said == Said::separated  ? gjk::Status::separated
                                                  : gjk::Status::undecided;
  }

  void take(ToldRun told, const Judged& about) {
    looked_.without_steps += told.steps.empty() && told.said && is_wrong(about.verdict);
    if (told.steps.empty()) return;
    bring_to_differences(told);
    ++looked_.searches;
    looked_.steps += told.steps.size();
    auto [findings, not_made] = check_steps(told);
    looked_.otherwise +=
        static_cast<std::size_t>(std::ranges::count(findings, StepFinding::otherwise, &StepFinding::kind));
    const bool is_right = about.verdict == Verdict::right;
    if (const StepFinding* const first = first_wrong(findings); first && first->kind == StepFinding::wrong) {
      ++looked_.wrong;
      looked_.repaired += is_right;
      looked_.kept_directions += first->keeps_direction;
      for (const std::size_t m : first->mistakes) ++looked_.by_mistake[m].made;
    } else {
      looked_.rounding += first != nullptr;
      for (const std::size_t m : not_made) ++looked_.by_mistake[m].not_made;
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

double StepsLooked::agreement_of(const Mistake& one) const {
  const std::size_t either = wrong + one.not_made;
  return either == 0 ? 0 : static_cast<double>(one.made) / static_cast<double>(either);
}

StepsLooked look_at_steps(const AskedProgram& program, const Judgement& judgement) {
  const AsksForSteps asks;
  Looking looking(program);
  for (const Judged& each : judgement.failed) {  // may not come to its end: each in a run of its own
    const Judged* const one = &each;
    looking.ask(std::span(&one, 1), false);
  }
  std::vector<const Judged*> some;
  std::set<std::string> known;
  for (const Judged& each : judgement.worst) {
    some.push_back(&each);
    known.insert(each.asked.name);
  }
  for (const bool right : {false, true}) add_some(judgement.samples, right, known, some);
  for (std::size_t at = 0; at < some.size(); at += most_of_run)
    looking.ask(std::span(some).subspan(at, std::min(most_of_run, some.size() - at)), true);
  return looking.take_all();
}

std::optional<Parting> parting_of(const StepsLooked& looked) {
  const LookedSearch* const shown = looked.shown();
  if (!shown) return std::nullopt;
  StepFinding wrong = *first_wrong(shown->findings);
  // Of some that make this step only the one that makes nearly all of them is shown; else its own steps are.
  std::erase_if(wrong.mistakes, [&](std::size_t m) { return m != looked.mistake; });
  return steps::parting_of(shown->run, wrong);
}

std::string words_of_first_wrong(const LookedSearch& search) {
  const StepFinding& wrong = *first_wrong(search.findings);
  return message_line(search.run.name) + ", iteration " + std::to_string(wrong.iteration) + ": " +
         message_line(wrong.words);
}

void add_cause(const StepsLooked& looked, std::vector<Cause>& causes) {
  const auto of = [](std::size_t some, std::size_t all) { return std::to_string(some) + " of " + std::to_string(all); };
  const std::size_t wrong = looked.wrong - looked.repaired;
  // A step that is clearly wrong says more than rounding, which would explain the answers as well.
  const auto add_behind_reasons = [&](const Cause& cause) {
    causes.insert(std::ranges::find_if(causes, [](const Cause& each) { return each.rank != Cause::reason; }), cause);
  };
  if (looked.searches > 0 && looked.without_steps > wrong)
    add_behind_reasons(
        {"it answers before it searches",
         "for " + of(looked.without_steps, looked.without_steps + wrong) + " wrong answers no step is told", 1});
  if (looked.wrong == 0) return;
  if (!looked.mistake) {
    const std::string repaired = wrong == 0 ? ", which later steps repair" : "";
    const auto kept = static_cast<double>(looked.kept_directions) / static_cast<double>(looked.wrong);
    if (kept >= enough_agreement)
      return add_behind_reasons({"the direction is not changed",
                                 "the first wrong step of " + of(looked.kept_directions, looked.wrong) +
                                     " searches goes on along the direction before it" + repaired,
                                 kept, "", "--report report"});
    return add_behind_reasons(
        {"wrong steps", of(looked.wrong, looked.searches) + " searches have one" + repaired, 1, "", "--report report"});
  }
  const auto& known = wrong_on_purpose::all()[*looked.mistake];
  const StepsLooked::Mistake& by_it = looked.by_mistake[*looked.mistake];
  Cause cause{wrong_on_purpose::number_of(known.value) + ": " + std::string(known.meaning),
              "the first wrong step of " + of(by_it.made, looked.wrong) + " searches follows from it",
              looked.agreement_of(by_it), std::string(known.word)};
  if (const auto same = std::ranges::find(causes, cause.mistake, &Cause::mistake); same != causes.end()) {
    cause.evidence += "; " + same->evidence;
    cause.agreement = std::max(cause.agreement, same->agreement);
    causes.erase(same);
  }
  const auto place = std::ranges::find_if(causes, [&cause](const Cause& other) {
    return other.rank != Cause::reason || other.agreement < cause.agreement;
  });
  causes.insert(place, std::move(cause));
}

}  // namespace walkthroughs::judge
