/// What the tests of the walkthroughs share: walkthroughs by name, their events in letters of the picture, a folder.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "tests/kit/folder.hpp"
#include "tests/walkthroughs/polygons.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/model/scene.hpp"
#include "walkthroughs/story/storyboard.hpp"

namespace walkthroughs::test {

using namespace program;

inline const Walkthrough& walkthrough(const std::string& name) {
  if (const Walkthrough* found = find_walkthrough(name)) return *found;
  throw std::invalid_argument("no walkthrough " + name);
}

/// A walkthrough of one scene that nobody has drawn. Without further objects the difference is `points` itself.
inline Walkthrough walkthrough_of(const std::vector<Point>& points, const gjk::Options<double>& options = {},
                                  const std::vector<Point>& minus = {{0, 0, 0}}) {
  return {.name = "test",
          .title = "test",
          .source = "test",
          .summary = "test",
          .scenes = {{.name = "test",
                      .a = {"first", walkthroughs::model::points(points)},
                      .b = {"second", walkthroughs::model::points(minus)},
                      .options = options}}};
}

template <template <class> class E>
std::vector<E<double>> all(const Trace& trace) {
  std::vector<E<double>> found;
  for (const auto& event : trace.events)
    if (const auto* one = std::get_if<E<double>>(&event)) found.push_back(*one);
  return found;
}

inline int iteration_of(const gjk::Event<double>& event) {
  return std::visit([](const auto& e) { return e.iteration; }, event);
}

/// One scene as it went, asked about in letters.
struct Told {
  Scene scene;
  Trace trace = run(scene);
  LabelledHull hull = difference_hull(scene);

  explicit Told(const Scene& s) : scene(s) {}
  explicit Told(const std::string& name, std::size_t index = 0) : Told(walkthrough(name).scenes.at(index)) {}

  gjk::Result<double> result() const { return all<gjk::Finished>(trace).at(0).result; }

  /// Returns: the letters, oldest first: "AEG".
  std::string names(const Simplex& simplex) const {
    std::string letters;
    for (int i = 0; i < simplex.size(); ++i) letters += hull.name(simplex[i].w);
    return letters;
  }
};

using kit::bytes_of, kit::Folder, kit::listing;

}  // namespace walkthroughs::test
