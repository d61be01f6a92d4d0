/// Pairs that went wrong, as scene files that `gjkstep render` draws step by step.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/study/sweep/sweep.hpp"

namespace study {

std::string to_string(Kind kind);  ///< "false positive"

/// Returns: a scene file that begins with comments on what is wrong. Scenes run in float or double; of another scalar the
/// comments say that what is drawn is the run in double, which may go right; of a certified answer, that it is the first search.
std::string scene_of(const Failure& failure, std::uint64_t seed);

/// Returns: "family-method-kind-index.json", made of plain letters.
std::string scene_name(const Failure& failure);

struct Saved {
  std::size_t files = 0;
  std::size_t left_out = 0;  ///< which no scene can hold
};

/// Writes those that fit into `folder`, which is made. Errors: render::FileError.
Saved write_failures(const std::filesystem::path& folder, const std::vector<Failure>& failures, std::uint64_t seed);

/// Returns: a sentence on what was left out and why; "" where nothing was.
std::string left_out_words(const Saved& saved);

}  // namespace study
