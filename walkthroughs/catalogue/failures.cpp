// Five wrong and undecided answers of the algorithm in floating point, each the fault of another operation. Not that of the
// input: exact arithmetic, which is asked for comparison, starts from the floats of the scene.

#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/story/exact.hpp"

namespace walkthroughs::catalogue {
namespace {

struct Words {
  std::string name, title, source, summary;
  WrongTurn turn;
};

Walkthrough about(const Words& told, const Scene& scene) {
  return {.name = "failures/" + told.name,
          .title = told.title,
          .source = "ARL-TR-7474, " + told.source,
          .summary = told.summary,
          .naming = Naming::roles,
          .scenes = {scene},
          .findings = [=](const Trace& trace) { return remarks_on(told.turn, scene, trace); }};
}

/// Objects of the plane whose coordinates are small whole numbers, times `unit`, plus `offset`.
Points in_plane(const std::vector<std::array<double, 2>>& vertices, double unit = 1, double offset = 0) {
  std::vector<Point> moved;
  for (const auto& [x, y] : vertices) moved.emplace_back(unit * x + offset, unit * y + offset, 0);
  return points(std::move(moved));
}

/// Range: w·d is a product of four lengths, and so is ABn·AO.
Walkthrough vanished_product() {
  return about({.name = "vanished-product",
                .title = "Apart, and found together: a product too small for a float",
                .source = "Section 3.1.3",
                .summary = "lengths of 1e-12: w·d, a product of four of them, becomes 0",
                .turn = {.cause = "in truth it stopped short: w·d is a product of four lengths of 1e−12, and becomes 0",
                         .truth = "in truth they do not"}},
               in_float({.name = "vanished-product",
                         .a = {"triangle a", in_plane({{-1, 0}, {-1, 3}, {1, 3}}, 1e-12)},
                         .b = {"triangle b", in_plane({{-2, -3}, {3, -3}, {2, -1}}, 1e-12)}}));
}

/// Range, at the other end: (AB×AO)×AB is a product of three lengths.
Walkthrough overflowed_product() {
  return about({.name = "overflowed-product",
                .title = "Together, and undecided: a product too large for a float",
                .source = "Section 3.2.2",
                .summary = "lengths of 1e13: (AB×AO)×AB, a product of three of them, becomes infinite",
                .turn = {.cause = "the product of three lengths of 1e13 is beyond the largest float, 3.4e38",
                         .truth = "no support function can be asked about an infinite direction"}},
               in_float({.name = "overflowed-product",
                         .a = {"triangle a", in_plane({{-3, -3}, {0, -3}, {-1, 3}}, 1e13)},
                         .b = {"triangle b", in_plane({{0, -3}, {0, 1}, {-3, 0}}, 1e13)}}));
}

/// A sign: the origin lies on an edge, and rounding puts it beyond.
Walkthrough beyond_an_edge() {
  return about({.name = "beyond-an-edge",
                .title = "Together, and undecided: a sign that should be zero",
                .source = "Section 3.2.3",
                .summary = "the origin lies on AB: ABn·AO is rounded up from 0, and (AB×AO)×AB leads nowhere",
                .turn = {.cause = "it lies on that edge, but ABn was rounded, and ABn·AO is no longer 0",
                         .truth = "from an edge that holds the origin no direction leads toward it"}},
               in_float({.name = "beyond-an-edge",
                         .a = {"triangle a", in_plane({{97, 94}, {-9, 46}, {87, -147}})},
                         .b = {"triangle b", in_plane({{-119, 93}, {94, -74}, {-113, -85}})}}));
}

/// A test for zero: all vertices of the difference lie in one plane through the origin, which is not parallel to an axis.
Walkthrough coplanar_askew() {
  return about({.name = "coplanar-askew",
                .title = "Together, and found apart: a test for zero that rounding fails",
                .source = "Section 3.2.3",
                .summary = "two triangles that overlap in one tilted plane: ABCn·AO misses 0",
                .turn = {.cause = "it lies in the triangle, but ABCn·AO adds up rounded products and misses 0",
                         .truth = "the search left the plane in which everything lies, and found nothing there"}},
               in_float({.name = "coplanar-askew",
                         .a = {"triangle a", points({{-145, -135, 145}, {357, 235, -189}, {16, 234, -394}})},
                         .b = {"triangle b", points({{-357, -235, 189}, {141, 253, -351}, {77, 23, 7}})},
                         .dimension = Dimension::space}));
}

/// The support function: far from the origin the roundings of P·d are larger than the objects.
Walkthrough far_from_the_origin() {
  return about({.name = "far-from-the-origin",
                .title = "Together, and found apart: the support point is missed",
                .source = "Section 2.4",
                .summary = "coordinates of 16,000,000: dot products are rounded by more than the objects are wide",
                .turn = {.cause = "it is not: a·d and b·d are near −592,000,000, where floats lie 64 apart",
                         .truth = "a point that reaches across the origin was missed"}},
               in_float({.name = "far-from-the-origin",
                         .a = {"quadrilateral a", in_plane({{3, 6}, {-8, 9}, {2, 1}, {-9, 9}}, 1, 16e6)},
                         .b = {"quadrilateral b", in_plane({{9, -2}, {-1, 4}, {-2, 9}, {-2, -6}}, 1, 16e6)}}));
}

}  // namespace

std::vector<Walkthrough> failures() {
  return {vanished_product(), overflowed_product(), beyond_an_edge(), coplanar_askew(), far_from_the_origin()};
}

}  // namespace walkthroughs::catalogue
