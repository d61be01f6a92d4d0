/// How near to the origin a search has come, iteration by iteration, and by which points of the two objects. It follows from the
/// simplices that the events tell, without any rounding: no number of the search is asked.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "walkthroughs/story/exact.hpp"
#include "walkthroughs/story/story.hpp"

namespace walkthroughs::story {

/// One iteration, as its last simplex is: that which it keeps, the whole one that holds the origin, or still the one before
/// where the vertex found was not added.
///
///  P1. `nearest` is the point of that simplex nearest to the origin: 0 exactly where the origin is in it.
///  P2. `on_a` − `on_b` is `nearest`, but for what rounding a − b has cost the vertices of the search.
struct Progress {
  int iteration = 0;
  std::size_t event = 0;     ///< of the trace: from there on that simplex is known
  bool is_fallback = false;  ///< whether it is one of the exact fallback, which begins anew
  double distance = 0;       ///< of `nearest` from the origin, finite
  ExactVector nearest = ExactVector::Zero(), on_a = nearest, on_b = nearest;
};

/// Returns: that of each iteration with a simplex, in order. One whose vertices are not finite is left out.
std::vector<Progress> progress_of(const Telling& telling);

/// Returns: how many of them an event of the trace leaves known, itself included.
std::size_t known_at(const std::vector<Progress>& progress, std::size_t event);

/// Returns: the last that is known in words, whole sentences.
std::string progress_told(const std::vector<Progress>& progress, std::size_t known, Dimension dimension);

}  // namespace walkthroughs::story
