/// Kinds of options that the commands have in common. What each refuses is told with the option and what to write instead.
#pragma once

#include <CLI/CLI.hpp>
#include <concepts>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/study/sweep/plan.hpp"
#include "walkthroughs/program/number_option.hpp"

namespace study {

/// Goes through all options that take a number without a sign. Call it when the command has all its options.
inline void expect_digits(CLI::App& command) {
  for (CLI::Option* const option : command.get_options([](const CLI::Option* o) {
         return o->get_type_name().starts_with(CLI::detail::type_name<std::uint64_t>());
       }))
    walkthroughs::expect_number(option, std::uint64_t{0}, ~std::uint64_t{0}, "from 0, below 2^64");
}

/// An option that takes "a,b", and that may be repeated.
template <class T>
void add_list(CLI::App& command, const std::string& name, std::vector<T>& values, const std::string& what) {
  const auto fail = [name](const std::string& text) {
    throw UsageError(name + " " + walkthroughs::in_quotes(text) + ": expected " +
                     (std::same_as<T, int> ? "whole numbers such as 5,20" : "names, divided by single commas") +
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
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name(std::same_as<T, int> ? "INT,..." : "TEXT,...");
}

/// Errors: UsageError where the folder has no name, or that of the next option.
inline void expect_named(const std::string& option, const std::string& folder) {
  if (folder.empty() || folder.starts_with("--"))
    throw UsageError(option + " " + walkthroughs::in_quotes(folder) + ": name a folder to write to, for example " +
                     option + " results");
}

}  // namespace study
