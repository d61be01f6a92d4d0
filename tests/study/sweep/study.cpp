#include "tests/study/sweep/study.hpp"

#include <algorithm>

#include "tests/study/methods/certified.hpp"

namespace study {
namespace {

bool is_same_setting(const Row& row, const Row& other) {
  return row.family == other.family && row.rules == other.rules && row.scalar == other.scalar &&
         row.zero_test == other.zero_test;
}

/// Wrong ones, undecided ones but where points are computed, queries that threw, and certificates that do not hold.
std::uint64_t failures_of_certified(const Tally& tally, const Counts& counts) {
  return counts.wrong() + counts.undecided - counts.in_doubt + tally.exceptions + tally.false_certificates;
}

[[noreturn]] void refuse(const NamedStudy& one, const NamedStudy& other, const std::string& why) {
  throw StudyError(one.name + " and " + other.name + " do not go together: " + why);
}

void expect_same_study(const NamedStudy& one, const NamedStudy& other) {
  const Header &h = one.study.header, &g = other.study.header;
  if (h.seed != g.seed)
    refuse(one, other, "their seeds are " + std::to_string(h.seed) + " and " + std::to_string(g.seed));
  if (h.version != g.version) refuse(one, other, "they were made by versions " + h.version + " and " + g.version);
  if (h.compiler != g.compiler)
    refuse(one, other, "their programs were compiled by " + h.compiler + " and " + g.compiler);
  if (h.command != g.command) refuse(one, other, "they are shards of '" + h.command + "' and '" + g.command + "'");
  if (h != g || one.study.families != other.study.families ||
      !std::ranges::equal(one.study.rows, other.study.rows, is_same_setting))
    refuse(one, other, "their families or settings differ");
  if (one.study.shard.count != other.study.shard.count)
    refuse(one, other,
           "they are shards of " + std::to_string(one.study.shard.count) + " and of " +
               std::to_string(other.study.shard.count));
}

void expect_each_once(const std::vector<NamedStudy>& sorted) {
  const std::uint64_t count = sorted.front().study.shard.count;
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i].study.shard.index == sorted[i - 1].study.shard.index)
      refuse(sorted[i - 1], sorted[i], "both are shard " + std::to_string(sorted[i].study.shard.index));
  for (std::uint64_t index = 0; index < count; ++index)
    if (index >= sorted.size() || sorted[index].study.shard.index != index)
      throw StudyError("shard " + std::to_string(index) + " of " + std::to_string(count) +
                       " is missing; make it with: " + sorted.front().study.header.command + " --shard " +
                       std::to_string(index) + "/" + std::to_string(count));
}

}  // namespace

Counts counts_at(const FamilyNote& family, const Row& row, int limit) {
  Counts counts = counts_at(row.tally, limit_for(row.rules, limit));
  if (family.size == row.tally.pairs()) counts.extent = Extent::census;
  return counts;
}

std::string contradiction(const Study& study) {
  for (const Row& row : study.rows) {
    const Counts counts = counts_at(row.tally, limit_for(row.rules, study.header.limits.back()));
    if (is_certified(row.rules) && failures_of_certified(row.tally, counts) > 0)
      return "family " + row.family + ": " + std::to_string(failures_of_certified(row.tally, counts)) + " of " +
             std::to_string(row.tally.pairs()) + " certified answers in " + row.scalar +
             " were wrong, none, or without a proof that holds, which cannot be: GJK, its proofs or the oracle have an "
             "error";
    if (row.rules == "as-intended" && row.scalar == "exact" && counts.wrong() > 0)
      return "family " + row.family + ": in exact numbers GJK was wrong on " + std::to_string(counts.wrong()) + " of " +
             std::to_string(counts.pairs) + " pairs, which cannot be: GJK or the oracle has an error";
  }
  return "";
}

Study merged(std::vector<NamedStudy> shards) {
  if (shards.empty()) throw StudyError("there is nothing to merge");
  for (const NamedStudy& each : shards) expect_same_study(shards.front(), each);
  std::ranges::stable_sort(shards, {}, [](const NamedStudy& each) { return each.study.shard.index; });
  expect_each_once(shards);
  Study sum = shards.front().study;
  for (std::size_t i = 1; i < shards.size(); ++i)
    for (std::size_t r = 0; r < sum.rows.size(); ++r) {
      sum.rows[r].tally += shards[i].study.rows[r].tally;
      for (const auto& [limit, timing] : shards[i].study.rows[r].timings) sum.rows[r].timings[limit] += timing;
      sum.rows[r].alone += shards[i].study.rows[r].alone;
    }
  for (const NamedStudy& each : shards)
    for (const std::string& processor : each.study.processors)
      if (std::ranges::find(sum.processors, processor) == sum.processors.end()) sum.processors.push_back(processor);
  sum.shard = {};
  return sum;
}

}  // namespace study
