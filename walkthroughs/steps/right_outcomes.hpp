/// What the report's rules make of a simplex, in any order of its vertices that leaves normals outward: all of that is right.
#pragma once

#include <string>
#include <vector>

#include "core/simplex.hpp"
#include "walkthroughs/steps/told_run.hpp"

namespace walkthroughs::steps {

using Indices = std::vector<int>;  ///< into a list of vertices

struct Outcome {
  bool contains_origin = false;
  Indices kept;  ///< oldest first
  Vec direction = Vec::Zero();
  std::string why;  ///< "ABCn·AO = 3 > 0", in the letters of the vertices as they were told
};

/// Returns: the order in which they were told.
Indices as_told(const Vertices& vertices);

/// Returns: those of the older vertices that leave normals outward, first the one in which they were told if it does.
std::vector<Indices> outward_orders(const Vertices& vertices);

/// Returns: what the report does with the vertices in that order, in doubles.
Outcome outcome_of(const Vertices& vertices, const Indices& order);

/// Returns: all that is right, first what the report does with the vertices in their order, in doubles: what it does in fractions,
/// too, and the feature nearest to the origin, which is another where the origin lies just on the border of a region.
std::vector<Outcome> right_outcomes(const Vertices& vertices);

/// Vertices that know their places in the list, and a simplex of them.
gjk::Simplex<double> simplex_of(const Vertices& vertices, const Indices& order);
Indices indices_of(const gjk::Simplex<double>& simplex);

/// Returns: for reading, so without the sign of a zero, and short.
std::string shown(double number);

}  // namespace walkthroughs::steps
