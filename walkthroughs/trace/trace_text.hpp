/// Traces, read back: what `gjkstep trace` wrote, checked, as a walkthrough that need not be run again.
#pragma once

#include <string_view>
#include <vector>

#include "walkthroughs/model/walkthrough.hpp"
#include "walkthroughs/text/document.hpp"

namespace walkthroughs::trace {

/// What storyboard.hpp's tell() needs to draw the frames that the writer of the trace would have drawn.
struct TraceFile {
  Walkthrough walkthrough;
  std::vector<Trace> traces;  ///< one for each scene
};

/// Complains about the first line that is wrong, or of a trace that contradicts itself.
Reading<TraceFile> trace_in(std::string_view text);

}  // namespace walkthroughs::trace
