// Where the camera stands.

#include "walkthroughs/picture/lens.hpp"

#include "tests/kit/catch.hpp"
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

TEST_CASE("No triangle that decides is seen edge-on") {
  int seen = 0;
  for (const Walkthrough& w : catalogue()) {
    if (w.layout != Layout::search || w.scenes[0].dimension != Dimension::space) continue;
    const StagedStory story(tell(w));
    const Point viewer = story.stages.at(0).lens.camera->toward_viewer();
    for (const Frame& frame : story.frames) {
      const Moment& now = frame.moments.at(0);
      if (frame.focus != Focus::region || now.processed.size() != 3) continue;
      const Point A = now.processed.point(gjk::Role::A), B = now.processed.point(gjk::Role::B),
                  C = now.processed.point(gjk::Role::C);
      const Point normal = (B - A).cross(C - A);
      if (normal.isZero(0)) continue;
      INFO(w.name << ", iteration " << now.iteration);
      CHECK(std::abs(normal.normalized().dot(viewer)) > 0.1);
      ++seen;
    }
  }
  CHECK(seen > 50);
}
