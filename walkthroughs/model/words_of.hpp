/// The words that scene files and traces use for enumerators: of(verdict, v) says v, and a word's position
/// is its enumerator.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "core/result.hpp"
#include "core/rule_sets.hpp"

namespace walkthroughs::words_of {

/// Returns: the words of a table of the core.
template <class E, std::size_t count>
constexpr std::array<std::string_view, count> names_in(const std::array<gjk::Named<E>, count>& table) {
  std::array<std::string_view, count> names;
  for (std::size_t i = 0; i < count; ++i) names[i] = table[i].name;
  return names;
}

inline constexpr std::array<std::string_view, 2> crossing_test{"on", "off"};
inline constexpr auto rules = names_in(gjk::rule_sets);
inline constexpr auto zero_test = names_in(gjk::zero_tests);
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
inline constexpr std::array status{gjk::to_string(gjk::Status::intersecting), gjk::to_string(gjk::Status::separated),
                                   gjk::to_string(gjk::Status::undecided)};
inline constexpr std::array reason{
    gjk::to_string(gjk::Reason::simplex_contains_origin), gjk::to_string(gjk::Reason::origin_not_crossed),
    gjk::to_string(gjk::Reason::no_new_vertex), gjk::to_string(gjk::Reason::iteration_limit),
    gjk::to_string(gjk::Reason::unusable_direction)};
inline constexpr std::array<std::string_view, 8> event{"search-started",   "support-found", "crossing-tested",
                                                       "vertex-added",     "region-tested", "simplex-reduced",
                                                       "direction-chosen", "finished"};

/// Returns: the word for an enumerator.
template <std::size_t count, class E>
constexpr std::string_view of(const std::array<std::string_view, count>& words, E enumerator) {
  return words[static_cast<std::size_t>(enumerator)];
}

}  // namespace walkthroughs::words_of
