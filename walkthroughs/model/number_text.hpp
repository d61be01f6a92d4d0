/// Numbers as text that reads back as the same number.
#pragma once

#include <charconv>
#include <concepts>
#include <string>

#include "walkthroughs/rooms.hpp"

namespace walkthroughs::model {

/// Appends the shortest such text.
template <std::floating_point S>
void append_number(S number, std::string& out) {
  char text[64];
  out.append(text, std::to_chars(text, text + sizeof text, number).ptr);
}

/// Returns: the shortest such text.
template <std::floating_point S>
std::string number_text(S number) {
  std::string text;
  append_number(number, text);
  return text;
}

}  // namespace walkthroughs::model
