/// What is said under the picture of one event.
#pragma once

#include <optional>

#include "walkthroughs/story/story.hpp"

namespace walkthroughs {

/// Returns: a frame with caption and facts but without moments; nothing where the event does not change the picture
/// or is told together with the next one. `now` is the moment after the event, which is one of `telling`.
std::optional<Frame> caption(const gjk::Event<double>& event, const Story& story, const Telling& telling,
                             const Moment& now);

/// Returns: a frame about a direction chosen, told as what it is: the search is where it was in iteration `earlier`.
Frame repetition(Frame frame, int earlier);

}  // namespace walkthroughs
