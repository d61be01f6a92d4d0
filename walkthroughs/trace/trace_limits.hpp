/// How much a trace may hold.
#pragma once

#include <cstddef>

#include "walkthroughs/model/event_fields.hpp"
#include "walkthroughs/text/scene_limits.hpp"

namespace walkthroughs::trace {

/// Beside these, scene_limits hold for objects, and document_limits for each line.
namespace trace_limits {
inline constexpr std::size_t bytes = 64 << 20;
inline constexpr std::size_t words = 1000;  ///< characters of a sentence
inline constexpr std::size_t remarks = 100;
inline constexpr int power = 20'000;               ///< of two, that a number is told with
inline constexpr std::size_t corners = 26;         ///< of a hull whose corners have letters
inline constexpr std::size_t differences = 10000;  ///< of vertices, where corners have letters
}  // namespace trace_limits

struct WholeNumbers {
  int least, most;
};

/// Returns: what a whole number of that meaning may be.
constexpr WholeNumbers range_of(Meaning meaning) {
  switch (meaning) {
    case Meaning::simplex_size: return {1, 4};
    case Meaning::sign: return {-1, 1};
    case Meaning::power: return {-trace_limits::power, trace_limits::power};
    case Meaning::position: return {0, static_cast<int>(scene_limits::points) - 1};
    case Meaning::limit: return {1, scene_limits::iterations};
    default: return {0, scene_limits::iterations};
  }
}

}  // namespace walkthroughs::trace
