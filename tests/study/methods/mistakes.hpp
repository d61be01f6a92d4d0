/// The mistakes that the report's steps may hold, under the study's own names.
#pragma once

#include "walkthroughs/steps/mistakes.hpp"

namespace study {

using walkthroughs::steps::ask_faithfully;
using walkthroughs::steps::Mistake;
using walkthroughs::steps::mistakes;
using walkthroughs::steps::Processed;
using walkthroughs::steps::Run;
using walkthroughs::steps::usual_first_direction;

}  // namespace study
