/// Numbers on the command line: each has its range, and is read the same way.
#pragma once

#include <CLI/CLI.hpp>
#include <concepts>
#include <string>

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

/// Lets an option take numbers from `low` to `high`, written in decimal, and nothing else.
template <class Number>
void expect_number(CLI::Option* option, Number low, Number high) {
  expect_number(option, low, high, "from " + CLI::detail::to_string(low) + " to " + CLI::detail::to_string(high));
}

}  // namespace walkthroughs::program
