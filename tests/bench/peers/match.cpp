#include "tests/bench/peers/match.hpp"

#include <algorithm>
#include <ctime>
#include <limits>

#include "tests/bench/peers/trial.hpp"
#include "tests/study/pairs/pairs.hpp"

namespace peers {
namespace {

std::vector<study::Pair> pairs_of(const study::Family& family, const MatchSettings& settings) {
  const std::uint64_t most = family.size.value_or(std::numeric_limits<std::uint64_t>::max());
  std::vector<study::Pair> pairs;
  for (std::uint64_t i = 0; i < std::min<std::uint64_t>(settings.pairs, most); ++i)
    pairs.push_back(family.make(settings.seed, i));
  return pairs;
}

std::string told(Answer failure, std::size_t pair) {
  return "pair " + std::to_string(pair) +
         (failure == Answer::timed_out ? ": no answer within " + std::to_string(seconds_for_a_pair) + " s"
                                       : ": crashed");
}

Score score(const std::vector<Answer>& answers, const std::vector<study::Truth>& truths) {
  Score score;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const bool meet = truths[i] == study::Truth::intersecting;
    switch (answers[i]) {
      case Answer::intersecting: score.false_positives += !meet; break;
      case Answer::separated: score.false_negatives += meet; break;
      case Answer::undecided:
      case Answer::threw: ++score.undecided; break;
      case Answer::crashed:
      case Answer::timed_out:
        if (score.first_failure.empty()) score.first_failure = told(answers[i], i);
        ++score.failed;
        break;
      case Answer::not_asked: ++score.not_asked; break;
    }
  }
  return score;
}

bool is_right(Answer answer, study::Truth truth) {
  return answer == (truth == study::Truth::intersecting ? Answer::intersecting : Answer::separated);
}

/// Only who has an answer of any kind to every pair, in time, takes part in the race.
bool may_race(const std::vector<Answer>& answers) {
  return std::all_of(answers.begin(), answers.end(), [](Answer answer) { return answer <= Answer::undecided; });
}

std::size_t corners(const study::Body& body) {
  const auto* points = std::get_if<study::Points>(&body);
  return points ? points->size() : 1;
}

/// Returns: the first pairs, as many as fit a second-level cache: the queries are timed, and not the memory.
std::vector<std::size_t> raced(const std::vector<study::Pair>& pairs) {
  std::vector<std::size_t> positions;
  std::size_t sum = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    sum += corners(pairs[i].a) + corners(pairs[i].b);
    if (sum > corners_raced) break;
    positions.push_back(i);
  }
  return positions;
}

/// One contender's part of the race.
struct Runner {
  Batch& batch;
  std::vector<Answer> answers;
  std::vector<double> nanoseconds = {};  ///< per query, one for each repeat

  /// What the others have put in the caches since this runner's last turn is replaced before the clock starts.
  void run(const std::vector<std::size_t>& pairs) {
    batch.ask_all(pairs, answers);
    const double start = processor_time();
    batch.ask_all(pairs, answers);
    nanoseconds.push_back((processor_time() - start) / static_cast<double>(pairs.size()));
  }
};

/// The runners take turns, so that what slows the machine for a while slows all of them.
void race(std::vector<Runner>& runners, const std::vector<std::size_t>& pairs, int repeats) {
  for (int i = 0; i < repeats; ++i)
    for (Runner& runner : runners)
      if (may_race(runner.answers)) runner.run(pairs);
}

std::size_t lost(const std::vector<Runner>& runners, const std::vector<Contender>& contenders,
                 const std::vector<study::Truth>& truths) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < truths.size(); ++i) {
    bool a_peer_is_right = false;
    for (std::size_t k = 0; k < runners.size(); ++k)
      a_peer_is_right |= contenders[k].is_peer && is_right(runners[k].answers[i], truths[i]);
    count += a_peer_is_right && !is_right(runners[0].answers[i], truths[i]);
  }
  return count;
}

}  // namespace

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double processor_time() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}

Match play(const study::Family& family, const std::vector<Contender>& contenders, const MatchSettings& settings) {
  const std::vector<study::Pair> pairs = pairs_of(family, settings);
  std::vector<study::Truth> truths;
  for (const study::Pair& pair : pairs) truths.push_back(study::truth(pair));

  Match match{.family = family.name, .pairs = pairs.size()};
  match.meet = static_cast<std::size_t>(std::count(truths.begin(), truths.end(), study::Truth::intersecting));
  std::vector<std::unique_ptr<Batch>> batches;
  std::vector<Runner> runners;
  for (const Contender& contender : contenders) {
    batches.push_back(contender.prepare(pairs));
    const std::vector<Answer> answers = tried(*batches.back(), pairs.size());
    match.scores.push_back(score(answers, truths));
    runners.push_back({*batches.back(), answers});
  }
  match.lost = lost(runners, contenders, truths);
  const std::vector<std::size_t> in_race = raced(pairs);
  match.raced = in_race.size();
  race(runners, in_race, settings.repeats);
  for (std::size_t i = 0; i < runners.size(); ++i)
    if (!runners[i].nanoseconds.empty()) match.scores[i].nanoseconds = median(runners[i].nanoseconds);
  return match;
}

}  // namespace peers
