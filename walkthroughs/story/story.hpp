/// A walkthrough as it is told: its frames, and what is said in each.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "walkthroughs/model/labelled_hull.hpp"
#include "walkthroughs/model/moment.hpp"
#include "walkthroughs/model/truth.hpp"
#include "walkthroughs/model/walkthrough.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs::story {

/// What a frame wants the reader to look at first.
enum class Focus {
  support,
  crossing,
  added,
  region,
  reduction,
  direction,
  repetition,
  parting,
  end,
  proof,   ///< of what the first search has found
  sign,    ///< one that was in doubt
  kept,    ///< the feature nearest to the origin
  proven,  ///< the answer
  diagram
};

/// A number that decides, or a reason, in one line.
struct Fact {
  enum class Mark { none, yes, no, skipped, answer, truth };
  Mark mark = Mark::none;
  std::string text;  ///< with the markup of render/font.hpp
  /// Of a number that is told: what it is of, "AB_n·AO", "d", and what it is: "3.5". Both stand in the text.
  std::string asked = {}, value = {};
  const Scene* of = nullptr;   ///< that says it, where a frame tells of several
  bool is_in_caption = false;  ///< which begins with it, so that it is not told twice
};

/// The events that a frame adds to the one before, counted from 0 in the trace of its scene; both ends belong to it.
struct EventRange {
  std::size_t first = 0, last = 0;
};

struct Frame {
  Focus focus;
  std::string caption;   ///< with markup: the number that decides, what follows, and the walkthrough's own remark
  std::string headline;  ///< only what follows
  std::vector<Fact> facts;
  std::vector<Moment> moments;     ///< one for each scene
  std::vector<EventRange> events;  ///< one for each scene
  std::vector<Focus> own_focus;    ///< of several scenes, one for each: what its search has done last

  /// Of the number that the caption begins with.
  Fact::Mark mark() const { return !facts.empty() && facts[0].is_in_caption ? facts[0].mark : Fact::Mark::none; }
  Focus focus_of(std::size_t scene) const { return own_focus.empty() ? focus : own_focus[scene]; }
  /// Returns: the iteration that the searches are in; where these differ that of each.
  std::vector<int> iterations() const {
    std::vector<int> all;
    for (const Moment& moment : moments) all.push_back(moment.iteration);
    if (std::ranges::adjacent_find(all, std::not_equal_to()) == all.end())
      all.resize(std::min<std::size_t>(all.size(), 1));
    return all;
  }
};

/// One scene as it went.
struct Telling {
  const Scene& scene;
  Trace trace;
  LabelledHull hull;  ///< where corners have names
  Panels panels;
  Truth truth = {};
  std::vector<std::optional<Frame>> said = {};  ///< of each event what caption() says
};

/// A walkthrough with everything its frames need. Made once; frames and pictures only read it.
struct Story {
  const Walkthrough& walkthrough;
  std::vector<Telling> tellings;  ///< one for each scene
  std::vector<Diagram> diagrams;  ///< Layout::diagrams: one for each frame
  std::vector<Frame> frames;

  /// Layout::until_they_part: the event from which on the searches differ; none where they never do, or are not compared.
  std::optional<std::size_t> parts_at = {};

  /// Whether the first of two searches has a mistake in it, and the other has not.
  bool shows_mistake() const { return tellings.size() == 2 && tellings[0].scene.mistake; }
  /// The frame of that event; none where it is left out, too.
  std::optional<std::size_t> parting() const {
    const auto found = std::ranges::find(frames, Focus::parting, &Frame::focus);
    return found == frames.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - frames.begin()));
  }
  Names names(std::size_t frame, std::size_t scene) const {
    return {walkthrough.naming, tellings[scene].hull, frames[frame].moments[scene]};
  }
};

}  // namespace walkthroughs::story
