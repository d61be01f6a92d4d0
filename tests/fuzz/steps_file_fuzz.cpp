/// Whatever a file for `gjkstep-study check-steps` holds: its searches are read and followed, and where one goes wrong both ways on
/// are told as a story; or it is turned away with an InputError that names it. And whatever a line that a judged program writes
/// holds, it is an answer or none, with the reason.
///
///     cmake -S . -B build/fuzz -G Ninja -DGJKSTEP_FUZZ=ON -DGJKSTEP_STUDY=ON -DCMAKE_CXX_COMPILER=clang++
///     ninja -C build/fuzz steps-file-fuzz
///     sh tests/fuzz/words.sh tests/fuzz/steps > build/fuzz/words.dict
///     mkdir -p build/fuzz/found-steps
///     build/fuzz/steps-file-fuzz -dict=build/fuzz/words.dict -max_len=4096 -timeout=10 -rss_limit_mb=512
///         build/fuzz/found-steps tests/fuzz/steps
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/study/methods/mistakes.hpp"
#include "tests/study/steps/check_steps.hpp"
#include "tests/study/steps/parting.hpp"
#include "walkthroughs/judge/answer.hpp"
#include "walkthroughs/text/text_file.hpp"

namespace {

using namespace study;

void require(bool holds) {
  if (!holds) std::abort();
}

std::vector<ToldRun> runs_or_reason(std::string_view text) {
  try {
    return read_told_runs(text, "fuzz.jsonl");
  } catch (const walkthroughs::text::InputError& error) {
    require(std::string_view(error.what()).starts_with("fuzz.jsonl:"));
    return {};
  }
}

void require_told(const ToldRun& run) {
  const StepsChecked checked = check_steps(run);
  require(checked.iteration >= 0 && checked.iteration <= static_cast<int>(run.steps.size()) + 1);
  require((checked.iteration == 0) == checked.words.empty());
  require(std::ranges::all_of(checked.mistakes, [](std::size_t m) { return m < mistakes().size(); }));
  const std::optional<Parting> parting = parting_of(run, checked);
  require(parting.has_value() == (checked.iteration > 0));
  if (parting) require(!parting->story().frames.empty());
}

/// As an answer about two tetrahedra that have a corner in common.
void require_answer(std::string_view line) {
  static const Pair pair{Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                         Points{{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
  const auto answer = walkthroughs::judge::read_answer(line, pair);
  require((answer.said == Said::nothing) == !answer.why.empty());
  require(answer.said != Said::separated || answer.evidence != walkthroughs::judge::Evidence::holds);  // they do touch
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const ToldRun& run : runs_or_reason(text)) require_told(run);
  for (std::size_t begin = 0; begin < size; begin = std::min(text.find('\n', begin), size - 1) + 1)
    require_answer(text.substr(begin, text.find('\n', begin) - begin));
  return 0;
}
