/// A wrong search beside the report's own, until they part.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "walkthroughs/model/walkthrough.hpp"
#include "walkthroughs/steps/check_steps.hpp"
#include "walkthroughs/story/story.hpp"

namespace walkthroughs::steps {

/// The name of such a walkthrough.
inline constexpr const char* parting_name = "first-wrong-step";

/// A walkthrough of two scenes, and their traces.
struct Parting {
  Walkthrough walkthrough;
  std::vector<Trace> traces;
  int iteration;           ///< in which it goes wrong
  std::string words = {};  ///< what is wrong, where the walkthrough does not know a mistake that says so

  /// Returns: frames until then and one iteration on. Refers to this, which must outlive it.
  Story story() const;
};

/// Returns: the first of the mistakes that make that step, on the same pair and begun in the same direction, beside the report's
/// algorithm. Where none of them goes wrong in that very step, with those vertices, the steps that the program itself tells, beside what
/// the report makes of that one; nothing where what it tells until then are no numbers. `finding`: one of check_steps(told).
std::optional<Parting> parting_of(const ToldRun& told, const StepFinding& finding);

}  // namespace walkthroughs::steps
