/// The first step of a search that the report's algorithm would not make.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tests/study/steps/told_run.hpp"

namespace study {

struct StepsChecked {
  int iteration = 0;                       ///< of the first such step, from 1; 0 where there is none
  std::string words;                       ///< what is wrong with it
  std::vector<std::size_t> mistakes;       ///< positions in mistakes() of those that would make it
  bool may_be_rounding = false;            ///< then none is named; or products vanish or overflow
  std::vector<std::string> other_choices;  ///< steps that the report makes otherwise, and that are right as well
};

/// Each step is made again from the simplex before it, as the program told it, in doubles and in fractions. Right are all that the
/// report's rules make of that simplex in any order of its vertices that leaves normals outward: another face that sees the origin,
/// too, is another correct choice, and so are the feature nearest to the origin and directions of other length. Where
/// the report chooses the same wrong region once the vertices are moved by a few roundings, the words say so.
StepsChecked check_steps(const ToldRun& run);

}  // namespace study
