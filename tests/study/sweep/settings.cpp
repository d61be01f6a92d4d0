#include "tests/study/sweep/settings.hpp"

#include <algorithm>

namespace study {
namespace {

/// Adds `name` unless it is there: names in the order in which they first appear.
void note(std::vector<std::string>& names, const std::string& name) {
  if (std::ranges::find(names, name) == names.end()) names.push_back(name);
}

template <class T>
bool has(const std::vector<T>& list, const T& wanted) {
  return std::ranges::find(list, wanted) != list.end();
}

std::string preferred(const std::vector<std::string>& names, const std::string& wanted) {
  return has(names, wanted) || names.empty() ? wanted : names.front();
}

}  // namespace

Settings::Settings(const Study& study) : study_(study) {
  for (const Row& row : study.rows) {
    note(rules_, row.rules);
    note(scalars_, row.scalar);
    note(zero_tests_, row.zero_test);
  }
  const std::vector<int>& all = limits();
  const int limit = has(all, 20) || all.empty() ? 20 : all.back();
  usual_ = {preferred(rules_, "as-intended"), preferred(scalars_, "double"), preferred(zero_tests_, "exact"), limit};
  usual_.limit = limit_for(usual_.rules, limit);
}

std::vector<std::pair<std::string, Setting>> Settings::certified() const {
  std::vector<std::pair<std::string, Setting>> all;
  for (const std::string& rules : rules_)
    for (const std::string& scalar : scalars_)
      if (is_certified(rules) &&
          std::ranges::any_of(study_.rows, [&](const Row& row) { return row.rules == rules && row.scalar == scalar; }))
        all.push_back({rules + " " + scalar, {rules, scalar, "exact", no_limit}});
  return all;
}

std::vector<std::pair<std::string, Setting>> Settings::scalars_and_certified() const {
  std::vector<std::pair<std::string, Setting>> all;
  if (!is_certified(usual_.rules))
    for (const std::string& scalar : scalars_)
      all.push_back({scalar, {usual_.rules, scalar, usual_.zero_test, usual_.limit}});
  for (auto& each : certified()) {
    const std::string& rules = each.second.rules;
    if (rules == usual_.rules || to_string(*first_search_of(rules)) == usual_.rules) all.push_back(std::move(each));
  }
  return all;
}

const Row* Settings::find(const std::string& family, const Setting& setting) const {
  const auto found = std::ranges::find_if(study_.rows, [&](const Row& row) {
    return row.family == family && row.rules == setting.rules && row.scalar == setting.scalar &&
           row.zero_test == setting.zero_test;
  });
  return found == study_.rows.end() ? nullptr : &*found;
}

const FamilyNote& Settings::family(const std::string& name) const {
  return *std::ranges::find(study_.families, name, &FamilyNote::name);
}

std::optional<Counts> Settings::counts(const std::string& family, const Setting& setting) const {
  const Row* const row = find(family, setting);
  if (row == nullptr) return std::nullopt;
  Counts counts = counts_at(this->family(family), *row, setting.limit);
  return counts.pairs == 0 ? std::nullopt : std::optional(std::move(counts));
}

}  // namespace study
