#include "tests/study/sweep/tally.hpp"

#include <algorithm>
#include <numeric>

namespace study {
namespace {

/// Adds queries of one truth and answer that took k iterations when asked with the largest limit.
void add(Counts& counts, Truth truth, Answer answer, int k, std::uint64_t queries, int limit) {
  const bool in_time = k <= limit && answer != Answer::at_limit, hit = truth == Truth::intersecting;
  counts.pairs += queries;
  if (hit) counts.hits += queries;
  count(hit ? counts.hit_iterations : counts.miss_iterations, std::min(k, limit), queries);
  if (!in_time || answer == Answer::unusable || answer == Answer::in_doubt) counts.undecided += queries;
  if (!in_time) return;
  if (answer == Answer::unusable) counts.unusable += queries;
  if (answer == Answer::in_doubt) counts.in_doubt += queries;
  if (answer == Answer::intersecting && !hit) counts.false_positives += queries;
  if (answer == Answer::separated && hit) counts.false_negatives += queries;
}

}  // namespace

void count(Histogram& histogram, int iterations, std::uint64_t queries) {
  const auto k = static_cast<std::size_t>(iterations);
  if (histogram.size() <= k) histogram.resize(k + 1);
  histogram[k] += queries;
}

void add(Histogram& sum, const Histogram& more) {
  sum.resize(std::max(sum.size(), more.size()));
  std::ranges::transform(more, sum, sum.begin(), std::plus());
}

std::uint64_t total(const Histogram& histogram) {
  return std::accumulate(histogram.begin(), histogram.end(), std::uint64_t{0});
}

void Tally::count(const Judgement& judgement, const Outcome& outcome) {
  Histogram& histogram = queries[judgement.truth == Truth::intersecting][static_cast<std::size_t>(outcome.answer)];
  study::count(histogram, outcome.iterations);
  if (outcome.returned > 0) study::count(returns, outcome.returned);
  ++proven[static_cast<std::size_t>(judgement.proof)];
}

Tally& Tally::operator+=(const Tally& more) {
  for (std::size_t truth = 0; truth < queries.size(); ++truth)
    for (std::size_t answer = 0; answer < answers; ++answer) add(queries[truth][answer], more.queries[truth][answer]);
  for (std::size_t proof = 0; proof < proofs; ++proof) proven[proof] += more.proven[proof];
  add(returns, more.returns);
  add(fallback_iterations, more.fallback_iterations);
  for (const auto counter : {&Tally::out_of_range, &Tally::not_askable, &Tally::truth_changed, &Tally::exceptions,
                             &Tally::certificates, &Tally::false_certificates})
    this->*counter += more.*counter;
  return *this;
}

Counts counts_at(const Tally& tally, int limit) {
  Counts counts;
  for (const Truth truth : {Truth::separated, Truth::intersecting})
    for (std::size_t answer = 0; answer < answers; ++answer) {
      const Histogram& histogram = tally.queries[truth == Truth::intersecting][answer];
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

TimesAlone& TimesAlone::operator+=(const TimesAlone& more) {
  one_search += more.one_search;
  two_searches += more.two_searches;
  if (more.slowest > slowest) {
    slowest = more.slowest;
    slowest_pair = more.slowest_pair;
  }
  return *this;
}

Cell& Cell::operator+=(const Cell& more) {
  tally += more.tally;
  for (const auto& [limit, timing] : more.timings) timings[limit] += timing;
  alone += more.alone;
  return *this;
}

}  // namespace study
