#include <algorithm>
#include <numeric>

#include "walkthroughs/walkthrough.hpp"

namespace walkthroughs {
namespace {

/// Levenshtein (1966): the least number of letters to insert, delete or replace.
std::size_t edit_distance(std::string_view from, std::string_view to) {
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

}  // namespace

const std::vector<Walkthrough>& catalogue() {
  static const std::vector<Walkthrough> all = {figure_4_left(), figure_4_right(), figure_4_right_no_crossing_test(),
                                               figure_5()};
  return all;
}

const Walkthrough* find_walkthrough(std::string_view name) {
  const auto& all = catalogue();
  const auto found = std::ranges::find(all, name, &Walkthrough::name);
  return found == all.end() ? nullptr : &*found;
}

std::string_view nearest_name(std::string_view name) {
  return std::ranges::min_element(catalogue(), {}, [&](const Walkthrough& w) { return edit_distance(name, w.name); })
      ->name;
}

}  // namespace walkthroughs
