/// What a program has answered about a pair, and whether its evidence proves that.
///
///     yes          they have a point in common; also true, or 'intersecting'
///     no           they are apart; also false, or 'separated'
///     undecided
///     distance 2   that they are apart by; of 0 they intersect
///     {"status":"separated"}   or another of these words, or {"distance":2}, or both; as `gjkstep query`, which says more
///
/// Any other line is no answer. Capitals and quotes do not matter.
///
/// Evidence is looked for beside "status" and in "evidence" and "certificate", and multiplied out in fractions: a "direction" d
/// with a·d < b·d, or "nearest", as gjkstep query --certified has it; a "simplex" of index pairs [i, j], or of objects with "a_index"
/// and "b_index", whose a[i] - b[j] have the origin in their hull. Numbers are numbers or "p/q".
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "walkthroughs/pairs/pair.hpp"

namespace walkthroughs::judge {

enum class Said { intersecting, separated, undecided, not_a_number, nothing };  ///< nothing: the line is no answer
enum class Evidence { none, holds, proves_nothing };

struct ProgramAnswer {
  Said said = Said::nothing;
  Evidence evidence = Evidence::none;   ///< whether it proves what was said
  std::optional<double> distance = {};  ///< finite
  std::string why = {};                 ///< why a line of JSON is no answer
};

/// Returns: whether the line is meant as an answer: what else a program prints is not counted.
bool is_meant_as_answer(std::string_view line);

/// Whatever the line holds. `pair`: that it is about.
ProgramAnswer read_answer(std::string_view line, const Pair& pair);

}  // namespace walkthroughs::judge
