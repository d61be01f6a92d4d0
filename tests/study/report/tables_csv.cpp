#include <charconv>
#include <sstream>

#include "tests/study/report/tables.hpp"
#include "walkthroughs/model/number_text.hpp"

namespace study {
namespace {

std::string head(const Header& header) {
  return "# " + header.command + "\n# seed " + std::to_string(header.seed) + "; gjkstep-study " + header.version +
         "; " + header.compiler + "\n";
}

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
  std::string end() const { return text_.str() + '\n'; }

 private:
  Line& nothing(int fields) {
    for (int i = 0; i < fields; ++i) *this << "";
    return *this;
  }

  std::ostringstream text_;
  bool is_first_ = true;
};

std::string line(const Settings& settings, const Row& row, int limit) {
  const Counts c = counts_at(settings.family(row.family), row, limit);
  Line fields;
  fields << row.family << row.rules << row.scalar << row.zero_test << limit << c.pairs << hit_rate(c)
         << false_positive_rate(c) << false_negative_rate(c) << undecided_rate(c) << c.cycles << c.unusable
         << c.hit_iterations << c.miss_iterations << c.support_calls << row.tally.out_of_range << row.tally.not_askable
         << row.tally.truth_changed << row.tally.exceptions;
  for (const std::uint64_t truths : row.tally.proven) fields << truths;
  return fields.end();
}

}  // namespace

std::string counts_csv(const Settings& settings) {
  std::string text = head(settings.study().header);
  text +=
      "family,rules,scalar,zero_test,limit,pairs,hits,hit_rate,hit_rate_low,hit_rate_high,"
      "false_positives,false_positive_rate,false_positive_rate_low,false_positive_rate_high,"
      "false_negatives,false_negative_rate,false_negative_rate_low,false_negative_rate_high,"
      "undecided,undecided_rate,undecided_rate_low,undecided_rate_high,cycles,unusable_directions,"
      "hit_iterations_mean,hit_iterations_p99,hit_iterations_max,miss_iterations_mean,miss_iterations_p99,"
      "miss_iterations_max,support_calls,out_of_range,not_askable,truth_changed_by_rounding,exceptions,"
      "proven_by_predicates,proven_by_formulas,proven_by_certificate\n";
  for (const Row& row : settings.study().rows)
    for (const int limit : settings.limits()) text += line(settings, row, limit);
  return text;
}

std::string timings_csv(const Settings& settings) {
  std::string text =
      head(settings.study().header) + "# " + processors_of(settings.study()) +
      "; the CPU clock of the thread that asks\nfamily,rules,scalar,zero_test,limit,timed_queries,ns_per_query\n";
  for (const Row& row : settings.study().rows)
    for (const auto& [limit, timing] : row.timings) {
      Line fields;
      fields << row.family << row.rules << row.scalar << row.zero_test << limit << timing.queries
             << walkthroughs::number_text(timing.per_query());
      text += fields.end();
    }
  return text;
}

}  // namespace study
