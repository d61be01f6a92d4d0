#include "tests/study/sweep/sweep.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <map>
#include <mutex>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <tuple>

#include "tests/study/methods/certified.hpp"
#include "tests/study/sweep/turns.hpp"
#include "tests/study/truth/oracle.hpp"

namespace study {
namespace {

constexpr std::uint64_t job_size = 256;  // pairs of one job; also of one timed batch
constexpr int askings_alone = 5;         // of a query that may be the slowest
constexpr std::size_t slow_batch = 16;   // questions of a timed batch of a slow scalar

/// Positions first … last - 1 in the list of the shard's pairs of one part.
struct Job {
  std::size_t part;
  std::uint64_t first, last;
};

/// A pair of a family, before any scalar has seen it.
struct Sample {
  std::uint64_t index;
  Pair pair;
  Judgement judgement;
};

/// A sample as one scalar sees it.
struct View {
  const Sample* sample;
  std::optional<RoundedPair> rounded;  ///< empty where a number is out of range
  Judgement judgement;
  std::unique_ptr<Question> question;  ///< null where it is not asked
};

struct Cell {
  Tally tally;
  Timings timings;
  TimesAlone alone;
};

/// All jobs of a plan, in order. There may be more of them than memory for a list.
class Jobs {
 public:
  explicit Jobs(const Plan& plan) {
    for (const Part& part : plan.parts) {
      pairs_.push_back(pairs_of_shard(part.pairs, plan.shard));
      ends_.push_back(size() + (pairs_.back() + job_size - 1) / job_size);
    }
  }
  std::uint64_t size() const { return ends_.empty() ? 0 : ends_.back(); }
  std::uint64_t pairs() const { return std::accumulate(pairs_.begin(), pairs_.end(), std::uint64_t{0}); }

  /// Requires: j < size().
  Job operator[](std::uint64_t j) const {
    const auto part = static_cast<std::size_t>(std::ranges::upper_bound(ends_, j) - ends_.begin());
    const std::uint64_t first = (j - (part == 0 ? 0 : ends_[part - 1])) * job_size;
    return {part, first, std::min(first + job_size, pairs_[part])};
  }

 private:
  std::vector<std::uint64_t> pairs_, ends_;  // by part: of the shard; how many jobs there are up to its end
};

std::optional<Kind> failure_kind(Truth truth, const Outcome& outcome, int limit) {
  const bool in_time = outcome.iterations <= limit;
  const bool has_answer = outcome.answer == Answer::intersecting || outcome.answer == Answer::separated;
  if (!in_time || !has_answer) return Kind::undecided;
  const bool says_hit = outcome.answer == Answer::intersecting;
  if (says_hit == (truth == Truth::intersecting)) return std::nullopt;
  return says_hit ? Kind::false_positive : Kind::false_negative;
}

// -- One job ----------------------------------------------------------------------------------------------------------

class Worker {
 public:
  Worker(const Plan& plan, const Job& job) : plan_(plan), job_(job), part_(plan.parts[job.part]) {}

  void run() {
    const std::vector<Sample> samples = make_samples();
    for (const Method* const method : plan_.methods) {
      const auto [views, is_new] = views_.try_emplace(method->scalar.name);
      if (is_new) views->second = views_of(samples, method->scalar);
      cells.push_back(cell_of(*method, views->second));
    }
    if (job_.first < plan_.timed_pairs) time_all();
  }

  std::vector<Cell> cells;  ///< one for each method
  std::vector<Failure> failures;

 private:
  std::vector<Sample> make_samples() const {
    std::vector<Sample> samples;
    for (std::uint64_t position = job_.first; position < job_.last; ++position) {
      const std::uint64_t index = plan_.shard.index + position * plan_.shard.count;
      Pair pair = part_.family->make(plan_.seed, index);
      const Judgement judgement = judgement_of(pair, index);
      samples.push_back({index, std::move(pair), judgement});
    }
    return samples;
  }

  Judgement judgement_of(const Pair& pair, std::uint64_t index) const try {
    return judge(pair);
  } catch (const std::exception& error) {
    throw std::runtime_error("the truth about pair " + std::to_string(index) + " of family '" + part_.family->name +
                             "' is not known: " + error.what());
  }

  std::vector<View> views_of(const std::vector<Sample>& samples, const Scalar& scalar) const {
    std::vector<View> views;
    for (const Sample& sample : samples) {
      if (scalar.is_slow && sample.index >= part_.slow_pairs) break;
      View view{&sample, scalar.rounded(sample.pair), sample.judgement, nullptr};
      if (view.rounded) {
        if (view.rounded->differs) view.judgement = judgement_of(view.rounded->pair, sample.index);
        view.question = scalar.question(view.rounded->pair);
      }
      views.push_back(std::move(view));
    }
    return views;
  }

  Cell cell_of(const Method& method, const std::vector<View>& views) {
    Cell cell;
    Tally& tally = cell.tally;
    std::array<std::uint64_t, kinds> kept{};
    for (const View& view : views) {
      if (view.judgement.truth != view.sample->judgement.truth) ++tally.truth_changed;
      if (!view.rounded)
        ++tally.out_of_range;
      else if (!view.question)
        ++tally.not_askable;
      else if (const auto kind = ask(method, view, cell))
        if (kept[static_cast<std::size_t>(*kind)]++ < plan_.failures_kept) keep(method, view, *kind);
    }
    return cell;
  }

  std::optional<Kind> ask(const Method& method, const View& view, Cell& cell) const try {
    Tally& tally = cell.tally;
    const int limit = plan_.limits.back();
    const Outcome outcome = method.ask(*view.question, limit);
    const int k = outcome.answer == Answer::at_limit ? method.first_return(*view.question, limit) : 0;
    const auto holds = is_checked(method, view) ? method.certificate_holds(*view.question) : std::nullopt;
    tally.count(view.judgement, outcome);
    if (k > 0) count(tally.returns, k);
    if (is_certified(method.rules)) {
      count(tally.second_iterations, outcome.second_iterations);
      cell.alone += time_alone(method, view, outcome, cell.alone.slowest);
    }
    tally.certificates += holds.has_value();
    tally.false_certificates += holds == false;
    const auto kind = failure_kind(view.judgement.truth, outcome, limit_for(method.rules, plan_.failure_limit));
    return !kind && holds == false ? Kind::false_certificate : kind;
  } catch (const std::exception&) {
    ++cell.tally.exceptions;
    return std::nullopt;
  }

  bool is_checked(const Method& method, const View& view) const {
    return method.certificate_holds && view.sample->index < part_.slow_pairs;
  }

  /// What interrupts a query makes it longer: one that seems the slowest so far is asked again, and its least time counts.
  static TimesAlone time_alone(const Method& method, const View& view, const Outcome& outcome, std::uint64_t so_far) {
    const auto nanoseconds = [&] {
      const Question* const question = view.question.get();
      return static_cast<std::uint64_t>(method.time({&question, 1}, no_limit).count());
    };
    TimesAlone times{.slowest_pair = view.sample->index, .slowest = nanoseconds()};
    (outcome.second_iterations > 0 ? times.two_searches : times.one_search) = {1, times.slowest};
    for (int asked = 1; asked < askings_alone && times.slowest > so_far; ++asked)
      times.slowest = std::min(times.slowest, nanoseconds());
    return times;
  }

  void keep(const Method& method, const View& view, Kind kind) {
    failures.push_back({part_.family->name, view.sample->index, &method, kind,
                        limit_for(method.rules, plan_.failure_limit), view.judgement.truth, view.rounded->pair});
  }

  void time_all() {
    std::vector<Batch> batches;
    for (const Method* const method : plan_.methods) batches.push_back({method, timed_questions(*method)});
    std::vector<Timings> times = times_in_turn(batches, plan_.limits);
    for (std::size_t m = 0; m < cells.size(); ++m) cells[m].timings = std::move(times[m]);
  }

  std::vector<const Question*> timed_questions(const Method& method) const {
    std::vector<const Question*> batch;
    for (const View& view : views_.at(method.scalar.name))
      if (view.question && (!method.scalar.is_slow || batch.size() < slow_batch)) batch.push_back(view.question.get());
    return batch;
  }

  const Plan& plan_;
  const Job& job_;
  const Part& part_;
  std::map<std::string, std::vector<View>> views_;  // by scalar
};

// -- All jobs ---------------------------------------------------------------------------------------------------------

/// Where the threads leave what they found.
class Collector {
 public:
  Collector(const Plan& plan, const Progress& progress, std::uint64_t all)
      : plan_(plan), progress_(progress), all_(all) {
    for (const Part& part : plan.parts)
      for (const Method* method : plan.methods)
        findings_.rows.push_back({part.family->name, method->rules, method->scalar.name, method->zero_test, {}, {}});
  }

  void take(const Job& job, Worker& worker) {
    const std::lock_guard lock(mutex_);
    for (std::size_t m = 0; m < worker.cells.size(); ++m) {
      Row& row = findings_.rows[job.part * plan_.methods.size() + m];
      row.tally += worker.cells[m].tally;
      for (const auto& [limit, timing] : worker.cells[m].timings) row.timings[limit] += timing;
      row.alone += worker.cells[m].alone;
    }
    for (Failure& failure : worker.failures) take(job, failure);
    done_ += job.last - job.first;
    if (progress_) progress_(done_, all_);
  }

  Findings result() {
    for (auto& [key, kept] : failures_)
      for (auto& [index, failure] : kept) findings_.failures.push_back(std::move(failure));
    return std::move(findings_);
  }

 private:
  /// The first ones are kept, whatever the order in which the threads find them.
  void take(const Job& job, Failure& failure) {
    const auto method = std::ranges::find(plan_.methods, failure.method) - plan_.methods.begin();
    auto& kept = failures_[{job.part, method, failure.kind}];
    kept.emplace(failure.index, std::move(failure));
    if (kept.size() > plan_.failures_kept) kept.erase(std::prev(kept.end()));
  }

  const Plan& plan_;
  const Progress& progress_;
  std::mutex mutex_;
  Findings findings_;
  std::map<std::tuple<std::size_t, std::ptrdiff_t, Kind>, std::map<std::uint64_t, Failure>> failures_;
  std::uint64_t done_ = 0, all_;
};

/// Hands out jobs until there are none left or one has failed.
class Queue {
 public:
  Queue(const Plan& plan, const Jobs& jobs, Collector& collector) : plan_(plan), jobs_(jobs), collector_(collector) {}

  void work() try {
    for (std::uint64_t j = next_++; j < jobs_.size() && !failed_; j = next_++) {
      const Job job = jobs_[j];
      Worker worker(plan_, job);
      worker.run();
      collector_.take(job, worker);
    }
  } catch (...) {
    if (!failed_.exchange(true)) error_ = std::current_exception();
  }

  void rethrow_error() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  const Plan& plan_;
  const Jobs& jobs_;
  Collector& collector_;
  std::atomic<std::uint64_t> next_ = 0;
  std::atomic<bool> failed_ = false;
  std::exception_ptr error_;
};

}  // namespace

Findings sweep(const Plan& plan, const Progress& progress) {
  const Jobs jobs(plan);
  Collector collector(plan, progress, jobs.pairs());
  Queue queue(plan, jobs, collector);
  {
    std::vector<std::jthread> others;
    for (unsigned t = 1; t < plan.threads; ++t) others.emplace_back([&] { queue.work(); });
    queue.work();
  }
  queue.rethrow_error();
  return collector.result();
}

}  // namespace study
