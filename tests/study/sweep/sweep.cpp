#include "tests/study/sweep/sweep.hpp"

#include <algorithm>
#include <exception>
#include <map>
#include <mutex>
#include <stdexcept>

#include "tests/study/methods/certified.hpp"
#include "tests/study/pairs/over_pairs.hpp"
#include "tests/study/sweep/turns.hpp"
#include "tests/study/truth/oracle.hpp"

namespace study {
namespace {

constexpr std::uint64_t batch_size = 256;  // pairs that are timed together
constexpr std::size_t slow_batch = 16;     // of these, in a slow scalar
constexpr int askings_alone = 5;           // of a query that may be the slowest

/// What some threads have made of one family: a cell for each method.
struct Cells : std::vector<Cell> {
  Cells& operator+=(const Cells& more) {
    resize(std::max(size(), more.size()));
    for (std::size_t m = 0; m < more.size(); ++m) (*this)[m] += more[m];
    return *this;
  }
};

/// A pair as one scalar sees it.
struct View {
  std::optional<RoundedPair> rounded;  ///< empty where a number is out of range
  std::unique_ptr<Question> question;  ///< null where it is not asked
  Judgement judgement = {};

  View(const Scalar& scalar, const Pair& pair) : rounded(scalar.rounded(pair)) {
    if (rounded) question = scalar.question(rounded->pair);
  }
};

/// What interrupts a query makes it longer: one that seems the slowest so far is asked again, and its least time counts.
TimesAlone time_alone(const Method& method, const Question& question, bool searched_twice, std::uint64_t index,
                      std::uint64_t so_far) {
  const auto nanoseconds = [&, asked = &question] {
    return static_cast<std::uint64_t>(method.time({&asked, 1}, no_limit).count());
  };
  TimesAlone times{.slowest_pair = index, .slowest = nanoseconds()};
  (searched_twice ? times.two_searches : times.one_search) = {1, times.slowest};
  for (int asked = 1; asked < askings_alone && times.slowest > so_far; ++asked)
    times.slowest = std::min(times.slowest, nanoseconds());
  return times;
}

/// Asks all methods about pairs of one family.
class Asker {
 public:
  Asker(const Plan& plan, const Part& part) : plan_(plan), part_(part) {}

  void ask(std::uint64_t index, Cells& cells) const {
    const Pair pair = part_.family->make(plan_.seed, index);
    const Judgement judgement = judgement_of(pair, index);
    std::map<std::string, View> views;  // by scalar
    cells.resize(plan_.methods.size());
    for (std::size_t m = 0; m < plan_.methods.size(); ++m) {
      const Scalar& scalar = plan_.methods[m]->scalar;
      if (scalar.is_slow && index >= part_.slow_pairs) continue;
      const auto [named, is_new] = views.try_emplace(scalar.name, scalar, pair);
      View& view = named->second;
      if (is_new)
        view.judgement = view.rounded && view.rounded->differs ? judgement_of(view.rounded->pair, index) : judgement;
      cells[m].tally.truth_changed += view.judgement.truth != judgement.truth;
      ask(*plan_.methods[m], index, view, cells[m]);
    }
  }

  /// Times all methods, each with the questions of some pairs in a row.
  void time(const std::vector<std::uint64_t>& indices, Cells& cells) const {
    std::map<std::string, std::vector<std::unique_ptr<Question>>> questions;  // by scalar
    std::vector<Batch> batches;
    for (const Method* const method : plan_.methods) {
      const auto [made, is_new] = questions.try_emplace(method->scalar.name);
      if (is_new) made->second = questions_of(method->scalar, indices);
      batches.push_back({method, {}});
      for (const auto& question : made->second) batches.back().questions.push_back(question.get());
    }
    cells.resize(plan_.methods.size());
    const std::vector<Timings> times = times_in_turn(batches, plan_.limits);
    for (std::size_t m = 0; m < times.size(); ++m) cells[m] += {{}, times[m], {}};
  }

 private:
  Judgement judgement_of(const Pair& pair, std::uint64_t index) const try {
    return judge(pair);
  } catch (const std::exception& error) {
    throw std::runtime_error("the truth about pair " + std::to_string(index) + " of family '" + part_.family->name +
                             "' is not known: " + error.what());
  }

  void ask(const Method& method, std::uint64_t index, const View& view, Cell& cell) const try {
    Tally& tally = cell.tally;
    tally.out_of_range += !view.rounded;
    tally.not_askable += view.rounded && !view.question;
    if (!view.question) return;
    const Outcome outcome = method.ask(*view.question, plan_.limits.back());
    const bool is_checked = method.certificate_holds && index < part_.slow_pairs;
    const auto holds = is_checked ? method.certificate_holds(*view.question) : std::nullopt;
    tally.count(view.judgement, outcome);
    tally.certificates += holds.has_value();
    tally.false_certificates += holds == false;
    if (!is_certified(method.rules)) return;
    count(tally.fallback_iterations, outcome.fallback_iterations);
    cell.alone += time_alone(method, *view.question, outcome.fallback_iterations > 0, index, cell.alone.slowest);
  } catch (const std::exception&) {
    ++cell.tally.exceptions;
  }

  std::vector<std::unique_ptr<Question>> questions_of(const Scalar& scalar,
                                                      const std::vector<std::uint64_t>& indices) const {
    std::vector<std::unique_ptr<Question>> questions;
    for (const std::uint64_t index : indices) {
      if (scalar.is_slow && (index >= part_.slow_pairs || questions.size() == slow_batch)) break;
      if (View view(scalar, part_.family->make(plan_.seed, index)); view.question)
        questions.push_back(std::move(view.question));
    }
    return questions;
  }

  const Plan& plan_;
  const Part& part_;
};

}  // namespace

std::vector<Row> sweep(const Plan& plan, const Progress& progress) {
  std::vector<Row> rows;
  std::mutex mutex;
  std::uint64_t done = 0, all = 0;
  for (const Part& part : plan.parts) all += pairs_of_shard(part.pairs, plan.shard);
  const auto begins = [&](std::uint64_t pairs) {
    const std::lock_guard lock(mutex);
    if (progress) progress(done += pairs, all);
  };
  for (const Part& part : plan.parts) {
    const Asker asker(plan, part);
    const std::uint64_t pairs = pairs_of_shard(part.pairs, plan.shard);
    const auto index_at = [&](std::uint64_t position) { return plan.shard.index + position * plan.shard.count; };
    Cells cells = over_pairs<Cells>(pairs, plan.threads, [&](Cells& own, std::uint64_t position) {
      if (position % batch_size == 0) {
        std::vector<std::uint64_t> indices;
        for (std::uint64_t i = position; i < std::min(position + batch_size, pairs); ++i)
          indices.push_back(index_at(i));
        if (position < plan.timed_pairs) asker.time(indices, own);
        begins(indices.size());
      }
      asker.ask(index_at(position), own);
    });
    cells.resize(plan.methods.size());  // a shard may have no pair of a family
    for (std::size_t m = 0; m < plan.methods.size(); ++m) {
      const Method& method = *plan.methods[m];
      rows.push_back({cells[m], part.family->name, method.rules, method.scalar.name, method.zero_test});
    }
  }
  return rows;
}

}  // namespace study
