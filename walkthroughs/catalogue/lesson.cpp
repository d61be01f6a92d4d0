#include "walkthroughs/catalogue/lesson.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "walkthroughs/picture/draw.hpp"
#include "walkthroughs/story/storyboard.hpp"

namespace walkthroughs::catalogue {
namespace {

using Doing = Screen::Doing;

// -- What is to be done ------------------------------------------------------------------------------------------------

const Scene& scene_in(const Story& story) { return story.tellings.back().scene; }

/// The corners of the objects; each less each is the difference.
std::vector<Point> differences(const Story& story) {
  std::vector<Point> all;
  for (const Point& of_a : vertices_of(scene_in(story).a))
    for (const Point& of_b : vertices_of(scene_in(story).b)) all.emplace_back(of_a - of_b);
  return all;
}

gjk::Status search_answers(const Story& story) { return answer_of(story.tellings.back().trace); }

bool is_to_the_right(const Story& story) {
  return std::ranges::all_of(differences(story), [](const Point& w) { return w.x() > 0; });
}

bool is_together(const Story& story) { return search_answers(story) == gjk::Status::intersecting; }

bool is_topmost(const Story& story) {
  for (const auto& event : story.tellings.back().trace.events)
    if (const auto* found = std::get_if<gjk::SupportFound<double>>(&event))
      return std::ranges::none_of(differences(story), [&](const Point& w) { return w.y() > found->vertex.w.y(); });
  return false;
}

bool has_three_points(const Story& story) {
  return std::ranges::any_of(story.frames, [](const Frame& frame) { return frame.moments[0].simplex.size() >= 3; });
}

bool is_stopped_short(const Story& story) {
  const auto& crossing = story.frames.back().moments[0].crossing;
  return crossing && crossing->verdict == gjk::Crossing::not_crossed;
}

/// Whether the origin lies on the border of the difference, in the plane. Scenes are in decimals: what they say in tenths may be off
/// by a rounding.
bool only_touches(const Story& story) {
  constexpr double rounding = 1e-9;
  const std::vector<Point> all = differences(story);
  return std::ranges::any_of(all, [&](const Point& p) {
    double left = 0, right = 0, least = std::numeric_limits<double>::infinity(), most = -least;
    for (const Point& w : all) {
      const double across = p.x() * w.y() - p.y() * w.x(), along = p.dot(w), room = rounding * p.norm();
      left = std::max(left, across - room);
      right = std::max(right, -across - room);
      if (std::abs(across) > room) continue;
      least = std::min(least, along - room);
      most = std::max(most, along + room);
    }
    return p.norm() > rounding && (left <= 0 || right <= 0) && least <= 0 && most >= 0;
  });
}

bool ends(const Story& story) { return search_answers(story) != gjk::Status::undecided; }

bool is_right(const Story& story) {
  return ends(story) && !is_otherwise(story.tellings.back().truth, search_answers(story));
}

bool takes_five_iterations(const Story& story) { return ends(story) && story.frames.back().moments[0].iteration >= 5; }

// -- The screens -------------------------------------------------------------------------------------------------------

constexpr std::array all_screens{
    Screen{"The difference of two objects",
           "The Minkowski difference a − b holds each point of a minus each point of b. "
           "Take an object by its middle and move it. Then a − b moves, too, and keeps its shape.",
           "Move the objects until all of a − b lies to the right of the origin O.",
           "Each point of a must lie to the right of each point of b.",
           "Each point of a lies to the right of each point of b. So each difference points to the right.", "live",
           Focus::support, 1, Doing::change, is_to_the_right, true},
    Screen{"The origin in it",
           "Where a and b have a point in common, that point minus itself is the origin O. "
           "So they intersect exactly when O lies in a − b.",
           "Move an object or drag its corners until O lies in a − b.", "Let the objects overlap, and look at O.",
           "The objects overlap, and O lies in a − b.", "figure-4-right", Focus::end, 1, Doing::change, is_together,
           true},
    Screen{"Support points",
           "GJK never computes all of a − b. It asks for the support point, which lies farthest along a direction d. "
           "It is the support point of a along d minus that of b along −d.",
           "Turn the arrow d until the support point is the topmost corner of a − b.",
           "Drag the tip of the arrow d upwards.", "Nothing of a − b lies farther along d than the support point.",
           "figure-4-left", Focus::support, 1, Doing::change, is_topmost},
    Screen{"One point",
           "The search keeps a simplex: one to four support points, of which A is the newest. "
           "It begins with one. Nothing but A is known yet.",
           "Draw the direction in which it looks next: an arrow from A.", "The way to the origin is straight: d = AO.",
           "From one point the search goes on along AO.", "regions/0-simplex-elsewhere", Focus::region, 1, Doing::draw},
    Screen{"Two points",
           "With two points the simplex is a segment. Where the origin lies on AB, the objects intersect, and the "
           "search ends. Else the origin lies to one side of AB.",
           "Drag a corner so that the search needs a third point.", "Move any corner a little: O leaves AB.",
           "From AB the search went on across AB, toward O: d = (AB×AO)×AB.", "regions/1-simplex-on-segment",
           Focus::end, 1, Doing::change, has_three_points},
    Screen{"The crossing test",
           "P is the newest support point: nothing of a − b reaches farther along d. "
           "Where P falls short of O, P·d < 0, no point is at O. Then the objects are apart.",
           "Pull the objects apart until the search ends by this test.", "Move one of them until they overlap no more.",
           "P·d < 0: all of a − b lies short of O.", "live", Focus::end, 1, Doing::change, is_stopped_short},
    Screen{"The regions of a triangle",
           "With three points O may lie beyond an edge, R3 or R7, or above or below ABC. "
           "The other regions are ruled out by what the search did before.",
           "In which region does O lie?",
           "Seen from above, O lies within the triangle. Seen edge-on, ABC_n points upwards.",
           "O lies below. The search goes on along −ABC_n, and A and B change places.", "regions/2-simplex-r1-below",
           Focus::added, 3, Doing::answer},
    Screen{
        "Why only three faces",
        "A tetrahedron has four faces. From BCD the search has just come: A was found on the side of BCD where O lies. "
        "So only the three faces at A are asked about.",
        "Above which of the three faces at A does O lie?",
        "Look at the three faces seen edge-on: in one picture O stands on the side of the normal.",
        "O lies above ACD, so B is dropped.", "regions/3-simplex-face-acd", Focus::added, 4, Doing::answer},
    Screen{"Touching",
           "Objects that touch have a point in common, so they intersect. O then lies on the border of a − b. "
           "Where they all but touch, rounding may decide.",
           "Move the objects until they just touch.", "Put a corner of one onto a corner of the other.",
           "O lies on the border of a − b.", "live", Focus::end, 1, Doing::change, only_touches},
    Screen{"A search that goes round",
           "The report's rules take the first edge or face that sees O, not the nearest. "
           "Seldom, the search then comes back to a simplex that it had, and never ends.",
           "Open Search below the picture, and choose rules that end.", "The complete rules keep what is nearest to O.",
           "Each simplex is nearer to O than the one before, so none comes back.", "cycle-separated", Focus::end, 1,
           Doing::change, ends},
    Screen{
        "Rounding, and certified answers",
        "Computers round. These triangles are apart, but small: a product of four lengths becomes zero. The search in "
        "floats answers wrongly.",
        "Open Search below the picture, and choose what makes the answer right.",
        "Doubles have more room than floats. A certified answer is proven.",
        "Doubles fail later than floats. A certified answer is never wrong: it is proven for the numbers as they are.",
        "failures/vanished-product", Focus::end, 1, Doing::change, is_right},
    Screen{"Now your own",
           "Drag, add and remove corners. Choose other rules, other numbers, or a mistake. "
           "Step back to see where the search went.",
           "Make a search of five iterations or more.", "Add corners, and let O lie near the border of a − b.",
           "Take along saves the scene as a file that gjkstep draws, or as a link.", "live", Focus::end, 1,
           Doing::change, takes_five_iterations}};

// -- As pictures -------------------------------------------------------------------------------------------------------

int draw_screen(const Screen& screen, render::Canvas& canvas, const render::Box& box, const Style& style) {
  Walkthrough shown = *find_walkthrough(screen.walkthrough);
  shown.panels.algorithm = false;
  const StagedStory story(as_shown_on(screen, tell(shown)));
  draw_panels(canvas, box, story, first_frame(screen, story), {.style = style, .turn = style.turn, .rise = style.rise});
  return 0;  // which the canvas has counted
}

/// Returns: those of the idea, and the task.
std::vector<std::string> sentences_of(const Screen& screen) {
  std::vector<std::string> sentences;
  for (std::string_view rest = screen.idea; !rest.empty();) {
    const std::size_t end = rest.find(". ");
    sentences.emplace_back(rest.substr(0, end == rest.npos ? end : end + 1));
    rest.remove_prefix(end == rest.npos ? rest.size() : end + 2);
  }
  sentences.emplace_back(screen.task);
  return sentences;
}

std::vector<Diagram> pictures() {
  std::vector<Diagram> all;
  for (const Screen& screen : all_screens)
    all.push_back({.caption = std::string(screen.title) + ".",
                   .facts = sentences_of(screen),
                   .description = "The objects of " + std::string(screen.walkthrough) + ", and their difference.",
                   .draw = [&screen](render::Canvas& canvas, const render::Box& box,
                                     const Style& style) { return draw_screen(screen, canvas, box, style); },
                   .in_space = find_walkthrough(screen.walkthrough)->scenes[0].dimension == Dimension::space});
  return all;
}

}  // namespace

std::span<const Screen> screens() { return all_screens; }

std::size_t first_frame(const Screen& screen, const Story& story) {
  const auto found = std::ranges::find_if(story.frames, [&](const Frame& frame) {
    return frame.focus == screen.focus && frame.moments[0].iteration >= screen.iteration;
  });
  const auto last = std::prev(story.frames.end());
  return static_cast<std::size_t>((found == story.frames.end() ? last : found) - story.frames.begin());
}

Story as_shown_on(const Screen& screen, Story story) {
  if (!screen.is_before_search) return story;
  for (Frame& frame : story.frames)
    for (Moment& moment : frame.moments) {
      const int iteration = moment.iteration;
      moment = Moment();
      moment.iteration = iteration;
    }
  return story;
}

std::vector<Walkthrough> lesson() {
  return {diagrams_of(lesson_name, "GJK in twelve screens", "Sections 2 and 3",
                      "a lesson: an idea a screen, and something to do there", pictures)};
}

}  // namespace walkthroughs::catalogue
