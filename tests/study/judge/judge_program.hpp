/// Is a program right? Held against exact answers; against itself, where a pair is changed and its answer must not; and against the
/// mistakes of the study, in case it is not.
#pragma once

#include <vector>

#include "tests/study/judge/asking.hpp"
#include "tests/study/judge/judged.hpp"

namespace study {

/// Errors: std::invalid_argument for pairs that the oracle cannot judge; those of run_program().
ProgramJudged judge_program(const AskedProgram& program, const std::vector<NamedPair>& pairs);

}  // namespace study
