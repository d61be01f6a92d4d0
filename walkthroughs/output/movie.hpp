/// Frames to a film, which another program makes.
#pragma once

#include <filesystem>
#include <string>

#include "render/color.hpp"
#include "walkthroughs/rooms.hpp"

namespace walkthroughs::output {

enum class Movie { mp4, gif };

/// Returns: a line for a POSIX shell that makes FOLDER/animation.mp4 or .gif of FOLDER/000.png, 001.png, … with ffmpeg:
/// each frame shown for `seconds`, the last one for twice as long. The mp4 plays everywhere (H.264, yuv420p), which takes
/// an even number of pixels each way: an odd one gets one more row or column in the colour of the paper.
std::string ffmpeg_line(Movie movie, const std::filesystem::path& folder, double seconds, render::Color paper);

}  // namespace walkthroughs::output
