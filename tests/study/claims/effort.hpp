/// What a query costs, and whether the report's shortcuts were sound in it: observers of runs.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>

#include "core/events.hpp"
#include "tests/study/sweep/tally.hpp"
#include "tests/study/truth/nearest_feature.hpp"

namespace study {

// clang-format off
/// What is counted of one shape, each in a histogram.
enum class Effort {
  hits, misses, wrong, undecided,            // queries, by iterations
  hit_cross_products, miss_cross_products,   // queries, by cross products
  most_in_a_3simplex,                        // queries, by the most cross products that one 3-simplex took
  simplices,                                 // by the number of vertices
  nearest_of_2, nearest_of_3, nearest_of_4,  // simplices of so many vertices, by Feature; all of it where it has the origin
  kept_the_nearest,  // 3-simplices that are not flat, by whether Algorithm 5 keeps the nearest feature
  // Section 3.2.3: "AB·AO > 0 and BA·BO > 0 in addition to Eq. 12", which the report does without. By iteration: edges AX kept;
  // of these, AX·AO > 0 is false, the origin lies beyond A; XA·XO > 0 is false, it lies beyond X.
  triangle_edges, triangle_newest_false, triangle_older_false,           // Algorithm 4
  tetrahedron_edges, tetrahedron_newest_false, tetrahedron_older_false,  // Algorithm 5
};
inline constexpr std::array effort_names{
    "hits", "misses", "wrong", "undecided", "hit_cross_products", "miss_cross_products", "most_in_a_3simplex",
    "simplices", "nearest_of_2", "nearest_of_3", "nearest_of_4", "kept_the_nearest",
    "triangle_edges", "triangle_newest_false", "triangle_older_false",
    "tetrahedron_edges", "tetrahedron_newest_false", "tetrahedron_older_false"};
// clang-format on

struct EffortCounts {
  std::array<Histogram, effort_names.size()> histograms;

  Histogram& operator[](Effort effort) { return histograms[static_cast<std::size_t>(effort)]; }
  EffortCounts& operator+=(const EffortCounts& more) {
    for (std::size_t i = 0; i < histograms.size(); ++i) add(histograms[i], more.histograms[i]);
    return *this;
  }
};

/// Counts the cross products of a run from what it tells. Algorithm 5 is counted as it runs here: the normals of Eq. 14
/// one by one, until one sees the origin; the report's listing computes all three first.
struct CrossProducts {
  int total = 0, most_in_a_3simplex = 0;

  template <class E>
  void operator()(const E&) {}

  template <class S>
  void operator()(const gjk::VertexAdded<S>&) {
    in_this_simplex_ = 0;
  }

  template <class S>
  void operator()(const gjk::RegionTested<S>& event) {
    if (event.verdict == gjk::Verdict::skipped) return;
    const int made = made_for(event);
    total += made;
    in_this_simplex_ += made;
    if (event.simplex_size == 4) most_in_a_3simplex = std::max(most_in_a_3simplex, in_this_simplex_);
  }

 private:
  /// X×Y×Z is two of them.
  template <class S>
  static int made_for(const gjk::RegionTested<S>& event) {
    const bool chosen = event.verdict == gjk::Verdict::chosen, is_edge = event.feature.size() == 2;
    const int direction = chosen && is_edge ? 2 : 0;
    switch (event.simplex_size) {
      case 2: return 2;                                          // AB×AO×AB
      case 3: return (label_of(event) == gjk::RegionLabel::R3 ? 3 : 0) + direction;  // ABCn, ABn and ACn, before the first test
      case 4:
        if (is_edge) return direction;
        return event.formula.empty() ? 0 : 1 + (chosen ? 2 : 0);  // a face's normal, and where it sees O its edges'
      default: return 0;
    }
  }

  int in_this_simplex_ = 0;
};

/// Returns: the simplex with what vertices are in the difference alone. Errors: std::logic_error where a coordinate is not a double.
template <class S>
gjk::Simplex<double> in_doubles(const gjk::Simplex<S>& simplex) {
  gjk::Simplex<double> converted;
  for (int i = 0; i < simplex.size(); ++i) {
    const gjk::Vec3<double> w = simplex[i].w.template cast<double>();
    if (w.template cast<S>() != simplex[i].w) throw std::logic_error("a vertex is not of doubles");
    converted.add({{}, {}, w});
  }
  return converted;
}

/// Looks, exactly, where the origin lies when Algorithms 3-5 are called.
class Shortcuts {
 public:
  /// `counts`: gets what is seen.
  explicit Shortcuts(EffortCounts& counts) : counts_(counts) {}

  template <class E>
  void operator()(const E&) {}

  template <class S>
  void operator()(const gjk::VertexAdded<S>& event) {
    using enum Effort;
    const gjk::Simplex<double>& simplex = simplex_ = in_doubles(event.simplex);
    const int size = simplex.size();
    count(counts_[simplices], size);
    nearest_ = size >= 2 ? nearest_feature(simplex) : feature_of(gjk::Role::A);
    if (size < 2) return;
    const bool is_inside = nearest_ != 0 && lies_on(simplex, nearest_);
    const Effort nearest[] = {nearest_of_2, nearest_of_3, nearest_of_4};
    count(counts_[nearest[size - 2]], static_cast<int>(is_inside ? (1U << size) - 1 : nearest_));
  }

  void operator()(const gjk::SimplexReduced<double>& event) {
    if (event.before.size() < 4 || nearest_ == 0) return;  // of a flat one it cannot be told
    Feature kept = 0;
    for (const gjk::Role role : event.kept) kept |= 1U << static_cast<int>(role);
    count(counts_[Effort::kept_the_nearest], kept == nearest_);
  }

  void operator()(const gjk::RegionTested<double>& event) {
    if (event.verdict != gjk::Verdict::chosen || event.feature.size() != 2 || event.simplex_size < 3) return;
    const gjk::Role other = event.feature[1];
    const bool is_triangle = event.simplex_size == 3;
    using enum Effort;
    count(counts_[is_triangle ? triangle_edges : tetrahedron_edges], event.iteration);
    if (!lies_toward(simplex_, gjk::Role::A, other))
      count(counts_[is_triangle ? triangle_newest_false : tetrahedron_newest_false], event.iteration);
    if (!lies_toward(simplex_, other, gjk::Role::A))
      count(counts_[is_triangle ? triangle_older_false : tetrahedron_older_false], event.iteration);
  }

 private:
  EffortCounts& counts_;
  gjk::Simplex<double> simplex_;
  Feature nearest_ = 0;  ///< of it
};

}  // namespace study
