/// Numbers as users write them outside of files.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace walkthroughs {

/// Returns: the number that `text` is, all of it, in decimal (010 is ten); nothing where it is none, or none of that type.
template <class Number>
std::optional<Number> decimal(std::string_view text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && rest == end ? std::optional(number) : std::nullopt;
}

}  // namespace walkthroughs
