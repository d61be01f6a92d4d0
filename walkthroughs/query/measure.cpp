#include "walkthroughs/query/measure.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>

#include "core/certified/certified.hpp"
#include "walkthroughs/model/exact_shape.hpp"
#include "walkthroughs/query/prepared_pair.hpp"
#include "walkthroughs/query/query_certified.hpp"
#include "walkthroughs/text/text_file.hpp"

namespace walkthroughs::query {
namespace {

using gjk::Status;
using Pairs = std::vector<PairAsWritten>;

constexpr int rounds = 9;

struct Answered {
  Status status;
  int iterations;
};

/// A setting with all pairs made ready for it.
struct Contender {
  Setting setting;
  std::size_t pairs;
  std::function<Answered(std::size_t)> ask;  ///< about the pair of that number
};

// -- Making ready -----------------------------------------------------------------------------------------------------

/// Returns: the pairs, their numbers those of S.
template <class S>
Contender plain(const Pairs& pairs, std::string_view scalar, QueryOptions query) {
  auto ready = std::make_shared<std::vector<PreparedPair<S>>>();
  for (const PairAsWritten& pair : pairs) ready->push_back(prepared<S>(PairAsWritten(pair), query));
  return {{std::string(scalar), std::string(words_of::of(query.rules))}, pairs.size(), [ready, query](std::size_t i) {
            const gjk::Result<S> result = searched((*ready)[i], query);
            return Answered{result.status, result.iterations};
          }};
}

struct Proof {
  Answered operator()(const ProvablePoints<double>& pair) const {
    const gjk::CertifiedResult result = proven(pair);
    return {result.status, result.iterations + result.fallback_iterations};
  }
  Answered operator()(const ProvableGrown& pair) const {
    const gjk::GrownResult result = gjk::certified_collision(pair.a, pair.b);
    return {result.status, result.iterations};
  }
  Answered operator()(const ProvableOthers& pair) const {
    if (const auto status = exact_status_of_cylinders(pair.a, pair.b)) return {*status, 0};
    const gjk::ShapesResult result = bounded_answer(pair.a, pair.b);
    return {result.status, result.iterations};
  }
};

Contender certified(const Pairs& pairs, const QueryOptions& query) {
  auto ready = std::make_shared<std::vector<Provable<double>>>();
  for (const PairAsWritten& pair : pairs) ready->push_back(provable<double>(pair, query));
  return {
      {"double", "certified", true}, pairs.size(), [ready](std::size_t i) { return std::visit(Proof{}, (*ready)[i]); }};
}

template <class S>
void add_plain(const Pairs& pairs, std::string_view scalar, QueryOptions query, std::vector<Contender>& all) {
  for (const auto& rules : gjk::rule_sets) {
    query.rules = rules.value;
    all.push_back(plain<S>(pairs, scalar, query));
  }
}

std::vector<Contender> contenders_about(const Pairs& pairs, bool fit_floats, const QueryOptions& query) {
  std::vector<Contender> all;
  if (fit_floats) add_plain<float>(pairs, "float", query, all);
  add_plain<double>(pairs, "double", query, all);
  add_plain<long double>(pairs, "long-double", query, all);
  all.push_back(certified(pairs, query));
  return all;
}

// -- Measuring --------------------------------------------------------------------------------------------------------

/// Returns: the time of a pair, in nanoseconds; all are asked so often that the clock can tell.
double time_of(const Contender& contender) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::nanoseconds enough = std::chrono::milliseconds(2);
  std::size_t asked = 0;
  int sum = 0;  // so that nothing is left out
  const Clock::time_point begin = Clock::now();
  std::chrono::nanoseconds passed{};
  do {
    for (std::size_t i = 0; i < contender.pairs; ++i) sum += static_cast<int>(contender.ask(i).status);
    asked += contender.pairs;
    passed = Clock::now() - begin;
  } while (passed < enough);
  volatile int kept = sum;
  static_cast<void>(kept);
  return static_cast<double>(passed.count()) / static_cast<double>(asked);
}

double median(std::array<double, rounds> values) {
  std::ranges::nth_element(values, values.begin() + rounds / 2);
  return values[rounds / 2];
}

/// Of each setting, how long each round has taken.
using Times = std::vector<std::array<double, rounds>>;

/// All settings take turns, and each round begins with another.
void time_all(const std::vector<Contender>& contenders, Times& times) {
  times.resize(contenders.size());
  for (std::size_t round = 0; round < rounds; ++round)
    for (std::size_t k = 0; k < contenders.size(); ++k) {
      const std::size_t turn = (k + round) % contenders.size();
      times[turn][round] += time_of(contenders[turn]) * static_cast<double>(contenders[turn].pairs);
    }
}

void judge(const Contender& contender, const std::vector<Status>& truth, Measured& measured) {
  for (std::size_t i = 0; i < contender.pairs; ++i) {
    const auto [status, iterations] = contender.ask(i);
    measured.iterations += iterations;
    if (status == truth[i]) continue;
    ++(status == Status::undecided      ? measured.undecided
       : status == Status::intersecting ? measured.found_together
                                        : measured.found_apart);
  }
}

// -- Reading ----------------------------------------------------------------------------------------------------------

/// The pairs of a text, some after the other.
class PairReader {
 public:
  PairReader(std::string_view text, const std::string& file_name, const QueryOptions& query)
      : text_(text), file_name_(file_name), query_(query), in_floats_(query) {
    in_floats_.scalar = QueryScalar::binary32;
  }

  /// Returns: at most so many; none at the end.
  Pairs next(std::size_t most) {
    Pairs pairs;
    for (; !text_.empty() && pairs.size() < most; ++number_) {
      const std::size_t end = std::min(text_.find('\n'), text_.size());
      const std::string_view line = text_.substr(0, end);
      Reading<PairAsWritten> pair = read_pair(line, query_);
      if (pair.complaint) pair.complaint->line = number_;
      pairs.push_back(accepted(std::move(pair), file_name_));
      fit_floats_ = fit_floats_ && !read_pair(line, in_floats_).complaint;
      text_.remove_prefix(std::min(end + 1, text_.size()));
    }
    return pairs;
  }
  /// Whether all numbers read so far may be floats.
  bool fit_floats() const { return fit_floats_; }

 private:
  std::string_view text_;
  const std::string& file_name_;
  const QueryOptions& query_;
  QueryOptions in_floats_;
  int number_ = 1;
  bool fit_floats_ = true;
};

// -- Choosing ---------------------------------------------------------------------------------------------------------

/// Of n pairs like these k were not answered rightly. Returns: a bound on the share of such pairs which holds in 95 of 100
/// samples: that of a Poisson number, (k + 1.65 √(k + 1) + 2) / n at least, and 3/n where none was.
double share_at_most(std::size_t k, std::size_t n) {
  const double count = static_cast<double>(k);
  return (k == 0 ? 3 : count + 1.65 * std::sqrt(count + 1) + 2) / static_cast<double>(n);
}

constexpr double one_in_a_million = 1e-6;
constexpr std::size_t enough_pairs = 3'000'000;  // of which none is answered wrongly

/// What settings are chosen for. Rules as printed are known to be wrong, and never chosen.
constexpr std::array<std::string_view, 3> aims{"never wrong", "wrong in at most one of a million of these", "fastest"};

std::array<const Measured*, 3> chosen(const Measurement& m) {
  std::array<const Measured*, 3> fastest{};
  for (const Measured& each : m.settings) {
    const bool is_never_wrong = each.setting.is_certified,
               is_rarely = is_never_wrong || share_at_most(each.not_right(), m.pairs) <= one_in_a_million;
    const std::array suits{is_never_wrong, is_rarely, each.setting.rules != words_of::of(RuleSet::as_printed)};
    for (std::size_t aim = 0; aim < aims.size(); ++aim)
      if (suits[aim] && (!fastest[aim] || each.nanoseconds < fastest[aim]->nanoseconds)) fastest[aim] = &each;
  }
  return fastest;
}

// -- Writing ----------------------------------------------------------------------------------------------------------

std::string digits(double x, int places) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", places, x);
  return text;
}

std::string advice(const Measurement& m) {
  std::string text;
  const auto settings = chosen(m);
  for (std::size_t aim = 0; aim < aims.size(); ++aim) {
    const Measured& each = *settings[aim];
    text += std::string(aims[aim]) + ": " + each.setting.scalar + ", " + each.setting.rules + " (" +
            digits(each.nanoseconds, 0) + " ns" +
            (each.not_right() > 0 ? ", " + std::to_string(each.not_right()) + " not right" : "") + ")\n";
  }
  if (m.pairs < enough_pairs)
    text += "  (" + std::to_string(m.pairs) + " pairs are too few to show one of a million; " +
            std::to_string(enough_pairs) + " without a wrong answer can)\n";
  return text;
}

/// Where numbers are beyond floats these are not asked any more.
void forget_floats(Measurement& measurement, Times& times) {
  measurement.fit_floats = false;
  const auto is_float = [](const Measured& each) { return each.setting.scalar == query_scalars[0]; };
  const auto count = std::ranges::count_if(measurement.settings, is_float);
  std::erase_if(measurement.settings, is_float);
  times.erase(times.begin(), times.begin() + std::min<std::ptrdiff_t>(count, std::ssize(times)));
}

}  // namespace

Measurement measure(std::string_view text, const std::string& file_name, const QueryOptions& query) {
  constexpr std::size_t block = 4096, timed_pairs = 100'000;
  PairReader reader(text, file_name, query);
  Measurement measurement;
  Times times;
  std::size_t timed = 0;
  for (Pairs pairs; !(pairs = reader.next(block)).empty();) {
    std::vector<Status> truth;
    measurement.unknown += std::erase_if(pairs, [&](const PairAsWritten& pair) {
      const Status status = exact_answer(pair.a, pair.b).status;
      if (status != Status::undecided) truth.push_back(status);
      return status == Status::undecided;
    });
    if (pairs.empty()) continue;
    if (measurement.fit_floats && !reader.fit_floats()) forget_floats(measurement, times);
    const std::vector<Contender> contenders = contenders_about(pairs, measurement.fit_floats, query);
    if (measurement.settings.empty())
      for (const Contender& each : contenders) measurement.settings.push_back({each.setting});
    for (std::size_t k = 0; k < contenders.size(); ++k) judge(contenders[k], truth, measurement.settings[k]);
    if (timed < timed_pairs) {
      time_all(contenders, times);
      timed += pairs.size();
    }
    measurement.pairs += pairs.size();
    measurement.together += static_cast<std::size_t>(std::ranges::count(truth, Status::intersecting));
  }
  if (measurement.pairs + measurement.unknown == 0)
    throw InputError(file_name + ": has no pairs; give one a line: {\"a\": …, \"b\": …}");
  if (measurement.pairs == 0) throw InputError(file_name + ": nothing can be proven about any of its pairs");
  for (std::size_t k = 0; k < times.size(); ++k) {
    measurement.settings[k].nanoseconds = median(times[k]) / static_cast<double>(timed);
    measurement.settings[k].iterations /= static_cast<double>(measurement.pairs);
  }
  return measurement;
}

std::string table_of(const Measurement& m) {
  std::string text = "pairs: " + std::to_string(m.pairs) + "; they intersect: " + std::to_string(m.together);
  if (m.unknown > 0) text += "; left out, as nothing can be proven: " + std::to_string(m.unknown);
  text += "\n\n";
  const auto row = [&](const auto&... cells) {
    char line[160];
    std::snprintf(line, sizeof line, "%-12s %-12s %9s %15s %15s %10s %11s\n", cells...);
    text += line;
  };
  row("scalar", "rules", "ns a pair", "found together", "found apart", "undecided", "iterations");
  for (const Measured& each : m.settings)
    row(each.setting.scalar.c_str(), each.setting.rules.c_str(), digits(each.nanoseconds, 0).c_str(),
        std::to_string(each.found_together).c_str(), std::to_string(each.found_apart).c_str(),
        std::to_string(each.undecided).c_str(), digits(each.iterations, 2).c_str());
  if (!m.fit_floats) text += "(not in floats: some numbers are beyond them)\n";
  return text + "\nfound together: they are apart; found apart: they intersect. Times are medians of " +
         std::to_string(rounds) + " rounds in turn.\n\n" + advice(m);
}

std::string csv_of(const Measurement& m) {
  std::string text =
      "scalar,rules,pairs,left_out,ns_a_pair,found_together,found_apart,undecided,iterations,chosen_for\n";
  const auto settings = chosen(m);
  for (const Measured& each : m.settings) {
    std::string chosen_for;
    for (std::size_t aim = 0; aim < aims.size(); ++aim)
      if (settings[aim] == &each) chosen_for.append(chosen_for.empty() ? "" : "; ").append(aims[aim]);
    text += each.setting.scalar + "," + each.setting.rules + "," + std::to_string(m.pairs) + "," +
            std::to_string(m.unknown) + "," + digits(each.nanoseconds, 1) + "," + std::to_string(each.found_together) +
            "," + std::to_string(each.found_apart) + "," + std::to_string(each.undecided) + "," +
            digits(each.iterations, 3) + "," + chosen_for + "\n";
  }
  return text;
}

}  // namespace walkthroughs::query
