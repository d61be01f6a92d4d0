/// Where one practises a decision that one has got wrong.
#pragma once

#include <string>

#include "walkthroughs/page/questions.hpp"

namespace walkthroughs {

/// Returns: the name of a walkthrough of regions, but not `but`, whose search comes to decide so, best one that is about that; else
/// about the same face or feature. Of a mistake that of the case which it gets wrong. Empty where there is none.
std::string practice_for(const Decision& decision, const std::string& but);

}  // namespace walkthroughs
