/// All frames as an animated PNG.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "walkthroughs/output/sink.hpp"

namespace walkthroughs {

inline constexpr double last_frame_times = 2;  // how much longer the last frame of an animation is shown

/// FOLDER/NAME/animation.png, which shows each frame for so many seconds, the last one `last_frame_times` as long. Joins the
/// files of Frames, which must be given the story before.
class AnimatedPng : public Sink {
 public:
  AnimatedPng(double seconds, FileWritten written) : seconds_(seconds), written_(std::move(written)) {}
  std::vector<std::string> files(const Walkthrough&) const override { return {"animation.png"}; }
  void add(const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer& renderer) override;

 private:
  double seconds_;
  FileWritten written_;
};

}  // namespace walkthroughs
