#include "walkthroughs/story/warnings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "walkthroughs/model/moment.hpp"
#include "walkthroughs/model/truth.hpp"
#include "walkthroughs/story/truth_told.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs::story {
namespace {

struct Lengths {
  double least = std::numeric_limits<double>::infinity(), largest = 0;
};

/// Returns: how narrow and how large coordinates are, as far as support functions tell; they are asked along the axes. The
/// least is that of a width that is not 0, the largest that of a coordinate of the difference.
Lengths lengths_of(const Scene& scene) {
  const AskedObject<double> a(scene.a), b(scene.b);
  Lengths lengths;
  for (int axis = 0; axis < 3; ++axis) {
    const Point d = Point::Unit(axis), back = -d;
    const Point of_a = a.support(d).point, of_b = b.support(back).point, behind_a = a.support(back).point,
                behind_b = b.support(d).point;
    for (const double width : {(of_a - behind_a)[axis], (behind_b - of_b)[axis]})
      if (width > 0) lengths.least = std::min(lengths.least, width);
    for (const Point& w : {Point(of_a - of_b), Point(behind_a - behind_b)})
      lengths.largest = std::max(lengths.largest, w.cwiseAbs().maxCoeff());
  }
  lengths.least = std::min(lengths.least, lengths.largest);
  return lengths;
}

/// The longest products are of four lengths: P·d, where d is (AB×AO)×AB, and ABn·AO. Two of them are those of an edge.
std::string about_products(const Scene& scene) {
  const auto [least, largest] = lengths_of(scene);
  const Precision precision = precision_of(scene.scalar);
  constexpr double few_terms = 16;
  const auto fourth_root = [](double x) { return std::sqrt(std::sqrt(x)); };
  const bool overflow = largest > fourth_root(precision.largest / few_terms),
             vanish = largest > 0 &&
                      std::sqrt(least) * std::sqrt(largest) < fourth_root(precision.least_normal / precision.epsilon);
  if (!overflow && !vanish) return "";
  const auto told = [](double length) { return plain(short_number(length)); };
  return (overflow || told(least) == told(largest) ? "lengths are near " + told(largest)
                                                   : "lengths are " + told(least) + " to " + told(largest)) +
         ": products of four of them, such as P·d and ABn·AO, " + (overflow ? "overflow" : "vanish or lose digits");
}

}  // namespace

std::vector<std::string> warnings_about(const Scene& scene) {
  if (scene.leaves_truth_out) return {};
  const bool in_float = scene.scalar == Scalar::binary32;
  const gjk::Status shown = answer_of(run(scene));
  std::vector<std::string> warnings{about_products(scene)};
  if (is_near_contact(scene.a, scene.b, scene.scalar))
    warnings.push_back("the objects are in contact within the rounding of " +
                       std::string(in_float ? "floats" : "doubles") + ": a search may answer either way");
  warnings.push_back(truth_told(truth_of(scene, shown), scene, shown).note);
  std::erase(warnings, "");
  return warnings;
}

}  // namespace walkthroughs::story
