/// Walkthroughs to PNG files.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "render/font.hpp"
#include "render/rasterizer.hpp"
#include "walkthroughs/storyboard.hpp"

namespace walkthroughs {

/// Told after each file: its path and its caption without markup, and which of how many it was.
using FrameWritten = std::function<void(const std::filesystem::path& file, const std::string& caption,
                                        std::size_t index, std::size_t count)>;

/// Where and how large; a strip is as high as it needs to be at the same scale.
struct Output {
  std::filesystem::path folder;
  render::Size size;
};

/// The tools of drawing, made once for all pictures.
struct Studio {
  render::Font font{render::Font::default_directory()};
  render::OffscreenContext context;
  render::Rasterizer rasterizer{context};
};

/// Writes FOLDER/NAME/000.png, 001.png, … and removes frames with higher numbers that an earlier, longer run has left.
/// Errors: render::FileError, render::ContextError.
void render_frames(const Story& story, const Output& output, Studio& studio, const FrameWritten& written);

/// Writes FOLDER/NAME/strip.png and returns its path. Errors: as render_frames.
std::filesystem::path render_strip(const Story& story, const Output& output, Studio& studio);

}  // namespace walkthroughs
