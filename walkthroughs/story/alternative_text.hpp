/// Frames in words, for readers who cannot see them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "walkthroughs/story/story.hpp"

namespace walkthroughs::story {

/// Returns: what the panels show, in few words without markup, for readers who are told beside it which objects these are and which
/// simplex it is; sentence by sentence, of which most stay from frame to frame.
std::vector<std::string> picture_in_words(const Story& story, std::size_t index);

/// Returns: the caption, what the panels show, and the facts, in sentences without markup.
std::string alternative_text(const Story& story, std::size_t index);

/// One frame that was written to a file.
struct FrameFile {
  std::string file;
  const Story& story;
  std::size_t index;
};

/// Returns: a JSON document: for each frame its file, walkthrough, caption, facts, alternative text, and for each scene
/// the range of its events.
std::string captions_json(const std::vector<FrameFile>& frames);

}  // namespace walkthroughs::story
