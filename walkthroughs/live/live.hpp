/// What a page asks that runs this program, and what it answers: a scene as text or a walkthrough's name in, its story and its
/// pictures out. All of it is JSON, and errors are values, as nothing can be caught where the page runs.
///
/// Each request is an object with one of these keys:
///
///     tell    {"name": "figure-4-left"}, {"trace": TEXT} or {"scene": TEXT, "file": NAME}, of which the last may be
///             missing: tells it. With "like": N also which frame shows what frame N of the story before shows, or of the
///             one that is held. With "brief": true only that frame is told, and nothing that a page keeps while one drags.
///             Answer: {"title", "story": as pages have it (page.hpp), "frame", "in_space", "scene": as a scene file, or null where
///             it cannot be changed, "switches" (changes.hpp), "answers": {"whose", "mistake", "parting", "search", "truth", "is_wrong"}
///             in words}. With "screen": N of the lesson also "is_done", and without "like" the frame with which that screen begins.
///             What is wrong with a text: {"error": {"line", "key", "reason", "text"}}. Where another program must be
///             asked, which has all searches: {"more": true}. In either case the story told before stays
///     draw    {"frame": N, "theme": NAME, "text": SCALE, "height": page units of the panels, "stacked": BOOL, "turn": DEGREES,
///             "rise": DEGREES, "zoom": FACTOR}, of which all may be missing: the picture of a frame. Answer: {"picture": SVG,
///             "width", "height", "grips"}, and where none can be taken hold of there also "objects": the same of the two objects
///             alone. With "asks": N also "aims": where the choices of that question can be pointed at, [{"choice", "at", "name"}];
///             of a direction [{"choice", "from", "by"}], along which an arrow is drawn. With "asks": "direction" of that which
///             comes next. Empty where that cannot be
///     hold    true: pictures keep the cameras and sizes of this story, whatever is told; false: the sizes no longer. The cameras stay
///             until something is told without "like"
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "render/font.hpp"
#include "walkthroughs/rooms.hpp"

namespace walkthroughs::live {

class Live {
 public:
  /// `font`: that pictures are laid out with; it must outlive this.
  explicit Live(render::Font& font);
  ~Live();

  /// Requires: a request. Returns: the answer, valid UTF-8.
  std::string answer(std::string_view request);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace walkthroughs::live
