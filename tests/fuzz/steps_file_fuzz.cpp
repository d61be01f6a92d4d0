/// Whatever a judged program writes: each line is a step, an answer or none, with the reason; steps are followed, and where one goes
/// wrong both ways on are told as a story.
///
///     cmake -S . -B build/fuzz -G Ninja -DGJKSTEP_FUZZ=ON -DCMAKE_CXX_COMPILER=clang++
///     ninja -C build/fuzz steps-file-fuzz
///     sh tests/fuzz/words.sh tests/fuzz/steps > build/fuzz/words.dict
///     mkdir -p build/fuzz/found-steps
///     build/fuzz/steps-file-fuzz -dict=build/fuzz/words.dict -max_len=4096 -timeout=10 -rss_limit_mb=512
///         build/fuzz/found-steps tests/fuzz/steps
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "walkthroughs/judge/answer.hpp"
#include "walkthroughs/pairs/named_pair.hpp"
#include "walkthroughs/steps/check_steps.hpp"
#include "walkthroughs/steps/differences.hpp"
#include "walkthroughs/steps/mistakes.hpp"
#include "walkthroughs/steps/parting.hpp"

namespace {

using namespace walkthroughs::steps;
using walkthroughs::judge::Said;

void require(bool holds) {
  if (!holds) std::abort();
}

void require_told(ToldRun run) {
  bring_to_differences(run);
  for (const StepFinding& found : check_steps(run).findings) {
    require(found.iteration >= 1 && found.iteration <= static_cast<int>(run.steps.size()));
    require(!found.words.empty());
    require(std::ranges::all_of(found.mistakes, [](std::size_t m) { return m < mistakes().size(); }));
    if (found.kind != StepFinding::wrong) continue;
    if (const auto parting = parting_of(run, found)) require(!parting->story().frames.empty());
  }
}

/// Searches, each behind the pair that it is about, as far as they can be read.
std::vector<ToldRun> told_in(const std::vector<std::string_view>& lines) {
  std::vector<ToldRun> runs;
  for (const std::string_view line : lines) try {
      if (is_meant_as_step(line)) {
        const ToldStep step = read_step(line);
        if (!runs.empty()) runs.back().steps.push_back(step);
      } else if (const auto pair = walkthroughs::pairs::points_of(walkthroughs::pairs::pair_of_line(line, "p").pair)) {
        runs.push_back({"p", *pair});
      }
    } catch (const std::invalid_argument& reason) {
      require(*reason.what() != '\0');
    }
  return runs;
}

/// As an answer about two tetrahedra that have a corner in common.
void require_answer(std::string_view line) {
  static const walkthroughs::pairs::Pair pair{
      walkthroughs::model::Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
      walkthroughs::model::Points{{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
  const auto answer = walkthroughs::judge::read_answer(line, pair);
  require((answer.said == Said::nothing) == !answer.why.empty());
  require(answer.said != Said::separated || answer.evidence != walkthroughs::judge::Evidence::holds);  // they do touch
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  std::vector<std::string_view> lines;
  for (std::size_t begin = 0; begin < size; begin = std::min(text.find('\n', begin), size - 1) + 1)
    lines.push_back(text.substr(begin, text.find('\n', begin) - begin));
  for (const std::string_view line : lines) require_answer(line);
  for (const ToldRun& run : told_in(lines)) require_told(run);
  return 0;
}
