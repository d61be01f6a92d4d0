#include <algorithm>
#include <cstdio>
#include <functional>

#include "tests/study/report/tables.hpp"

namespace study {
namespace {

using Names = std::vector<std::string>;
constexpr const char* no_pairs = "no pairs";

using CellOf = std::function<std::string(const FamilyNote& family)>;

struct Column {
  std::string heading;
  CellOf cell;  ///< "" where there is nothing to say
};

std::string line(const Names& cells) {
  std::string text = "|";
  for (const std::string& cell : cells) text += " " + cell + " |";
  return text + "\n";
}

std::string heading(const std::vector<Column>& columns) {
  Names names{"family"}, rule{"---"};
  for (const Column& column : columns) {
    names.push_back(column.heading);
    rule.push_back("---");
  }
  return line(names) + line(rule);
}

Names row(const FamilyNote& family, const std::vector<Column>& columns) {
  Names cells{family.name};
  for (const Column& column : columns) cells.push_back(column.cell(family));
  return cells;
}

std::string table(const Settings& settings, const std::vector<Column>& columns) {
  std::string text = heading(columns);
  for (const FamilyNote& family : settings.study().families) text += line(row(family, columns));
  return text;
}

/// Whether a cell says that nothing was seen or could be seen, or nothing at all.
bool is_nothing(const std::string& cell) { return cell.empty() || cell == no_pairs || cell.starts_with("0 "); }

/// As table(); families in which nothing was seen in any column are named below it.
std::string rate_table(const Settings& settings, const std::vector<Column>& columns) {
  std::string seen, nothing;
  for (const FamilyNote& family : settings.study().families) {
    const Names cells = row(family, columns);
    if (std::all_of(cells.begin() + 1, cells.end(), is_nothing))
      nothing += (nothing.empty() ? "" : ", ") + family.name;
    else
      seen += line(cells);
  }
  if (!seen.empty()) seen = heading(columns) + seen + (nothing.empty() ? "" : "\n");
  return seen + (nothing.empty() ? "" : "Nothing was seen in: " + nothing + ".\n");
}

std::string described(const Setting& setting) { return setting.scalar + ", " + all_but_scalar(setting); }

/// A column of one setting.
Column column(const Settings& settings, std::string heading, const Setting& setting,
              const std::function<std::string(const Counts&)>& words) {
  return {std::move(heading), [&settings, setting, words](const FamilyNote& family) {
            const auto counts = settings.counts(family.name, setting);
            return counts ? words(*counts) : "";
          }};
}

std::string words_of_failures(const Counts& counts) { return in_words(failure_rate(counts)); }

std::string words_of_undecided(const Counts& counts) {
  std::string words = in_words(undecided_rate(counts));
  if (counts.cycles > 0) words += "; " + std::to_string(counts.cycles) + " in circles";
  if (counts.unusable > 0) words += "; " + std::to_string(counts.unusable) + " without a direction";
  if (counts.in_doubt > 0) words += "; " + std::to_string(counts.in_doubt) + " in doubt";
  return words;
}

std::string with_decimals(int decimals, double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string words_of(const Histogram& iterations) {
  if (total(iterations) == 0) return "";
  const Spread spread = spread_of(iterations);
  return with_decimals(2, spread.mean) + ", " + std::to_string(spread.p99) + ", " + std::to_string(spread.max);
}

// -- The tables of counts ---------------------------------------------------------------------------------------------

/// Returns: "predicates", or with the counts "predicates 498, certificates 2" where there were several.
std::string words_of_proofs(const Tally& tally) {
  constexpr const char* names[proofs] = {"predicates", "formulas", "certificates"};
  const bool are_several = std::ranges::count_if(tally.proven, [](std::uint64_t n) { return n > 0; }) > 1;
  std::string words;
  for (std::size_t proof = 0; proof < proofs; ++proof)
    if (tally.proven[proof] > 0)
      words += (words.empty() ? "" : ", ") + std::string(names[proof]) +
               (are_several ? " " + std::to_string(tally.proven[proof]) : "");
  return words;
}

std::string families_table(const Settings& settings) {
  const Setting usual = settings.usual();
  Setting narrow = usual;
  narrow.scalar = "float";
  const auto rounding = [&settings, narrow](std::uint64_t Tally::*what) {
    return [&settings, narrow, what](const FamilyNote& family) {
      const Row* const row = settings.find(family.name, narrow);
      return row && row->tally.*what > 0 ? std::to_string(row->tally.*what) : "";
    };
  };
  return "## Families\n\nOf each pair it is known exactly whether the sets have a point in common; touching counts: "
         "by CGAL's exact predicates; by CGAL's exact linear program, with a certificate that is multiplied out in "
         "fractions; or by formulas in fractions. Float is asked about the pair as float writes it, and its answer "
         "held against the truth about that pair; how often "
         "writing it in float changed the truth is told beside it.\n\n" +
         table(settings,
               {{"what", [](const FamilyNote& family) { return family.what; }},
                {"pairs",
                 [](const FamilyNote& family) {
                   return std::to_string(family.pairs) + (family.pairs == family.size ? ", all" : "");
                 }},
                {"of these exact", [](const FamilyNote& family) { return std::to_string(family.slow_pairs); }},
                column(settings, "hits", usual, [](const Counts& c) { return in_short(hit_rate(c).share()); }),
                {"truth by",
                 [&settings, usual](const FamilyNote& family) {
                   const Row* const row = settings.find(family.name, usual);
                   return row ? words_of_proofs(row->tally) : "";
                 }},
                {"changed by float", rounding(&Tally::truth_changed)},
                {"beyond float's range", rounding(&Tally::out_of_range)}});
}

/// The two ways to be wrong, each of the pairs with which it can happen, and to be undecided.
std::string errors_table(const Settings& settings, const Setting& setting) {
  const auto rates = [&](std::string heading, Rate (*rate)(const Counts&)) {
    return column(settings, std::move(heading), setting,
                  [rate](const Counts& counts) { return in_words(rate(counts)); });
  };
  return rate_table(settings, {rates("false positives, of pairs apart", false_positive_rate),
                               rates("false negatives, of pairs that meet", false_negative_rate),
                               rates("undecided, of all pairs", undecided_rate)});
}

std::string scalars_table(const Settings& settings, const std::function<std::string(const Counts&)>& words) {
  std::vector<Column> columns;
  for (const auto& [title, setting] : settings.scalars_and_certified())
    columns.push_back(column(settings, title, setting, words));
  return rate_table(settings, columns);
}

/// A column for each set of rules, in the usual scalar, else as usual.
std::string rules_table(const Settings& settings) {
  std::vector<Column> columns;
  for (const std::string& rules : settings.rules()) {
    Setting setting = settings.usual();
    setting.rules = rules;
    columns.push_back(column(settings, rules, setting, words_of_failures));
  }
  return rate_table(settings, columns);
}

/// Returns: the usual setting with every scalar and zero test, and a title for each. What does not round has only the usual
/// zero test: nothing needs to be tolerated.
std::vector<std::pair<std::string, Setting>> scalars_and_zero_tests(const Settings& settings) {
  std::vector<std::pair<std::string, Setting>> all;
  for (const std::string& scalar : settings.scalars())
    for (const std::string& zero_test : settings.zero_tests()) {
      Setting setting = settings.usual();
      if (scalar == "exact" && zero_test != setting.zero_test) continue;
      setting.scalar = scalar;
      setting.zero_test = zero_test;
      all.emplace_back(scalar + ", " + zero_test, setting);
    }
  return all;
}

std::string zero_tests_table(const Settings& settings) {
  std::vector<Column> columns;
  for (const auto& [title, setting] : scalars_and_zero_tests(settings))
    if (setting.scalar != "exact") columns.push_back(column(settings, title, setting, words_of_failures));
  return rate_table(settings, columns);
}

std::string limits_table(const Settings& settings) {
  if (is_certified(settings.usual().rules)) return "Certified answers have no limit.\n";
  std::vector<Column> columns;
  for (const int limit : settings.limits()) {
    Setting setting = settings.usual();
    setting.limit = limit;
    columns.push_back(column(settings, "at most " + std::to_string(limit), setting,
                             [](const Counts& counts) { return in_words(undecided_rate(counts)); }));
  }
  return rate_table(settings, columns);
}

/// Returns: "8.4", of both sets together.
std::string support_calls(const Counts& counts) {
  if (counts.pairs == 0) return "";
  return with_decimals(1, static_cast<double>(counts.support_calls) / static_cast<double>(counts.pairs));
}

std::string iterations_table(const Settings& settings) {
  const Setting usual = settings.usual();
  return table(settings, {column(settings, "hits: mean, 99 %, max", usual,
                                 [](const Counts& counts) { return words_of(counts.hit_iterations); }),
                          column(settings, "misses: mean, 99 %, max", usual,
                                 [](const Counts& counts) { return words_of(counts.miss_iterations); }),
                          column(settings, "support calls a query", usual, support_calls)});
}

std::string head(const Settings& settings, const std::string& title) {
  const Header& header = settings.study().header;
  return "# " + title + "\n\nMade by `" + header.command + "` with seed " + std::to_string(header.seed) +
         ", gjkstep-study " + header.version + ", compiled by " + header.compiler + ".\n\n";
}

constexpr const char* of_round_shapes =
    "Certified answers about sets of points, and about balls, are never undecided; about cylinders, whose points are "
    "computed, they are where these are known too badly. Balls and cylinders take no second search and have no "
    "certificate. ";

constexpr const char* of_second_searches =
    " A certified answer about points takes the same search first; how often a second follows, and its iterations, is in "
    "certified.md.";

std::string how_to_read(const Settings& settings) {
  return "Rates are shares of the pairs asked where a table names no others, with the ends of their 95 % score "
         "intervals (Wilson 1927); where "
         "nothing was seen, only the upper end. Families that were listed to the last pair are a census, \"of all\", "
         "and have none. Unless a table says otherwise: " +
         described(settings.usual()) + ". " + (settings.certified().empty() ? "" : of_round_shapes) +
         "Every combination is in study.csv, which the command writes.\n\n";
}

// -- Certified answers ------------------------------------------------------------------------------------------------

/// Returns: "0.2".
std::string share_of_second_searches(const Tally& tally) {
  const Histogram& all = tally.second_iterations;
  return in_short(static_cast<double>(total(without_none(all))) / static_cast<double>(total(all)));
}

/// Returns: "3.74, 8": mean and largest; "" where there was none.
std::string iterations_of_second_searches(const Tally& tally) {
  const Histogram some = without_none(tally.second_iterations);
  if (total(some) == 0) return "";
  const Spread spread = spread_of(some);
  return with_decimals(2, spread.mean) + ", " + std::to_string(spread.max);
}

std::string nanoseconds_of(const Timing& timing) {
  return timing.queries == 0 ? "" : with_decimals(0, timing.per_query());
}

std::string microseconds(std::uint64_t nanoseconds) {
  return with_decimals(1, static_cast<double>(nanoseconds) / 1000);
}

/// Returns: "13.2: 4711", microseconds and the index of the pair.
std::string slowest_of(const TimesAlone& alone) {
  return alone.slowest == 0 ? "" : microseconds(alone.slowest) + ": " + std::to_string(alone.slowest_pair);
}

/// A column of the rows of one certified setting; empty where it was not asked.
Column certified_column(const Settings& settings, std::string heading, const Setting& setting,
                        const std::function<std::string(const Row&)>& words) {
  return {std::move(heading), [&settings, setting, words](const FamilyNote& family) {
            const Row* const row = settings.find(family.name, setting);
            return row && total(row->tally.second_iterations) > 0 ? words(*row) : "";
          }};
}

/// Returns: "all hold", "2 do not hold".
std::string words_of_certificates(const Tally& tally) {
  return tally.false_certificates == 0 ? "all hold" : std::to_string(tally.false_certificates) + " do not hold";
}

/// Returns: all families in a few sentences.
std::string summary(const Settings& settings, const Setting& setting) {
  Counts counts;
  Tally tally;
  TimesAlone alone;
  std::string slowest;
  for (const FamilyNote& family : settings.study().families) {
    const Row* const row = settings.find(family.name, setting);
    if (row == nullptr || total(row->tally.second_iterations) == 0) continue;
    if (row->alone.slowest > alone.slowest) slowest = family.name;
    counts += *settings.counts(family.name, setting);
    tally += row->tally;
    alone += row->alone;
  }
  if (counts.pairs == 0) return "No pair was asked.\n";
  std::string text = std::to_string(counts.pairs) + " pairs: " + std::to_string(counts.wrong()) + " wrong, " +
                     std::to_string(counts.undecided) + " undecided. " + std::to_string(tally.certificates) +
                     " certificates, those of the first pairs of each family, were multiplied out in fractions: " +
                     words_of_certificates(tally) + ". " + share_of_second_searches(tally) +
                     " of the pairs took a second search";
  if (const Histogram some = without_none(tally.second_iterations); total(some) > 0)
    text += ", of " + with_decimals(2, spread_of(some).mean) + " iterations in the mean and " +
            std::to_string(spread_of(some).max) + " at most";
  text += ".";
  if (alone.one_search.queries > 0) text += " Without it a query took " + nanoseconds_of(alone.one_search) + " ns.";
  if (alone.two_searches.queries > 0) text += " With it a query took " + nanoseconds_of(alone.two_searches) + " ns.";
  if (!slowest.empty())
    text += " The slowest, pair " + std::to_string(alone.slowest_pair) + " of " + slowest + ", took " +
            microseconds(alone.slowest) + " µs.";
  return text + "\n";
}

std::string certified_table(const Settings& settings, const Setting& setting) {
  const auto counted = [&](std::string heading, std::string (*words)(const Counts&)) {
    return column(settings, std::move(heading), setting, words);
  };
  const auto told = [&](std::string heading, std::string (*words)(const Row&)) {
    return certified_column(settings, std::move(heading), setting, words);
  };
  return table(
      settings,
      {counted("pairs", [](const Counts& counts) { return std::to_string(counts.pairs); }),
       counted("wrong", [](const Counts& counts) { return std::to_string(counts.wrong()); }),
       counted("undecided", [](const Counts& counts) { return std::to_string(counts.undecided); }),
       told("second searches: share", [](const Row& row) { return share_of_second_searches(row.tally); }),
       told("iterations of these: mean, max", [](const Row& row) { return iterations_of_second_searches(row.tally); }),
       told("ns without", [](const Row& row) { return nanoseconds_of(row.alone.one_search); }),
       told("ns with", [](const Row& row) { return nanoseconds_of(row.alone.two_searches); }),
       told("slowest, µs: pair", [](const Row& row) { return slowest_of(row.alone); })});
}

// -- Timings ----------------------------------------------------------------------------------------------------------

std::string time_of(const Settings& settings, const std::string& family, const Setting& setting) {
  const Row* const row = settings.find(family, setting);
  const int limit = limit_for(setting.rules, setting.limit);
  if (row == nullptr || !row->timings.contains(limit)) return "";
  return nanoseconds_of(row->timings.at(limit));
}

std::string times_table(const Settings& settings) {
  std::vector<std::pair<std::string, Setting>> all;
  if (!is_certified(settings.usual().rules)) all = scalars_and_zero_tests(settings);
  for (const auto& each : settings.certified()) all.push_back(each);
  std::vector<Column> columns;
  for (const auto& [title, setting] : all)
    columns.push_back({title, [&settings, setting = setting](const FamilyNote& family) {
                         return time_of(settings, family.name, setting);
                       }});
  return table(settings, columns);
}

/// Returns: "4.19", the mean over hits and misses.
std::string iterations_per_query(const Counts& counts) {
  Histogram all = counts.hit_iterations;
  add(all, counts.miss_iterations);
  return with_decimals(2, spread_of(all).mean);
}

/// Why float is not the faster one, where this run shows that it is not, with the compiler that this was measured with.
std::string float_and_double(const Settings& settings) {
  if (settings.study().families.empty() || !settings.study().header.compiler.starts_with("GNU 12.")) return "";
  const std::string& family = settings.study().families.front().name;
  Setting narrow = settings.usual(), wide = settings.usual();
  narrow.scalar = "float";
  wide.scalar = "double";
  const auto in_float = settings.counts(family, narrow), in_double = settings.counts(family, wide);
  if (!in_float || !in_double) return "";
  const Timings &float_times = settings.find(family, narrow)->timings,
                &double_times = settings.find(family, wide)->timings;
  if (float_times.empty() || double_times.empty() ||
      float_times.at(narrow.limit).per_query() < double_times.at(wide.limit).per_query())
    return "";
  return "\nFloat is not the faster one, and not for more iterations (" + family + ": " +
         iterations_per_query(*in_float) + " in float, " + iterations_per_query(*in_double) +
         " in double) but for how GCC 12 packs the three numbers of a point into vector registers: compiled with "
         "-fno-tree-slp-vectorize, which forbids that, float takes no longer than double.\n";
}

}  // namespace

std::string processors_of(const Study& study) {
  std::string text;
  for (const std::string& processor : study.processors) text += (text.empty() ? "" : " and ") + processor;
  return text;
}

std::string in_short(double value) {
  if (value == 0) return "0";
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", value);
  std::string words = text;
  const std::size_t at = words.find("e-0");  // "3.1e-05" is longer than it need be
  return at == std::string::npos ? words : words.erase(at + 2, 1);
}

std::string in_words(const Rate& rate) {
  if (rate.trials == 0) return no_pairs;
  if (!rate.has_interval()) return in_short(rate.share()) + " of all";
  const Interval interval = rate.interval();
  if (rate.count == 0) return "0 (< " + in_short(interval.high) + ")";
  return in_short(rate.share()) + " (" + in_short(interval.low) + " – " + in_short(interval.high) + ")";
}

std::string counts_markdown(const Settings& settings) {
  return head(settings, "Accuracy") + how_to_read(settings) + families_table(settings) +
         "\n## Wrong or undecided, by scalar\n\n" + scalars_table(settings, words_of_failures) +
         "\n## Iterations\n\nHits and misses by truth; an undecided query counts with the iterations that it "
         "took." +
         (settings.certified().empty() ? "" : of_second_searches) + "\n\n" + iterations_table(settings);
}

std::string errors_markdown(const Settings& settings) {
  std::string text = head(settings, "Errors of each kind") + how_to_read(settings) +
                     "A false positive can only happen to a pair that is apart, a false negative only to one that "
                     "meets: each is told as a share of these. A family without such pairs says so.\n";
  for (const std::string scalar : {"double", "float"})
    if (std::ranges::find(settings.scalars(), scalar) != settings.scalars().end()) {
      Setting setting = settings.usual();
      setting.scalar = scalar;
      text += "\n## In " + scalar + "\n\n" + errors_table(settings, setting);
    }
  for (const auto& [title, setting] : settings.certified())
    if (setting.rules != settings.usual().rules)
      text += "\n## " + title + "\n\n" + errors_table(settings, setting);
  return text +
         "\n## Undecided, by scalar\n\nIn circles: a simplex and a direction came back, so no limit would have "
         "helped.\n\n" +
         scalars_table(settings, words_of_undecided);
}

std::string settings_markdown(const Settings& settings) {
  return head(settings, "What the other settings change") + how_to_read(settings) +
         "## Wrong or undecided, by rules\n\n" + rules_table(settings) + "\n## Wrong or undecided, by zero test\n\n" +
         zero_tests_table(settings) + "\n## Undecided, by iteration limit\n\n" + limits_table(settings);
}

std::string timings_markdown(const Settings& settings) {
  return head(settings, "Speed") + "Measured on " + processors_of(settings.study()) +
         ", by the CPU clock of the thread that asks (CLOCK_THREAD_CPUTIME_ID), which stands still while the processor "
         "serves others. Nanoseconds per query: " +
         described(settings.usual()) +
         "; columns vary scalar and zero test. Shapes are made before the clock starts. The methods take turns with "
         "the "
         "same batch of up to 256 pairs, each limit after a pass with which the caches warm up, and another limit "
         "first in each turn; of five turns, of exact "
         "numbers three and 16 pairs, the median counts. One reading of the clock in each batch is part of it. Balls "
         "and cylinders pay for the choice of the form at each support call. " +
         (settings.certified().empty() ? "" : of_round_shapes) + "\n\n" + times_table(settings) +
         float_and_double(settings);
}

std::string certified_markdown(const Settings& settings) {
  if (settings.certified().empty()) return "";
  std::string text = head(settings, "Certified answers") + of_round_shapes +
                     "Where the first search proves nothing a second one follows. Each pair is timed alone by the CPU "
                     "clock of the thread that asks, on " +
                     processors_of(settings.study()) +
                     "; reading the clock once is part of it, caches and branches have just seen other pairs, and of "
                     "the slowest pair the least of five askings counts.\n";
  for (const auto& [title, setting] : settings.certified())
    text += "\n## " + title + "\n\n" + summary(settings, setting) + "\n" + certified_table(settings, setting);
  return text;
}

}  // namespace study
