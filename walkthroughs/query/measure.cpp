#include "walkthroughs/query/measure.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <concepts>
#include <cstdio>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <utility>

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

// -- Exact numbers ----------------------------------------------------------------------------------------------------

/// Returns: how many points the shape has in exact numbers; nothing where these need square roots.
std::optional<std::size_t> points_in_exact(const AnyShape& shape) {
  const auto count = []<class Shape>(const Shape& one) -> std::optional<std::size_t> {
    if constexpr (!CanBeAsked<typename ShapeRow<Shape>::template In<gjk::Fraction>>) {
      return std::nullopt;
    } else if constexpr (std::same_as<Shape, Points>) {
      return one.size();
    } else {
      const auto a = points_in_exact(one.summands[0]), b = points_in_exact(one.summands[1]);
      return a && b ? std::optional(*a + *b) : std::nullopt;
    }
  };
  return visit_shape(count, shape);
}

constexpr std::size_t most_exact_pairs = 1000, most_exact_points = 4096;  // some seconds

/// Which pairs are asked in exact numbers. What they take depends on the points, and nothing here on the clock.
class ExactShare {
 public:
  /// Returns: whether that pair is. Requires: something can be proven about it.
  bool takes(const PairAsWritten& pair) {
    const auto of_a = points_in_exact(pair.a.form), of_b = points_in_exact(pair.b.form);
    if (!of_a || !of_b) ++refused_;
    if (!of_a || !of_b || pairs_ == most_exact_pairs || points_ + *of_a + *of_b > most_exact_points) return false;
    ++pairs_;
    points_ += *of_a + *of_b;
    return true;
  }
  /// So many pairs have shapes that cannot be asked in exact numbers.
  std::size_t refused() const { return refused_; }

 private:
  std::size_t pairs_ = 0, points_ = 0, refused_ = 0;
};

/// Pairs that something can be proven about, and what. Those that exact numbers are asked about come first.
struct Block {
  Pairs pairs;
  std::vector<Status> truth;
  std::size_t in_exact = 0;

  void add(PairAsWritten&& pair, Status status) {
    pairs.push_back(std::move(pair));
    truth.push_back(status);
  }
  void add(Block&& more) {
    std::ranges::move(more.pairs, std::back_inserter(pairs));
    std::ranges::copy(more.truth, std::back_inserter(truth));
  }
};

Block block_of(Pairs&& pairs, ExactShare& share) {
  Block exact, others;
  for (PairAsWritten& pair : pairs) {
    const Status status = exact_answer(pair.a, pair.b).status;
    if (status != Status::undecided) (share.takes(pair) ? exact : others).add(std::move(pair), status);
  }
  exact.in_exact = exact.pairs.size();
  exact.add(std::move(others));
  return exact;
}

// -- Making ready -----------------------------------------------------------------------------------------------------

/// Returns: the pairs, their numbers those of S.
template <class S>
Contender plain(std::span<const PairAsWritten> pairs, std::string_view scalar, QueryOptions query) {
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

Contender certified(std::span<const PairAsWritten> pairs, const QueryOptions& query) {
  auto ready = std::make_shared<std::vector<Provable<double>>>();
  for (const PairAsWritten& pair : pairs) ready->push_back(provable<double>(pair, query));
  return {
      {"double", "certified", true}, pairs.size(), [ready](std::size_t i) { return std::visit(Proof{}, (*ready)[i]); }};
}

template <class S>
void add_plain(std::span<const PairAsWritten> pairs, std::string_view scalar, QueryOptions query,
               std::vector<Contender>& all) {
  for (const auto& rules : gjk::rule_sets) {
    query.rules = rules.value;
    all.push_back(plain<S>(pairs, scalar, query));
  }
}

std::vector<Contender> contenders_about(const Block& block, bool fit_floats, const QueryOptions& query) {
  const std::span<const PairAsWritten> pairs = block.pairs;
  std::vector<Contender> all;
  if (fit_floats) add_plain<float>(pairs, "float", query, all);
  add_plain<double>(pairs, "double", query, all);
  add_plain<long double>(pairs, "long-double", query, all);
  add_plain<gjk::Fraction>(pairs.first(block.in_exact), "exact", query, all);
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

/// What is known of a setting so far.
struct Record {
  Measured measured;
  std::size_t timed = 0;               ///< pairs
  std::array<double, rounds> times{};  ///< that these have taken, in each round
};

/// All settings take turns, and each round begins with another.
void time_all(const std::vector<Contender>& contenders, std::vector<Record>& records) {
  for (std::size_t round = 0; round < rounds; ++round)
    for (std::size_t k = 0; k < contenders.size(); ++k) {
      const std::size_t turn = (k + round) % contenders.size();
      if (const std::size_t pairs = contenders[turn].pairs; pairs > 0)
        records[turn].times[round] += time_of(contenders[turn]) * static_cast<double>(pairs);
    }
  for (std::size_t k = 0; k < contenders.size(); ++k) records[k].timed += contenders[k].pairs;
}

void judge(const Contender& contender, const std::vector<Status>& truth, Measured& measured) {
  measured.pairs += contender.pairs;
  for (std::size_t i = 0; i < contender.pairs; ++i) {
    const auto [status, iterations] = contender.ask(i);
    measured.iterations += iterations;
    if (status == truth[i]) continue;
    ++(status == Status::undecided      ? measured.undecided
       : status == Status::intersecting ? measured.found_together
                                        : measured.found_apart);
  }
}

/// Returns: the settings that were asked anything.
std::vector<Measured> means_of(std::vector<Record> records) {
  std::vector<Measured> settings;
  for (auto& [measured, timed, times] : records) {
    if (measured.pairs == 0) continue;
    measured.nanoseconds = median(times) / static_cast<double>(timed);
    measured.iterations /= static_cast<double>(measured.pairs);
    settings.push_back(std::move(measured));
  }
  return settings;
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

/// What settings are chosen for. Rules as printed are known to be wrong, and never chosen. Nor is what was asked about some
/// pairs only: the others may take longer, or be answered wrongly.
constexpr std::array<std::string_view, 3> aims{"never wrong", "wrong in at most one of a million of these", "fastest"};

std::array<const Measured*, 3> chosen(const Measurement& m) {
  std::array<const Measured*, 3> fastest{};
  for (const Measured& each : m.settings) {
    if (each.pairs < m.pairs) continue;
    const bool is_never_wrong = each.setting.is_certified,
               is_rarely = is_never_wrong || share_at_most(each.not_right(), each.pairs) <= one_in_a_million;
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
void forget_floats(Measurement& measurement, std::vector<Record>& records) {
  measurement.fit_floats = false;
  std::erase_if(records, [](const Record& each) { return each.measured.setting.scalar == query_scalars[0]; });
}

/// Returns: about how many pairs exact numbers were asked, and why not about the others.
std::string note_on_exact(const Measurement& m) {
  const auto exact =
      std::ranges::find(m.settings, query_scalars[3], [](const Measured& each) { return each.setting.scalar; });
  const std::size_t asked = exact == m.settings.end() ? 0 : exact->pairs, beyond = m.pairs - m.not_exact - asked;
  if (asked == m.pairs) return "";
  std::string text = "(exact: asked about " + std::to_string(asked) + " of these pairs";
  if (m.not_exact > 0) text += "; not about " + std::to_string(m.not_exact) + " whose points need square roots";
  if (beyond > 0)
    text += "; not about " + std::to_string(beyond) + " beyond the first " + std::to_string(most_exact_pairs) +
            " pairs or " + std::to_string(most_exact_points) + " points";
  return text + ")\n";
}

}  // namespace

Measurement measure(std::string_view text, const std::string& file_name, const QueryOptions& query) {
  constexpr std::size_t most_at_a_time = 4096, timed_pairs = 100'000;
  PairReader reader(text, file_name, query);
  ExactShare share;
  Measurement measurement;
  std::vector<Record> records;
  for (Pairs pairs; !(pairs = reader.next(most_at_a_time)).empty();) {
    const std::size_t read = pairs.size();
    const Block block = block_of(std::move(pairs), share);
    measurement.unknown += read - block.pairs.size();
    if (block.pairs.empty()) continue;
    if (measurement.fit_floats && !reader.fit_floats()) forget_floats(measurement, records);
    const std::vector<Contender> contenders = contenders_about(block, measurement.fit_floats, query);
    if (records.empty())
      for (const Contender& each : contenders) records.push_back({{each.setting}});
    for (std::size_t k = 0; k < contenders.size(); ++k) judge(contenders[k], block.truth, records[k].measured);
    if (measurement.pairs < timed_pairs) time_all(contenders, records);
    measurement.pairs += block.pairs.size();
    measurement.together += static_cast<std::size_t>(std::ranges::count(block.truth, Status::intersecting));
  }
  if (measurement.pairs + measurement.unknown == 0)
    throw InputError(file_name + ": has no pairs; give one a line: {\"a\": …, \"b\": …}");
  if (measurement.pairs == 0) throw InputError(file_name + ": nothing can be proven about any of its pairs");
  measurement.not_exact = share.refused();
  measurement.settings = means_of(std::move(records));
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
  text += note_on_exact(m);
  return text + "\nfound together: they are apart; found apart: they intersect. Times are medians of " +
         std::to_string(rounds) +
         " rounds in turn.\nAs-printed is never advised: Algorithm 1, read literally, answers wrongly.\n\n" + advice(m);
}

std::string csv_of(const Measurement& m) {
  std::string text =
      "scalar,rules,pairs,left_out,ns_a_pair,found_together,found_apart,undecided,iterations,chosen_for\n";
  const auto settings = chosen(m);
  for (const Measured& each : m.settings) {
    std::string chosen_for;
    for (std::size_t aim = 0; aim < aims.size(); ++aim)
      if (settings[aim] == &each) chosen_for.append(chosen_for.empty() ? "" : "; ").append(aims[aim]);
    text += each.setting.scalar + "," + each.setting.rules + "," + std::to_string(each.pairs) + "," +
            std::to_string(m.pairs + m.unknown - each.pairs) + "," + digits(each.nanoseconds, 1) + "," +
            std::to_string(each.found_together) + "," + std::to_string(each.found_apart) + "," +
            std::to_string(each.undecided) + "," + digits(each.iterations, 3) + "," + chosen_for + "\n";
  }
  return text;
}

}  // namespace walkthroughs::query
