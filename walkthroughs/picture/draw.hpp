/// Frames to pictures. Reads the story; computes nothing that the trace or the hull already states. Labels that could not be kept
/// clear of lines, of each other and of the panel's frame, and lines of text that there was no room for, are counted by the canvas.
#pragma once

#include <cstddef>

#include "render/canvas.hpp"
#include "walkthroughs/picture/stage.hpp"
#include "walkthroughs/picture/style.hpp"

namespace walkthroughs::picture {

/// What stands around the panels.
enum class Text {
  around,  ///< a title above; step, caption and facts below
  none,    ///< nothing: a document brings its own
};

/// What a picture looks like, apart from what it tells.
struct Look {
  Style style{render::themes::report};
  Text text = Text::around;
  bool values = true;  ///< whether the panels show the numbers that decide
  bool code = true;    ///< whether the pseudo-code is written; without it its place is empty, for who cuts it off
  bool grips = false;  ///< whether the canvas is told what a reader can take hold of
  int height = 448;    ///< of the panels, without text, in page units
  bool stacked =
      false;  ///< whether the panels of searches stand below each other, without the pseudo-code, as on a narrow screen
  double turn = 0;  ///< degrees by which the camera of a scene in space is moved around the vertical axis
  double rise = 0;  ///< and by which it is moved upwards
  double zoom = 1;  ///< how many times as large scenes are as where they just fit
  /// Whose cameras pictures have, and whose sizes, so that nothing moves but what the reader moves; without them the story's own.
  /// Requires: as many scenes, of as many dimensions.
  const StagedStory *cameras = nullptr, *framing = nullptr;
};

/// The page that a frame with text is laid out on; smaller and larger pictures are this page, scaled.
inline constexpr render::Size frame_page{1280, 720};

/// Returns: the page of a frame; without text it is as wide, and as high as the panels.
render::Size page_of_frame(const Look& look);

/// Returns: the part of that page that holds the panels but for the pseudo-code, for who writes all words himself.
render::Box pictures_of_frame(const Walkthrough& walkthrough, const Look& look);

/// Draws frame `index` of `story`. Requires: a canvas with the page page_of_frame(look), in the colour of the paper;
/// index < story.frames.size().
void draw_frame(render::Canvas& canvas, const StagedStory& story, std::size_t index, const Look& look = {});

/// Draws the panels of a frame into a part of another page.
void draw_panels(render::Canvas& canvas, const render::Box& box, const StagedStory& story, std::size_t index,
                 const Look& look);

inline constexpr render::Size objects_page{420, 420};
/// Draws the two objects of a scene alone. Requires: a canvas with the page objects_page, in the colour of the paper.
void draw_objects_alone(render::Canvas& canvas, const StagedStory& story, std::size_t index, std::size_t scene,
                        const Look& look);

/// Draws into a small box what a frame shows of the difference of a scene. Requires: no diagram.
void draw_small(render::Canvas& canvas, const render::Box& box, const StagedStory& story, std::size_t index,
                std::size_t scene, const Look& look);

/// Draws into `room` what is written below the panels of a frame: how far the story is, the caption, and the numbers that decide;
/// the facts smaller where there are many.
void draw_footer(render::Canvas& canvas, const render::Box& room, const StagedStory& story, std::size_t index,
                 const Style& style);

/// Draws the caption alone, as large as it fits, with the mark of its number.
void draw_caption(render::Canvas& canvas, const render::Box& room, const Frame& frame, const Style& style);

/// Returns: "iteration 2 · simplex [B, A]"; nothing of a diagram.
std::string state_in_words(const StagedStory& story, std::size_t index);

/// Draws the words of a footer, without the number of frames, in one column that begins at the top left corner of the page, each at
/// its full size.
/// Returns: how high the column is.
double draw_words(render::Canvas& canvas, double width, const StagedStory& story, std::size_t index,
                  const Style& style);

/// The whole walkthrough in one picture: the last picture of each iteration, side by side; where they are many in rows, read as
/// text is. Of two scenes the last picture of each.
render::Size strip_page(const StagedStory& story, const Look& look = {});

/// Requires: a canvas with the page strip_page(story, look), in the colour of the paper.
void draw_strip(render::Canvas& canvas, const StagedStory& story, const Look& look = {});

}  // namespace walkthroughs::picture
