/// Algorithms 2-5 as a table: which regions are told of a simplex, in which order, and what follows from each verdict.
///
/// core/rules.hpp computes, this table only knows what may be said; so a trace can be checked without a search, and a rule
/// that says something else than before is noticed.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/events.hpp"

namespace walkthroughs {

/// What follows from a verdict: the next place to look at, or how the rule ends.
struct RuleStep {
  int place = 0;
  bool is_end = false;
  std::string_view kept = {};       ///< roles, oldest first; empty: the simplex stays as it is
  std::string_view direction = {};  ///< expression; empty: the simplex contains the origin
};

/// One thing that may be told at a place of a rule. Rows of one place differ in their relation.
struct RuleRow {
  int place = 0;
  std::string_view feature, label = {}, face = {}, expression = {}, formula = {};
  gjk::Relation relation = gjk::Relation::positive;
  std::optional<RuleStep> chosen = {}, rejected = {}, skipped = {}, possible = {};  ///< empty: not to be said here
};

/// Returns: the rows at that place for a simplex of that size. Requires: 1 <= size <= 4.
std::vector<RuleRow> rows_at(int place, int size);

}  // namespace walkthroughs
