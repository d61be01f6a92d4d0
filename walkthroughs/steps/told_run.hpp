/// A search as somebody else's program tells it: a line at the end of each iteration, and perhaps the answer.
///
///     {"direction":[1,0,0],"simplex":[[3,1,0]]}
///     {"direction":[-3,-1,0],"simplex":[[3,1,0],[-2,0,1]]}
///     yes
///
/// A step says along which direction it searched, and the simplex after it was reduced, points a - b, the newest last; whoever
/// has it first in every step is understood, too. The first point may come with the second. The last simplex need not be
/// reduced, and the step that ends a search with "no" need not be told: its vertex never becomes part of a simplex. What is
/// no number, such as nan, is read as that. Vertices may be rounded to floats, or to six digits.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "walkthroughs/pairs/pair.hpp"

namespace walkthroughs::steps {

using Vertices = std::vector<Vec>;  ///< of a simplex, oldest first

struct ToldStep {
  Vec direction;
  Vertices simplex;  ///< one to four

  /// Returns: whether all that it says are numbers.
  bool is_of_numbers() const;
};

struct ToldRun {
  std::string name;  ///< of the pair
  PointPair pair;
  std::vector<ToldStep> steps = {};
  std::optional<gjk::Status> said = {};
  double roundings = 1;  ///< of its numbers, in those of doubles
};

/// Returns: whether a line is meant as a step: an object with a direction and a simplex, and no status, of no unreasonable length.
bool is_meant_as_step(std::string_view line);

/// Errors: std::invalid_argument, which says what is wrong with the line.
ToldStep read_step(std::string_view line);

}  // namespace walkthroughs::steps
