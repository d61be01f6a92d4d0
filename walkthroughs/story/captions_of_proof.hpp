/// What is said of proofs and of the second search.
#pragma once

#include <optional>

#include "walkthroughs/story/story.hpp"

namespace walkthroughs {

// Returns: a frame with caption and facts but without moments; nothing where another frame tells it. `now`: after the event.
std::optional<Frame> caption_of(const gjk::FilterTried<double>& event, const Names& names, const Moment& now);
std::optional<Frame> caption_of(const gjk::SignTaken<double>& event, const Names& names, Dimension dimension);
std::optional<Frame> caption_of(const gjk::FeatureKept<double>& event, const Names& names, const Moment& now);
std::optional<Frame> caption_of(const gjk::Certified<double>& event, const Names& names, const Moment& now,
                                Dimension dimension);

/// Whether it is 0 for everything that lies in the plane, and nobody doubts it: a component of AB×AO, the height over a triangle.
bool is_out_of_plane(const gjk::SignTaken<double>& sign);

/// Returns: "AB·AO = 3.2 ± 4e−16 > 0"; "w·d" with the name of w in its place.
std::string sign_in_words(const gjk::SignTaken<double>& sign, const Names& names);

}  // namespace walkthroughs
