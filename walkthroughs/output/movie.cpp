#include <algorithm>
#include <cmath>
#include <cstdio>

#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/output/frames.hpp"
#include "walkthroughs/text/printable.hpp"

namespace walkthroughs::output {
namespace {

/// Returns: a path that ffmpeg takes neither for an option nor for an address such as "http:".
std::string path_for_ffmpeg(const std::filesystem::path& path) {
  const std::string text = path.string();
  return path.is_absolute() || (!text.starts_with('-') && text.find(':') == std::string::npos) ? text : "./" + text;
}

/// ffmpeg counts files with "%03d"; a per cent sign of the folder's own is written twice.
std::string frames_in(const std::filesystem::path& folder) {
  std::string pattern;
  for (const char c : path_for_ffmpeg(folder)) pattern += c == '%' ? std::string("%%") : std::string(1, c);
  return pattern + "/%03d.png";
}

std::string hexadecimal(render::Color color) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%02x%02x%02x", color.r, color.g, color.b);
  return text;
}

}  // namespace

std::string ffmpeg_line(Movie movie, const std::filesystem::path& folder, double seconds, double of_last,
                        render::Color paper) {
  // The last frame goes on for what it is shown longer.
  const std::string longer = "tpad=stop_duration=" + number_text(std::max(of_last - seconds, 0.0)) + ":stop_mode=clone";
  const std::string rate = "1000/" + std::to_string(std::lround(seconds * 1000));
  const std::string input =
      "ffmpeg -y -v error -framerate " + rate + " -i " + shell_quoted(frames_in(folder)) + " -vf ";
  if (movie == Movie::gif)
    return input + shell_quoted(longer + ",split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=none") + " " +
           shell_quoted(path_for_ffmpeg(folder / "animation.gif"));
  const std::string even = "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=" + hexadecimal(paper);
  // Some players cannot show less than a few frames a second, so each is repeated.
  return input + shell_quoted(longer + "," + even + ",fps=25") + " -c:v libx264 -pix_fmt yuv420p " +
         shell_quoted(path_for_ffmpeg(folder / "animation.mp4"));
}

}  // namespace walkthroughs::output
