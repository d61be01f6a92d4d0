// A trace alone, without the shapes, gives the state of the search after each event.

#include "walkthroughs/model/moment.hpp"

#include <optional>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"

namespace moment_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;
using walkthroughs::test::Told;

namespace {

/// Every trace of the catalogue that has one search only, and one that goes through tetrahedra.
std::vector<Told> searches() {
  std::vector<Told> list;
  for (const Walkthrough& w : whole_catalogue())
    for (const Scene& scene : w.scenes)
      if (!scene.certified) list.emplace_back(scene);
  list.emplace_back(walkthrough_of({{5, 1, 2}, {-4, 3, 1}, {-1, -5, 2}, {0, 1, -6}, {1, 2, 5}}).scenes[0]);
  return list;
}

std::vector<Point> points_of(const Simplex& simplex) {
  std::vector<Point> list;
  for (int i = 0; i < simplex.size(); ++i) list.push_back(simplex[i].w);
  return list;
}

}  // namespace

TEST_CASE("After each event the moment is as the events state it outright, and of the iteration at hand") {
  for (const Told& told : searches()) {
    std::vector<Point> simplex;
    std::optional<Point> found, direction;
    std::vector<std::string> features;
    int iteration = 0;
    for (std::size_t i = 0; i < told.trace.events.size(); ++i) {
      const auto& event = told.trace.events[i];
      if (iteration_of(event) != std::exchange(iteration, iteration_of(event))) features.clear();
      if (const auto* e = std::get_if<gjk::SearchStarted<double>>(&event)) direction = e->direction;
      if (const auto* e = std::get_if<gjk::SupportFound<double>>(&event)) found = e->vertex.w;
      if (const auto* e = std::get_if<gjk::VertexAdded<double>>(&event)) simplex = points_of(e->simplex);
      if (const auto* e = std::get_if<gjk::RegionTested<double>>(&event))
        features.push_back(to_string(e->feature) + to_string(e->face));
      if (const auto* e = std::get_if<gjk::SimplexReduced<double>>(&event)) simplex = points_of(e->after);
      if (const auto* e = std::get_if<gjk::DirectionChosen<double>>(&event)) direction = e->direction, found.reset();
      const Moment now = replay(told.trace, i + 1);
      CHECK(points_of(now.simplex) == simplex);
      CHECK(now.direction->value == direction);
      CHECK((now.found ? std::optional(now.found->w) : std::nullopt) == found);
      std::vector<std::string> replayed;
      for (const auto& region : now.regions) replayed.push_back(to_string(region.feature) + to_string(region.face));
      CHECK(replayed == features);
      if (now.crossing) CHECK(now.crossing->iteration == iteration);
      if (now.reduction) CHECK(now.reduction->iteration == iteration);
      CHECK(now.result.has_value() == (i + 1 == told.trace.events.size()));
    }
    CHECK(replay(told.trace, told.trace.events.size()).result->status == told.result().status);
    CHECK(simplex == points_of(told.result().simplex));
  }
}

}  // namespace moment_test
