/// Where a program fails, its steps, if it tells them: the first that the report's algorithm would not make.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tests/study/judge/asking.hpp"
#include "tests/study/judge/judged.hpp"
#include "tests/study/steps/check_steps.hpp"

namespace study {

/// What the steps of one failure say.
struct JudgedSteps {
  std::string pair;                     ///< its name
  std::optional<StepsChecked> checked;  ///< empty where there is nothing to check
  std::string why = {};                 ///< it is empty
};

/// The first failures, of each family at most one, are asked again, each alone in a run of the program whose environment has JUDGE_STEPS:
/// before its answer it then writes its steps, as told_run.hpp says.
///
/// Returns: one for each failure that was asked, at most `most`. Errors: those of run_program().
std::vector<JudgedSteps> steps_of_failures(const AskedProgram& program, const ProgramJudged& judged, std::size_t most);

/// Returns: a section of Markdown; nothing where nothing failed.
std::string steps_markdown(const std::vector<JudgedSteps>& all);

}  // namespace study
