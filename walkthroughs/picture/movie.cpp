#include "walkthroughs/picture/movie.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace walkthroughs {
namespace {

/// Returns: a character between quotes. Of those that a terminal acts upon, only a line break stays what it is.
std::string in_single_quotes(char c) {
  if (c == '\'') return "'\\''";
  if (c == '\n' || (static_cast<unsigned char>(c) >= 0x20 && c != 0x7F)) return std::string(1, c);
  char text[32];
  std::snprintf(text, sizeof text, R"-('"$(printf '\%03o')"')-", static_cast<unsigned>(c));
  return text;
}

/// Returns: `text` as one word of a POSIX shell, in quotes only where it needs them.
std::string quoted(const std::string& text) {
  const auto plain = [](char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') ||
           std::string_view("/._-+=%@").find(c) != std::string_view::npos;
  };
  if (!text.empty() && std::ranges::all_of(text, plain)) return text;
  std::string word = "'";
  for (const char c : text) word += in_single_quotes(c);
  return word + "'";
}

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

std::string ffmpeg_line(Movie movie, const std::filesystem::path& folder, double seconds, render::Color paper) {
  const std::string once_more = "tpad=stop=1:stop_mode=clone";  // the last frame
  const std::string rate = "1000/" + std::to_string(std::lround(seconds * 1000));
  const std::string input = "ffmpeg -y -v error -framerate " + rate + " -i " + quoted(frames_in(folder)) + " -vf ";
  if (movie == Movie::gif)
    return input + quoted(once_more + ",split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=none") + " " +
           quoted(path_for_ffmpeg(folder / "animation.gif"));
  const std::string even = "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=" + hexadecimal(paper);
  // Some players cannot show less than a few frames a second, so each is repeated.
  return input + quoted(once_more + "," + even + ",fps=25") + " -c:v libx264 -pix_fmt yuv420p " +
         quoted(path_for_ffmpeg(folder / "animation.mp4"));
}

}  // namespace walkthroughs
