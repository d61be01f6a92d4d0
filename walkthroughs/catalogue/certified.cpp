// Answers that are proven: two that plain doubles prove, those that the report's rules get wrong in floats or never find, and a
// pair that touches beside one that misses by the least that a double can.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/catalogue/figure_objects.hpp"

namespace walkthroughs::catalogue {
namespace {

Walkthrough proven(const std::string& name, const std::string& title, const std::string& summary, Scene scene) {
  scene.name = "certified/" + name;
  scene.certified = true;
  return search_of(scene.name, title, "Algorithm 1, with a proof", summary, scene);
}

/// A triangle with an edge from (0, 0) to (3, 1), on which (1.5, 0.5) lies, and another that has that corner, or one higher.
Scene corner_on_an_edge(double higher) {
  return scene_of("triangle a", {{0, 0}, {3, 1}, {2, -2}}, "triangle b", {{1.5, 0.5 + higher}, {3, 3}, {0, 2.5}});
}

/// What comes after the search of another walkthrough, one of `all`, which tells it.
Walkthrough what_happens_next(const std::vector<Walkthrough>& all, const std::string& told, const std::string& title,
                              const std::string& what) {
  const auto found = std::ranges::find(all, told, &Walkthrough::name);
  if (found == all.end()) throw std::logic_error("there is no walkthrough of that name");
  Walkthrough next = proven(told.substr(told.rfind('/') + 1), title, told + ": " + what, found->scenes[0]);
  next.begins_with_the_guess = true;
  return next;
}

}  // namespace

std::vector<Walkthrough> certified_answers() {
  const double least = std::nextafter(0.5, 1) - 0.5;
  std::vector<Walkthrough> told = failures();
  std::ranges::move(other_rules(), std::back_inserter(told));
  return {proven("separation", "Apart, proven in doubles",
                 "nothing of the difference reaches the origin's level, by more than rounding can have made",
                 figure_4_right_scene()),
          proven("tetrahedron", "Together, proven in doubles",
                 "four products have the right signs, by more than rounding can have made",
                 scene_of("tetrahedron a", {{-2, -1, -1}, {3, -1, 0}, {0, 4, 0}, {0, 0, 3}}, "tetrahedron b",
                          {{-1, 0, 1}, {2, 2, -1}, {-2, 3, 0}, {0, 1, -3}})),
          proven("touching", "A corner on an edge, to the last digit",
                 "doubles cannot tell touching from apart; the exact fallback can", corner_on_an_edge(0)),
          proven("one-step-apart", "The same corner, one double higher",
                 "the least that a double can be higher, and the answer is another", corner_on_an_edge(least)),
          what_happens_next(told, "failures/vanished-product", "A product too small for a float, and what is true",
                            "the filter proves nothing, the exact fallback finds them apart"),
          what_happens_next(told, "failures/overflowed-product", "A product too large for a float, and what is true",
                            "undecided, and the exact fallback finds a common point"),
          what_happens_next(told, "failures/beyond-an-edge", "A sign that should be zero, and what is true",
                            "the sign in doubt is taken of whole numbers, and is 0"),
          what_happens_next(told, "failures/coplanar-askew", "Triangles in one tilted plane, and what is true",
                            "the gap is nothing but rounding"),
          what_happens_next(told, "failures/far-from-the-origin", "Far from the origin, and what is true",
                            "a support point was missed, and is found"),
          what_happens_next(told, "cycle-separated", "After the circle: apart",
                            "the exact fallback comes nearer with every step, and ends"),
          what_happens_next(told, "cycle-intersecting", "After the circle: together",
                            "the exact fallback comes nearer with every step, and ends")};
}

}  // namespace walkthroughs::catalogue
