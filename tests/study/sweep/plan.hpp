/// From what a user asks for to what is done.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tests/study/sweep/sweep.hpp"
#include "walkthroughs/program/exit_code.hpp"

namespace study {

inline constexpr int largest_limit = 1000;  ///< of iterations
inline constexpr const char* limits_in_words = "whole numbers from 1 to 1000, such as 5,20";

using walkthroughs::UsageError;

inline constexpr std::uint64_t most_seed = ~std::uint64_t{0};
inline constexpr unsigned most_threads = 1024;  ///< that a command line may ask for

enum class Scope { quick, full };

/// What belongs to the study itself, whoever runs it and in how many shards. Empty lists: all that there are.
struct Request {
  Scope scope = Scope::quick;
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> pairs = {};  ///< of each family; else as the scope says
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
