/// A whole study, or one shard of it, as a value and as a file.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/study/sweep/sweep.hpp"
#include "walkthroughs/text/text_file.hpp"

namespace study {

/// Everything that must agree before tallies may be added.
struct Header {
  std::string command;   ///< that makes the whole study in one run
  std::string version;   ///< of the program
  std::string compiler;  ///< and its flags
  std::uint64_t seed = 1;
  std::vector<int> limits;
  bool operator==(const Header&) const = default;
};

/// What the tables say of a family.
struct FamilyNote {
  std::string name, what;
  std::uint64_t pairs = 0, slow_pairs = 0;  ///< of the whole study
  std::optional<std::uint64_t> size = {};   ///< how many there are, where all can be listed
  bool operator==(const FamilyNote&) const = default;
};

struct Study {
  Header header;
  Shard shard;
  std::vector<std::string> processors;  ///< that the timings were taken on, and in how many threads
  std::vector<FamilyNote> families;
  std::vector<Row> rows;  ///< as in Findings
};

/// Returns: the row's counts, which are a census where it went through all pairs of a list. Certified answers have the same at
/// every limit.
Counts counts_at(const FamilyNote& family, const Row& row, int limit);

/// Files that do not go together, or are none of the study's; what() is a sentence that says which and why.
struct StudyError : walkthroughs::InputError {
  using InputError::InputError;
};

/// Exact numbers, asked by the rules as intended, are never wrong where they decide, and certified answers are never wrong,
/// undecided or without a proof: else GJK or the oracle has an error.
///
/// Returns: a sentence on the first family in which they were; "" where they were in none.
std::string contradiction(const Study& study);

/// A shard and the file that it was read from.
struct NamedStudy {
  std::string name;
  Study study;
};

/// Returns: the study that one run would have made, but for the timings. The order of the shards does not matter.
/// Errors: StudyError where they belong to different studies, or one is missing or there twice.
Study merged(std::vector<NamedStudy> shards);

}  // namespace study
