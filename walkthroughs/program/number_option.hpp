/// Numbers on the command line: each has its range, and is read the same way.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>

#include "core/gjk.hpp"
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/text/printable.hpp"

namespace walkthroughs::program {

/// `words`: the range, as help and complaints call it.
template <class Number>
void expect_number(CLI::Option* option, Number low, Number high, const std::string& words) {
  const std::string expected = (std::integral<Number> ? "expected a whole number " : "expected a number ") + words;
  const auto read = [=](std::string& text) -> std::string {
    const auto number = decimal<Number>(text);
    if (!number || !(low <= *number && *number <= high)) return expected + ", found " + in_quotes(text);
    if constexpr (std::integral<Number>) text = std::to_string(*number);  // the parser would take 010 for 8
    return "";
  };
  option->transform(CLI::Validator(read, words));
}

/// Returns: the direction x,y,z, written in decimal; nothing where a number is not finite, or all are 0.
inline std::optional<gjk::Vec3<double>> direction_in(std::string_view text) {
  gjk::Vec3<double> direction;
  for (int i = 0; i < 3; ++i) {
    const std::size_t end = i < 2 ? text.find(',') : text.size();
    const auto number = decimal<double>(text.substr(0, end));
    if (!number || end == std::string_view::npos) return std::nullopt;
    direction[i] = *number;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return gjk::is_usable_direction(direction) ? std::optional(direction) : std::nullopt;
}

/// Lets an option take a direction and nothing else; direction_in() has it.
inline void expect_direction(CLI::Option* option) {
  const auto read = [](const std::string& text) -> std::string {
    return direction_in(text) ? "" : "expected three finite numbers x,y,z, not all 0, found " + in_quotes(text);
  };
  option->check(CLI::Validator(read, "x,y,z"));
}

/// Lets an option take numbers from `low` to `high`, written in decimal, and nothing else.
template <class Number>
void expect_number(CLI::Option* option, Number low, Number high) {
  expect_number(option, low, high, "from " + CLI::detail::to_string(low) + " to " + CLI::detail::to_string(high));
}

}  // namespace walkthroughs::program
