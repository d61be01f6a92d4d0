#include "walkthroughs/query/query.hpp"

#include <concepts>
#include <nlohmann/json.hpp>

#include "core/gjk.hpp"
#include "core/rule_sets.hpp"
#include "render/json_text.hpp"
#include "walkthroughs/query/prepared_pair.hpp"
#include "walkthroughs/query/query_certified.hpp"
#include "walkthroughs/query/query_evidence.hpp"

namespace walkthroughs::query {

template <class S>
gjk::Result<S> searched(const PreparedPair<S>& pair, const QueryOptions& query) {
  const auto search = [&]<class Rules>() { return gjk::collision<S, Rules>(pair.a, pair.b, pair.options); };
  if constexpr (std::floating_point<S>)
    return gjk::with_rules(query.rules, query.zero_test, search);
  else  // what does not round has nothing to tolerate: both zero tests are this one
    return gjk::with_rules<gjk::ExactZeroTest>(query.rules, search);
}
template gjk::Result<float> searched(const PreparedPair<float>&, const QueryOptions&);
template gjk::Result<double> searched(const PreparedPair<double>&, const QueryOptions&);
template gjk::Result<long double> searched(const PreparedPair<long double>&, const QueryOptions&);
template gjk::Result<gjk::Fraction> searched(const PreparedPair<gjk::Fraction>&, const QueryOptions&);
template PreparedPair<gjk::Fraction> prepared(PairAsWritten&&, const QueryOptions&);

namespace {

template <class S>
void answer_in(PairAsWritten&& pair, const QueryOptions& query, std::string& out) {
  write_answer(searched(prepared<S>(std::move(pair), query), query), out);
}

void answer(PairAsWritten&& pair, const QueryOptions& query, std::string& out) {
  if (query.evidence != QueryEvidence::of_the_search) return answer_certified(std::move(pair), query, out);
  switch (query.scalar) {
    case QueryScalar::binary32: return answer_in<float>(std::move(pair), query, out);
    case QueryScalar::binary64: return answer_in<double>(std::move(pair), query, out);
    case QueryScalar::long_double: return answer_in<long double>(std::move(pair), query, out);
    case QueryScalar::exact: return answer_in<gjk::Fraction>(std::move(pair), query, out);
  }
}

/// Returns: what a line notes for its writer, as the first members of its answer: "\"name\":\"one\",\"id\":7,".
/// Requires: that the line was read.
std::string repeated(std::string_view line) {
  const auto all = nlohmann::ordered_json::parse(line, nullptr, false);
  std::string text;
  for (const auto& [key, value] : all.items())
    if (reading::is_note(key)) text += render::json_text(nlohmann::json(key)) + ":" + render::json_text(value) + ",";
  return text;
}

void write_error(const std::string& reason, std::size_t line_number, std::string& out) {
  using Json = nlohmann::ordered_json;
  // What was read may be in the reason, and need not be UTF-8.
  out += render::json_text(Json{{"error", reason}, {"line", line_number}}) + "\n";
}

void write_too_long(std::size_t line_number, std::string& out) {
  write_error("the line is longer than " + std::to_string(query_limits::line >> 20) + " MiB; give fewer points",
              line_number, out);
}

}  // namespace

bool answer_line(std::string_view line, std::size_t line_number, const QueryOptions& options, std::string& out) {
  Reading<PairAsWritten> pair = read_pair(line, options);
  const std::size_t begin = out.size();
  const bool has_notes = pair.value.has_notes;
  if (pair.complaint)
    write_error(pair.complaint->text(), line_number, out);
  else
    answer(std::move(pair.value), options, out);
  if (has_notes) out.insert(begin + 1, repeated(line));
  return !pair.complaint;
}

QueryTally answer_lines(const QueryOptions& options, const ReadSome& read, const Write& write) {
  constexpr std::size_t enough = 1 << 16;
  QueryTally tally;
  std::string out;
  const auto write_answers = [&] {
    if (!out.empty()) write(out);
    out.clear();
  };
  const auto write_then_read = [&](std::span<char> bytes) {
    write_answers();
    return read(bytes);
  };
  LineReader lines(write_then_read, query_limits::line);
  while (const auto line = lines.next()) {
    ++tally.lines;
    const bool good = !line->is_too_long && answer_line(line->text, tally.lines, options, out);
    if (line->is_too_long) write_too_long(tally.lines, out);
    if (!good && ++tally.bad == 1) tally.first_bad = tally.lines;
    if (out.size() >= enough) write_answers();
  }
  write_answers();
  return tally;
}

}  // namespace walkthroughs::query
