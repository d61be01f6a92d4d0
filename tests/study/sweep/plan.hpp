/// From what a user asks for to what is done.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tests/study/sweep/sweep.hpp"
#include "walkthroughs/program/exit_code.hpp"

namespace study {

using walkthroughs::program::UsageError;

/// What belongs to the study itself, whoever runs it and in how many shards. Empty lists: all that there are.
struct Request {
  bool is_full = false;
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> pairs = {};  ///< of each family; else of a full or a quick run
  std::vector<std::string> families = {}, rules = {}, scalars = {}, zero_tests = {};
  std::vector<int> limits = {};
};

/// Returns: those families, in the order of the tables; all where no name is given. Errors: UsageError.
std::vector<const Family*> families_called(const std::vector<std::string>& names);

/// Returns: what to sweep, as one shard and in one thread. Errors: UsageError.
Plan plan_of(const Request& request);

/// Returns: the command that makes this study in one run.
std::string command_of(const Request& request);

/// Reads "2/8": shard 2, counted from 0, of 8. Errors: UsageError.
Shard parse_shard(const std::string& text);

}  // namespace study
