/// The sets of rules and the zero tests by name, for callers who learn only at run time which of them is wanted. A
/// further set of rules is
///  - a type in rules.hpp (or a header of its own),
///  - an enumerator and a row here,
///  - a line in with_rules().
#pragma once

#include <array>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "complete.hpp"

namespace gjk {

enum class RuleSet { as_intended, as_printed, eager, complete };

enum class ZeroTestKind { exact, relative };

/// An enumerator, its word in files and on command lines, and what it stands for.
template <class E>
struct Named {
  E value;
  std::string_view name, meaning;
};

/// In the order of the enumerators.
inline constexpr std::array<Named<RuleSet>, 4> rule_sets{
    {{RuleSet::as_intended, "as-intended", "the report's rules as its text means them"},
     {RuleSet::as_printed, "as-printed", "Algorithm 1 read literally"},
     {RuleSet::eager, "eager", "w·d < 0 ends the search at the first point, too"},
     {RuleSet::complete, "complete", "every region that can hold the nearest point is tested"}}};

inline constexpr std::array<Named<ZeroTestKind>, 2> zero_tests{
    {{ZeroTestKind::exact, "exact", "a product counts as it was computed"},
     {ZeroTestKind::relative, "relative", "a product counts as zero within its rounding"}}};

constexpr std::string_view to_string(RuleSet rules) { return rule_sets[static_cast<std::size_t>(rules)].name; }
constexpr std::string_view to_string(ZeroTestKind test) { return zero_tests[static_cast<std::size_t>(test)].name; }

/// Calls use.template operator()<Rules>(), such as [&]<class Rules>() { ... }, with the rules of that name.
///
/// Returns: what it returns. The type must be the same for all rules.
/// Errors: std::invalid_argument for what is no enumerator. What `use` throws passes through.
template <class ZeroTest, class Use>
decltype(auto) with_rules(RuleSet rules, Use&& use) {
  switch (rules) {
    case RuleSet::as_intended: return use.template operator()<Intended<ZeroTest>>();
    case RuleSet::as_printed: return use.template operator()<Printed<ZeroTest>>();
    case RuleSet::eager: return use.template operator()<Eager<ZeroTest>>();
    case RuleSet::complete: return use.template operator()<Complete<ZeroTest>>();
  }
  throw std::invalid_argument("there is no such set of rules");
}

template <class Use>
decltype(auto) with_rules(RuleSet rules, ZeroTestKind test, Use&& use) {
  switch (test) {
    case ZeroTestKind::exact: return with_rules<ExactZeroTest>(rules, std::forward<Use>(use));
    case ZeroTestKind::relative: return with_rules<RelativeZeroTest>(rules, std::forward<Use>(use));
  }
  throw std::invalid_argument("there is no such zero test");
}

/// Returns: what Algorithm 1 does with these rules; no zero test changes it.
inline FirstPoint first_point(RuleSet rules) {
  return with_rules<ExactZeroTest>(rules, []<class Rules>() { return Rules::first_point(); });
}
inline NotCrossed not_crossed(RuleSet rules) {
  return with_rules<ExactZeroTest>(rules, []<class Rules>() { return Rules::not_crossed(); });
}

}  // namespace gjk
