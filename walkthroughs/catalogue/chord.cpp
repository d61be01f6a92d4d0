#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "walkthroughs/catalogue/figure_objects.hpp"

namespace walkthroughs::catalogue {
namespace {

using render::Interval;
using render::Vec2;

constexpr double rounding = 1e-9;  // sets are of size 1: a circle line is as wide as the rounding error of its points
constexpr double as_long = 0.99;   // parts outside that differ by less count as equally long
constexpr int samples = 64;        // along a chord
constexpr double first_angle = 13 * std::numbers::pi / 12;  // a chord found first lies aslant
constexpr int rings = 6, around = 48;  // circles of points that chords join, and how many are on each
constexpr int halvings = 40;           // to find where a chord leaves the set

double fraction_of(int sample) { return (sample + 0.5) / samples; }

/// Returns: the fraction between `in`, where the chord is in the set, and `out`, where it is not, at which it leaves.
double border(const PlanarSet& set, const Chord& chord, double in, double out) {
  for (int i = 0; i < halvings; ++i) {
    const double middle = (in + out) / 2;
    (set.contains(chord.at(middle)) ? in : out) = middle;
  }
  return (in + out) / 2;
}

std::vector<Interval> parts_outside(const PlanarSet& set, const Chord& chord) {
  std::vector<Interval> parts;
  double last_in = 0, last_out = -1;  // -1: the last sample was in the set
  const auto visit = [&](double at) {
    if (set.contains(chord.at(at))) {
      if (last_out >= 0) parts.back().to = border(set, chord, at, last_out);
      last_in = at;
      last_out = -1;
    } else {
      if (last_out < 0) parts.push_back({border(set, chord, last_in, at), 1});
      last_out = at;
    }
  };
  for (int i = 0; i < samples; ++i) visit(fraction_of(i));
  visit(1);
  return parts;
}

/// Requires: the chord leaves the set.
Interval longest_part(const Chord& chord) {
  return *std::ranges::max_element(chord.outside, {}, [](const Interval& part) { return part.to - part.from; });
}

double length_outside(const Chord& chord) {
  const Interval part = longest_part(chord);
  return (part.to - part.from) * chord.length();
}

/// Requires: each of the chords leaves the set; there is one.
Chord longest_outside(const std::vector<Chord>& chords) {
  const double longest = length_outside(*std::ranges::max_element(chords, {}, length_outside));
  const Chord* best = nullptr;
  for (const Chord& chord : chords) {
    if (length_outside(chord) < as_long * longest) continue;
    if (!best || chord.length() > best->length() + rounding) best = &chord;
  }
  return *best;
}

/// Returns: the middle of the unit disk and points on circles around it.
std::vector<Vec2> points_of_rings() {
  std::vector<Vec2> points = {Vec2::Zero()};
  for (int ring = 1; ring <= rings; ++ring) {
    for (int i = 0; i < around; ++i) {
      const double angle = first_angle + 2 * std::numbers::pi * i / around;
      points.push_back(Vec2(std::cos(angle), std::sin(angle)) * (1.0 * ring / rings));
    }
  }
  return points;
}

}  // namespace

bool PlanarSet::contains(const Vec2& p) const { return excess(p) <= rounding; }

ChordSearch deciding_chord(const PlanarSet& set, const std::vector<Vec2>& candidates, double long_enough) {
  std::vector<Vec2> points;
  std::ranges::copy_if(candidates, std::back_inserter(points), [&](const Vec2& p) { return set.contains(p); });
  ChordSearch search;
  std::vector<Chord> leaving;
  double shallowest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      Chord chord{points[i], points[j]};
      ++search.tried;
      chord.outside = parts_outside(set, chord);
      if (!chord.outside.empty()) {
        leaving.push_back(chord);
      } else if (chord.length() >= long_enough && set.excess(chord.at(0.5)) > shallowest + rounding) {
        shallowest = set.excess(chord.at(0.5));
        search.chord = chord;
      }
    }
  }
  search.leaving = leaving.size();
  if (leaving.empty()) return search;
  search.chord = longest_outside(leaving);
  const Interval part = longest_part(search.chord);
  search.witness = search.chord.at((part.from + part.to) / 2);
  return search;
}

ChordSearch decide_convexity(const PlanarSet& set) { return deciding_chord(set, points_of_rings(), 1); }

}  // namespace walkthroughs::catalogue
