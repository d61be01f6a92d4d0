/// Kinds of options that the commands have in common. What each refuses is told with the option and what to write instead.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

#include "tests/study/sweep/plan.hpp"
#include "walkthroughs/program/number_option.hpp"
#include "walkthroughs/text/printable.hpp"

namespace study {

/// Errors: UsageError, always.
[[noreturn]] inline void refuse_list(const std::string& option, const std::string& text, const std::string& expected) {
  throw UsageError(option + " " + walkthroughs::text::in_quotes(text) + ": expected " + expected +
                   "; 'gjkstep-study list' shows them");
}

/// An option that takes "a,b", and that may be repeated. `expected`: what its values are, in words.
inline void add_list(CLI::App& command, const std::string& name, std::vector<std::string>& values,
                     const std::string& what, const std::string& expected = "names, divided by single commas") {
  const auto add = [=, &values](const std::string& text) {
    for (std::size_t at = 0, comma = 0; comma != std::string::npos; at = comma + 1) {
      comma = text.find(',', at);
      const std::string value = text.substr(at, comma == std::string::npos ? comma : comma - at);
      if (value.empty() || value.starts_with('-')) refuse_list(name, text, expected);
      values.push_back(value);
    }
  };
  const auto add_all = [add](const std::vector<std::string>& texts) { std::ranges::for_each(texts, add); };
  command.add_option_function<std::vector<std::string>>(name, add_all, what)
      ->expected(1)
      ->allow_extra_args(false)  // what follows is not one of them, nor is a "--"
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("TEXT,...");
}

inline void add_seed(CLI::App& command, std::uint64_t& seed) {
  walkthroughs::program::expect_number(
      command.add_option("--seed", seed, "which pairs are made")->capture_default_str(), std::uint64_t{0},
      ~std::uint64_t{0});
}

/// `pairs`: a number, or an optional one.
template <class Number>
CLI::Option* add_pair_count(CLI::App& command, const std::string& name, Number& pairs, const std::string& what) {
  CLI::Option* const option = command.add_option(name, pairs, what)->capture_default_str();
  walkthroughs::program::expect_number(option, std::uint64_t{1}, most_pairs);
  return option;
}

inline void add_threads(CLI::App& command, unsigned& threads) {
  walkthroughs::program::expect_number(
      command.add_option("--threads", threads, "0: as many as there are processors")->capture_default_str(), 0u, 1024u);
}

/// Returns: how many threads that option means.
inline unsigned threads_of(unsigned threads) {
  return threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
}

/// Errors: UsageError where the folder has no name, or that of the next option.
inline void expect_named(const std::string& option, const std::string& folder) {
  if (folder.empty() || folder.starts_with("--"))
    throw UsageError(option + " " + walkthroughs::text::in_quotes(folder) +
                     ": name a folder to write to, for example " + option + " results");
}

}  // namespace study
