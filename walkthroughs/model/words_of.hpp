/// The words that scene files and traces use for enumerators: of(v) says v, and a word's position in all(v) is its
/// enumerator.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "walkthroughs/model/walkthrough.hpp"

namespace walkthroughs::model::words_of {

template <std::size_t count>
using Words = std::array<std::string_view, count>;

/// Returns: the words that to_string() has for the first `count` enumerators.
template <class E, std::size_t count>
constexpr Words<count> as_core_says() {
  Words<count> words;
  for (std::size_t i = 0; i < count; ++i) words[i] = to_string(static_cast<E>(i));
  return words;
}

inline constexpr Words<2> crossing_test{"on", "off"};
inline constexpr auto rules = as_core_says<gjk::RuleSet, gjk::rule_sets.size()>();
inline constexpr auto zero_test = as_core_says<gjk::ZeroTestKind, gjk::zero_tests.size()>();
inline constexpr Words<2> letters{"roles", "fixed"};

// All words of a type, for readers and writers of fields of any type.
constexpr auto all(gjk::Crossing) {
  return Words<4>{"crossed", "not-crossed", "not-applied-first-point", "not-applied-switched-off"};
}
constexpr auto all(gjk::Relation) { return Words<5>{"> 0", "< 0", "= 0", "!= 0", ">= 0"}; }
constexpr auto all(gjk::Verdict) { return Words<4>{"chosen", "rejected", "skipped", "possible"}; }
constexpr auto all(gjk::Status) { return as_core_says<gjk::Status, 3>(); }
constexpr auto all(gjk::Reason) { return as_core_says<gjk::Reason, 6>(); }
constexpr auto all(gjk::Proof) { return as_core_says<gjk::Proof, 3>(); }
constexpr auto all(gjk::CrossingTest) { return crossing_test; }
constexpr auto all(RuleSet) { return rules; }
constexpr auto all(ZeroTest) { return zero_test; }
constexpr auto all(Scalar) { return Words<2>{"double", "float"}; }
constexpr auto all(Layout) { return Words<4>{"search", "close-ups", "in-step", "until-they-part"}; }
constexpr auto all(Naming) { return Words<3>{"corners", "roles", "fixed"}; }
constexpr auto all(Remark::At) {
  return Words<6>{"support-found", "crossing-tested", "region-tested", "reduced", "direction-chosen", "end"};
}
inline std::vector<std::string_view> all(Mistake) {
  std::vector<std::string_view> words;
  for (const wrong_on_purpose::Description& each : wrong_on_purpose::all()) words.push_back(each.word);
  return words;
}

/// Returns: the word for an enumerator.
template <class E>
constexpr std::string_view of(E enumerator) {
  return all(enumerator)[static_cast<std::size_t>(enumerator)];
}

inline constexpr Words<5> panels{"objects", "hull", "algorithm", "decision", "close-up"};
inline constexpr std::array panel_members{&Panels::objects, &Panels::hull, &Panels::algorithm, &Panels::decision,
                                          &Panels::close_up};
static_assert(sizeof(Panels) == panels.size() && panel_members.size() == panels.size(), "a word for each panel");

/// Returns: the words for the panels that are shown.
inline std::vector<std::string_view> of(const Panels& shown) {
  std::vector<std::string_view> words;
  for (std::size_t i = 0; i < panels.size(); ++i)
    if (shown.*panel_members[i]) words.push_back(panels[i]);
  return words;
}

}  // namespace walkthroughs::model::words_of
