/// Kinds of options that the commands have in common. What each refuses is told with the option and what to write instead.
#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "tests/study/sweep/plan.hpp"

namespace study {

/// Returns: empty unless `text` is a whole number, written with digits alone, that T can hold.
template <std::unsigned_integral T>
std::optional<T> digits_as(std::string_view text) {
  T number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// The parser would take -1 for the largest number, larger ones for the same, and 010 for 8. Goes through all options that
/// take a number without a sign. Call it when the command has all its options.
inline void expect_digits(CLI::App& command) {
  for (CLI::Option* const option : command.get_options([](const CLI::Option* o) {
         return o->get_type_name().starts_with(CLI::detail::type_name<std::uint64_t>());
       }))
    option->transform(CLI::Validator(
        [](std::string& text) -> std::string {
          const auto number = digits_as<std::uint64_t>(text);
          if (!number) return "expected a whole number from 0, below 2^64, found '" + text + "'";
          text = std::to_string(*number);  // 010 is 10
          return "";
        },
        ""));
}

/// An option that takes "a,b", and that may be repeated.
template <class T>
void add_list(CLI::App& command, const std::string& name, std::vector<T>& values, const std::string& what) {
  const auto fail = [name](const std::string& text) {
    throw UsageError(name + " '" + text + "': expected " +
                     (std::same_as<T, int> ? "whole numbers such as 5,20" : "names, divided by single commas") +
                     "; 'gjkstep-study list' shows them");
  };
  const auto add = [&values, fail](const std::string& text) {
    for (std::size_t at = 0, comma = 0; comma != std::string::npos; at = comma + 1) {
      comma = text.find(',', at);
      const std::string value = text.substr(at, comma == std::string::npos ? comma : comma - at);
      if (value.empty() || value.starts_with('-')) fail(text);
      if constexpr (std::same_as<T, int>) {
        const auto number = digits_as<unsigned short>(value);
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
    throw UsageError(option + " '" + folder + "': name a folder to write to, for example " + option + " results");
}

}  // namespace study
