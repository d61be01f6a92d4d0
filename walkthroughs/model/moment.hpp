/// The state of a search at one moment, replayed from its trace alone.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "walkthroughs/model/scene.hpp"

namespace walkthroughs::model {

using Vertex = gjk::Vertex<double>;
using Simplex = gjk::Simplex<double>;

struct Direction {
  gjk::Expression expression;  ///< empty for the first direction, which comes from no feature
  Point value;
  Simplex from;  ///< the simplex that it leads away from; empty for the first direction
};

struct Moment {
  int iteration = 0;
  std::optional<Direction> direction;
  std::optional<Vertex> found;  ///< what the support function returned for `direction`
  bool added = false;           ///< whether `found` has joined the simplex
  Simplex simplex;              ///< as it stands, `found` included once it was added
  Simplex processed;            ///< the one that the letters A, B, C, D speak of: as of the last VertexAdded
  Simplex before;               ///< the one that they spoke of until that VertexAdded
  std::vector<Point> known;     ///< of the difference, each once, in the order in which they were found
  std::vector<std::pair<Point, Point>> segments;         ///< edges that simplices of this search have had, oldest first
  std::optional<gjk::CrossingTested<double>> crossing;   ///< of `found`
  std::vector<gjk::RegionTested<double>> regions;        ///< of this iteration so far, the skipped ones included
  std::optional<gjk::SimplexReduced<double>> reduction;  ///< of this iteration
  std::optional<gjk::Result<double>> result;
  // Of a search whose answer is proven.
  std::optional<gjk::FilterTried<double>> proof;  ///< the last that was tried
  bool in_exact_fallback = false;                 ///< which follows where none holds; `result` is empty again then
  std::optional<gjk::Status> guess;               ///< what the first search had found, once the second has begun
  std::vector<gjk::SignTaken<double>> signs;      ///< of this iteration of the exact fallback
  std::optional<gjk::FeatureKept<double>> kept;   ///< of that iteration
  std::optional<gjk::CertifiedResult> certified;
  double scale = 1;  ///< of its points, where they are drawn in a unit of their own; its numbers stay the trace's
};

/// Makes the moment before an event that after it.
void advance(Moment& now, const gjk::Event<double>& event);

/// Returns: the moment after the first `count` events. Requires: count <= trace.events.size().
Moment replay(const Trace& trace, std::size_t count);

/// Returns: the answer with which a complete trace ends, the proven one where there is one.
gjk::Status answer_of(const Trace& trace);

}  // namespace walkthroughs::model
