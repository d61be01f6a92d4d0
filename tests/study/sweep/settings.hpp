/// Settings: what a study varies, and where its rows are found.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/study/methods/certified.hpp"
#include "tests/study/sweep/study.hpp"

namespace study {

struct Setting {
  std::string rules, scalar, zero_test;
  int limit;
};

/// Returns: "rules as-intended, zero test exact, at most 20 iterations"; "rules certified", which say it all.
inline std::string all_but_scalar(const Setting& setting) {
  if (is_certified(setting.rules)) return "rules " + setting.rules;
  return "rules " + setting.rules + ", zero test " + setting.zero_test + ", at most " + std::to_string(setting.limit) +
         " iterations";
}

/// The settings of one study. Refers to it.
class Settings {
 public:
  explicit Settings(const Study& study);

  const std::vector<std::string>& rules() const { return rules_; }
  const std::vector<std::string>& scalars() const { return scalars_; }
  const std::vector<std::string>& zero_tests() const { return zero_tests_; }
  const std::vector<int>& limits() const { return study_.header.limits; }

  /// Returns: what tables vary one thing of: the rules as intended, in double, with the exact zero test and the report's
  /// limit; where the study has no such, the first, or last limit, that it has.
  const Setting& usual() const { return usual_; }

  /// Returns: null where this was not asked.
  const Row* find(const std::string& family, const Setting& setting) const;

  /// Returns: the note on the family of that name, which the study has.
  const FamilyNote& family(const std::string& name) const;

  /// Returns: empty where this was not asked, or of no pair. What is certified has the same at every limit.
  std::optional<Counts> counts(const std::string& family, const Setting& setting) const;

  /// Returns: the certified settings, with what tables call them: "certified double".
  std::vector<std::pair<std::string, Setting>> certified() const;

  /// Returns: the usual setting in each scalar, and certified answers whose search begins by the usual rules.
  std::vector<std::pair<std::string, Setting>> scalars_and_certified() const;

  const Study& study() const { return study_; }

 private:
  const Study& study_;
  std::vector<std::string> rules_, scalars_, zero_tests_;
  Setting usual_;
};

}  // namespace study
