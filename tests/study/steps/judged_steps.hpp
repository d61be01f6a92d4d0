/// Where a program fails, its steps, if it tells them: the first that the report's algorithm would not make.
#pragma once

#include <cstddef>
#include <vector>

#include "tests/study/judge/asking.hpp"
#include "tests/study/judge/judged.hpp"

namespace study {

/// Failures, of each family the one that is easiest to read (the fewest points, small whole numbers), these in the same order, are
/// asked again, each alone in a run of the program whose environment has JUDGE_STEPS: before its answer it then writes its steps,
/// as told_run.hpp says. Draws the first `pictures` that have a wrong step.
///
/// Returns: one for each failure that was asked, at most `most`. Errors: those of run_program(); those of drawing.
std::vector<JudgedSteps> steps_of_failures(const AskedProgram& program, const ProgramJudged& judged, std::size_t most,
                                           std::size_t pictures);

}  // namespace study
