/// What a query costs, and whether the report's shortcuts were sound in it: observers of runs.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>

#include "core/events.hpp"
#include "tests/study/truth/nearest_feature.hpp"
#include "tests/study/sweep/rate.hpp"

namespace study {

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
      case 3: return (event.label == "R3" ? 3 : 0) + direction;  // ABCn, ABn and ACn, before the first test
      case 4:
        if (is_edge) return direction;
        return event.formula.empty() ? 0 : 1 + (chosen ? 2 : 0);  // a face's normal, and where it sees O its edges'
      default: return 0;
    }
  }

  int in_this_simplex_ = 0;
};

/// Section 3.2.3: "AB·AO > 0 and BA·BO > 0 in addition to Eq. 12", which the report does without.
struct ExtraChecks {
  std::uint64_t edges = 0;         ///< where Eq. 12 or its like for another edge AX was true
  std::uint64_t newest_false = 0;  ///< of these AX·AO > 0 was false: the origin lies beyond A
  std::uint64_t older_false = 0;   ///< of these XA·XO > 0 was false: it lies beyond X

  ExtraChecks& operator+=(const ExtraChecks& other) {
    edges += other.edges;
    newest_false += other.newest_false;
    older_false += other.older_false;
    return *this;
  }
};

/// Looks, exactly, where the origin lies when Algorithms 3-5 are called.
struct Shortcuts {
  static constexpr std::size_t iterations = 21;

  std::array<std::array<std::uint64_t, 16>, 5>
      nearest{};  ///< by size of the simplex and Feature; all of it where it contains the origin
  std::array<ExtraChecks, iterations> in_triangle, in_tetrahedron;  ///< by iteration: Algorithm 4, Algorithm 5
  Rate kept_the_nearest;  ///< what Algorithm 5 keeps is the nearest feature, of those that are not flat
  std::size_t largest_simplex = 0;

  template <class E>
  void operator()(const E&) {}

  void operator()(const gjk::VertexAdded<double>& event) { look_at(event.simplex); }

  void look_at(const gjk::Simplex<double>& simplex) {
    simplex_ = simplex;
    const auto size = static_cast<std::size_t>(simplex.size());
    largest_simplex = std::max(largest_simplex, size);
    nearest_ = size >= 2 ? nearest_feature(simplex) : feature_of(gjk::Role::A);
    if (size < 2) return;
    const bool is_inside = nearest_ != 0 && lies_on(simplex, nearest_);
    ++nearest[size][is_inside ? (1U << size) - 1 : nearest_];
  }

  void operator()(const gjk::SimplexReduced<double>& event) {
    if (event.before.size() < 4 || nearest_ == 0) return;  // of a flat one it cannot be told
    Feature kept = 0;
    for (const char role : event.kept) kept |= 1U << (role - 'A');
    kept_the_nearest.add(kept == nearest_);
  }

  void operator()(const gjk::RegionTested<double>& event) {
    if (event.verdict != gjk::Verdict::chosen || event.feature.size() != 2 || event.simplex_size < 3) return;
    const auto other = static_cast<gjk::Role>(event.feature[1] - 'A');
    const auto iteration = std::min(static_cast<std::size_t>(event.iteration), iterations - 1);
    ExtraChecks& checks = (event.simplex_size == 3 ? in_triangle : in_tetrahedron)[iteration];
    ++checks.edges;
    if (!lies_toward(simplex_, gjk::Role::A, other)) ++checks.newest_false;
    if (!lies_toward(simplex_, other, gjk::Role::A)) ++checks.older_false;
  }

  Shortcuts& operator+=(const Shortcuts& other) {
    for (std::size_t size = 0; size < nearest.size(); ++size)
      for (std::size_t f = 0; f < nearest[size].size(); ++f) nearest[size][f] += other.nearest[size][f];
    for (std::size_t i = 0; i < iterations; ++i) {
      in_triangle[i] += other.in_triangle[i];
      in_tetrahedron[i] += other.in_tetrahedron[i];
    }
    kept_the_nearest += other.kept_the_nearest;
    largest_simplex = std::max(largest_simplex, other.largest_simplex);
    return *this;
  }

  /// Returns: how often `feature` was the nearest when a simplex of that many vertices was processed.
  Rate nearest_was(std::size_t size, Feature feature) const {
    Rate rate{nearest[size][feature], 0};
    for (const std::uint64_t n : nearest[size]) rate.trials += n;
    return rate;
  }

 private:
  gjk::Simplex<double> simplex_;
  Feature nearest_ = 0;  ///< of it
};

}  // namespace study
