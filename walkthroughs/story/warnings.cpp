#include "walkthroughs/story/warnings.hpp"

#include <algorithm>
#include <cmath>

#include "walkthroughs/model/moment.hpp"
#include "walkthroughs/model/truth.hpp"
#include "walkthroughs/story/truth_told.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs::story {
namespace {

/// Returns: the largest coordinate of the difference, as far as support functions tell; they are asked along the axes.
double largest_coordinate(const Scene& scene) {
  const AskedObject<double> a(scene.a), b(scene.b);
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) {
      const Point d = sign * Point::Unit(axis);
      largest = std::max(largest, (a.support(d).point - b.support(Point(-d)).point).cwiseAbs().maxCoeff());
    }
  return largest;
}

/// The longest products are of four lengths: P·d, where d is (AB×AO)×AB, and ABn·AO.
std::string about_products(const Scene& scene) {
  const double largest = largest_coordinate(scene);
  const Precision precision = precision_of(scene.scalar);
  constexpr double few_terms = 16;
  const auto fourth_root = [](double x) { return std::sqrt(std::sqrt(x)); };
  const char* const what = largest > fourth_root(precision.largest / few_terms) ? "overflow"
                           : largest > 0 && largest < fourth_root(precision.least_normal / precision.epsilon)
                               ? "vanish or lose digits"
                               : nullptr;
  if (!what) return "";
  return "lengths are near " + plain(short_number(largest)) + ": products of four of them, such as P·d and ABn·AO, " +
         what;
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
