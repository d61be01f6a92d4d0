// Where the camera stands.

#include "walkthroughs/picture/lens.hpp"

#include "tests/catch.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/picture/stage.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

TEST_CASE("The camera sees the face that decides from its front in every walkthrough of a tetrahedron") {
  int seen = 0;
  for (const Walkthrough* w : find_walkthroughs("regions")) {
    if (!w->name.starts_with("regions/3-simplex-")) continue;
    const StagedStory story(tell(*w));
    const Telling& telling = story.tellings.at(0);
    const Lens& lens = story.stages.at(0).lens;
    REQUIRE(lens.camera);
    const std::optional<int> decisive = w->remarks.at(0).iteration;
    for (const auto& event : all<gjk::RegionTested>(telling.trace)) {
      const bool decides = event.iteration == *decisive && event.simplex_size == 4 && event.face.empty() &&
                           event.verdict == gjk::Verdict::chosen && event.normal;
      if (!decides) continue;
      INFO(w->name << " " << event.feature);
      CHECK(lens.camera->sees(*event.normal));
      ++seen;
    }
  }
  CHECK(seen >= 9);
}

TEST_CASE("The camera keeps the vertices that decide and the origin apart in the picture") {
  for (const Walkthrough* w : find_walkthroughs("regions")) {
    const StagedStory story(tell(*w));
    const Lens& lens = story.stages.at(0).lens;
    if (!lens.camera) continue;
    for (const Frame& frame : story.frames) {
      const Moment& now = frame.moments.at(0);
      if (frame.focus != Focus::region || now.iteration != w->remarks.at(0).iteration) continue;
      INFO(w->name);
      std::vector<Point> points = {Point::Zero()};
      for (int i = 0; i < now.processed.size(); ++i) points.push_back(now.processed[i].w);
      double size = 0;
      for (const Point& p : points)
        for (const Point& q : points) size = std::max(size, (p - q).norm());
      for (const Point& p : points)
        for (const Point& q : points)
          if (p != q) CHECK((lens(p) - lens(q)).norm() > 0.05 * size);
    }
  }
}

TEST_CASE("A scene of the plane has no camera and one in space has the same at every telling") {
  for (const Walkthrough& w : catalogue())
    for (const Scene& scene : w.scenes) {
      INFO(w.name);
      const auto of = [&] { return StagedStory(tell(w)).stages.at(0).lens.camera; };
      CHECK(of().has_value() == (scene.dimension == Dimension::space));
      if (of()) CHECK(of()->toward_viewer() == of()->toward_viewer());
    }
}

TEST_CASE("The camera looks along the gap between objects that are separated") {
  int seen = 0;
  for (const Walkthrough* w : find_walkthroughs("vehicle-and-threat")) {
    const StagedStory story(tell(*w));
    const auto& finished = std::get<gjk::Finished<double>>(story.tellings.at(0).trace.events.back());
    if (!finished.result.separation) continue;
    INFO(w->name);
    const Point across = finished.result.separation->direction.normalized();
    CHECK(std::abs(story.stages.at(0).lens.camera->toward_viewer().dot(across)) < 1e-12);
    ++seen;
  }
  CHECK(seen == 2);
}
