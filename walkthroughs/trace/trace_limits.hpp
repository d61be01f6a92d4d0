/// How much a trace may hold.
#pragma once

#include <cstddef>
#include <string_view>

namespace walkthroughs {

/// Beside these, scene_limits hold for objects, and document_limits for each line.
namespace trace_limits {
inline constexpr std::size_t bytes = 64 << 20;
inline constexpr std::size_t words = 1000;  ///< characters of a sentence
inline constexpr std::size_t remarks = 100;
inline constexpr int power = 20'000;               ///< of two, that a number is told with
inline constexpr std::size_t corners = 26;         ///< of a hull whose corners have letters
inline constexpr std::size_t differences = 10000;  ///< of vertices, where corners have letters
}  // namespace trace_limits

}  // namespace walkthroughs
