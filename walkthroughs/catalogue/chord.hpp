/// Is a planar set convex? Section 2.2 asks of every two of its points whether the chord between them stays inside;
/// here the question is asked of finitely many.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "render/geometry.hpp"
#include "walkthroughs/rooms.hpp"

namespace walkthroughs::catalogue {

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

/// Returns: the middle of a disk and `rings` circles around it up to `radius`, with `around` points each.
std::vector<render::Vec2> points_of_rings(double radius, int rings, int around);

}  // namespace walkthroughs::catalogue
