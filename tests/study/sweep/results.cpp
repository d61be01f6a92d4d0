#include "tests/study/sweep/results.hpp"

#include <algorithm>
#include <fstream>
#include <iostream>

#include "render/file.hpp"
#include "tests/study/methods/certified.hpp"

namespace study {
namespace {

std::string setting_of(const Row& row) { return row.family + ',' + row.rules + ',' + row.scalar + ',' + row.zero_test; }

std::string families_csv(const Plan& plan) {
  std::string text = "family,pairs,slow_pairs,size,what\n";
  for (const Part& part : plan.parts)
    text += csv_line(part.family->name, part.pairs, part.slow_pairs,
                     part.family->size ? std::to_string(*part.family->size) : "", '"' + part.family->what + '"');
  return text;
}

std::string counts_csv(const Plan& plan, const std::vector<Row>& rows) {
  std::string text =
      "family,rules,scalar,zero_test,limit,pairs,hits,false_positives,false_negatives,undecided,cycles,unusable,"
      "in_doubt,out_of_range,not_askable,truth_changed,exceptions,by_predicates,by_formulas,by_certificates,"
      "certificates,"
      "false_certificates\n";
  for (const Row& row : rows)
    for (const int limit : limits_for(row.rules, plan.limits)) {
      const Counts c = counts_at(row.tally, limit);
      const Tally& t = row.tally;
      text += csv_line(setting_of(row), limit_word(limit), c.pairs, c.hits, c.false_positives, c.false_negatives,
                       c.undecided, c.cycles, c.unusable, c.in_doubt, t.out_of_range, t.not_askable, t.truth_changed,
                       t.exceptions, t.proven[0], t.proven[1], t.proven[2], t.certificates, t.false_certificates);
    }
  return text;
}

/// With the largest limit. Those of a second search are 0 where none was needed.
std::string iterations_csv(const Plan& plan, const std::vector<Row>& rows) {
  std::string text = "family,rules,scalar,zero_test,of,queries_by_iterations\n";
  for (const Row& row : rows) {
    const Counts counts = counts_at(row.tally, limit_for(row.rules, plan.limits.back()));
    text += csv_line(setting_of(row), "hits", csv_text(counts.hit_iterations)) +
            csv_line(setting_of(row), "misses", csv_text(counts.miss_iterations));
    if (is_certified(row.rules))
      text += csv_line(setting_of(row), "second searches", csv_text(row.tally.fallback_iterations));
  }
  return text;
}

std::string timings_csv(const std::vector<Row>& rows) {
  std::string text = "family,rules,scalar,zero_test,limit,queries,nanoseconds\n";
  for (const Row& row : rows)
    for (const auto& [limit, timing] : row.timings)
      text += csv_line(setting_of(row), limit_word(limit), timing.queries, timing.nanoseconds);
  return text;
}

std::string alone_csv(const std::vector<Row>& rows) {
  std::string text =
      "family,rules,scalar,zero_test,without_second_search,nanoseconds_without,with_second_search,nanoseconds_with,"
      "slowest_nanoseconds,slowest_pair\n";
  for (const Row& row : rows)
    if (is_certified(row.rules))
      text += csv_line(setting_of(row), row.alone.one_search.queries, row.alone.one_search.nanoseconds,
                       row.alone.two_searches.queries, row.alone.two_searches.nanoseconds, row.alone.slowest,
                       row.alone.slowest_pair);
  return text;
}

/// How it was made. Times have the processor, too.
std::string head(const Request& request, const Plan& plan) {
  return "# command: " + command_of(request) + "\n# seed: " + std::to_string(request.seed) +
         "\n# version: gjkstep-study " GJKSTEP_VERSION "\n# compiler: " GJKSTEP_COMPILER "\n# shard: " +
         std::to_string(plan.shard.index) + " of " + std::to_string(plan.shard.count) + '\n';
}

}  // namespace

std::vector<Csv> csv_of(const Request& request, const Plan& plan, const std::vector<Row>& rows) {
  const std::string made = head(request, plan), timed = made + "# processor: " + processor() + ", " +
                                                        std::to_string(plan.threads) +
                                                        (plan.threads == 1 ? " thread" : " threads") + '\n';
  return {{"families.csv", made + families_csv(plan)},
          {"iterations.csv", made + iterations_csv(plan, rows)},
          {"timings.csv", timed + timings_csv(rows)},
          {"alone.csv", timed + alone_csv(rows)},
          {"counts.csv", made + counts_csv(plan, rows)}};
}

std::filesystem::path folder_of(const std::filesystem::path& folder, const Shard& shard) {
  if (shard.count == 1) return folder;
  return folder / ("shard-" + std::to_string(shard.index) + "-of-" + std::to_string(shard.count));
}

void write_csv(const std::filesystem::path& folder, const std::vector<Csv>& files) {
  render::make_folder(folder, "choose another with --out");
  for (const Csv& csv : files) {
    render::write_file(folder / csv.name, csv.text);
    std::cout << (folder / csv.name).string() << '\n';
  }
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(std::min(line.find(':') + 2, line.size()));
  return "an unknown processor";
}

std::string contradiction(const Plan& plan, const std::vector<Row>& rows) {
  for (const Row& row : rows) {
    const Counts counts = counts_at(row.tally, limit_for(row.rules, plan.limits.back()));
    std::uint64_t impossible = 0;
    if (is_certified(row.rules))  // points that are computed may leave an answer in doubt
      impossible =
          counts.wrong() + counts.undecided - counts.in_doubt + row.tally.exceptions + row.tally.false_certificates;
    else if (row.rules == "as-intended" && row.scalar == "exact")
      impossible = counts.wrong();
    if (impossible > 0)
      return "family " + row.family + ": of " + std::to_string(counts.pairs) + " answers by rules " + row.rules +
             ", computed in " + row.scalar + ", " + std::to_string(impossible) +
             " were wrong, none, or without a proof that holds, which cannot be: GJK, its proofs or the oracle have an "
             "error; 'gjkstep-study judge -- gjkstep query' finds the pairs";
  }
  return "";
}

}  // namespace study
