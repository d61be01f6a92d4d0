#include "tests/study/sweep/tally.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace study {
namespace {

std::size_t index(Truth truth) { return static_cast<std::size_t>(truth); }
std::size_t index(Answer answer) { return static_cast<std::size_t>(answer); }

Histogram& iterations_of(Counts& counts, Truth truth) {
  return truth == Truth::intersecting ? counts.hit_iterations : counts.miss_iterations;
}

bool is_wrong(Truth truth, Answer answer) {
  return answer == (truth == Truth::intersecting ? Answer::separated : Answer::intersecting);
}

/// Adds `queries` of one truth and answer that took k iterations when asked with the largest limit.
void add(Counts& counts, Truth truth, Answer answer, int k, std::uint64_t queries, int limit) {
  const bool in_time = k <= limit && answer != Answer::at_limit;
  const int taken = std::min(k, limit);
  counts.pairs += queries;
  if (truth == Truth::intersecting) counts.hits += queries;
  Histogram& iterations = iterations_of(counts, truth);
  iterations.resize(std::max(iterations.size(), static_cast<std::size_t>(taken) + 1));
  iterations[static_cast<std::size_t>(taken)] += queries;
  if (!in_time || answer == Answer::unusable || answer == Answer::in_doubt) counts.undecided += queries;
  if (in_time && answer == Answer::unusable) counts.unusable += queries;
  if (in_time && answer == Answer::in_doubt) counts.in_doubt += queries;
  if (in_time && is_wrong(truth, answer))
    (truth == Truth::intersecting ? counts.false_negatives : counts.false_positives) += queries;
}

}  // namespace

void count(Histogram& histogram, int iterations) {
  const auto k = static_cast<std::size_t>(iterations);
  if (histogram.size() <= k) histogram.resize(k + 1);
  ++histogram[k];
}

void add(Histogram& sum, const Histogram& more) {
  sum.resize(std::max(sum.size(), more.size()));
  std::ranges::transform(more, sum, sum.begin(), std::plus());
}

std::uint64_t total(const Histogram& histogram) {
  return std::accumulate(histogram.begin(), histogram.end(), std::uint64_t{0});
}

void Tally::count(const Judgement& judgement, const Outcome& outcome) {
  study::count(queries[index(judgement.truth)][index(outcome.answer)], outcome.iterations);
  ++proven[static_cast<std::size_t>(judgement.proof)];
}

Tally& Tally::operator+=(const Tally& more) {
  for (std::size_t truth = 0; truth < queries.size(); ++truth)
    for (std::size_t answer = 0; answer < answers; ++answer) add(queries[truth][answer], more.queries[truth][answer]);
  for (std::size_t proof = 0; proof < proofs; ++proof) proven[proof] += more.proven[proof];
  add(returns, more.returns);
  out_of_range += more.out_of_range;
  not_askable += more.not_askable;
  truth_changed += more.truth_changed;
  exceptions += more.exceptions;
  add(second_iterations, more.second_iterations);
  certificates += more.certificates;
  false_certificates += more.false_certificates;
  return *this;
}

TimesAlone& TimesAlone::operator+=(const TimesAlone& more) {
  one_search += more.one_search;
  two_searches += more.two_searches;
  if (more.slowest > slowest) std::tie(slowest, slowest_pair) = std::pair(more.slowest, more.slowest_pair);
  return *this;
}

Counts counts_at(const Tally& tally, int limit) {
  Counts counts;
  for (const Truth truth : {Truth::separated, Truth::intersecting})
    for (std::size_t answer = 0; answer < answers; ++answer) {
      const Histogram& histogram = tally.queries[index(truth)][answer];
      for (std::size_t k = 0; k < histogram.size(); ++k)
        if (histogram[k] > 0) add(counts, truth, static_cast<Answer>(answer), static_cast<int>(k), histogram[k], limit);
    }
  for (std::size_t k = 0; k < tally.returns.size() && k <= static_cast<std::size_t>(limit); ++k)
    counts.cycles += tally.returns[k];
  return counts;
}

Timing& Timing::operator+=(const Timing& more) {
  queries += more.queries;
  nanoseconds += more.nanoseconds;
  return *this;
}

}  // namespace study
