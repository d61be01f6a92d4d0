/// Pictures of parts of the renderer on numbers that nobody chose: crowded lattices, on which things coincide, and what lies outside.
/// Each is a sheet of small cells.
#pragma once

#include <string>
#include <vector>

#include "render/image.hpp"
#include "walkthroughs/picture/studio.hpp"

namespace golden {

struct Part {
  std::string name, reason;
  render::Image (*draw)(walkthroughs::Studio& studio);
};

const std::vector<Part>& parts();

}  // namespace golden
