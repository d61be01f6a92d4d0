/// The words that scene files and traces use for enumerators: of(verdict, v) says v, and a word's position
/// is its enumerator.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace walkthroughs::words_of {

inline constexpr std::array<std::string_view, 2> crossing_test{"on", "off"};
inline constexpr std::array<std::string_view, 2> rules{"as-intended", "as-printed"};
inline constexpr std::array<std::string_view, 2> zero_test{"exact", "relative"};
inline constexpr std::array<std::string_view, 2> scalar{"double", "float"};
inline constexpr std::array<std::string_view, 3> panels{"objects", "hull", "algorithm"};
inline constexpr std::array<std::string_view, 4> layout{"search", "close-ups", "in-step", "until-they-part"};
inline constexpr std::array<std::string_view, 2> naming{"corners", "roles"};
inline constexpr std::array<std::string_view, 6> remark_at{"support-found", "crossing-tested",  "region-tested",
                                                           "reduced",       "direction-chosen", "end"};
inline constexpr std::array<std::string_view, 4> crossing{"crossed", "not-crossed", "not-applied-first-point",
                                                          "not-applied-switched-off"};
inline constexpr std::array<std::string_view, 4> relation{"> 0", "< 0", "= 0", "!= 0"};
inline constexpr std::array<std::string_view, 3> verdict{"chosen", "rejected", "skipped"};
inline constexpr std::array<std::string_view, 3> status{"intersecting", "separated", "undecided"};
inline constexpr std::array<std::string_view, 5> reason{"simplex-contains-origin", "origin-not-crossed",
                                                        "no-new-vertex", "iteration-limit", "unusable-direction"};
inline constexpr std::array<std::string_view, 8> event{"search-started",   "support-found", "crossing-tested",
                                                       "vertex-added",     "region-tested", "simplex-reduced",
                                                       "direction-chosen", "finished"};

/// Returns: the word for an enumerator.
template <std::size_t count, class E>
constexpr std::string_view of(const std::array<std::string_view, count>& words, E enumerator) {
  return words[static_cast<std::size_t>(enumerator)];
}

}  // namespace walkthroughs::words_of
