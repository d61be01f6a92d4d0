/// Numbers as text that reads back as the same number; and numbers and sizes of pictures as users write them outside of files.
#pragma once

#include <charconv>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "render/geometry.hpp"
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

/// Returns: the number that `text` is, all of it, in decimal (010 is ten); nothing where it is none, or none of that type.
template <class Number>
std::optional<Number> decimal(std::string_view text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && rest == end ? std::optional(number) : std::nullopt;
}

/// Returns: what "1280x720" says; nothing for other texts and for sizes that cannot be drawn.
inline std::optional<render::Size> size_in(std::string_view text) {
  const std::size_t x = text.find('x');
  if (x == std::string_view::npos) return std::nullopt;
  const auto width = decimal<int>(text.substr(0, x)), height = decimal<int>(text.substr(x + 1));
  const auto fits = [](auto side) { return side && render::min_pixels <= *side && *side <= render::max_pixels; };
  if (!fits(width) || !fits(height)) return std::nullopt;
  return render::Size{*width, *height};
}

}  // namespace walkthroughs::model
