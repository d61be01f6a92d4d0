#include "tests/study/pairs/families.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string_view>

#include "tests/study/pairs/families_recipes.hpp"

namespace study {
namespace {

std::vector<Family> all_families() {
  std::vector<Family> all;
  for (const auto& part :
       {random_families(), touching_families(), extreme_families(), listed_families(), round_families()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// How many letters must be added, left out or changed (Levenshtein).
std::size_t distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= from.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t changed = diagonal + (from[i - 1] == to[j - 1] ? 0 : 1);
      diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, changed}));
    }
  }
  return row.back();
}

}  // namespace

Family thrown(std::string name, std::string what, std::function<Pair(Dice&)> recipe) {
  auto make = [name, recipe = std::move(recipe)](std::uint64_t seed, std::uint64_t index) {
    Dice dice(seed, name, index);
    return recipe(dice);
  };
  return {std::move(name), std::move(what), {}, std::move(make)};
}

const std::vector<Family>& families() {
  static const std::vector<Family> all = all_families();
  return all;
}

const Family& family_named(const std::string& name) {
  const auto& all = families();
  const auto found = std::ranges::find(all, name, &Family::name);
  if (found != all.end()) return *found;
  const auto meant = std::ranges::min_element(all, {}, [&](const Family& f) { return distance(name, f.name); });
  throw std::invalid_argument("there is no family '" + name + "'; did you mean '" + meant->name + "'?");
}

}  // namespace study
