#include "walkthroughs/text/picture_size.hpp"

#include "walkthroughs/text/decimal.hpp"

namespace walkthroughs {

std::optional<render::Size> size_in(std::string_view text) {
  const std::size_t x = text.find('x');
  if (x == std::string_view::npos) return std::nullopt;
  const auto width = decimal<int>(text.substr(0, x)), height = decimal<int>(text.substr(x + 1));
  const auto fits = [](auto side) { return side && render::min_pixels <= *side && *side <= render::max_pixels; };
  if (!fits(width) || !fits(height)) return std::nullopt;
  return render::Size{*width, *height};
}

}  // namespace walkthroughs
