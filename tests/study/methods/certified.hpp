/// Answers that are proven (core/certified.hpp), as the study names them. No rules and no iteration limit of the search that
/// begins can change what is answered: so there is one setting, which has no limit.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/rule_sets.hpp"

namespace study {

/// The name that stands in place of rules, and the rules of the search that begins.
struct CertifiedRules {
  std::string_view name;
  gjk::RuleSet first_search;
};
inline constexpr CertifiedRules certified_rules[] = {{"certified", gjk::RuleSet::as_intended},
                                                     {"certified-eager", gjk::RuleSet::eager}};

/// Returns: the rules of the search that begins; empty for rules that are not certified.
constexpr std::optional<gjk::RuleSet> first_search_of(std::string_view rules) {
  for (const CertifiedRules& each : certified_rules)
    if (each.name == rules) return each.first_search;
  return std::nullopt;
}

constexpr bool is_certified(std::string_view rules) { return first_search_of(rules).has_value(); }

inline constexpr int no_limit = std::numeric_limits<int>::max();

/// Returns: the limit that rules have where a table is about `limit`.
constexpr int limit_for(std::string_view rules, int limit) { return is_certified(rules) ? no_limit : limit; }

/// Returns: those of the limits that these rules are asked with.
inline std::vector<int> limits_for(std::string_view rules, const std::vector<int>& limits) {
  return is_certified(rules) ? std::vector{no_limit} : limits;
}

/// Returns: "20", "none".
inline std::string limit_word(int limit) { return limit == no_limit ? "none" : std::to_string(limit); }

}  // namespace study
