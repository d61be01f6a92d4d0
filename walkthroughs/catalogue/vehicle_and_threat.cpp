// The report's own motive (Section 1): has a threat hit the vehicle, has a counter-munition hit the threat?

#include <numbers>

#include "walkthroughs/catalogue/catalogue.hpp"

namespace walkthroughs::catalogue {
namespace {

/// A vehicle 6 long and 2.4 wide, its front sloped; x is forward, z up.
Object vehicle() {
  const std::vector<Point> corners = {{-3, -1.2, 0.3}, {-3, 1.2, 0.3}, {2.4, -1.2, 0.3}, {2.4, 1.2, 0.3},
                                      {-2.8, -1, 1.6}, {-2.8, 1, 1.6}, {1, -1, 1.6},     {1, 1, 1.6},
                                      {3, -1, 0.8},    {3, 1, 0.8}};
  return {"vehicle", points(corners)};
}

/// A rod that flies along its own x axis, pitched down and turned, its middle at `at`.
Object threat(const Point& at) {
  const double pitch = 25 * std::numbers::pi / 180, heading = 200 * std::numbers::pi / 180;
  const Eigen::Matrix3d rotation =
      (Eigen::AngleAxisd(heading, Point::UnitZ()) * Eigen::AngleAxisd(pitch, Point::UnitY())).toRotationMatrix();
  return {"threat", Cylinder{{0, 0, 0}, {1, 0, 0}, 0.25, 1.8}, {rotation, at}};
}

Object counter_munition(const Point& at) { return {"counter-munition", Ball{at, 0.4}}; }

Walkthrough about(const std::string& name, const std::string& title, const std::string& summary, Object a, Object b) {
  return search_of("vehicle-and-threat/" + name, title, "Section 1", summary,
                   {.name = name, .a = std::move(a), .b = std::move(b), .dimension = Dimension::space});
}

}  // namespace

std::vector<Walkthrough> vehicle_and_threat() {
  return {
      about("vehicle-hit", "A threat hits the vehicle", "a cylinder and a convex hull that intersect",
            threat({1.8, 0.6, 1.3}), vehicle()),
      about("vehicle-near-miss", "A threat misses the vehicle", "the same, the cylinder flying higher",
            threat({1.8, 0.6, 2.35}), vehicle()),
      about("counter-munition-hit", "The counter-munition hits the threat", "a cylinder and a sphere that intersect",
            threat({3.2, 0.9, 2.1}), counter_munition({3.8, 1.3, 2.9})),
      about("counter-munition-near-miss", "The counter-munition misses the threat",
            "the same, the sphere a little to the side", threat({3.2, 0.9, 2.1}), counter_munition({3.2, 1.3, 2.9}))};
}

}  // namespace walkthroughs::catalogue
