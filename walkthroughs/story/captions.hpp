/// What is said under the picture of one event.
#pragma once

#include <optional>

#include "walkthroughs/story/story.hpp"

namespace walkthroughs::story {

/// Returns: a frame with caption and facts but without moments; nothing where the event does not change the picture
/// or is told together with the next one. `now` is the moment after the event, which is one of `telling`.
std::optional<Frame> caption(const gjk::Event<double>& event, const Story& story, const Telling& telling,
                             const Moment& now);

/// Returns: a frame about a direction chosen, told as what it is: the search is where it was in iteration `earlier`.
Frame repetition(Frame frame, int earlier);

/// `caption`: as part of a sentence.
inline Frame frame_about(Focus focus, const std::string& caption, std::vector<Fact> facts = {}) {
  const std::string sentence = as_sentence(caption) + ".";
  return {focus, sentence, sentence, std::move(facts), {}, {}, {}};
}

/// The number that decides, then what follows from it. `fact`: the number, as it is told elsewhere.
inline Frame frame_by_number(Focus focus, const std::string& number, const std::string& conclusion, Fact fact) {
  fact.is_in_caption = true;
  Frame frame = frame_about(focus, conclusion, {std::move(fact)});
  frame.caption = number + ": " + conclusion + ".";
  return frame;
}

/// One sentence more; none where it is empty.
inline void append_to(Frame& frame, const std::string& text) {
  if (!text.empty()) frame.caption += " " + as_sentence(text) + ".";
}

// What caption() says of proofs and of the second search.
std::optional<Frame> caption_of(const gjk::FilterTried<double>& event, const Names& names, const Moment& now,
                                const Scene& scene);
std::optional<Frame> caption_of(const gjk::SignTaken<double>& event, const Names& names, const Moment&,
                                const Scene& scene);
std::optional<Frame> caption_of(const gjk::FeatureKept<double>& event, const Names& names, const Moment& now,
                                const Scene& scene);
std::optional<Frame> caption_of(const gjk::Certified<double>& event, const Names& names, const Moment& now,
                                const Scene& scene);

/// Whether it is 0 for everything that lies in the plane, and nobody doubts it: a component of AB×AO, the height over a
/// triangle.
bool is_out_of_plane(const gjk::SignTaken<double>& sign);

/// Returns: "AB·AO = 3.2 ± 4e−16 > 0"; "w·d" with the name of w in its place.
std::string sign_in_words(const gjk::SignTaken<double>& sign, const Names& names);

}  // namespace walkthroughs::story
