// Where the camera stands.

#include "walkthroughs/picture/lens.hpp"

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/picture/stage.hpp"

namespace lens_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;

TEST_CASE(
    "The camera sees the face that decides from its front, and vertices and origin apart, in every region in space") {
  int faces = 0;
  for (const Walkthrough* w : find_walkthroughs("regions")) {
    INFO(w->name);
    const StagedStory story(tell(*w));
    const Lens& lens = story.stages.at(0).lens;
    if (!lens.camera) continue;
    for (const Frame& frame : story.frames) {
      const Moment& now = frame.moments.at(0);
      if (frame.focus != Focus::region || now.iteration != w->remarks.at(0).iteration) continue;
      const gjk::RegionTested<double>& tested = now.regions.back();
      if (tested.simplex_size == 4 && tested.face.empty() && tested.verdict == gjk::Verdict::chosen && tested.normal) {
        CHECK(lens.camera->sees(*tested.normal));
        ++faces;
      }
      std::vector<Point> points = {Point::Zero()};
      for (int i = 0; i < now.processed.size(); ++i) points.push_back(now.processed[i].w);
      double size = 0, least = std::numeric_limits<double>::infinity();
      for (const Point& p : points)
        for (const Point& q : points) {
          size = std::max(size, (p - q).norm());
          if (p != q) least = std::min(least, (lens(p) - lens(q)).norm());
        }
      CHECK(least > 0.05 * size);
    }
  }
  CHECK(faces >= 9);
}

TEST_CASE("No triangle that decides is seen edge-on") {
  int seen = 0;
  for (const Walkthrough& w : whole_catalogue()) {
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

}  // namespace lens_test
