/// Files of traces. trace_text.hpp says how they are read.
#pragma once

#include "walkthroughs/text/text_file.hpp"
#include "walkthroughs/trace/trace_limits.hpp"
#include "walkthroughs/trace/trace_text.hpp"

namespace walkthroughs::trace {

/// Returns: trace_in(). Errors: InputError, in which the name stands.
inline TraceFile parse_trace(std::string_view text, const std::string& file_name) {
  return accepted(trace_in(text), file_name);
}

/// Errors: InputError, about the first line that is wrong, or of a trace that contradicts itself. Reads regular files of at
/// most trace_limits::bytes.
inline TraceFile read_trace(const std::filesystem::path& file) {
  return parse_trace(read_text(file, trace_limits::bytes), called(file));
}

}  // namespace walkthroughs::trace
