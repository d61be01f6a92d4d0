#include "walkthroughs/command_line.hpp"

#include <charconv>

#include "render/rasterizer.hpp"
#include "walkthroughs/nearest.hpp"

namespace walkthroughs {

const Walkthrough& walkthrough_named(const std::string& name) {
  if (const Walkthrough* found = find_walkthrough(name)) return *found;
  throw UsageError("there is no walkthrough '" + name + "'; did you mean '" + nearest_name(name) +
                   "'? 'gjkstep list' shows all");
}

std::vector<const Walkthrough*> walkthroughs_named(const std::string& name) {
  const std::vector<const Walkthrough*> found = find_walkthroughs(name);
  return found.empty() ? std::vector{&walkthrough_named(name)} : found;
}

render::Size parse_size(const std::string& text) {
  render::Size size;
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width);
  const bool has_x = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
  const auto height = has_x ? std::from_chars(width.ptr + 1, end, size.height) : width;
  const auto fits = [](int pixels) { return render::min_pixels <= pixels && pixels <= render::max_pixels; };
  if (!has_x || height.ec != std::errc() || height.ptr != end || !fits(size.width) || !fits(size.height))
    throw UsageError("--size '" + text + "': expected WIDTHxHEIGHT in pixels, for example 1280x720, each from " +
                     std::to_string(render::min_pixels) + " to " + std::to_string(render::max_pixels));
  return size;
}

}  // namespace walkthroughs
