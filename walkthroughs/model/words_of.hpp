/// The words that scene files and traces use for enumerators: of(verdict, v) says v, and a word's position
/// is its enumerator.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "walkthroughs/model/walkthrough.hpp"

namespace walkthroughs::words_of {

/// Returns: the words that to_string() has for the first `count` enumerators.
template <class E, std::size_t count>
constexpr std::array<std::string_view, count> as_core_says() {
  std::array<std::string_view, count> words;
  for (std::size_t i = 0; i < count; ++i) words[i] = to_string(static_cast<E>(i));
  return words;
}

inline constexpr std::array<std::string_view, 2> crossing_test{"on", "off"};
inline constexpr auto rules = as_core_says<gjk::RuleSet, gjk::rule_sets.size()>();
inline constexpr auto zero_test = as_core_says<gjk::ZeroTestKind, gjk::zero_tests.size()>();
inline constexpr std::array<std::string_view, 2> scalar{"double", "float"};
inline constexpr std::array<std::string_view, 5> panels{"objects", "hull", "algorithm", "decision", "close-up"};
inline constexpr std::array<std::string_view, 4> layout{"search", "close-ups", "in-step", "until-they-part"};
inline constexpr std::array<std::string_view, 3> naming{"corners", "roles", "fixed"};
inline constexpr std::array<std::string_view, 2> letters{"roles", "fixed"};
inline constexpr std::array<std::string_view, 6> remark_at{"support-found", "crossing-tested",  "region-tested",
                                                           "reduced",       "direction-chosen", "end"};
inline constexpr std::array<std::string_view, 4> crossing{"crossed", "not-crossed", "not-applied-first-point",
                                                          "not-applied-switched-off"};
inline constexpr std::array<std::string_view, 5> relation{"> 0", "< 0", "= 0", "!= 0", ">= 0"};
inline constexpr std::array<std::string_view, 4> verdict{"chosen", "rejected", "skipped", "possible"};
inline constexpr auto status = as_core_says<gjk::Status, 3>();
inline constexpr auto reason = as_core_says<gjk::Reason, 6>();
inline constexpr auto proof = as_core_says<gjk::Proof, 3>();

// All words of a type, for readers and writers of fields of any type.
constexpr const auto& all(gjk::Crossing) { return crossing; }
constexpr const auto& all(gjk::Relation) { return relation; }
constexpr const auto& all(gjk::Verdict) { return verdict; }
constexpr const auto& all(gjk::Status) { return status; }
constexpr const auto& all(gjk::Reason) { return reason; }
constexpr const auto& all(gjk::Proof) { return proof; }
constexpr const auto& all(gjk::CrossingTest) { return crossing_test; }
constexpr const auto& all(RuleSet) { return rules; }
constexpr const auto& all(ZeroTest) { return zero_test; }
constexpr const auto& all(Scalar) { return scalar; }
constexpr const auto& all(Layout) { return layout; }
constexpr const auto& all(Naming) { return naming; }
constexpr const auto& all(Remark::At) { return remark_at; }
inline std::vector<std::string_view> all(Mistake) {
  std::vector<std::string_view> words;
  for (const wrong_on_purpose::Description& each : wrong_on_purpose::all()) words.push_back(each.word);
  return words;
}

/// Returns: the word for an enumerator.
template <std::size_t count, class E>
constexpr std::string_view of(const std::array<std::string_view, count>& words, E enumerator) {
  return words[static_cast<std::size_t>(enumerator)];
}

/// Returns: the word for an enumerator of an event.
template <class E>
constexpr std::string_view of(E enumerator) {
  return all(enumerator)[static_cast<std::size_t>(enumerator)];
}

}  // namespace walkthroughs::words_of
