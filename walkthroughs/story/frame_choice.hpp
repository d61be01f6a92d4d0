/// A choice of frames, as users write it: "4,10,18", "3-7", "regions,end".
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "walkthroughs/story/story.hpp"

namespace walkthroughs::story {

struct FrameChoice {
  std::vector<std::pair<std::size_t, std::size_t>> steps;  ///< from and to, both belong to it; the first step is 1
  std::vector<Focus> kinds;                                ///< Focus::end: the last frame, whatever it is about
};

/// The words for kinds of frames, "supports, crossings, …", for messages.
std::string frame_kinds();

/// Returns: what the text says; nothing where that is no choice of frames.
std::optional<FrameChoice> frames_in(std::string_view text);

/// Returns: the places of the frames that are chosen, in the order of the story.
std::vector<std::size_t> places_of(const FrameChoice& choice, const std::vector<Frame>& frames);

/// Returns: what speaks against the choice for these frames, "there are 4 steps, and no step 30"; empty where nothing does.
std::string objection_to(const FrameChoice& choice, const std::vector<Frame>& frames);

}  // namespace walkthroughs::story
