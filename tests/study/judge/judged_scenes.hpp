/// What went wrong, as scene files that `gjkstep render` draws.
#pragma once

#include <string>
#include <vector>

#include "tests/study/judge/judged.hpp"

namespace study {

struct JudgedScene {
  std::string name;   ///< of the file: "wrong-no-boxes-7.json"
  std::string title;  ///< "wrong no: boxes-7"
  std::string truth;  ///< in a sentence
  std::string text;
};

/// Returns: the first of each family and kind, at most `most` of them, and of each change that must not matter the first pair whose
/// answer it changed. Left out is what no scene can hold: too large a number.
std::vector<JudgedScene> judged_scenes(const ProgramJudged& judged, const std::string& program, std::uint64_t most);

}  // namespace study
