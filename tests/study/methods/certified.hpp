/// Answers that are proven (core/certified/certified.hpp), as the study names them. No rules and no iteration limit of the search that
/// begins can change what is answered: so there is one setting, which has no limit.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace study {

constexpr bool is_certified(std::string_view rules) { return rules.starts_with("certified"); }

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
