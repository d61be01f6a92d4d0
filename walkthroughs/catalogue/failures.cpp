// Five wrong and undecided answers of the algorithm in floating point, each the fault of another operation. Not that of the
// input: exact arithmetic, which is asked for comparison, starts from the floats of the scene.

#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/story/rounding.hpp"

namespace walkthroughs::catalogue {
namespace {

struct Failure {
  std::string name, title, section, summary;
  WrongTurn turn;
  Scene scene;
};

Walkthrough told(const Failure& failure) {
  Scene scene = in_float(failure.scene);
  scene.name = failure.name;
  Walkthrough walkthrough =
      search_of("failures/" + failure.name, failure.title, "Section " + failure.section, failure.summary, scene);
  walkthrough.findings = [turn = failure.turn, scene](const Trace& trace) { return remarks_on(turn, scene, trace); };
  return walkthrough;
}

/// Corners in the plane whose coordinates are small whole numbers, times `unit`, plus `offset`.
std::vector<Corner> moved(std::vector<Corner> corners, double unit, double offset = 0) {
  for (auto& [x, y, z] : corners) {
    x = unit * x + offset;
    y = unit * y + offset;
  }
  return corners;
}

std::vector<Failure> all_failures() {
  return {
      // Range: w·d is a product of four lengths, and so is ABn·AO.
      {.name = "vanished-product",
       .title = "Apart, but found to intersect: a product too small",
       .section = "3.1.3",
       .summary = "lengths of 1e-12: w·d, a product of four of them, becomes 0",
       .turn = {.cause = "in truth it stopped short: w·d is a product of four lengths of 1e−12, and becomes 0"},
       .scene = scene_of("triangle a", moved({{-1, 0}, {-1, 3}, {1, 3}}, 1e-12), "triangle b",
                         moved({{-2, -3}, {3, -3}, {2, -1}}, 1e-12))},
      // Range, at the other end: (AB×AO)×AB is a product of three lengths.
      {.name = "overflowed-product",
       .title = "Together, and undecided: a product too large for a float",
       .section = "3.2.2",
       .summary = "lengths of 1e13: (AB×AO)×AB, a product of three of them, becomes infinite",
       .turn = {.cause = "the product of three lengths of 1e13 is beyond the largest float, 3.4e38",
                .ending = "no support function can be asked about an infinite direction"},
       .scene = scene_of("triangle a", moved({{-3, -3}, {0, -3}, {-1, 3}}, 1e13), "triangle b",
                         moved({{0, -3}, {0, 1}, {-3, 0}}, 1e13))},
      // A sign: the origin lies on an edge, and rounding puts it beyond.
      {.name = "beyond-an-edge",
       .title = "Together, and undecided: a sign that should be zero",
       .section = "3.2.3",
       .summary = "the origin lies on AB: ABn·AO is rounded up from 0, and (AB×AO)×AB leads nowhere",
       .turn = {.cause = "it lies on that edge, but ABn was rounded, and ABn·AO is no longer 0",
                .ending = "from an edge that holds the origin no direction leads toward it"},
       .scene = scene_of("triangle a", {{97, 94}, {-9, 46}, {87, -147}}, "triangle b",
                         {{-119, 93}, {94, -74}, {-113, -85}})},
      // A test for zero: all vertices of the difference lie in one plane through the origin, which is not parallel to an axis.
      {.name = "coplanar-askew",
       .title = "Together, and found apart: rounding spoils a test for zero",
       .section = "3.2.3",
       .summary = "two triangles that overlap in one tilted plane: ABCn·AO misses 0",
       .turn = {.cause = "it lies in the triangle, but ABCn·AO adds up rounded products and misses 0",
                .ending = "rounded away from 0, ABCn·AO sent d out of the plane that holds a − b"},
       .scene = scene_of("triangle a", {{-145, -135, 145}, {357, 235, -189}, {16, 234, -394}}, "triangle b",
                         {{-357, -235, 189}, {141, 253, -351}, {77, 23, 7}})},
      // The support function: far from the origin the roundings of P·d are larger than the objects.
      {.name = "far-from-the-origin",
       .title = "Together, and found apart: the support point is missed",
       .section = "2.4",
       .summary = "coordinates of 16,000,000: dot products are rounded by more than the objects are wide",
       .turn = {.cause = "it is not: a·d and b·d are near −592,000,000, where floats lie 64 apart",
                .ending = "the point that reaches across the origin was missed"},
       .scene = scene_of("quadrilateral a", moved({{3, 6}, {-8, 9}, {2, 1}, {-9, 9}}, 1, 16e6), "quadrilateral b",
                         moved({{9, -2}, {-1, 4}, {-2, 9}, {-2, -6}}, 1, 16e6))}};
}

}  // namespace

std::vector<Walkthrough> failures() {
  std::vector<Walkthrough> walkthroughs;
  for (const Failure& each : all_failures()) walkthroughs.push_back(told(each));
  return walkthroughs;
}

}  // namespace walkthroughs::catalogue
