/// A walkthrough: scenes, and which panels their frames have. One file each; `catalogue()` lists them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "walkthroughs/scene.hpp"

namespace walkthroughs {

/// What a frame shows of its scenes. A panel that is not asked for is not computed.
enum class Layout {
  objects_and_difference,  ///< one scene: its objects on the left, the labelled hull of their difference on the right
  close_ups,               ///< two scenes: the first move of each, seen close up in its difference
};

/// A sentence that only this walkthrough can say, joined to the caption of one event.
struct Remark {
  enum class At { support_found, region_tested, end };
  At at;
  int iteration;
  std::string text;
};

/// The move that close-ups show: the one that iteration `iteration` makes, in three sentences.
struct CloseUp {
  int iteration;
  std::string direction, support, crossing;
};

struct Walkthrough {
  std::string name;     ///< as on the command line
  std::string title;    ///< heads every frame
  std::string source;   ///< where the report tells it
  std::string summary;  ///< one line for `gjkstep list`
  Layout layout = Layout::objects_and_difference;
  std::vector<Scene> scenes;
  std::vector<Remark> remarks = {};
  std::optional<CloseUp> close_up = {};  ///< Layout::close_ups only
};

/// Returns: all walkthroughs, in the order of the report.
const std::vector<Walkthrough>& catalogue();

/// Returns: the walkthrough of that name, or null.
const Walkthrough* find_walkthrough(std::string_view name);

/// Returns: the name of a walkthrough that is spelled most like `name`.
std::string nearest_name(std::string_view name);

Walkthrough figure_4_left();
Walkthrough figure_4_right();
Walkthrough figure_4_right_no_crossing_test();
Walkthrough figure_5();

}  // namespace walkthroughs
