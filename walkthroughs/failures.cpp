// Wrong and undecided answers of the algorithm in floating point, five of them, each the fault of another operation. The
// numbers of every scene are held exactly by its scalar: what goes wrong is the search.

#include "walkthroughs/exact.hpp"
#include "walkthroughs/walkthrough.hpp"

namespace walkthroughs {
namespace {

struct Words {
  std::string name, title, summary;
  WrongTurn turn;
};

Walkthrough about(const Words& told, const Scene& scene) {
  return {.name = "failures/" + told.name,
          .title = told.title,
          .source = "ARL-TR-7474, Algorithms 1-5",
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

/// Range: w·d is a product of four lengths.
Walkthrough vanished_product() {
  return about({.name = "vanished-product",
                .title = "Apart, and found together: a product too small for a double",
                .summary = "lengths of 1e-100, well within double; a product of four of them is not",
                .turn = {.cause = "P·d should be negative, but the product of four lengths of 1e−100 is below the "
                                  "least double, and becomes 0",
                         .truth = "every product that could have told otherwise has become 0"}},
               {.name = "vanished-product",
                .a = {"triangle a", in_plane({{1, 1}, {0, 2}, {-2, 2}}, 1e-100)},
                .b = {"triangle b", in_plane({{0, -1}, {-3, 0}, {-1, -2}}, 1e-100)}});
}

/// Range, at the other end: AB×AO×AB is a product of three lengths.
Walkthrough overflowed_product() {
  return about({.name = "overflowed-product",
                .title = "Together, and undecided: a product too large for a float",
                .summary = "lengths of 1e13, well within float; a product of three of them is not",
                .turn = {.cause = "the product of three lengths of 1e13 is beyond the largest float",
                         .truth = "the largest float is 3.4e38"}},
               in_float({.name = "overflowed-product",
                         .a = {"triangle a", in_plane({{-3, -3}, {0, -3}, {-1, 3}}, 1e13)},
                         .b = {"triangle b", in_plane({{0, -3}, {0, 1}, {-3, 0}}, 1e13)}}));
}

/// A test for zero: all vertices of the difference lie in one plane through the origin, but not parallel to an axis.
Walkthrough coplanar_askew() {
  return about({.name = "coplanar-askew",
                .title = "Together in one plane, and found apart: a zero that rounding misses",
                .summary = "two triangles in one tilted plane: ABCn·AO is not quite 0",
                .turn = {.cause = "it lies in the triangle, but ABCn·AO is a sum of rounded products and misses 0",
                         .truth = "the search left the plane of the triangles and found nothing there"}},
               in_float({.name = "coplanar-askew",
                         .a = {"triangle a", points({{-145, -135, 145}, {357, 235, -189}, {16, 234, -394}})},
                         .b = {"triangle b", points({{-357, -235, 189}, {141, 253, -351}, {77, 23, 7}})},
                         .dimension = Dimension::space}));
}

/// A sign: the origin lies on an edge, and rounding puts it beyond.
Walkthrough beyond_an_edge() {
  return about({.name = "beyond-an-edge",
                .title = "Together, and undecided: no direction leads on from an edge that holds the origin",
                .summary = "the origin lies on an edge; rounding puts it beyond, where no direction leads",
                .turn = {.cause = "it lies on that edge, but rounding makes the product positive",
                         .truth = "a search along the zero vector would find nothing"}},
               in_float({.name = "beyond-an-edge",
                         .a = {"triangle a", in_plane({{261, -85}, {151, 218}, {74, 107}})},
                         .b = {"triangle b", in_plane({{181, 164}, {-63, 104}, {139, 123}})}}));
}

/// The support function: far from the origin all points reach equally far, as far as floats can tell.
Walkthrough far_from_the_origin() {
  return about(
      {.name = "far-from-the-origin",
       .title = "Together, and found apart: a support function that cannot tell its points apart",
       .summary = "coordinates around 16,000,000: dot products are rounded by more than the objects are wide",
       .turn = {.cause = "the dot products of points so far from the origin are rounded to multiples of whole units",
                .truth = "another point reaches across the origin"}},
      in_float({.name = "far-from-the-origin",
                .a = {"quadrilateral a", in_plane({{3, 6}, {-8, 9}, {2, 1}, {-9, 9}}, 1, 16e6)},
                .b = {"quadrilateral b", in_plane({{9, -2}, {-1, 4}, {-2, 9}, {-2, -6}}, 1, 16e6)}}));
}

}  // namespace

std::vector<Walkthrough> failures() {
  return {vanished_product(), overflowed_product(), beyond_an_edge(), coplanar_askew(), far_from_the_origin()};
}

}  // namespace walkthroughs
