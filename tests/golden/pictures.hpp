/// The golden pictures: which, and why each.
///
/// All are 640x360, from walkthroughs as a user would render them. Those without letters do not depend on the version of
/// FreeType; the words of all pictures are checked as text elsewhere. Together they show every primitive of the canvas,
/// every panel, the plane, space, and each theme.
#pragma once

#include <string>
#include <vector>

#include "walkthroughs/picture/draw.hpp"
#include "walkthroughs/picture/studio.hpp"

namespace golden {

enum class Letters { drawn, left_out };

struct Picture {
  std::string walkthrough;
  std::size_t frame;
  std::string theme;  ///< "report", "slides", "dark"
  walkthroughs::Text text;
  Letters letters;
  std::string reason;

  /// Returns: "figure-4-left-007-report".
  std::string name() const;
};

const std::vector<Picture>& pictures();

// From the list to pixels as they come out now, in three steps, so that a control can spoil what is between two of them.

/// Returns: the picture's theme, and whether it has captions.
walkthroughs::Look look_of(const Picture& picture);
/// Returns: the triangles to be drawn; letters that are left out are fully transparent.
render::Canvas canvas_of(const Picture& picture, const walkthroughs::Look& look, walkthroughs::Studio& studio);
/// Returns: the pixels.
render::Image draw(const Picture& picture, walkthroughs::Studio& studio);

}  // namespace golden
