/// Whether a claim of the report holds, found from what was counted.
#pragma once

#include <string>
#include <vector>

#include "tests/study/sweep/rate.hpp"

namespace study {

/// How strong the report's words are.
enum class Strength {
  always,         ///< "never", "at most", "cannot": one exception refutes it, and few cases without one prove nothing
  nearly_always,  ///< "almost always", "rarely": in 99 % at least
  usually,        ///< "usually", "generally": in more than half
  all_but_few,    ///< "for all but 2" of a million: 2 may be 7 as well, so that at most 10 of a million are allowed
};

/// Where the cases come from: thrown at random, so that their share has an interval, or all that there are.
enum class Cases { thrown, all };

/// How often a claim was true where it could be looked at: for one shape.
struct Measured {
  std::string where;  ///< "boxes"
  Rate holds;
  std::string group = {};  ///< "random shapes": named in place of its members where all of them go one way
  Cases cases = Cases::thrown;

  Interval interval() const;
};

struct Claim {
  std::string words, section;  ///< the report's
  std::string counted;         ///< what is counted as true
  Strength strength;
  std::vector<Measured> measured;  ///< the report's own shape, or the first one, in front
};

/// How a claim stands at one place.
enum class Standing {
  holds,
  nearly_holds,  ///< an *always* that exceptions refute, which are fewer than 1 % all the same
  fails,
  open,  ///< the interval has both
};

Standing standing(Strength strength, const Measured& measured);

/// Returns: "holds", "does not hold"; "mostly holds, but not for spheres" or "mostly fails, but holds for boxes" with the
/// shorter list; "holds for boxes, not for spheres". Behind it come rare exceptions, and what is left open.
std::string verdict(const Claim& claim);

/// Returns: the place where the claim is true least often. Requires: something was measured.
const Measured& worst(const Claim& claim);

// -- Words and numbers ------------------------------------------------------------------------------------------------

std::string grouped(std::uint64_t number);            ///< 1,234,567
std::string share_text(double share);                 ///< 12.3 %, 99.983 %, or 1.7 per million
std::string rate_text(const Rate& rate);              ///< with its interval
std::string text_of(const Measured& measured);        ///< "boxes: 12.3 % (10.4–14.5)", "cycles: 0 % of all 1,296"
std::string joined(const std::vector<std::string>&);  ///< "a, b and c"

}  // namespace study
