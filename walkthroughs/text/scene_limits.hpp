/// How large a scene may be, in files, queries and traces.
#pragma once

#include <cstddef>

#include "walkthroughs/rooms.hpp"

namespace walkthroughs::text::scene_limits {

inline constexpr std::size_t bytes = 16 << 20;
inline constexpr std::size_t points = 100000;         ///< of one list
inline constexpr int sums = 4;                        ///< in one another
inline constexpr std::size_t title = 120, name = 40;  ///< characters
inline constexpr std::size_t walkthrough = 200;       ///< characters of its name, and bytes
inline constexpr int iterations = 1000;
inline constexpr double magnitude = 1e150;

}  // namespace walkthroughs::text::scene_limits
