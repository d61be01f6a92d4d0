/// The pictures of a page: where they are, and what of them is shown.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "render/geometry.hpp"

namespace walkthroughs {

/// The pictures that a page shows, one a frame; drawn already, or to be drawn.
struct PagePictures {
  std::function<std::string(std::size_t frame, int turn)>
      url;               ///< of a picture, seen from the page; `turn` 0: the usual view
  render::Size page;     ///< on which they are laid out,
  render::Box part;      ///< and what of it is shown
  double text_scale = 1;  ///< of their text, which that of the page follows
  int turns = 0;          ///< further views of each, all around
  bool is_dark = false;   ///< drawn on a dark ground
};

}  // namespace walkthroughs
