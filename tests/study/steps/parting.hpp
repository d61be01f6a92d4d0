/// A search with a mistake beside the report's own, until they part.
#pragma once

#include <optional>
#include <vector>

#include "tests/study/steps/check_steps.hpp"
#include "walkthroughs/model/walkthrough.hpp"
#include "walkthroughs/story/story.hpp"

namespace study {

/// A walkthrough of two scenes, and their traces.
struct Parting {
  walkthroughs::Walkthrough walkthrough;
  std::vector<walkthroughs::Trace> traces;
  int iteration;  ///< in which it goes wrong

  /// Returns: frames until then and one iteration on. Refers to this, which must outlive it.
  walkthroughs::Story story() const;
};

/// Returns: the first of the mistakes that were found, on the same pair and begun in the same direction, beside the report's
/// algorithm; nothing where none of them goes wrong in that very step, with those vertices, as where the program has made other
/// choices before.
std::optional<Parting> parting_of(const ToldRun& run, const StepsChecked& checked);

}  // namespace study
