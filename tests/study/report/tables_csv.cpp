#include <charconv>
#include <sstream>

#include "tests/study/methods/certified.hpp"
#include "tests/study/report/tables.hpp"
#include "walkthroughs/model/number_text.hpp"

namespace study {
namespace {

std::string head(const Header& header) {
  return "# " + header.command + "\n# seed " + std::to_string(header.seed) + "; gjkstep-study " + header.version +
         "; " + header.compiler + "\n";
}

/// Of certified queries; [0] is of those that needed none.
struct SecondSearches {
  const Histogram& iterations;
};

/// One field after the other, with commas between.
class Line {
 public:
  template <class T>
  Line& operator<<(const T& field) {
    if (!is_first_) text_ << ',';
    is_first_ = false;
    text_ << field;
    return *this;
  }
  /// A count of some trials, its rate and the interval of that; where there were no trials there are none, and of a
  /// census no interval.
  Line& operator<<(const Rate& rate) {
    *this << rate.count;
    if (rate.trials == 0) return nothing(3);
    *this << walkthroughs::number_text(rate.share());
    if (!rate.has_interval()) return nothing(2);
    const Interval interval = rate.interval();
    return *this << walkthroughs::number_text(interval.low) << walkthroughs::number_text(interval.high);
  }
  Line& operator<<(const Histogram& iterations) {
    if (total(iterations) == 0) return nothing(3);
    const Spread spread = spread_of(iterations);
    return *this << walkthroughs::number_text(spread.mean) << spread.p99 << spread.max;
  }
  /// How many there were, and of these the mean and the largest number of iterations.
  Line& operator<<(const SecondSearches& searches) {
    if (total(searches.iterations) == 0) return nothing(3);
    const Histogram some = without_none(searches.iterations);
    *this << total(some);
    if (total(some) == 0) return nothing(2);
    return *this << walkthroughs::number_text(spread_of(some).mean) << spread_of(some).max;
  }
  std::string end() const { return text_.str() + '\n'; }

 private:
  Line& nothing(int fields) {
    for (int i = 0; i < fields; ++i) *this << "";
    return *this;
  }

  std::ostringstream text_;
  bool is_first_ = true;
};

/// Returns: "" where some are not counted: those of second searches.
std::string support_calls(const Row& row, const Counts& counts) {
  return is_certified(row.rules) ? "" : std::to_string(counts.support_calls);
}

std::string line(const Settings& settings, const Row& row, int limit) {
  const Counts c = counts_at(settings.family(row.family), row, limit);
  Line fields;
  fields << row.family << row.rules << row.scalar << row.zero_test << limit_word(limit) << c.pairs << hit_rate(c)
         << false_positive_rate(c) << false_negative_rate(c) << undecided_rate(c) << c.cycles << c.unusable
         << c.in_doubt << c.hit_iterations << c.miss_iterations << support_calls(row, c) << row.tally.out_of_range
         << row.tally.not_askable << row.tally.truth_changed << row.tally.exceptions;
  for (const std::uint64_t truths : row.tally.proven) fields << truths;
  fields << SecondSearches{row.tally.second_iterations};
  if (is_certified(row.rules))
    fields << row.tally.certificates << row.tally.false_certificates;
  else
    fields << ""
           << "";
  return fields.end();
}

}  // namespace

std::string counts_csv(const Settings& settings) {
  std::string text = head(settings.study().header);
  text +=
      "family,rules,scalar,zero_test,limit,pairs,hits,hit_rate,hit_rate_low,hit_rate_high,"
      "false_positives,false_positive_rate,false_positive_rate_low,false_positive_rate_high,"
      "false_negatives,false_negative_rate,false_negative_rate_low,false_negative_rate_high,"
      "undecided,undecided_rate,undecided_rate_low,undecided_rate_high,cycles,unusable_directions,in_doubt,"
      "hit_iterations_mean,hit_iterations_p99,hit_iterations_max,miss_iterations_mean,miss_iterations_p99,"
      "miss_iterations_max,support_calls,out_of_range,not_askable,truth_changed_by_rounding,exceptions,"
      "proven_by_predicates,proven_by_formulas,proven_by_certificate,second_searches,second_iterations_mean,"
      "second_iterations_max,certificates_checked,false_certificates\n";
  for (const Row& row : settings.study().rows)
    for (const int limit : limits_for(row.rules, settings.limits())) text += line(settings, row, limit);
  return text;
}

std::string timings_csv(const Settings& settings) {
  std::string text =
      head(settings.study().header) + "# " + processors_of(settings.study()) +
      "; the CPU clock of the thread that asks\nfamily,rules,scalar,zero_test,limit,timed_queries,ns_per_query\n";
  for (const Row& row : settings.study().rows)
    for (const auto& [limit, timing] : row.timings) {
      Line fields;
      fields << row.family << row.rules << row.scalar << row.zero_test << limit_word(limit) << timing.queries
             << walkthroughs::number_text(timing.per_query());
      text += fields.end();
    }
  return text;
}

}  // namespace study
