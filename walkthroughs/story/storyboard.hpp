/// Events to frames: which moments get a picture.
#pragma once

#include <cstddef>
#include <vector>

#include "walkthroughs/story/story.hpp"

namespace walkthroughs::story {

enum class Detail {
  decision,  ///< one frame for each event that changes the picture
  step,      ///< one frame for each iteration: its last
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

}  // namespace walkthroughs::story
