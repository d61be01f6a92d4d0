// What one takes hold of first.

#include "walkthroughs/catalogue/catalogue.hpp"

namespace walkthroughs::catalogue {

std::vector<Walkthrough> two_triangles() {
  const Scene scene =
      scene_of("triangle a", {{-3, -1}, {1, -2}, {-0.5, 2}}, "triangle b", {{-1.5, 0.5}, {3, -1}, {2.5, 2}});
  return {search_of("live", "Two triangles to take hold of", "Section 3.1.2",
                    "drag a corner of a triangle, and see what the search does then", scene)};
}

}  // namespace walkthroughs::catalogue
