/// Whatever a stream of queries holds: each line gets one line, an answer or an error that names it, in every scalar and by all
/// rules; and
/// the quick way through lines finds what the other reader finds.
///
///     cmake -S . -B build/fuzz -G Ninja -DGJKSTEP_FUZZ=ON -DCMAKE_CXX_COMPILER=clang++
///     ninja -C build/fuzz query-fuzz
///     mkdir -p build/fuzz/found-queries
///     build/fuzz/query-fuzz -dict=tests/fuzz/scene_file.dict -max_len=4096 -timeout=10 -rss_limit_mb=512
///         build/fuzz/found-queries tests/fuzz/queries
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "tests/walkthroughs/text/same_tree.hpp"
#include "walkthroughs/query/query.hpp"

namespace {

using namespace walkthroughs;

void require(bool holds) {
  if (!holds) std::abort();
}

template <class Read>
std::optional<Document> tree(Read&& read, std::string& complaint) {
  try {
    return read();
  } catch (const DocumentError& error) {
    complaint = error.key + ": " + error.what();
    return std::nullopt;
  }
}

void require_same_tree(std::string_view line) {
  std::string complaint, other_complaint;
  const auto quick = tree([&] { return Document::of_line(line); }, complaint);
  const auto slow = tree([&] { return Document(line, Document::Comments::refused); }, other_complaint);
  require(quick.has_value() == slow.has_value() && complaint == other_complaint);
  if (quick) require(test::same_tree(quick->root(), slow->root()));
}

void require_lines(std::string_view answers, const QueryTally& tally) {
  std::size_t lines = 0, bad = 0;
  for (std::size_t end; !answers.empty(); answers.remove_prefix(end + 1)) {
    end = answers.find('\n');
    require(end != std::string_view::npos);
    const auto said = nlohmann::json::parse(answers.substr(0, end));  // throws where it is not JSON
    ++lines;
    if (said.contains("error")) require(said["line"] == lines && ++bad > 0);
    if (!said.contains("error")) require(said.contains("status") && said["iterations"].get<int>() <= 20);
  }
  require(lines == tally.lines && bad == tally.bad);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (std::size_t begin = 0; begin < size; begin = std::min(text.find('\n', begin), size - 1) + 1)
    require_same_tree(text.substr(begin, text.find('\n', begin) - begin));
  const auto lines_in = static_cast<std::size_t>(std::ranges::count(text, '\n')) + (size && text.back() != '\n');
  for (int scalar = 0; scalar < static_cast<int>(query_scalars.size()); ++scalar)
    for (const auto& rules : gjk::rule_sets) {
      std::string_view rest = text;
      const auto read = [&](std::span<char> bytes) {  // in parts of some odd size
        const std::size_t count = std::min({bytes.size(), rest.size(), std::size_t{61}});
        if (count != 0) std::memcpy(bytes.data(), rest.data(), count);
        rest.remove_prefix(count);
        return count;
      };
      std::string answers;
      const QueryOptions options{.scalar = static_cast<QueryScalar>(scalar), .rules = rules.value};
      const QueryTally tally = answer_lines(options, read, [&](std::string_view part) { answers += part; });
      require(tally.lines == lines_in);
      require_lines(answers, tally);
    }
  return 0;
}
