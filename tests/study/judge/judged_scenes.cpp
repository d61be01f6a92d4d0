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

namespace limits = walkthroughs::scene_limits;

std::string kind_of(const Judged& judged) {
  return judged.false_evidence ? "false evidence"
                               : std::string(verdict_words[static_cast<std::size_t>(judged.verdict)]);
}

bool fits(const Pair& pair) {
  const auto few = [](const Body& body) {
    const auto* const points = std::get_if<Points>(&body);
    return !points || points->size() <= limits::points;
  };
  return few(pair.a) && few(pair.b) &&
         std::max(walkthroughs::largest_number(pair.a), walkthroughs::largest_number(pair.b)) <= limits::magnitude;
}

/// Of plain letters, whatever others have called the pair.
std::string file_name(const std::string& words) {
  std::string name = words.substr(0, 100);
  for (char& letter : name)
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0 && letter != '.') letter = '-';
  return name + ".json";
}

std::string title_of(const Judged& judged) {
  const std::string title = kind_of(judged) + ": " + walkthroughs::printable(judged.named.name);
  return title.size() <= limits::title ? title : kind_of(judged);
}

std::string truth_of(const Judged& judged) {
  return judged.truth == Truth::intersecting ? "They have a point in common." : "They are apart.";
}

std::string scene_of(const Judged& judged, const std::string& program) {
  const std::string question = question_line(judged.named.pair);
  return "// " + walkthroughs::printable(program) + ", pair " + walkthroughs::printable(judged.named.name) + ": " +
         kind_of(judged) + ". " + truth_of(judged) +
         "\n// What is drawn is the report's algorithm, not that program.\n" +
         "{\"title\": " + nlohmann::json(title_of(judged)).dump() + ",\n" + question.substr(1) + "\n";
}

}  // namespace

std::vector<JudgedScene> judged_scenes(const ProgramJudged& judged, const std::string& program, std::uint64_t most) {
  std::vector<JudgedScene> scenes;
  std::map<std::pair<std::string, std::string>, std::uint64_t> count;
  for (const Judged& each : judged.pairs) {
    const bool is_failure = each.is_wrong() || each.verdict == Verdict::undecided;
    if (!is_failure || !fits(each.named.pair)) continue;
    if (count[{each.named.family, kind_of(each)}]++ >= most) continue;
    scenes.push_back(
        {file_name(kind_of(each) + "-" + each.named.name), title_of(each), truth_of(each), scene_of(each, program)});
  }
  return scenes;
}

}  // namespace study
