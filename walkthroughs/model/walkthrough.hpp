/// A walkthrough: scenes, and which panels their frames have; or diagrams, which no search makes.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "walkthroughs/model/scene.hpp"

namespace render {
class Canvas;
struct Box;
}  // namespace render

namespace walkthroughs::picture {
struct Style;
}

namespace walkthroughs::model {

/// What a walkthrough tells, and of how many scenes.
enum class Layout {
  search,           ///< one scene, from the first event to the last
  close_ups,        ///< two scenes: the first move of each, seen close up in its difference
  in_step,          ///< two scenes, iteration by iteration
  until_they_part,  ///< two scenes with the same objects, event by event; where their traces part is marked
  diagrams,         ///< no scene: pictures made by `diagrams`
};

/// Parts of a frame of Layout::search. The search itself (simplex, origin, directions) is always shown; it comes from
/// the trace alone. What is not asked for is not computed.
struct Panels {
  bool objects = true;    ///< the two objects
  bool hull = true;       ///< the outline of the whole difference, behind the search
  bool algorithm = true;  ///< the pseudo-code that is running
  bool decision = true;   ///< in space: the plane in which a decision is plain
  bool close_up = false;  ///< a magnified part around the origin; without it only where marks would cover each other
};

/// What the vertices of the difference are called.
enum class Naming {
  corners,  ///< the corners of a planar hull A, B, C, … all around, as in Figure 4
  roles,    ///< the vertices of the simplex A (newest), B, C, D, as in Algorithms 2-5, and P for the point just found
  fixed,    ///< each point that was found one letter for the whole search, A the first, B the second, …
};

/// A sentence that only this walkthrough can say, joined to the caption of one event.
struct Remark {
  enum class At { support_found, crossing_tested, region_tested, reduced, direction_chosen, end };
  At at;
  int iteration;
  std::string text;
  std::string only_for =
      {};                 ///< region_tested: the label, feature or "face feature" meant, such as "R3", "AB" or "ACD AC"
  std::string fact = {};  ///< a line of its own below the caption; empty where there is none
  bool contradicts = false;  ///< whether it says why, or what, exact numbers decide otherwise
};

/// The move that close-ups show: the one that iteration `iteration` makes, in three sentences.
struct CloseUp {
  int iteration;
  std::string direction, support, crossing;
};

/// One picture that no search makes.
struct Diagram {
  std::string caption;             ///< one sentence, with markup
  std::vector<std::string> facts;  ///< lines below it
  std::string description;         ///< what is to be seen, for readers who cannot see it
  /// Draws into `box`. Returns: how many labels could not be kept clear.
  std::function<int(render::Canvas&, const render::Box& box, const picture::Style&)> draw;
  bool in_space = false;  ///< whether it can be looked at from elsewhere
};

/// The case of Section 3.2 that a walkthrough of the region catalogue is about.
struct RegionCase {
  std::string text;     ///< "R3: the origin lies beyond AB"
  std::string section;  ///< "3.2.3"
};

struct Walkthrough {
  std::string name;     ///< as on the command line; "regions/2-simplex-r3"
  std::string title;    ///< heads every frame
  std::string source;   ///< where the report tells it
  std::string summary;  ///< one line for `gjkstep list`
  Layout layout = Layout::search;
  Panels panels = {};
  Naming naming = Naming::corners;
  std::vector<Scene> scenes = {};
  std::vector<Remark> remarks = {};
  std::optional<CloseUp> close_up = {};                 ///< Layout::close_ups only
  std::function<std::vector<Diagram>()> diagrams = {};  ///< Layout::diagrams only
  std::optional<RegionCase> region_case = {};           ///< walkthroughs regions/… only
  bool begins_with_the_guess = false;                   ///< certified/…: the first search is told elsewhere
};

/// Returns: two searches on the same objects until they part, `first` and that of the walkthrough.
Walkthrough until_they_part(Scene first, Walkthrough second);

/// Returns: its search beside the same one with that mistake, which stands first. Requires: one scene that may_be_mistaken().
Walkthrough beside_mistake(Mistake mistake, Walkthrough right);

}  // namespace walkthroughs::model
