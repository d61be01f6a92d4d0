/// Traces, read back: what `gjkstep trace` wrote, checked, as a walkthrough that need not be run again.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "walkthroughs/model/walkthrough.hpp"
#include "walkthroughs/text/text_file.hpp"
#include "walkthroughs/trace/trace_limits.hpp"

namespace walkthroughs::trace {

/// What storyboard.hpp's tell() needs to draw the frames that the writer of the trace would have drawn.
struct TraceFile {
  Walkthrough walkthrough;
  std::vector<Trace> traces;  ///< one for each scene
};

/// Complains about the first line that is wrong, or of a trace that contradicts itself.
Reading<TraceFile> trace_in(std::string_view text);

/// Returns: trace_in(). Errors: InputError, in which the name stands.
inline TraceFile parse_trace(std::string_view text, const std::string& file_name) {
  return accepted(trace_in(text), file_name);
}

/// Errors: InputError, about the first line that is wrong, or of a trace that contradicts itself. Reads regular files of at
/// most trace_limits::bytes.
inline TraceFile read_trace(const std::filesystem::path& file) {
  return parse_trace(read_text(file, trace_limits::bytes), file.string());
}

}  // namespace walkthroughs::trace
