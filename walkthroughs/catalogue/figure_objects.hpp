/// The objects of the report's figures. It prints neither their coordinates nor their measures.
#pragma once

#include <functional>
#include <optional>

#include "render/geometry.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/catalogue/region_grid.hpp"

namespace walkthroughs::catalogue {

// Is a planar set convex? Section 2.2 asks of every two of its points whether the chord between them stays inside; here the
// question is asked of finitely many.

/// A closed set of the plane.
struct PlanarSet {
  std::string name;
  /// How far outside a point lies: at most 0 in the set, and the smaller the deeper in it.
  std::function<double(const render::Vec2&)> excess;

  bool contains(const render::Vec2& p) const;
};

struct Chord {
  render::Vec2 from = render::Vec2::Zero(), to = render::Vec2::Zero();
  std::vector<render::Interval> outside = {};  ///< the parts that are not in the set, in order

  render::Vec2 at(double fraction) const { return from + (to - from) * fraction; }
  double length() const { return (to - from).norm(); }
};

struct ChordSearch {
  std::size_t tried = 0, leaving = 0;  ///< chords; those of them with a part outside the set
  Chord chord;                         ///< the one that decides
  /// In the middle of the longest part outside; empty where no chord leaves the set.
  std::optional<render::Vec2> witness;
};

/// Tries the chords between every two of those `candidates` that lie in the set.
///
/// Returns: the chord with the longest part outside; of those within 1 % of it the longest chord. Where none leaves the
/// set, the one whose middle lies least deep in it, of the chords at least `long_enough`. Of equals the first.
ChordSearch deciding_chord(const PlanarSet& set, const std::vector<render::Vec2>& candidates, double long_enough);

/// The same, of points all over the unit disk, and chords at least as long as its radius.
ChordSearch decide_convexity(const PlanarSet& set);

// The objects behind Figure 4, chosen so that the search makes every move that Section 3.1.2 tells. A triangle and a
// quadrilateral with no parallel sides have a heptagon for a difference.

/// Two objects that intersect.
inline Scene figure_4_left_scene() {
  return scene_of("triangle", {{-1.25, 1.25}, {0.5, 2.25}, {2.25, 1.75}}, "quadrilateral",
                  {{-1.5, -1.5}, {-1.25, 2.25}, {1, 0}, {1.25, -1.75}}, "left");
}

/// Two objects that do not.
inline Scene figure_4_right_scene() {
  return scene_of("triangle", {{-1, 2.5}, {2.25, 0.5}, {2.5, 2}}, "quadrilateral",
                  {{0.25, -1}, {0.5, -2}, {-1.75, -2.5}, {-0.75, 0}}, "right");
}

// The simplices of Figures 6-8 have the letters where the report has them.

/// B at the left, A at the right.
inline Simplex figure_6_simplex() { return simplex_of({{-2, -0.6, 0}, {2, 0.6, 0}}); }
inline Window figure_6_window() { return {.low = {-6.6, -2.332}, .high = {6.6, 2.332}}; }

/// A on top, B at the left, C at the right: ABCn points to the reader.
inline Simplex figure_7_simplex() { return simplex_of({{1.4, -0.9, 0}, {-1.6, -0.9, 0}, {-0.2, 1.1, 0}}); }
inline Window figure_7_window() { return {.low = {-7.36, -2.3}, .high = {7.36, 2.9}}; }

/// BCD lies in the plane z = 0, counter-clockwise seen from above, B at the back; A lies above it.
inline Simplex figure_8_simplex() {
  return simplex_of({{1.5, -0.85, 0}, {-1.6, -0.85, 0}, {0.1, 1.6, 0}, {0.05, 0.4, 2.4}});
}
/// A third of the way from BCD to A.
inline Window figure_8_slice() { return {.low = {-4.5, -2.5}, .high = {4.5, 3.145}, .height = 0.8}; }

}  // namespace walkthroughs::catalogue
