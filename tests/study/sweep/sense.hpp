/// Whether a study is one that can have been found: what a checksum cannot tell of a file that was made wrong.
#pragma once

#include "tests/study/sweep/study.hpp"

namespace study {

/// Looks whether families and settings are this program's, each row is there once, and what it counts adds up to the pairs of
/// the shard.
///
/// Errors: std::invalid_argument, with the first row that is nonsense, and why.
void expect_sense(const Study& study);

}  // namespace study
