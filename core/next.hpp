/// What Algorithms 2-5 return.
#pragma once

#include "simplex.hpp"

namespace gjk {

/// Either the simplex contains the origin, or the search goes on from it in a direction.
template <class S>
class Next {
 public:
  static Next origin_found() { return {}; }
  static Next search_along(const Vec3<S>& direction) { return Next(direction); }

  bool contains_origin() const { return contains_origin_; }

  /// Requires: not contains_origin().
  const Vec3<S>& direction() const { return direction_; }

 private:
  Next() {}
  explicit Next(const Vec3<S>& direction) : contains_origin_(false), direction_(direction) {}

  bool contains_origin_ = true;
  Vec3<S> direction_;
};

}  // namespace gjk
