/// Why may a program be wrong? Each probable cause rests on numbers: what it predicts is held against what the program said, or the
/// program is asked again after a change.
#pragma once

#include <string>
#include <vector>

#include "walkthroughs/judge/judge.hpp"

namespace walkthroughs::judge {

struct Cause {
  std::string name;          ///< "contact is taken for a miss"
  std::string evidence;      ///< with numbers
  double agreement = 0;      ///< from 0 to 1: how much of what is wrong it explains, and nothing else
  std::string mistake = {};  ///< the word of one of wrong_on_purpose::all(), where it is one
  std::string option = {};   ///< of the command line, with which it does not count
  /// Rounding is what is left where nothing else is clearly wrong; a symptom is what comes of any broken search.
  enum Rank { reason, rounding, symptom } rank = reason;
};

/// Below it a cause is not named.
inline constexpr double enough_agreement = 0.8;

/// Returns: the most probable first; none where nothing agrees so much. Errors: those of run_program().
std::vector<Cause> probable_causes(const AskedProgram& program, const Judgement& judgement, const Standard& standard);

}  // namespace walkthroughs::judge
