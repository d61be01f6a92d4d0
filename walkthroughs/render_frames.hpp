/// Walkthroughs to PNG files.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "render/font.hpp"
#include "render/rasterizer.hpp"
#include "walkthroughs/walkthrough.hpp"

namespace walkthroughs {

/// Told after each file: its path and its caption without markup, and which of how many it was.
using FrameWritten =
    std::function<void(const std::filesystem::path& file, const std::string& caption, std::size_t index, std::size_t count)>;

/// Writes `out`/NAME/000.png, 001.png, … and removes frames with higher numbers that an earlier, longer run has left.
/// Errors: render::FileError, render::ContextError.
void render_frames(const Walkthrough& walkthrough, const std::filesystem::path& out, render::Size size,
                   render::Rasterizer& rasterizer, render::Font& font, const FrameWritten& written);

}  // namespace walkthroughs
