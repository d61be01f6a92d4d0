// A trace alone, without the shapes, gives the state of the search after each event.

#include "walkthroughs/model/moment.hpp"

#include <sstream>

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

/// The state that counts, as the events state it outright.
struct State {
  std::string simplex, found;
  Point direction = {0, 0, 0};
};

std::string points(const Simplex& simplex) {
  std::ostringstream text;
  for (int i = 0; i < simplex.size(); ++i) text << simplex[i].w.transpose() << ';';
  return text.str();
}

std::string point(const Point& p) {
  std::ostringstream text;
  text << p.transpose();
  return text.str();
}

std::vector<State> states(const Trace& trace) {
  std::vector<State> list;
  State now;
  for (const auto& event : trace.events) {
    if (const auto* e = std::get_if<gjk::SearchStarted<double>>(&event)) now.direction = e->direction;
    if (const auto* e = std::get_if<gjk::SupportFound<double>>(&event)) now.found = point(e->vertex.w);
    if (const auto* e = std::get_if<gjk::VertexAdded<double>>(&event)) now.simplex = points(e->simplex);
    if (const auto* e = std::get_if<gjk::SimplexReduced<double>>(&event)) now.simplex = points(e->after);
    if (const auto* e = std::get_if<gjk::DirectionChosen<double>>(&event)) {
      now.direction = e->direction;
      now.found.clear();
    }
    list.push_back(now);
  }
  return list;
}

}  // namespace

TEST_CASE("Simplex, direction and the vertex found are as the trace states them after each event") {
  for (const Told& told : searches()) {
    const std::vector<State> expected = states(told.trace);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const Moment now = replay(told.trace, i + 1);
      CHECK(points(now.simplex) == expected[i].simplex);
      CHECK(now.direction->value == expected[i].direction);
      CHECK((now.found ? point(now.found->w) : "") == expected[i].found);
    }
  }
}

TEST_CASE("Before the first event nothing is known") {
  const Moment now = replay(Told("figure-4-left").trace, 0);
  CHECK(now.iteration == 0);
  CHECK_FALSE(now.direction.has_value());
  CHECK(now.simplex.size() == 0);
  CHECK(now.segments.empty());
}

TEST_CASE("The last moment has the result, and no other has") {
  for (const Told& told : searches()) {
    const std::size_t count = told.trace.events.size();
    for (std::size_t i = 0; i < count; ++i) CHECK_FALSE(replay(told.trace, i).result.has_value());
    CHECK(replay(told.trace, count).result->status == told.result().status);
    CHECK(points(replay(told.trace, count).simplex) == points(told.result().simplex));
  }
}

TEST_CASE("Crossing, regions and reduction are those of the iteration at hand") {
  for (const Told& told : searches()) {
    std::vector<std::string> features;
    int iteration = 0;
    for (std::size_t i = 0; i < told.trace.events.size(); ++i) {
      const auto& event = told.trace.events[i];
      if (iteration_of(event) != std::exchange(iteration, iteration_of(event))) features.clear();
      if (const auto* e = std::get_if<gjk::RegionTested<double>>(&event)) features.push_back(e->feature + e->face);
      const Moment now = replay(told.trace, i + 1);
      std::vector<std::string> replayed;
      for (const auto& region : now.regions) replayed.push_back(region.feature + region.face);
      CHECK(replayed == features);
      if (now.crossing) CHECK(now.crossing->iteration == iteration);
      if (now.reduction) CHECK(now.reduction->iteration == iteration);
    }
  }
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
