/// The mistakes that the judge knows, under the study's own names.
#pragma once

#include "walkthroughs/judge/mistakes.hpp"

namespace study {

using walkthroughs::judge::ask_faithfully;
using walkthroughs::judge::Mistake;
using walkthroughs::judge::mistakes;
using walkthroughs::judge::Processed;
using walkthroughs::judge::Run;
using walkthroughs::judge::usual_first_direction;

}  // namespace study
