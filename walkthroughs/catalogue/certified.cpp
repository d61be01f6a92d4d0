// Answers that are proven: two that plain doubles prove, those that the report's rules get wrong in floats or never find, and a
// pair that touches beside one that misses by the least that a double can.

#include <cmath>
#include <stdexcept>

#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/catalogue/cycles.hpp"
#include "walkthroughs/catalogue/figure_objects.hpp"

namespace walkthroughs::catalogue {
namespace {

constexpr const char* source = "ARL-TR-7474, Algorithm 1, with a proof";

struct Words {
  std::string name, title, summary;
};

Walkthrough about(const Words& told, Scene scene) {
  scene.name = "certified/" + told.name;
  scene.certified = true;
  return {.name = scene.name,
          .title = told.title,
          .source = source,
          .summary = told.summary,
          .naming = Naming::roles,
          .scenes = {scene}};
}

/// What comes after a search that is told elsewhere.
Walkthrough what_happens_next(const Words& told, const Scene& scene) {
  Walkthrough walkthrough = about(told, scene);
  walkthrough.begins_with_the_guess = true;
  return walkthrough;
}

Scene tetrahedra() {
  return {.name = "",
          .a = {"tetrahedron a", points({{-2, -1, -1}, {3, -1, 0}, {0, 4, 0}, {0, 0, 3}})},
          .b = {"tetrahedron b", points({{-1, 0, 1}, {2, 2, -1}, {-2, 3, 0}, {0, 1, -3}})},
          .dimension = Dimension::space};
}

/// A triangle with an edge from (0, 0) to (3, 1), on which (1.5, 0.5) lies, and another that has that corner, or one higher.
Scene corner_on_an_edge(double higher) {
  return {.name = "",
          .a = {"triangle a", points({{0, 0, 0}, {3, 1, 0}, {2, -2, 0}})},
          .b = {"triangle b", points({{1.5, 0.5 + higher, 0}, {3, 3, 0}, {0, 2.5, 0}})}};
}

/// What comes after the failure of that name.
Walkthrough what_happens_next(const Words& told) {
  for (const Walkthrough& each : failures())
    if (each.name == "failures/" + told.name) return what_happens_next(told, each.scenes[0]);
  throw std::logic_error("there is no failure of that name");
}

}  // namespace

std::vector<Walkthrough> certified_answers() {
  const double least = std::nextafter(0.5, 1) - 0.5;
  return {
      about({"separation", "Apart, proven in doubles",
             "nothing of the difference reaches the origin's level, by more than rounding can have made"},
            figure_4_right_scene()),
      about({"tetrahedron", "Together, proven in doubles",
             "four products have the right signs, by more than rounding can have made"},
            tetrahedra()),
      about({"touching", "A corner on an edge, to the last digit",
             "doubles cannot tell touching from apart; the exact fallback can"},
            corner_on_an_edge(0)),
      about({"one-step-apart", "The same corner, one double higher",
             "the least that a double can be higher, and the answer is another"},
            corner_on_an_edge(least)),
      what_happens_next({"vanished-product", "A product too small for a float, and what is true",
                         "failures/vanished-product: the filter proves nothing, the exact fallback finds them apart"}),
      what_happens_next({"overflowed-product", "A product too large for a float, and what is true",
                         "failures/overflowed-product: undecided, and the exact fallback finds a common point"}),
      what_happens_next({"beyond-an-edge", "A sign that should be zero, and what is true",
                         "failures/beyond-an-edge: the sign in doubt is taken of whole numbers, and is 0"}),
      what_happens_next({"coplanar-askew", "Triangles in one tilted plane, and what is true",
                         "failures/coplanar-askew: the gap is nothing but rounding"}),
      what_happens_next({"far-from-the-origin", "Far from the origin, and what is true",
                         "failures/far-from-the-origin: a support point was missed, and is found"}),
      what_happens_next({"cycle-separated", "After the circle: apart",
                         "cycle-separated: the exact fallback comes nearer with every step, and ends"},
                        cycling_apart("")),
      what_happens_next({"cycle-intersecting", "After the circle: together",
                         "cycle-intersecting: the exact fallback comes nearer with every step, and ends"},
                        cycling_together("")),
  };
}

}  // namespace walkthroughs::catalogue
