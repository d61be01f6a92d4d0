/// Traces, read back: what `gjkstep trace` wrote, checked, as a walkthrough that need not be run again.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "walkthroughs/text/text_file.hpp"
#include "walkthroughs/model/walkthrough.hpp"

namespace walkthroughs {

/// A trace cannot be read, or contradicts itself. what(): "FILE:LINE: KEY: reason; what to do", or without KEY.
struct TraceError : InputError {
  using InputError::InputError;
};

/// What storyboard.hpp's tell() needs to draw the frames that the writer of the trace would have drawn.
struct TraceFile {
  Walkthrough walkthrough;
  std::vector<Trace> traces;  ///< one for each scene
};

/// Beside these, scene_limits hold for objects, and document_limits for each line.
namespace trace_limits {
inline constexpr std::size_t bytes = 64 << 20;
inline constexpr std::size_t name = 200, words = 1000;  ///< characters: of a walkthrough, of a sentence
inline constexpr std::size_t remarks = 100;
inline constexpr std::size_t corners = 26;         ///< of a hull whose corners have letters
inline constexpr std::size_t differences = 10000;  ///< of vertices, where corners have letters
}  // namespace trace_limits

/// Errors: TraceError, about the first line that is wrong. Reads regular files of at most trace_limits::bytes.
TraceFile read_trace(const std::filesystem::path& file);

/// `file_name`: stands in errors; nothing is read from there. Errors: TraceError.
TraceFile parse_trace(std::string_view text, const std::string& file_name);

}  // namespace walkthroughs
