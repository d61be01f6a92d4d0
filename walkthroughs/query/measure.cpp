#include "walkthroughs/query/measure.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>

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
    const gjk::ShapesResult result = bounded_answer<double>(pair.a, pair.b);
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

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// All settings take turns, and each round begins with another.
void time_all(const std::vector<Contender>& contenders, std::vector<Measured>& measured) {
  std::vector<std::vector<double>> times(contenders.size());
  for (std::size_t round = 0; round < rounds; ++round)
    for (std::size_t k = 0; k < contenders.size(); ++k) {
      const std::size_t turn = (k + round) % contenders.size();
      times[turn].push_back(time_of(contenders[turn]));
    }
  for (std::size_t k = 0; k < measured.size(); ++k) measured[k].nanoseconds = median(times[k]);
}

Measured judged(const Contender& contender, const std::vector<Status>& truth) {
  Measured measured{contender.setting};
  for (std::size_t i = 0; i < contender.pairs; ++i) {
    const auto [status, iterations] = contender.ask(i);
    measured.iterations += iterations;
    if (status == truth[i]) continue;
    ++(status == Status::undecided      ? measured.undecided
       : status == Status::intersecting ? measured.found_together
                                        : measured.found_apart);
  }
  measured.iterations /= static_cast<double>(contender.pairs);
  return measured;
}

// -- Reading ----------------------------------------------------------------------------------------------------------

/// Returns: the pairs of a text. `fit_floats`: becomes false where a number is none that a float may be.
Pairs read_pairs(std::string_view text, const std::string& file_name, const QueryOptions& query, bool& fit_floats) {
  Pairs pairs;
  QueryOptions in_floats = query;
  in_floats.scalar = QueryScalar::binary32;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    Reading<PairAsWritten> pair = read_pair(line, query);
    if (pair.complaint) pair.complaint->line = number;
    pairs.push_back(accepted(std::move(pair), file_name));
    fit_floats = fit_floats && !read_pair(line, in_floats).complaint;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  if (pairs.empty()) throw InputError(file_name + ": has no pairs; give one a line: {\"a\": …, \"b\": …}");
  return pairs;
}

// -- Choosing ---------------------------------------------------------------------------------------------------------

std::string digits(double x, int places) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", places, x);
  return text;
}

std::string name_of(const Setting& setting) { return setting.scalar + ", " + setting.rules; }

using Chosen = std::optional<Measured>;

template <class Suits>
Chosen fastest(const Measurement& measurement, const Suits& suits) {
  Chosen chosen;
  for (const Measured& each : measurement.settings)
    if (suits(each) && (!chosen || each.nanoseconds < chosen->nanoseconds)) chosen = each;
  return chosen;
}

/// Of n pairs like these k were not answered rightly. Returns: a bound on the share of such pairs which holds in 95 of 100
/// samples: that of a Poisson number, (k + 1.65 √(k + 1) + 2) / n at least, and 3/n where none was.
double share_at_most(std::size_t k, std::size_t n) {
  const double count = static_cast<double>(k);
  return (k == 0 ? 3 : count + 1.65 * std::sqrt(count + 1) + 2) / static_cast<double>(n);
}

std::string with_cost(const Measured& chosen) {
  return name_of(chosen.setting) + " (" + digits(chosen.nanoseconds, 0) + " ns)";
}

std::string advice(const Measurement& m) {
  constexpr double one_in_a_million = 1e-6;
  const Chosen never = fastest(m, [](const Measured& each) { return each.setting.is_certified; });
  const Chosen rarely = fastest(m, [&](const Measured& each) {
    return each.setting.is_certified || share_at_most(each.not_right(), m.pairs) <= one_in_a_million;
  });
  std::string text = "never wrong: " + with_cost(*never) + "\n";
  text += "wrong in at most one of a million of these: " + with_cost(*rarely) + "\n";
  if (m.pairs < 3'000'000)
    text += "  (" + std::to_string(m.pairs) + " pairs cannot show less than " +
            digits(3e6 / static_cast<double>(m.pairs), 1) + " in a million; 3000000 without a wrong answer can)\n";
  return text + "fastest: " + with_cost(*fastest(m, [](const Measured&) { return true; })) + "\n";
}

}  // namespace

Measurement measure(std::string_view text, const std::string& file_name, const QueryOptions& query) {
  bool fit_floats = true;
  Pairs pairs = read_pairs(text, file_name, query, fit_floats);
  Measurement measurement{.fit_floats = fit_floats};
  std::vector<Status> truth;
  std::erase_if(pairs, [&](const PairAsWritten& pair) {
    const Status status = exact_answer(pair.a, pair.b).status;
    if (status != Status::undecided) truth.push_back(status);
    measurement.unknown += status == Status::undecided;
    return status == Status::undecided;
  });
  if (pairs.empty()) throw InputError(file_name + ": nothing can be proven about any of its pairs");
  measurement.pairs = pairs.size();
  measurement.together = static_cast<std::size_t>(std::ranges::count(truth, Status::intersecting));
  const std::vector<Contender> contenders = contenders_about(pairs, fit_floats, query);
  for (const Contender& each : contenders) measurement.settings.push_back(judged(each, truth));
  time_all(contenders, measurement.settings);
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
  std::string text = "scalar,rules,pairs,ns_a_pair,found_together,found_apart,undecided,iterations\n";
  for (const Measured& each : m.settings)
    text += each.setting.scalar + "," + each.setting.rules + "," + std::to_string(m.pairs) + "," +
            digits(each.nanoseconds, 1) + "," + std::to_string(each.found_together) + "," +
            std::to_string(each.found_apart) + "," + std::to_string(each.undecided) + "," + digits(each.iterations, 3) +
            "\n";
  return text;
}

}  // namespace walkthroughs::query
