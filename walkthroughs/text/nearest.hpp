/// Suggestions for words that nobody knows.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "walkthroughs/rooms.hpp"

namespace walkthroughs::text {

/// Levenshtein (1966): the least number of letters to insert, delete or replace.
inline std::size_t edit_distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t replaced = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j + 1] + 1, row[j] + 1});
    }
  }
  return row.back();
}

/// Returns: a candidate that begins with `word`, else the one that takes the fewest letters to reach from it (Levenshtein
/// distance); the first of several. Of longer words the first 64 letters count: comparing takes time for each.
/// Requires: at least one candidate.
inline std::string nearest(std::string_view word, std::span<const std::string> candidates) {
  word = word.substr(0, 64);
  const auto begun = std::ranges::find_if(candidates, [&](const std::string& each) { return each.starts_with(word); });
  if (begun != candidates.end()) return *begun;
  return *std::ranges::min_element(candidates, {}, [&](const std::string& each) { return edit_distance(word, each); });
}

}  // namespace walkthroughs::text
