/// The points a - b of two sets, up to the rounding of programs that compute in floats, or print few digits.
#pragma once

#include <optional>

#include "walkthroughs/steps/told_run.hpp"

namespace walkthroughs::steps {

/// Returns: whether they lead the same way.
bool parallel(const Vec& x, const Vec& y);

class Differences {
 public:
  /// Requires: points that outlive it.
  Differences(const Points& a, const Points& b);

  /// Returns: the longest edge of the box around both sets.
  double size() const { return size_; }

  /// Returns: the a - b next to it, if that is the same up to the rounding of floats, or of six digits; else itself, also where there
  /// are too many to look at.
  Vec nearest(const Vec& v) const;

  bool are_same(const Vec& x, const Vec& y) const;
  bool has(const Vertices& vertices, const Vec& v) const;

  /// Returns: all a - b of points that are farthest along these; of very many some.
  Vertices farthest(const Vec& d, const Vec& d_of_b) const;

  /// Returns: whether it is an a - b, and as far along d as any.
  bool reaches(const Vec& v, const Vec& d) const;

  /// Returns: whether it is one of these; false where there are too many to look at.
  bool is_farthest(const Vec& v, const Vec& d, const Vec& d_of_b) const;

  /// Returns: a direction along which that a - b is the farthest; none where none is found.
  std::optional<Vec> direction_to(const Vec& v) const;

  /// Returns: whether it is any a - b; true where there are too many to look at.
  bool contain(const Vec& v) const;

 private:
  Points farthest(const Points& points, const Vec& d) const;
  bool is_between(const Points& a, const Points& b, const Vec& v) const;

  const Points &a_, &b_;
  double size_;
};

/// Every vertex becomes the a - b that it is a rounding of, and the newest the last, where it is always first. Who takes the first
/// point before the loop tells it with the second: then a step of its own is put before them.
void bring_to_differences(ToldRun& run);

}  // namespace walkthroughs::steps
