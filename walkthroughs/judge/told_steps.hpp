/// Which step of a program is wrong? It is asked about some pairs once more, and told by JUDGE_STEPS=1 in its environment to write a
/// line at the end of each iteration, as walkthroughs/steps/told_run.hpp has it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "walkthroughs/judge/causes.hpp"
#include "walkthroughs/steps/check_steps.hpp"
#include "walkthroughs/steps/parting.hpp"

namespace walkthroughs::judge {

/// A search, and what is found about its steps.
struct LookedSearch {
  ToldRun run;
  StepFindings findings;
  bool is_answered_rightly = false;
};

struct StepsLooked {
  struct Mistake {
    std::size_t made = 0;      ///< searches whose first wrong step it makes
    std::size_t not_made = 0;  ///< searches without a wrong step in which it would have made one
  };

  std::size_t searches = 0, steps = 0;  ///< that it has told
  std::size_t wrong = 0;                ///< searches with a wrong step
  std::size_t repaired = 0;             ///< of these, those that are answered rightly all the same
  std::size_t rounding = 0;             ///< searches of which rounding may be the reason, and no line wrong
  std::size_t otherwise = 0;            ///< steps that the report makes otherwise, and that are as right
  std::size_t kept_directions = 0;      ///< searches whose first wrong step goes on along the direction before it
  std::size_t without_steps = 0;        ///< wrong answers for which no step is told
  std::vector<Mistake> by_mistake;      ///< of mistakes()
  std::optional<std::size_t>
      mistake;                      ///< the one that makes nearly all wrong steps, and hardly any where others go right
  std::vector<LookedSearch> found;  ///< those with findings: wrong answers first, then those easiest to follow
  std::string complaint;            ///< why steps cannot be read, or not all; else empty

  /// Returns: from 0 to 1, as Cause::agreement.
  double agreement_of(const Mistake& one) const;
  /// Returns: the one with a wrong step that is shown; null where there is none.
  const LookedSearch* shown() const;
};

/// Asks about what failed, the worst, and samples of what it answers wrongly and rightly. Errors: those of run_program().
StepsLooked look_at_steps(const AskedProgram& program, const Judgement& judgement);

/// Returns: the one that is shown, beside the report's; nothing where there is none, or what it tells are no numbers.
std::optional<Parting> parting_of(const StepsLooked& looked);

/// Returns: "m14-1, iteration 3: keeps …". Requires: a wrong step.
std::string words_of_first_wrong(const LookedSearch& search);

/// Adds why answers are wrong, by the steps: the mistake that makes most of the first wrong ones, or that there are some; or that
/// there are none.
void add_cause(const StepsLooked& looked, std::vector<Cause>& causes);

}  // namespace walkthroughs::judge
