/// What a program has answered about a pair, and whether its evidence proves that.
///
///     {"status":"separated"}     or "intersecting", true, "undecided"; as in `gjkstep query`, which may say more
///     true                       alone: they intersect; false: they do not; "undecided"
///
/// Evidence is looked for beside "status" and in "evidence" and "certificate", and multiplied out in fractions: a "direction" d
/// with a·d < b·d, or "nearest", as gjkstep query --certified has it; a "point" of both; a "simplex" of index pairs [i, j], or
/// of objects with "a_index" and "b_index", whose a[i] - b[j] have the origin in their hull. Numbers are numbers or "p/q".
#pragma once

#include <string>
#include <string_view>

#include "tests/study/pairs/pair.hpp"

namespace study {

enum class Said { intersecting, separated, undecided, nothing };  ///< nothing: the line is no answer
enum class Evidence { none, holds, proves_nothing };

struct ProgramAnswer {
  Said said = Said::nothing;
  Evidence evidence = Evidence::none;  ///< whether it proves what was said
  std::string why;                     ///< why the line is no answer
};

/// Whatever the line holds. `pair`: that it is about.
ProgramAnswer read_answer(std::string_view line, const Pair& pair);

}  // namespace study
