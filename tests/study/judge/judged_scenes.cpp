#include "tests/study/judge/judged_scenes.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/text/scene_limits.hpp"

namespace study {
namespace {

namespace limits = walkthroughs::text::scene_limits;

std::string kind_of(const Judged& judged) {
  return judged.false_evidence ? "false evidence"
                               : std::string(verdict_words[static_cast<std::size_t>(judged.verdict)]);
}

bool fits(const Pair& pair) {
  const auto few = [](const Body& body) {
    const auto* const points = std::get_if<Points>(&body);
    return !points || points->size() <= limits::points;
  };
  return few(pair.a) && few(pair.b) && std::max(largest_number(pair.a), largest_number(pair.b)) <= limits::magnitude;
}

/// Of plain letters, whatever others have called the pair.
std::string file_name(const std::string& words) {
  std::string name = words.substr(0, 100);
  for (char& letter : name)
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0 && letter != '.') letter = '-';
  return name + ".json";
}

std::string title_of(const std::string& kind, const std::string& pair) {
  const std::string title = kind + ": " + walkthroughs::text::printable(pair);
  return title.size() <= limits::title ? title : kind;
}

std::string truth_of(const Judged& judged) {
  return judged.truth == Truth::intersecting ? "They have a point in common." : "They are apart.";
}

/// `kind`: of failure. `name`: of the pair.
JudgedScene scene_of(const std::string& kind, const std::string& name, const std::string& truth, const Pair& pair,
                     const std::string& program) {
  const std::string title = title_of(kind, name);
  std::string text = "// " + walkthroughs::text::printable(program) + ", pair " + walkthroughs::text::printable(name) +
                     ": " + kind + ". " + truth + "\n// What is drawn is the report's algorithm, not that program.\n" +
                     "{\"title\": " + nlohmann::json(title).dump() + ",\n" + question_line(pair).substr(1) + "\n";
  return {file_name(kind + "-" + name), title, truth, std::move(text)};
}

}  // namespace

std::vector<JudgedScene> judged_scenes(const ProgramJudged& judged, const std::string& program, std::uint64_t most) {
  std::vector<JudgedScene> scenes;
  std::map<std::pair<std::string, std::string>, std::uint64_t> count;
  for (const Judged& each : judged.pairs) {
    const bool is_failure = each.is_wrong() || each.false_evidence || each.verdict == Verdict::undecided;
    if (!is_failure || !fits(each.named.pair)) continue;
    if (count[{each.named.family, kind_of(each)}]++ >= most) continue;
    scenes.push_back(scene_of(kind_of(each), each.named.name, truth_of(each), each.named.pair, program));
  }
  for (const Change& change : judged.changes)
    if (most > 0 && change.first_pair && fits(*change.first_pair))
      scenes.push_back(scene_of("other answer, " + std::string(change.what), change.first,
                                "The change must not change the answer.", *change.first_pair, program));
  return scenes;
}

}  // namespace study
