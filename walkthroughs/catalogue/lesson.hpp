/// The lesson: one idea a screen, a picture to take hold of, and something to do there.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/story/story.hpp"

namespace walkthroughs::catalogue {

struct Screen {
  std::string_view title, idea, task, hint;
  std::string_view seen;         ///< what one has seen once the task is done
  std::string_view walkthrough;  ///< which it shows,
  Focus focus;                   ///< at the first frame of this kind
  int iteration;                 ///< from this iteration on

  /// What is to be done: to change the scene, to answer the question that is asked next, or to draw the direction that comes next.
  enum class Doing { change, answer, draw };
  Doing doing;
  bool (*is_done)(const Story&) = nullptr;  ///< by a change: whether the search that is told does what was to be done
  bool is_before_search = false;            ///< whether only the objects and their difference are drawn
};

std::span<const Screen> screens();

/// Returns: the frame of the screen's walkthrough that it begins with.
std::size_t first_frame(const Screen& screen, const Story& story);

/// Returns: the story with nothing to draw of the search, where the screen comes before it.
Story as_shown_on(const Screen& screen, Story story);

/// Of the walkthrough that has the screens as pictures, each with its idea and its task.
inline constexpr const char* lesson_name = "lesson";

}  // namespace walkthroughs::catalogue
