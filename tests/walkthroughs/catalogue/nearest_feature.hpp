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

using namespace program;

/// The point of a feature's line, plane or space that is nearest to a point, and the weights of the feature's vertices in it:
/// one is negative exactly where the point lies beyond what is opposite to its vertex.
struct Footpoint {
  std::vector<double> weights;
  Point at;
};

/// Requires: up to four vertices. Of vertices that depend on each other the weights are not finite.
inline Footpoint footpoint(const std::vector<Point>& vertices, const Point& p) {
  Eigen::Matrix3d edges = Eigen::Matrix3d::Zero(), missing = Eigen::Matrix3d::Identity();
  const auto count = static_cast<Eigen::Index>(vertices.size()) - 1;
  for (Eigen::Index i = 0; i < count; ++i) {
    edges.col(i) = vertices[static_cast<std::size_t>(i) + 1] - vertices[0];
    missing(i, i) = 0;
  }
  const Eigen::Matrix3d gram = edges.transpose() * edges + missing;
  const Point found = gram.inverse() * (edges.transpose() * (p - vertices[0]));
  std::vector<double> weights{1 - found.sum()};
  for (Eigen::Index i = 0; i < count; ++i) weights.push_back(found[i]);
  return {weights, vertices[0] + edges * found};
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
    const double distance = (found.at - p).norm(), weight = *std::ranges::min_element(found.weights);
    if (weight < -border || distance > least + border) continue;
    nearest = distance > least - border || weight < border ? "" : letters;
    least = std::min(least, distance);
  }
  return nearest;
}

}  // namespace walkthroughs::test
