/// A PNG file a frame, and an SVG file where it is asked for; and how a film is made of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "walkthroughs/output/sink.hpp"

namespace walkthroughs::output {

/// Returns: what the picture of a frame is called: "007.png", "007-turn-1.svg"; `turn` 0 is the usual view.
std::string picture_name(std::size_t index, int turn = 0, const char* extension = ".png");

/// Returns: a picture that Frames has written to that folder, for formats that hold it as well.
/// Errors: render::FileError: what has just been written is not there any more, which no input is to blame for.
std::vector<std::uint8_t> written_picture(const std::filesystem::path& folder, std::size_t index, int turn = 0);

/// Returns: how many further views each frame of a walkthrough gets: none where no scene is in space.
int turns_of(const Walkthrough& walkthrough, const Output& output);

/// FOLDER/NAME/000.png, 001.png, …; of a scene in space also 000-turn-1.png, … up to `turns` of the output, the camera moved on
/// by equal angles all around. Removes what an earlier, longer run has left of these. Where SVG files are asked for, all of
/// these also as 000.svg, …
class Frames : public Sink {
 public:
  explicit Frames(bool has_svg = false) : has_svg_(has_svg) {}
  std::vector<std::string> files(const Walkthrough&) const override;
  void add(const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer& renderer) override;

 private:
  bool has_svg_;
};

// -- Frames to a film, which another program makes --

enum class Movie { mp4, gif };

/// Returns: a line for a POSIX shell that makes FOLDER/animation.mp4 or .gif of FOLDER/000.png, 001.png, … with ffmpeg:
/// each frame shown for `seconds`, the last one for twice as long. The mp4 plays everywhere (H.264, yuv420p), which takes
/// an even number of pixels each way: an odd one gets one more row or column in the colour of the paper.
std::string ffmpeg_line(Movie movie, const std::filesystem::path& folder, double seconds, double of_last,
                        render::Color paper);

}  // namespace walkthroughs::output
