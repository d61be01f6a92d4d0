/// The steps of a search that the report's algorithm would not make: wrong ones, and those that are as right.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "walkthroughs/steps/told_run.hpp"

namespace walkthroughs::steps {

struct StepFinding {
  enum Kind {
    wrong,
    rounding,  ///< the report does the same once the vertices are moved by a few roundings; or products vanish or overflow
    otherwise  ///< right, too
  };

  int iteration;  ///< from 1
  Kind kind;
  std::string words;                       ///< what is wrong with it, or otherwise
  std::vector<std::size_t> mistakes = {};  ///< positions in mistakes() of those that would make it
  bool keeps_direction = false;            ///< whether the direction after it is that before it, and ought not to be
};

/// In the order of iterations.
using StepFindings = std::vector<StepFinding>;

struct CheckedSteps {
  StepFindings findings;
  /// Positions in mistakes() of those that the search does not make: they would keep a wrong simplex where it keeps a right one.
  std::set<std::size_t> mistakes_not_made;
};

/// Returns: the first that is wrong, or else that may be; null where there is none.
const StepFinding* first_wrong(const StepFindings& findings);

/// Each step is made again from the simplex before it, as the program told it, in doubles and in fractions; so what comes after a
/// wrong one is looked at, too. Right are all that the report's rules make of that simplex in any order of its vertices that leaves
/// normals outward: another face that sees the origin, too, is another correct choice, and so are the feature nearest to the origin
/// and directions of other length. Of the direction behind a wrong simplex nothing is said: the report has none.
CheckedSteps check_steps(const ToldRun& run);

}  // namespace walkthroughs::steps
