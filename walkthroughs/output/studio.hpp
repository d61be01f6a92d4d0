/// The tools of drawing, made once for all pictures.
#pragma once

#include <filesystem>

#include "render/font.hpp"
#include "render/rasterizer.hpp"
#include "walkthroughs/rooms.hpp"

namespace walkthroughs::output {

struct Studio {
  render::Backend backend = render::default_backend();
  std::filesystem::path font_folder = render::Font::default_directory();
  render::Font font{font_folder};
  render::OffscreenContext context{backend};
  render::Rasterizer rasterizer{context};
};

}  // namespace walkthroughs::output
