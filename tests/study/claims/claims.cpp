#include "tests/study/claims/claims.hpp"

#include "tests/study/methods/mistakes.hpp"

namespace study {
namespace {

/// Returns: the head of a file: how it was made, and its columns.
template <class Names>
std::string head(const ClaimsOptions& options, std::string columns, const Names& names) {
  for (const char* const name : names) columns += std::string(",") + name;
  return "# command: gjkstep-study claims --pairs " + std::to_string(options.pairs) + " --seed " +
         std::to_string(options.seed) +
         "\n# compiler: " GJKSTEP_COMPILER "\n# pairs: " + std::to_string(options.pairs) + "\n" + columns + '\n';
}

std::string in_quotes(const std::string& text) { return '"' + text + '"'; }

std::string row(std::string keys, const auto& counters) {
  for (const std::int64_t number : counters.numbers) keys += ',' + std::to_string(number);
  return keys + '\n';
}

std::string row(const Shape& shape, const std::string& computed, bool is_all, const EffortCounts& counts) {
  std::string text = csv_line(shape.name, computed, shape.hardness == Hardness::random ? "random" : "hard",
                              is_all ? "yes" : "no", in_quotes(shape.what));
  for (const Histogram& histogram : counts.histograms) text.insert(text.size() - 1, ',' + csv_text(histogram));
  return text;
}

std::string effort_csv(const ClaimsOptions& options) {
  std::string text = head(options, "shape,in,kind,all,what", effort_names), in_fractions;
  for (const Shape& shape : claim_shapes()) {
    options.progress("effort: " + shape.name);
    text += row(shape, "double", shape.pairs(options) == shape.size, count_effort(shape, options));
    if (shape.hardness == Hardness::hard_whole)
      in_fractions += row(shape, "fractions", false, count_in_fractions(shape, options));
  }
  return text + in_fractions;
}

std::string moller_csv(const ClaimsOptions& options) {
  std::string text = head(options, "kind,rules,way", compared_names);
  for (const TriangleKind& kind : triangle_kinds()) {
    options.progress("Möller's test: " + kind.name);
    const Comparisons compared = compare_with_moller(kind, options);
    for (std::size_t rules = 0; rules < rules_compared.size(); ++rules)
      for (std::size_t way = 0; way < way_names.size(); ++way)
        text += row(in_quotes(kind.name) + ',' + rules_compared[rules] + ',' + in_quotes(way_names[way]),
                    compared[rules][way]);
  }
  return text;
}

std::string mistakes_csv(const ClaimsOptions& options) {
  std::string text = head(options, "pairs,mistake,name,section", of_mistake_names);
  for (const char* const pairs : mistaken_pairs) {
    options.progress(std::string("mistakes: ") + pairs);
    const MistakeCounts counts = count_mistakes(pairs, options);
    for (std::size_t i = 0; i < counts.size(); ++i)
      text += row(std::string(pairs) + ",M" + std::to_string(i + 1) + ',' + in_quotes(mistakes()[i].name) + ',' +
                      mistakes()[i].section,
                  counts[i]);
  }
  return text;
}

}  // namespace

std::vector<Csv> claims_csv(const ClaimsOptions& options) {
  return {{"claims-effort.csv", effort_csv(options)},
          {"claims-moller.csv", moller_csv(options)},
          {"claims-mistakes.csv", mistakes_csv(options)}};
}

}  // namespace study
