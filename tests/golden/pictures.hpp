/// The golden pictures: which, and why each.
///
/// All are 640x360, from walkthroughs as a user would render them. Those without letters do not depend on the version of
/// FreeType; the words of all pictures are checked as text elsewhere. Together they show every primitive of the canvas,
/// every panel, the plane, space, and each theme.
#pragma once

#include <string>
#include <vector>

#include "walkthroughs/output/renderer.hpp"
#include "walkthroughs/picture/draw.hpp"

namespace golden {

enum class Letters { drawn, left_out };

struct Picture {
  std::string walkthrough;
  std::size_t frame;
  std::string theme;  ///< "report", "slides", "dark"
  walkthroughs::picture::Text text;
  Letters letters;
  std::string reason;

  /// Returns: "figure-4-left-007-report".
  std::string name() const;
};

const std::vector<Picture>& pictures();

/// Returns: the picture as it is drawn now; letters that are left out are fully transparent.
render::Image draw(const Picture& picture, walkthroughs::output::Studio& studio);

/// Pictures of parts of the renderer on numbers that nobody chose: crowded lattices, on which things coincide, and what lies outside.
/// Each is a sheet of small cells.
struct Part {
  std::string name, reason;
  render::Image (*draw)(walkthroughs::output::Studio& studio);
};

const std::vector<Part>& parts();

}  // namespace golden
