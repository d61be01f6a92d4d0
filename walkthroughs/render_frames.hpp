/// Walkthroughs to PNG files.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "render/font.hpp"
#include "render/rasterizer.hpp"
#include "walkthroughs/draw.hpp"

namespace walkthroughs {

/// Told after each file: its path, and which frame of the story it shows.
using FrameWritten = std::function<void(const std::filesystem::path& file, std::size_t index)>;

/// Where, how large, and with what around the panels. The size is that of a frame with text; what has another page, such
/// as a strip or a frame without text, is as wide and as high as it needs to be at the same scale.
struct Output {
  std::filesystem::path folder;
  render::Size size;
  Look look = {};
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

/// Writes FOLDER/NAME/sheet.png, a contact sheet of all frames in reading order, and returns its path. Each frame is drawn
/// anew at `sheet_scale` of its size. Errors: as render_frames.
std::filesystem::path render_sheet(const Story& story, const Output& output, Studio& studio);

inline constexpr double sheet_scale = 0.375;
inline constexpr int sheet_columns = 4, sheet_gap = 8;  // at most so many in a row; pixels around each frame

}  // namespace walkthroughs
