/// The golden pictures: which, and why each.
///
/// All are 640x360, from walkthroughs as a user would render them. Those without letters do not depend on the version of
/// FreeType; the words of all pictures are checked as text elsewhere. Together they show every primitive of the canvas,
/// every panel, the plane, space, and each theme.
#pragma once

#include <string>
#include <vector>

#include "walkthroughs/render_frames.hpp"

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

/// Returns: what the picture looks like now, before and after drawing.
walkthroughs::Look look_of(const Picture& picture);
render::Canvas canvas_of(const Picture& picture, const walkthroughs::Look& look, walkthroughs::Studio& studio);
render::Image draw(const Picture& picture, walkthroughs::Studio& studio);

}  // namespace golden
