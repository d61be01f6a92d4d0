/// A wrong search beside the report's own, until they part.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/study/steps/check_steps.hpp"
#include "walkthroughs/model/walkthrough.hpp"
#include "walkthroughs/story/story.hpp"

namespace study {

/// A walkthrough of two scenes, and their traces.
struct Parting {
  walkthroughs::model::Walkthrough walkthrough;
  std::vector<walkthroughs::model::Trace> traces;
  int iteration;           ///< in which it goes wrong
  std::string words = {};  ///< what is wrong, where the walkthrough does not know a mistake that says so

  /// Returns: frames until then and one iteration on. Refers to this, which must outlive it.
  walkthroughs::story::Story story() const;
};

/// Returns: the first of the mistakes that were found, on the same pair and begun in the same direction, beside the report's
/// algorithm. Where none of them goes wrong in that very step, with those vertices, the steps that the program itself tells, beside what
/// the report makes of the first wrong one; nothing where no step is wrong.
std::optional<Parting> parting_of(const ToldRun& run, const StepsChecked& checked);

}  // namespace study
