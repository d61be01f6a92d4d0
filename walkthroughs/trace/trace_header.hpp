/// The first line of a trace, read back: what the rest is, and the scenes in full.
#pragma once

#include "walkthroughs/model/walkthrough.hpp"
#include "walkthroughs/text/document.hpp"

namespace walkthroughs {

/// Returns: the walkthrough, its remarks among the rest; nothing in it computes. Where it is none it is complained about.
Walkthrough read_header(const Value& root);

}  // namespace walkthroughs
