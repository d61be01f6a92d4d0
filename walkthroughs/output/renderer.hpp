/// Draws pictures and writes them, and what else a format is made of, in the order in which it is asked for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <vector>

#include "walkthroughs/output/studio.hpp"
#include "walkthroughs/picture/draw.hpp"

namespace walkthroughs::output {

/// Where, how large, and with what around the panels. The size is that of a frame with text; what has another page, such
/// as a strip or a frame without text, is as wide and as high as it needs to be at the same scale.
struct Output {
  std::filesystem::path folder;
  render::Size size;
  Look look = {};
  int turns = 0;  ///< views of each frame beside the usual one, around the vertical axis, of scenes in space
};

/// Returns: the size of a picture of `page` at the scale of `output`, smaller where it would not fit.
render::Size pixels_of(render::Size page, const Output& output);

/// Returns: the folder FOLDER/NAME of what is written of a walkthrough, which is there. Errors: render::FileError.
std::filesystem::path folder_of(const Output& output, const Walkthrough& walkthrough);

/// Draws on the thread that calls, and encodes on others, so that the next picture is drawn while the last ones are
/// compressed. Files are written, and told of, in the order in which they were asked for, each when there is no more room
/// for others that wait. A few pictures are in memory at a time, however many there are.
/// Errors of all functions: render::FileError, also of files asked for earlier; render::ContextError. Files asked for
/// before the one that could not be written are there, later ones are not.
class Renderer {
 public:
  /// Makes the bytes of a file, when it is its turn.
  using Content = std::function<std::vector<std::uint8_t>()>;
  using Written = std::function<void(const std::filesystem::path& file)>;

  /// `studio` must outlive the renderer.
  explicit Renderer(Studio& studio) : studio_(studio) {}
  /// Writes what was asked for; errors are lost. Call finish() to see them.
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Returns: a canvas for a picture of `page`.
  render::Canvas canvas(render::Size page, const Output& output);
  /// Returns: the frame of that story.
  render::Canvas frame(const StagedStory& story, std::size_t index, const Output& output);
  render::Image draw(const render::Canvas& canvas) { return studio_.rasterizer.draw(canvas); }
  /// What pictures are lettered with.
  render::Font& font() { return studio_.font; }

  /// Returns: the picture as PNG, which is encoded from now on, beside others.
  static Content png(render::Image image, render::PngText text);
  /// Asks for a file. `written` is told when it is there.
  void write(std::filesystem::path file, Content content, Written written);
  /// Asks for something else to be done, when all that was asked for before is written.
  void then(std::function<void()> job);
  /// Returns when all files are written.
  void finish();

 private:
  void do_next();

  Studio& studio_;
  std::deque<std::function<void()>> jobs_;
};

}  // namespace walkthroughs::output
