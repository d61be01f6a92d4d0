#include "walkthroughs/pairs/families.hpp"

#include <algorithm>
#include <stdexcept>

#include "walkthroughs/pairs/families_recipes.hpp"
#include "walkthroughs/text/names.hpp"

namespace walkthroughs::pairs {
namespace {

std::vector<Family> all_families() {
  std::vector<Family> all;
  for (const auto& part :
       {random_families(), touching_families(), extreme_families(), listed_families(), round_families()})
    all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace

const std::vector<Family>& families() {
  static const std::vector<Family> all = all_families();
  return all;
}

const Family& family_named(const std::string& name) {
  const auto& all = families();
  const auto found = std::ranges::find(all, name, &Family::name);
  if (found != all.end()) return *found;
  std::vector<std::string> names;
  for (const Family& family : all) names.push_back(family.name);
  throw std::invalid_argument("there is no family '" + name + "'; did you mean '" + nearest(name, names) + "'?");
}

}  // namespace walkthroughs::pairs
