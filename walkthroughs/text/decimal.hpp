/// Numbers as users write them outside of files, and sizes of pictures.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

#include "render/geometry.hpp"
#include "walkthroughs/rooms.hpp"

namespace walkthroughs::text {

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

}  // namespace walkthroughs::text
