/// Events to frames: which moments get a picture, and what is said under it.
#pragma once

#include <string>
#include <vector>

#include "walkthroughs/hull.hpp"
#include "walkthroughs/moment.hpp"
#include "walkthroughs/walkthrough.hpp"

namespace walkthroughs {

/// What a frame wants the reader to look at first.
enum class Focus { support, crossing, region, reduction, direction, end };

/// A number that decides, or a reason, in one line.
struct Fact {
  enum class Mark { none, yes, no, skipped, answer };
  Mark mark = Mark::none;
  std::string text;  ///< with the markup of render/font.hpp
};

struct Frame {
  Focus focus;
  std::string caption;   ///< one sentence, with markup
  std::string headline;  ///< the same without the walkthrough's own remark
  std::vector<Fact> facts;
  std::vector<Moment> moments;  ///< one for each scene
};

/// A walkthrough with everything its frames need. Made once; frames and pictures only read it.
struct Story {
  const Walkthrough& walkthrough;
  std::vector<Trace> traces;        ///< one for each scene
  std::vector<LabelledHull> hulls;  ///< one for each scene
  std::vector<Frame> frames;
};

/// Runs the scenes and tells them: one frame for each event that changes the picture.
/// The story refers to the walkthrough, which must outlive it.
Story tell(const Walkthrough& walkthrough);
Story tell(Walkthrough&&) = delete;

}  // namespace walkthroughs
