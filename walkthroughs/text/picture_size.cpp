#include "walkthroughs/text/picture_size.hpp"

#include <charconv>

namespace walkthroughs {

bool is_size(const render::Size& size) {
  const auto fits = [](int side) { return render::min_pixels <= side && side <= render::max_pixels; };
  return fits(size.width) && fits(size.height);
}

std::optional<render::Size> size_in(std::string_view text) {
  render::Size size;
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width);
  if (width.ec != std::errc() || width.ptr == end || *width.ptr != 'x') return std::nullopt;
  const auto height = std::from_chars(width.ptr + 1, end, size.height);
  if (height.ec != std::errc() || height.ptr != end || !is_size(size)) return std::nullopt;
  return size;
}

}  // namespace walkthroughs
