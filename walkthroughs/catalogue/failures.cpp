// Five wrong and undecided answers of the algorithm in floating point, each the fault of another operation. Not that of the
// input: exact arithmetic, which is asked for comparison, starts from the floats of the scene.

#include "walkthroughs/catalogue/catalogue.hpp"

namespace walkthroughs::catalogue {
namespace {

Walkthrough failure(const std::string& name, const std::string& title, const std::string& section,
                    const std::string& summary, const std::vector<Remark>& remarks, const Scene& scene) {
  Scene in_floats = in_float(scene);
  in_floats.name = name;
  return search_of("failures/" + name, title, "Section " + section, summary, in_floats, remarks);
}

/// Why exact arithmetic decides otherwise there.
Remark cause(Remark::At at, int iteration, const std::string& text, const std::string& only_for = {}) {
  return {.at = at, .iteration = iteration, .text = text, .only_for = only_for, .contradicts = true};
}
Remark ending(int iteration, const std::string& text) {
  return {.at = Remark::At::end, .iteration = iteration, .text = text};
}

/// Corners in the plane whose coordinates are small whole numbers, times `unit`, plus `offset`.
std::vector<Corner> moved(std::vector<Corner> corners, double unit, double offset = 0) {
  for (auto& [x, y, z] : corners) {
    x = unit * x + offset;
    y = unit * y + offset;
  }
  return corners;
}

}  // namespace

std::vector<Walkthrough> failures() {
  return {
      // Range: w·d is a product of four lengths, and so is ABn·AO.
      failure("vanished-product", "Apart, but found to intersect: a product too small", "3.1.3",
              "lengths of 1e-12: w·d, a product of four of them, becomes 0",
              {cause(Remark::At::crossing_tested, 3,
                     "in truth it stopped short: w·d is a product of four lengths of 1e−12, and becomes 0")},
              scene_of("triangle a", moved({{-1, 0}, {-1, 3}, {1, 3}}, 1e-12), "triangle b",
                       moved({{-2, -3}, {3, -3}, {2, -1}}, 1e-12))),
      // Range, at the other end: (AB×AO)×AB is a product of three lengths.
      failure("overflowed-product", "Together, and undecided: a product too large for a float", "3.2.2",
              "lengths of 1e13: (AB×AO)×AB, a product of three of them, becomes infinite",
              {cause(Remark::At::direction_chosen, 2,
                     "the product of three lengths of 1e13 is beyond the largest float, 3.4e38"),
               ending(2, "no support function can be asked about an infinite direction")},
              scene_of("triangle a", moved({{-3, -3}, {0, -3}, {-1, 3}}, 1e13), "triangle b",
                       moved({{0, -3}, {0, 1}, {-3, 0}}, 1e13))),
      // A sign: the origin lies on an edge, and rounding puts it beyond.
      failure(
          "beyond-an-edge", "Together, and undecided: a sign that should be zero", "3.2.3",
          "the origin lies on AB: ABn·AO is rounded up from 0, and (AB×AO)×AB leads nowhere",
          {cause(Remark::At::region_tested, 3, "it lies on that edge, but ABn was rounded, and ABn·AO is no longer 0",
                 "AB"),
           ending(3, "from an edge that holds the origin no direction leads toward it")},
          scene_of("triangle a", {{97, 94}, {-9, 46}, {87, -147}}, "triangle b", {{-119, 93}, {94, -74}, {-113, -85}})),
      // A test for zero: all vertices of the difference lie in one plane through the origin, which is not parallel to an axis.
      failure("coplanar-askew", "Together, and found apart: rounding spoils a test for zero", "3.2.3",
              "two triangles that overlap in one tilted plane: ABCn·AO misses 0",
              {cause(Remark::At::region_tested, 3,
                     "it lies in the triangle, but ABCn·AO adds up rounded products and misses 0", "ABC"),
               ending(4, "rounded away from 0, ABCn·AO sent d out of the plane that holds a − b")},
              scene_of("triangle a", {{-145, -135, 145}, {357, 235, -189}, {16, 234, -394}}, "triangle b",
                       {{-357, -235, 189}, {141, 253, -351}, {77, 23, 7}})),
      // The support function: far from the origin the roundings of P·d are larger than the objects.
      failure("far-from-the-origin", "Together, and found apart: the support point is missed", "2.4",
              "coordinates of 16,000,000: dot products are rounded by more than the objects are wide",
              {cause(Remark::At::support_found, 3,
                     "it is not: a·d and b·d are near −592,000,000, where floats lie 64 apart"),
               ending(3, "the point that reaches across the origin was missed")},
              scene_of("quadrilateral a", moved({{3, 6}, {-8, 9}, {2, 1}, {-9, 9}}, 1, 16e6), "quadrilateral b",
                       moved({{9, -2}, {-1, 4}, {-2, 9}, {-2, -6}}, 1, 16e6)))};
}

}  // namespace walkthroughs::catalogue
