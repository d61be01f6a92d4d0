/// Draws pictures and writes them, and what else a format is made of, in the order in which it is asked for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "render/font.hpp"
#include "render/rasterizer.hpp"
#include "walkthroughs/picture/draw.hpp"

namespace walkthroughs::output {

/// The tools of drawing, made once for all pictures.
struct Studio {
  render::Backend backend = render::default_backend();
  std::filesystem::path font_folder = render::Font::default_directory();
  render::Font font{font_folder};
  render::OffscreenContext context{backend};
  render::Rasterizer rasterizer{context};
};

/// Where, how large, and with what around the panels. The size is that of a frame with text; what has another page, such
/// as a strip or a frame without text, is as wide and as high as it needs to be at the same scale.
struct Output {
  std::filesystem::path folder;
  render::Size size;
  Look look = {};
  int turns = 0;           ///< views of each frame beside the usual one, around the vertical axis, of scenes in space
  bool is_staged = false;  ///< whether files are written to the stage of their folder, and then published
};

/// Returns: the size of a picture of `page` at the scale of `output`, smaller where it would not fit.
render::Size pixels_of(render::Size page, const Output& output);

/// Returns: the folder FOLDER/NAME of what is written of a walkthrough, or its stage, which is there. Errors: render::FileError.
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
  /// Told of each file of a story when it is there; `frame`: which one it shows, where it is the picture of one.
  using Written =
      std::function<void(const std::filesystem::path& file, const Story& story, std::optional<std::size_t> frame)>;

  /// `studio` must outlive the renderer.
  Renderer(Studio& studio, Written written) : studio_(studio), written_(std::move(written)) {}
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
  /// Asks for a file of a story, perhaps the picture of one of its frames.
  void write(std::filesystem::path file, Content content, std::shared_ptr<const StagedStory> story,
             std::optional<std::size_t> frame = {});
  /// Asks for something else to be done, when all that was asked for before is written.
  void then(std::function<void()> job);
  /// Returns when all files are written.
  void finish();
  /// Tells of a file that was written by what then() was asked for.
  void tell(const std::filesystem::path& file, const Story& story) const { written_(file, story, std::nullopt); }

 private:
  void do_next();

  Studio& studio_;
  const Written written_;
  std::deque<std::function<void()>> jobs_;
};

}  // namespace walkthroughs::output
