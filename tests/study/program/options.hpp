/// Kinds of options that the commands have in common. What each refuses is told with the option and what to write instead.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <concepts>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

#include "tests/study/sweep/plan.hpp"
#include "walkthroughs/program/number_option.hpp"
#include "walkthroughs/text/decimal.hpp"
#include "walkthroughs/text/printable.hpp"

namespace study {

/// What stands in that folder, in messages.
inline constexpr const char* scenes_of_failures = "the scenes of --save-failures";

/// An option that takes "a,b", and that may be repeated.
template <class T>
void add_list(CLI::App& command, const std::string& name, std::vector<T>& values, const std::string& what) {
  const auto fail = [name](const std::string& text) {
    throw UsageError(name + " " + walkthroughs::in_quotes(text) + ": expected " +
                     (std::same_as<T, int> ? limits_in_words : "names, divided by single commas") +
                     "; 'gjkstep-study list' shows them");
  };
  const auto add = [&values, fail](const std::string& text) {
    for (std::size_t at = 0, comma = 0; comma != std::string::npos; at = comma + 1) {
      comma = text.find(',', at);
      const std::string value = text.substr(at, comma == std::string::npos ? comma : comma - at);
      if (value.empty() || value.starts_with('-')) fail(text);
      if constexpr (std::same_as<T, int>) {
        const auto number = walkthroughs::decimal<unsigned short>(value);
        if (!number) fail(text);
        values.push_back(*number);
      } else {
        values.push_back(value);
      }
    }
  };
  command
      .add_option_function<std::vector<std::string>>(
          name,
          [add](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) add(text);
          },
          what)
      ->expected(1)
      ->allow_extra_args(false)  // what follows is not one of them, nor is a "--"
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name(std::same_as<T, int> ? "INT,..." : "TEXT,...");
}

inline void add_seed(CLI::App& command, std::uint64_t& seed) {
  walkthroughs::expect_number(command.add_option("--seed", seed, "which pairs are made")->capture_default_str(),
                              std::uint64_t{0}, most_seed);
}

inline void add_threads(CLI::App& command, unsigned& threads) {
  walkthroughs::expect_number(
      command.add_option("--threads", threads, "0: as many as there are processors")->capture_default_str(), 0u,
      most_threads);
}

/// Returns: how many threads that option means.
inline unsigned threads_of(unsigned threads) {
  return threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
}

/// Errors: UsageError where the folder has no name, or that of the next option.
inline void expect_named(const std::string& option, const std::string& folder) {
  if (folder.empty() || folder.starts_with("--"))
    throw UsageError(option + " " + walkthroughs::in_quotes(folder) + ": name a folder to write to, for example " +
                     option + " results");
}

}  // namespace study
