// A trace alone, without the shapes, gives the state of the search after each event.

#include "walkthroughs/model/moment.hpp"

#include <optional>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

namespace {

/// Every trace of the catalogue that has one search only, and one that goes through tetrahedra.
std::vector<Told> searches() {
  std::vector<Told> list;
  for (const Walkthrough& w : catalogue())
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
      if (const auto* e = std::get_if<gjk::RegionTested<double>>(&event)) features.push_back(e->feature + e->face);
      if (const auto* e = std::get_if<gjk::SimplexReduced<double>>(&event)) simplex = points_of(e->after);
      if (const auto* e = std::get_if<gjk::DirectionChosen<double>>(&event)) direction = e->direction, found.reset();
      const Moment now = replay(told.trace, i + 1);
      CHECK(points_of(now.simplex) == simplex);
      CHECK(now.direction->value == direction);
      CHECK((now.found ? std::optional(now.found->w) : std::nullopt) == found);
      std::vector<std::string> replayed;
      for (const auto& region : now.regions) replayed.push_back(region.feature + region.face);
      CHECK(replayed == features);
      if (now.crossing) CHECK(now.crossing->iteration == iteration);
      if (now.reduction) CHECK(now.reduction->iteration == iteration);
      CHECK(now.result.has_value() == (i + 1 == told.trace.events.size()));
    }
    CHECK(replay(told.trace, told.trace.events.size()).result->status == told.result().status);
    CHECK(simplex == points_of(told.result().simplex));
  }
}

TEST_CASE("Before the first event nothing is known") {
  const Moment now = replay(Told("figure-4-left").trace, 0);
  CHECK(now.iteration == 0);
  CHECK_FALSE(now.direction.has_value());
  CHECK(now.simplex.size() == 0);
  CHECK(now.segments.empty());
}

TEST_CASE("A direction leads away from the simplex that was kept, the first from none") {
  const Told told("figure-4-left");
  std::vector<std::string> from;
  for (std::size_t i = 1; i <= told.trace.events.size(); ++i) {
    const std::string letters = told.names(replay(told.trace, i).direction->from);
    if (from.empty() || from.back() != letters) from.push_back(letters);
  }
  CHECK(from == std::vector<std::string>{"", "A", "AE", "EG"});
  CHECK(replay(told.trace, 1).direction->expression.empty());
}

TEST_CASE("The segments are the edges of all simplices so far, oldest first") {
  const auto segments = [](const Told& told) {
    std::string list;
    for (const auto& [from, to] : replay(told.trace, told.trace.events.size()).segments)
      list += told.hull.name(from) + told.hull.name(to) + " ";
    return list;
  };
  CHECK(segments(Told("figure-4-left")) == "AE AG EG EF GF ");
  CHECK(segments(Told("figure-4-right")) == "");
  CHECK(segments(Told("figure-4-right-no-crossing-test")) == "AE AF EF ");
}
