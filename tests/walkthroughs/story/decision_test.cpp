#include "walkthroughs/story/decision.hpp"

#include <random>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
using Kind = DecisionView::Kind;

namespace {

/// Walkthroughs of one search in space: those of the catalogue, and some that nobody has chosen.
std::vector<Walkthrough> in_space() {
  std::vector<Walkthrough> list;
  for (const Walkthrough& w : catalogue())
    if (w.layout == Layout::search && w.scenes[0].dimension == Dimension::space) list.push_back(w);
  std::mt19937 random(5);
  const auto coordinate = [&] { return static_cast<double>(static_cast<int>(random() % 41) - 20) / 4; };
  for (int i = 0; i < 30; ++i) {
    std::vector<Point> points;
    for (int k = 0; k < 7; ++k) points.emplace_back(coordinate(), coordinate(), coordinate());
    Walkthrough w = walkthrough_of(points);
    w.scenes[0].dimension = Dimension::space;
    w.naming = Naming::roles;
    list.push_back(std::move(w));
  }
  return list;
}

Point vertex(const Moment& now, char role) { return now.processed.point(static_cast<gjk::Role>(role - 'A')); }

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// Calls `check(view, views, moment, frame)` with every view of every frame.
template <class Check>
void for_all_views(const Check& check) {
  for (const Walkthrough& w : in_space()) {
    const Story story = tell(w);
    INFO(w.name);
    for (const Frame& frame : story.frames) {
      INFO(frame.caption);
      const std::vector<DecisionView> views = decision_views(frame.moments[0], frame.focus);
      for (const DecisionView& view : views) check(view, views, frame.moments[0], frame);
    }
  }
}

const gjk::RegionTested<double>* tested(const Moment& now, const std::string& face, const std::string& feature) {
  for (const auto& region : now.regions)
    if (region.face == face && region.feature == feature && region.verdict != gjk::Verdict::skipped &&
        !asks_along_edge(region))
      return &region;
  return nullptr;
}

}  // namespace

TEST_CASE("A plane that is looked at straight on shows lengths and right angles as they are") {
  int views_seen = 0;
  for_all_views([&](const DecisionView& view, const auto&, const Moment& now, const Frame&) {
    const Plane& plane = view.plane;
    CHECK(plane.right.norm() == Approx(1));
    CHECK(plane.up.norm() == Approx(1));
    CHECK(std::abs(plane.right.dot(plane.up)) < 1e-12);
    CHECK(plane.stretch == Vec2(1, 1));
    const Vec2 place(2, -3);
    CHECK((plane(plane.out(place)) - place).norm() < 1e-9);
    if (view.kind == Kind::true_shape || view.kind == Kind::segment)
      for (const char one : view.face)
        for (const char other : view.face)
          CHECK((plane(vertex(now, one)) - plane(vertex(now, other))).norm() ==
                Approx((vertex(now, one) - vertex(now, other)).norm()));
    ++views_seen;
  });
  CHECK(views_seen > 500);
}

TEST_CASE(
    "Seen edge-on a triangle is a level line, its normal up, the fourth vertex below, and the origin on its side") {
  int above = 0, below = 0, in_plane = 0;
  for_all_views([&](const DecisionView& view, const auto&, const Moment& now, const Frame&) {
    if (view.kind != Kind::edge_on) return;
    const Point A = vertex(now, view.face[0]), P = vertex(now, view.face[1]), Q = vertex(now, view.face[2]);
    const Point normal = (P - A).cross(Q - A);
    const double size = (P - A).norm() + (Q - A).norm();
    for (const char role : view.face) CHECK(std::abs(view.plane(vertex(now, role)).y()) < 1e-9 * size);
    CHECK(normal.normalized().dot(view.plane.up) == Approx(1));
    CHECK(view.plane.right.dot(normal.normalized()) == Approx(0).margin(1e-12));
    if (now.processed.size() == 4 && view.face != "BCD" && !now.is_second_search)  // which turns no normals outward
      for (const char role : {'B', 'C', 'D'})
        if (view.face.find(role) == std::string::npos) CHECK(view.plane(vertex(now, role)).y() < 1e-9 * size);
    CHECK(view.height == Approx(view.plane(Point::Zero()).y()).margin(1e-6 * size));
    if (const auto* region = tested(now, "", view.face)) {
      const double value = std::get<double>(region->value);
      CHECK((view.height > 0) == (value > 0));
      CHECK((view.height < 0) == (value < 0));
    }
    ++(view.height > 0 ? above : view.height < 0 ? below : in_plane);
  });
  CHECK(above > 20);
  CHECK(below > 20);
  CHECK(in_plane > 2);
}

TEST_CASE("In true shape a triangle is seen down its normal, and its foot lies where the tests of its edges say") {
  int beyond = 0, within = 0;
  for_all_views([&](const DecisionView& view, const auto&, const Moment& now, const Frame&) {
    if (view.kind != Kind::true_shape) return;
    const Vec2 A = view.plane(vertex(now, view.face[0])), P = view.plane(vertex(now, view.face[1])),
               Q = view.plane(vertex(now, view.face[2])), O = view.plane(Point::Zero());
    CHECK(turn(A, P, Q) > 0);  // counter-clockwise, from where the normal AP×AQ points
    const std::string face = now.processed.size() == 4 ? view.face : "";
    for (const std::size_t i : {1u, 2u}) {
      const auto* region = tested(now, face, {'A', view.face[i]});
      if (!region) continue;
      const double value = std::get<double>(region->value), outward = i == 1 ? -turn(A, P, O) : turn(A, Q, O);
      if (std::abs(outward) < 1e-9 * turn(A, P, Q)) continue;
      CHECK((outward > 0) == (value > 0));
      ++(value > 0 ? beyond : within);
    }
  });
  CHECK(beyond > 10);
  CHECK(within > 20);
}

TEST_CASE("Views of one triangle have one direction to the right, so that the foot stands below the origin") {
  int pairs = 0;
  for_all_views([&](const DecisionView& view, const std::vector<DecisionView>& views, const Moment&, const Frame&) {
    if (views.size() != 2 || &view != &views[0] || views[0].face != views[1].face) return;
    CHECK(views[0].kind == Kind::edge_on);
    CHECK(views[1].kind == Kind::true_shape);
    CHECK(views[0].plane(Point::Zero()).x() == Approx(views[1].plane(Point::Zero()).x()));
    CHECK((views[0].plane.right - views[1].plane.right).norm() < 1e-12);
    ++pairs;
  });
  CHECK(pairs > 30);
}

TEST_CASE("An edge lies level, A at the right, the origin above it") {
  int segments = 0;
  for_all_views([&](const DecisionView& view, const auto&, const Moment& now, const Frame&) {
    if (view.kind != Kind::segment) return;
    const char X = view.face[1];
    CHECK(view.plane(vertex(now, X)) == Vec2::Zero());
    CHECK(view.plane(vertex(now, 'A')).x() > 0);
    CHECK(view.plane(vertex(now, 'A')).y() == Approx(0).margin(1e-9));
    CHECK(view.plane(Point::Zero()).y() >= -1e-12);
    CHECK(view.plane(Point::Zero()).norm() == Approx(vertex(now, X).norm()));  // O is in that plane
    ++segments;
  });
  CHECK(segments > 30);
}

TEST_CASE("In the plane of d and OP, P lies as far to the right as the crossing test says") {
  int crossed = 0, not_crossed = 0;
  for_all_views([&](const DecisionView& view, const auto&, const Moment& now, const Frame& frame) {
    if (view.kind != Kind::crossing) return;
    CHECK((frame.focus == Focus::crossing || (frame.focus == Focus::end && now.result->separation)));
    CHECK(view.plane(Point::Zero()) == Vec2::Zero());
    const Vec2 P = view.plane(now.found->w);
    CHECK(view.height == Approx(*now.crossing->value / now.direction->value.norm()).margin(0));  // as the search found
    CHECK(P.x() == Approx(view.height).margin(1e-6 * P.norm()));  // but for what floats have rounded
    CHECK(P.norm() == Approx(now.found->w.norm()));
    CHECK(P.y() >= 0);
    CHECK((view.height < 0) == (now.crossing->verdict == gjk::Crossing::not_crossed));
    ++(view.height < 0 ? not_crossed : crossed);
  });
  CHECK(crossed > 30);
  CHECK(not_crossed > 5);
}

TEST_CASE(
    "What is asked about is looked at: each face before the first test, then the one in question, or its true shape") {
  const auto views = [](const Story& story, const std::string& caption) {
    std::string found;
    for (const Frame& frame : story.frames)
      if (frame.moments[0].processed.size() == 4 && frame.caption.starts_with(caption)) {
        for (const DecisionView& view : decision_views(frame.moments[0], frame.focus))
          found += (found.empty() ? "" : ", ") + view.face + (view.kind == Kind::edge_on ? " edge-on" : " true shape") +
                   (view.decides ? "" : " beside");
        return found + "; " + face_in_question(frame.moments[0], frame.focus);
      }
    return std::string("no such frame");
  };
  const Story story = tell(walkthrough("regions/3-simplex-face-adb-edge-ad"));
  CHECK(views(story, "P joins") == "ABC edge-on, ACD edge-on, ADB edge-on, BCD edge-on beside; ");
  CHECK(views(story, "The origin does not lie above face ABC") == "ABC edge-on; ABC");
  CHECK(views(story, "The origin does not lie above face ACD") == "ACD edge-on; ACD");
  CHECK(views(story, "The origin lies above face ADB") == "ADB edge-on, ADB true shape beside; ADB");
  CHECK(views(story, "The foot of the origin does not lie beyond edge AB of face ADB") ==
        "ADB edge-on beside, ADB true shape; ADB");
  CHECK(views(story, "The foot of the origin lies beyond edge AD of face ADB") ==
        "ADB edge-on beside, ADB true shape; ADB");
  CHECK(views(story, "C and B are no longer needed") == "ADB edge-on beside, ADB true shape; ADB");
  CHECK(views(tell(walkthrough("regions/3-simplex-inside")), "No face sees the origin") ==
        "ABC edge-on, ACD edge-on, ADB edge-on; ");
}

TEST_CASE("Vertices that span no plane, first points and scenes of the plane have no such views") {
  Moment flat;
  for (const Point& p : {Point(0, 0, 0), Point(1, 1, 1), Point(2, 2, 2)}) flat.processed.add({{p, {}}, {}, p});
  CHECK(decision_views(flat, Focus::added).empty());
  CHECK(face_in_question(flat, Focus::added).empty());
  CHECK_FALSE(shows_decision(tell(walkthrough("figure-4-left"))));
  CHECK(shows_decision(tell(walkthrough("regions/3-simplex-inside"))));
  Walkthrough switched_off = walkthrough("regions/3-simplex-inside");
  switched_off.panels.decision = false;
  CHECK_FALSE(shows_decision(tell(switched_off)));
  const Story story = tell(walkthrough("regions/3-simplex-inside"));
  for (const Frame& frame : story.frames)
    if (frame.focus == Focus::support || frame.focus == Focus::direction || frame.focus == Focus::end)
      CHECK(decision_views(frame.moments[0], frame.focus).empty());
}
