/// Events to frames: which moments get a picture.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "walkthroughs/story/story.hpp"

namespace walkthroughs::story {

enum class Detail {
  decision,   ///< one frame for each event that changes the picture
  iteration,  ///< one frame for each iteration: its last
};

/// Tells what the traces say, one for each scene: no search is run. The story refers to the walkthrough, which must outlive
/// it. Requires: complete traces of these scenes; for Layout::close_ups such as have that move.
Story tell(const Walkthrough& walkthrough, std::vector<Trace> traces, Detail detail = Detail::decision);
Story tell(Walkthrough&&, std::vector<Trace>, Detail = Detail::decision) = delete;

/// Runs the scenes and tells them. The story refers to the walkthrough, which must outlive it.
Story tell(const Walkthrough& walkthrough, Detail detail = Detail::decision);
Story tell(Walkthrough&&, Detail = Detail::decision) = delete;

/// Keeps only these frames of a story, named by their places in order. Each then covers what has happened since the one kept
/// before.
void keep_only(Story& story, const std::vector<std::size_t>& places);

/// Returns: the places of the last frame of each iteration.
std::vector<std::size_t> last_of_each_iteration(const std::vector<Frame>& frames);

/// Returns: which of `frames`, of another search, shows what frame `index` of `known` shows: the same kind of thing in the same
/// iteration, as often as it comes there; else the last frame before. Requires: both have frames.
std::size_t counterpart(const std::vector<Frame>& known, std::size_t index, const std::vector<Frame>& frames);

// -- A choice of frames, as users write it: "4,10,18", "3-7", "regions,end" -----------------------------------------------

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

/// Returns: what speaks against the choice for these frames, "has 4 steps, and no step 30; choose from 1 to 4"; empty where nothing does.
std::string objection_to(const FrameChoice& choice, const std::vector<Frame>& frames);

}  // namespace walkthroughs::story
