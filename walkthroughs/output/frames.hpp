/// A PNG file a frame, and an SVG file where it is asked for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
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

/// Told after each file: which frame of the story it shows.
using FrameWritten = std::function<void(const std::filesystem::path& file, const Story& story, std::size_t index)>;

/// FOLDER/NAME/000.png, 001.png, …; of a scene in space also 000-turn-1.png, … up to `turns` of the output, the camera moved on
/// by equal angles all around. Removes what an earlier, longer run has left of these. Where there is somebody to tell of SVG
/// files, all of these also as 000.svg, …
class Frames : public Sink {
 public:
  explicit Frames(FrameWritten written, FrameWritten svg_written = nullptr)
      : written_(std::move(written)), svg_written_(std::move(svg_written)) {}
  std::vector<std::string> files(const Walkthrough&) const override;
  void add(const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer& renderer) override;

 private:
  FrameWritten written_, svg_written_;
};

}  // namespace walkthroughs::output
