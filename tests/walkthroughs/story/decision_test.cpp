#include "walkthroughs/story/decision.hpp"

#include "tests/kit/catch.hpp"
#include "tests/kit/dice.hpp"
#include "tests/walkthroughs/support.hpp"

namespace decision_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;
using Kind = DecisionView::Kind;

namespace {

/// Walkthroughs of one search in space: those of the catalogue, and some that nobody has chosen.
std::vector<Walkthrough> in_space() {
  std::vector<Walkthrough> list;
  for (const Walkthrough& w : whole_catalogue())
    if (w.layout == Layout::search && w.scenes[0].dimension == Dimension::space) list.push_back(w);
  kit::Dice dice(5);
  const auto coordinate = [&] { return dice.between(-20, 20) / 4.0; };
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

Point vertex(const Moment& now, gjk::Role role) { return now.processed.point(role); }

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

const gjk::RegionTested<double>* tested(const Moment& now, const gjk::Roles& face, const gjk::Roles& feature) {
  for (const auto& region : now.regions)
    if (region.face == face && region.feature == feature && region.verdict != gjk::Verdict::skipped &&
        !asks_along_edge(region))
      return &region;
  return nullptr;
}

}  // namespace

TEST_CASE(
    "Seen edge-on a triangle is a level line, its normal up, the fourth vertex below, and the origin on its side") {
  int above = 0, below = 0, in_plane = 0;
  for_all_views([&](const DecisionView& view, const auto&, const Moment& now, const Frame&) {
    if (view.kind != Kind::edge_on) return;
    const Point A = vertex(now, view.face[0]), P = vertex(now, view.face[1]), Q = vertex(now, view.face[2]);
    const Point normal = (P - A).cross(Q - A);
    const double size = (P - A).norm() + (Q - A).norm();
    for (const gjk::Role role : view.face) CHECK(std::abs(view.plane(vertex(now, role)).y()) < 1e-9 * size);
    CHECK(normal.normalized().dot(view.plane.up) == Approx(1));
    CHECK(view.plane.right.dot(normal.normalized()) == Approx(0).margin(1e-12));
    if (now.processed.size() == 4 && view.face != "BCD" && !now.in_exact_fallback)  // which turns no normals outward
      for (const gjk::Role role : {gjk::Role::B, gjk::Role::C, gjk::Role::D})
        if (!view.face.has(role)) CHECK(view.plane(vertex(now, role)).y() < 1e-9 * size);
    CHECK(view.height == Approx(view.plane(Point::Zero()).y()).margin(1e-6 * size));
    if (const auto* region = tested(now, {}, view.face)) {
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
    const gjk::Roles face = now.processed.size() == 4 ? view.face : gjk::Roles();
    for (const int i : {1, 2}) {
      const auto* region = tested(now, face, {gjk::Role::A, view.face[i]});
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

}  // namespace decision_test
