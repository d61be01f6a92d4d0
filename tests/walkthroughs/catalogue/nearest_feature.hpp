/// Which feature of a simplex is nearest to a point: found by trying all of them, without any of the half-spaces of
/// walkthroughs/catalogue/region_grid.hpp or the tests of core/rules.hpp.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "walkthroughs/model/moment.hpp"

namespace walkthroughs::test {

/// The point of a feature's line, plane or space that is nearest to a point, as weights of the feature's vertices.
struct Footpoint {
  Eigen::VectorXd weights;
  double distance;
};

inline Footpoint footpoint(const std::vector<Point>& vertices, const Point& p) {
  const auto count = static_cast<Eigen::Index>(vertices.size());
  Eigen::MatrixXd span(3, count - 1);
  for (Eigen::Index i = 1; i < count; ++i) span.col(i - 1) = vertices[static_cast<std::size_t>(i)] - vertices[0];
  Eigen::VectorXd weights(count);
  if (count > 1) weights.tail(count - 1) = span.colPivHouseholderQr().solve(p - vertices[0]);
  weights[0] = 1 - (count > 1 ? weights.tail(count - 1).sum() : 0);
  Point foot = vertices[0];
  if (count > 1) foot += span * weights.tail(count - 1);
  return {weights, (foot - p).norm()};
}

/// Returns: its letters in alphabetical order; empty where a point lies on the border between two regions.
inline std::string nearest_feature(const Simplex& simplex, const Point& p) {
  constexpr double border = 1e-9;
  std::string nearest;
  double least = std::numeric_limits<double>::infinity();
  for (int subset = 1; subset < 1 << simplex.size(); ++subset) {
    std::vector<Point> vertices;
    std::string letters;
    for (int i = 0; i < simplex.size(); ++i) {
      if (!(subset >> i & 1)) continue;
      vertices.push_back(simplex.point(static_cast<gjk::Role>(i)));
      letters += gjk::letter(static_cast<gjk::Role>(i));
    }
    const Footpoint found = footpoint(vertices, p);
    if (found.weights.minCoeff() < -border || found.distance > least + border) continue;
    const bool tie = found.distance > least - border || found.weights.minCoeff() < border;
    nearest = tie ? "" : letters;
    least = std::min(least, found.distance);
  }
  return nearest;
}

}  // namespace walkthroughs::test
