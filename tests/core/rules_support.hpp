/// Asks one of Algorithms 2-5 about one simplex, and puts what it told into words that a test can compare.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/core/oracle.hpp"
#include "tests/core/support.hpp"
#include "tests/kit/catch.hpp"

namespace gjk::test {

template <class S>
struct Told {
  std::string skipped;     ///< "B R4, BC R5, C R6, A R2"
  std::string decided;     ///< "AB R3: no, AC R7: yes"
  std::string next;        ///< the next simplex, oldest first, in the roles of the one given: "CAB"; empty at the end
  std::string expression;  ///< of the next direction
  std::optional<Vec3<S>> direction;  ///< empty where the simplex contains the origin
  std::vector<RegionTested<S>> regions;

  const RegionTested<S>& region(const std::string& feature, const std::string& face = "") const {
    for (const auto& r : regions)
      if (to_string(r.feature) == feature && to_string(r.face) == face) return r;
    throw std::logic_error("no word of " + feature);
  }
};

/// Vertices of the difference that remember their place in `oldest_first` through their index.
template <class S>
Simplex<S> simplex_of(const std::vector<Vec3<S>>& oldest_first) {
  Simplex<S> simplex;
  int i = 0;
  for (const Vec3<S>& w : oldest_first) simplex.add({SupportPoint<S>(w, i++), SupportPoint<S>(Vec3<S>::Zero()), w});
  return simplex;
}

inline void append(std::string& list, const std::string& item) { list += (list.empty() ? "" : ", ") + item; }

/// Runs the algorithm for this size of simplex, the last point being A.
template <class S>
Told<S> ask_rules(const std::vector<Vec3<S>>& oldest_first);

/// Points relative to an origin, as they look in a frame.
template <class S>
std::vector<Vec3<S>> seen_from(const Point& origin, const Points& points, const Frame<S>& frame) {
  return seen(moved(points, {-origin[0], -origin[1], -origin[2]}), frame);
}

/// What a rule must tell and do where the origin lies in a region. The search goes on straight from the feature that is kept
/// toward the origin, whatever formula the report has for it.
struct Outcome {
  std::string decided, next, expression;
};
template <class S>
Told<S> require_outcome(const Outcome& expected, const std::string& skipped, const std::vector<Vec3<S>>& simplex);

struct OutcomeAt {
  Point origin;
  Outcome outcome;
};
/// Floating point recognises "exactly on" only where nothing is rounded.
enum class In { all_frames, frames_without_rounding };
/// In each scalar. `points`: the simplex, oldest first.
void require_outcomes(In places, const Points& points, const std::string& skipped,
                      const std::vector<OutcomeAt>& expected);

}  // namespace gjk::test
