#include "tests/study/sweep/sense.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <set>
#include <stdexcept>

#include "tests/study/methods/all_methods.hpp"
#include "tests/study/methods/certified.hpp"
#include "tests/study/pairs/families.hpp"

namespace study {
namespace {

constexpr std::uint64_t most_nanoseconds = 3'600'000'000'000;  // that a query takes: an hour
constexpr int most_second_iterations = 1000;
constexpr int most_certified_iterations = 100000;  // C9 tries some dozens of balls with 200 points each

void expect(bool holds, const std::string& otherwise) {
  if (!holds) throw std::invalid_argument(otherwise);
}

void expect_limits(const std::vector<int>& limits) {
  expect(!limits.empty() && limits.front() >= 1 && limits.back() <= 1000 &&
             std::ranges::adjacent_find(limits, std::greater_equal{}) == limits.end(),
         "the iteration limits are not ascending from 1 to 1000");
}

void expect_family(const FamilyNote& note) {
  const auto family = std::ranges::find(families(), note.name, &Family::name);
  expect(family != families().end(), "there is no family '" + note.name + "'");
  expect(note.size == family->size, "family " + note.name + ": its size is another one");
  expect(note.slow_pairs <= note.pairs && note.pairs <= note.size.value_or(most_pairs),
         "family " + note.name + ": more pairs than there are, or more slow ones than pairs");
}

/// Tables look rows up: there is one for each family and each setting, family by family.
void expect_each_row_once(const Study& study) {
  const std::size_t methods = study.families.empty() ? 0 : study.rows.size() / study.families.size();
  expect(methods != 0 && study.rows.size() == methods * study.families.size(), "rows are missing");
  std::set<std::array<std::string, 4>> seen;
  for (std::size_t r = 0; r < study.rows.size(); ++r) {
    const Row &row = study.rows[r], &setting = study.rows[r % methods];
    const bool fits = row.family == study.families[r / methods].name && row.rules == setting.rules &&
                      row.scalar == setting.scalar && row.zero_test == setting.zero_test;
    expect(fits && seen.insert({row.family, row.rules, row.scalar, row.zero_test}).second,
           "row " + std::to_string(r) + " is not the one that stands there");
  }
}

const Method& method_of(const Row& row) {
  const auto& all = all_methods();
  const auto method = std::ranges::find_if(all, [&](const Method& m) {
    return m.rules == row.rules && m.scalar.name == row.scalar && m.zero_test == row.zero_test;
  });
  expect(method != all.end(), "there is no such setting");
  return *method;
}

/// Returns: how many queries it counts. No count is so large that sums of them wrap around.
std::uint64_t queries_in(const Histogram& histogram, int limit) {
  expect(histogram.size() <= static_cast<std::size_t>(limit) + 1,
         "a query took more than " + std::to_string(limit) + " iterations");
  expect(std::ranges::all_of(histogram, [](std::uint64_t count) { return count <= most_pairs; }),
         "a count is above " + std::to_string(most_pairs));
  return total(histogram);
}

void expect_tally(const Tally& tally, int limit, std::uint64_t pairs) {
  std::uint64_t asked = 0, proven = 0, at_limit = 0;
  for (const auto& by_answer : tally.queries) {
    for (const Histogram& histogram : by_answer) asked += queries_in(histogram, limit);
    const Histogram& stopped = by_answer[static_cast<std::size_t>(Answer::at_limit)];
    at_limit += total(stopped);
    expect(stopped.empty() || total(stopped) == (stopped.size() == limit + 1u ? stopped.back() : 0),
           "a query was stopped before the largest iteration limit");
  }
  for (const std::uint64_t count : {tally.out_of_range, tally.not_askable, tally.exceptions, tally.truth_changed,
                                    tally.proven[0], tally.proven[1], tally.proven[2]})
    queries_in({count}, limit);
  for (const std::uint64_t count : tally.proven) proven += count;
  expect(tally.pairs() == pairs,
         "its tally is of " + std::to_string(tally.pairs()) + " pairs, and the shard asks " + std::to_string(pairs));
  expect(proven == asked,
         std::to_string(asked) + " pairs were answered, and the truth is proven of " + std::to_string(proven));
  expect(tally.truth_changed <= pairs - tally.out_of_range, "the truth changed of more pairs than could be rounded");
  expect(queries_in(tally.returns, limit) <= at_limit && (tally.returns.empty() || tally.returns[0] == 0),
         "more queries came back to a state than were stopped at the limit");
}

/// What certified queries alone have; a search of theirs is never without an answer.
void expect_certified(const Tally& tally, bool is_certified, std::uint64_t asked) {
  const std::uint64_t searched = queries_in(tally.second_iterations, most_second_iterations);
  expect(searched == (is_certified ? asked : 0),
         "not every certified query tells of its second search, or another does");
  queries_in({tally.certificates, tally.false_certificates}, 1);
  expect(tally.certificates <= searched && tally.false_certificates <= tally.certificates,
         "more certificates than answers, or more false ones than there are");
  for (const auto& by_answer : tally.queries)
    for (const Answer answer : {Answer::unusable, Answer::at_limit})
      expect(!is_certified || total(by_answer[static_cast<std::size_t>(answer)]) == 0,
             "a certified query is without an answer");
}

/// Of the pairs that were asked the first are timed, the same at each limit; maybe none, where none of the first was asked.
void expect_timings(const Timings& timings, std::uint64_t asked) {
  for (const auto& [limit, timing] : timings) {
    expect(timing.queries == timings.begin()->second.queries && timing.queries >= 1 && timing.queries <= asked,
           "a time is of queries that were not asked");
    expect(timing.nanoseconds / timing.queries <= most_nanoseconds, "a query took more than an hour");
  }
}

/// Every certified answer is timed alone, or none: earlier versions timed none.
void expect_times_alone(const TimesAlone& alone, const FamilyNote& family, std::uint64_t answered) {
  const std::uint64_t timed = alone.one_search.queries + alone.two_searches.queries;
  for (const Timing& timing : {alone.one_search, alone.two_searches})
    expect(timing.queries <= answered &&
               timing.nanoseconds / std::max(timing.queries, std::uint64_t{1}) <= most_nanoseconds,
           "a query that is timed alone was not answered, or took more than an hour");
  expect(timed == 0 || timed == answered, "some certified answers are timed alone, others are not");
  expect(alone.slowest_pair < std::max(family.pairs, std::uint64_t{1}) && alone.slowest <= most_nanoseconds,
         "the slowest pair was not asked, or took more than an hour");
}

void expect_row(const Row& row, const FamilyNote& family, const Study& study) try {
  const std::uint64_t pairs = method_of(row).scalar.is_slow ? family.slow_pairs : family.pairs;
  const int limit = is_certified(row.rules) ? most_certified_iterations : study.header.limits.back();
  expect_tally(row.tally, limit, pairs_of_shard(pairs, study.shard));
  const Tally& tally = row.tally;
  const std::uint64_t in_question = tally.pairs() - tally.out_of_range - tally.not_askable;
  expect_certified(tally, is_certified(row.rules), in_question - tally.exceptions);
  expect_timings(row.timings, in_question);
  expect_times_alone(row.alone, family, in_question - tally.exceptions);
} catch (const std::invalid_argument& error) {
  throw std::invalid_argument("family " + row.family + ", rules " + row.rules + ", scalar " + row.scalar +
                              ", zero test " + row.zero_test + ": " + error.what());
}

}  // namespace

void expect_sense(const Study& study) {
  expect_limits(study.header.limits);
  expect(study.shard.index < study.shard.count, "there is no such shard");
  expect(!study.processors.empty(), "the processor is missing");
  for (const FamilyNote& family : study.families) expect_family(family);
  expect_each_row_once(study);
  for (std::size_t r = 0; r < study.rows.size(); ++r)
    expect_row(study.rows[r], study.families[r * study.families.size() / study.rows.size()], study);
}

}  // namespace study
