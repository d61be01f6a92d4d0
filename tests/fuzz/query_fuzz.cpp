/// Whatever a stream of queries holds: each line gets one line, an answer or an error that names it, in every scalar and by all
/// rules; an answer about points that is certified has a certificate that holds; and the quick way through lines finds what the other
/// reader finds.
///
///     cmake -S . -B build/fuzz -G Ninja -DGJKSTEP_FUZZ=ON -DCMAKE_CXX_COMPILER=clang++
///     ninja -C build/fuzz query-fuzz
///     sh tests/fuzz/words.sh tests/fuzz/queries > build/fuzz/words.dict
///     mkdir -p build/fuzz/found-queries
///     build/fuzz/query-fuzz -dict=build/fuzz/words.dict -max_len=4096 -timeout=10 -rss_limit_mb=512
///         build/fuzz/found-queries tests/fuzz/queries
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "tests/kit/certificates.hpp"
#include "tests/walkthroughs/text/same_tree.hpp"
#include "walkthroughs/query/query.hpp"

namespace {

using namespace walkthroughs;
using namespace walkthroughs::program;

void require(bool holds) {
  if (!holds) std::abort();
}

std::string complaint_of(const Document& document) { return document.complaint() ? document.complaint()->text() : ""; }

void require_same_tree(std::string_view line) {
  const Document quick = Document::of_line(line), slow(line, Document::Comments::refused);
  const std::string complaint = complaint_of(quick);
  require(complaint == complaint_of(slow) || complaint == "the line is empty");  // which is no empty file
  require(test::same_tree(quick.root(), slow.root()));
}

/// Requires: a line that was answered.
void require_proven(std::string_view line, const nlohmann::json& said, const QueryOptions& options) {
  const auto pair = nlohmann::json::parse(line);
  if (options.scalar == QueryScalar::binary32)
    require(kit::is_proven(said, kit::set_in<float>(pair["a"]), kit::set_in<float>(pair["b"])));
  else
    require(kit::is_proven(said, kit::set_in<double>(pair["a"]), kit::set_in<double>(pair["b"])));
}

/// Returns: the first line, which is taken away with its line feed.
std::string_view next_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

void require_lines(std::string_view text, std::string_view answers, const QueryTally& tally,
                   const QueryOptions& options) {
  require(answers.empty() || answers.back() == '\n');
  std::size_t lines = 0, bad = 0;
  while (!answers.empty()) {
    const std::string_view line = next_line(text);
    const auto said = nlohmann::json::parse(next_line(answers));  // throws where it is not JSON
    ++lines;
    if (said.contains("error")) {
      require(said["line"] == lines && ++bad > 0);
      continue;
    }
    require(said.contains("status"));
    const bool is_about_points = said.contains("second_iterations");
    if (options.evidence == QueryEvidence::of_the_search || is_about_points)
      require(said["iterations"].get<int>() <= 20);
    else
      require(said["status"] == "undecided" ? said.contains("gap") : said.contains("proof"));
    if (is_about_points) require_proven(line, said, options);
  }
  require(lines == tally.lines && bad == tally.bad);
}

/// Requires: `lines` is how many the text has.
void require_answers(std::string_view text, std::size_t lines, const QueryOptions& options) {
  std::string_view rest = text;
  const auto read = [&](std::span<char> bytes) {  // in parts of some odd size
    const std::size_t count = std::min({bytes.size(), rest.size(), std::size_t{61}});
    if (count != 0) std::memcpy(bytes.data(), rest.data(), count);
    rest.remove_prefix(count);
    return count;
  };
  std::string answers;
  const QueryTally tally = answer_lines(options, read, [&](std::string_view part) { answers += part; });
  require(tally.lines == lines);
  require_lines(text, answers, tally, options);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (std::size_t begin = 0; begin < size; begin = std::min(text.find('\n', begin), size - 1) + 1)
    require_same_tree(text.substr(begin, text.find('\n', begin) - begin));
  const auto lines = static_cast<std::size_t>(std::ranges::count(text, '\n')) + (size && text.back() != '\n');
  for (const auto& rules : gjk::rule_sets) {
    for (int scalar = 0; scalar < static_cast<int>(query_scalars.size()); ++scalar)
      require_answers(text, lines, {.scalar = static_cast<QueryScalar>(scalar), .rules = rules.value});
    for (const QueryScalar scalar : {QueryScalar::binary32, QueryScalar::binary64})
      for (const QueryEvidence evidence : {QueryEvidence::certificate, QueryEvidence::fractions})
        for (const auto& start : {std::optional<QueryStart>(), std::optional(QueryStart::inside)})
          require_answers(text, lines, {.scalar = scalar, .rules = rules.value, .start = start, .evidence = evidence});
  }
  return 0;
}
