/// Walkthroughs to PNG files.
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "render/font.hpp"
#include "render/rasterizer.hpp"
#include "render/worker.hpp"
#include "walkthroughs/picture/draw.hpp"

namespace walkthroughs {

/// Told after each file: its path, and which frame of the story it shows.
using FrameWritten = std::function<void(const std::filesystem::path& file, std::size_t index)>;
/// Told after a file that shows more than one frame.
using FileWritten = std::function<void(const std::filesystem::path& file)>;

/// Where, how large, and with what around the panels. The size is that of a frame with text; what has another page, such
/// as a strip or a frame without text, is as wide and as high as it needs to be at the same scale.
struct Output {
  std::filesystem::path folder;
  render::Size size;
  Look look = {};
  int turns = 0;  ///< views of each frame beside the usual one, around the vertical axis, of scenes in space
};

/// Returns: what the picture of a frame is called: "007.png", "007-turn-1.png"; `turn` 0 is the usual view.
std::string picture_name(std::size_t index, int turn = 0);

/// Returns: how many further views each frame of a walkthrough gets: none where no scene is in space.
int turns_of(const Walkthrough& walkthrough, const Output& output);

/// The tools of drawing, made once for all pictures.
struct Studio {
  render::Backend backend = render::default_backend();
  std::filesystem::path font_folder = render::Font::default_directory();
  render::Font font{font_folder};
  render::OffscreenContext context{backend};
  render::Rasterizer rasterizer{context};
};

/// Draws on the thread that calls and encodes on further ones, as many as there are processors, so that the next picture is
/// drawn while the last ones are compressed. Files are written, and told of there, in the order in which they were asked for.
/// A few pictures are in memory at a time, however many there are.
/// Errors of all functions: render::FileError, also of files asked for earlier; render::ContextError. Files asked for
/// before the one that could not be written are there, later ones are not.
class Renderer {
 public:
  /// `studio` must outlive the renderer.
  explicit Renderer(Studio& studio) : studio_(studio) {}

  /// Writes FOLDER/NAME/000.png, 001.png, …; of a scene in space also 000-turn-1.png, … up to `output.turns`, the
  /// camera moved on by equal angles all around. Removes what an earlier, longer run has left of these.
  /// With `animation_seconds` writes FOLDER/NAME/animation.png last, which shows each frame for so long, the last one
  /// `last_frame_times` as long, and tells `animation_written`.
  /// Reads the story before it returns, and not after.
  void frames(const StagedStory& story, const Output& output, FrameWritten written,
              std::optional<double> animation_seconds = {}, FileWritten animation_written = {});
  /// Writes FOLDER/NAME/strip.png.
  void strip(const StagedStory& story, const Output& output, FileWritten written);
  /// Writes FOLDER/NAME/sheet.png, a contact sheet of all frames in reading order, each drawn anew, as sheet_layout() says.
  void sheet(const StagedStory& story, const Output& output, FileWritten written);
  /// Does something else when the files asked for before are written, where they are written.
  void then(std::function<void()> job) { writer_.post(std::move(job)); }
  /// Returns when all files are written.
  void finish() { writer_.finish(); }

 private:
  static std::size_t processors() { return std::max(1u, std::thread::hardware_concurrency()); }

  render::Image draw(const StagedStory& story, std::size_t index, const Output& output);
  void write(std::filesystem::path file, render::Image image, render::PngText text, FileWritten written);

  Studio& studio_;
  render::Worker writer_{2 + processors(), processors()};
};

/// As Renderer::frames, strip and sheet, one at a time; each returns when its files are written, and the last two return
/// the path.
void render_frames(const StagedStory& story, const Output& output, Studio& studio, const FrameWritten& written);
std::filesystem::path render_strip(const StagedStory& story, const Output& output, Studio& studio);
std::filesystem::path render_sheet(const StagedStory& story, const Output& output, Studio& studio);

inline constexpr double sheet_scale = 0.375;
inline constexpr int sheet_columns = 4, sheet_gap = 8;  // so many in a row; pixels around each frame

/// Where the frames of a contact sheet stand, in pixels.
struct SheetLayout {
  int count, columns;
  render::Size frame;  ///< of which size frames are asked for,
  render::Size cell;   ///< and which they have, perhaps without text

  int left(int index) const { return sheet_gap + index % columns * (cell.width + sheet_gap); }
  int top(int index) const { return sheet_gap + index / columns * (cell.height + sheet_gap); }
  render::Size size() const {
    return {left(columns - 1) + cell.width + sheet_gap, top(count - 1) + cell.height + sheet_gap};
  }
};

/// Returns: `count` frames of `output` at `sheet_scale`, `sheet_columns` in a row; more in a row where the sheet would be
/// higher than max_image_side, and smaller ones where that is not enough. Requires: count >= 1.
/// Errors: render::FileError where even the smallest do not fit, which takes 400,000 of them.
SheetLayout sheet_layout(int count, const Output& output);

inline constexpr double last_frame_times = 2;  // how much longer the last frame of an animation is shown

}  // namespace walkthroughs
