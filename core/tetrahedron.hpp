/// Does a tetrahedron hold the origin? The volumes that tell.
#pragma once

#include "shapes.hpp"

namespace gjk::detail {

/// Let v(x, y, z) = (x×y)·z. For any four vectors a·v(b,c,d) − b·v(a,c,d) + c·v(a,b,d) − d·v(a,b,c) = 0. Where the four coefficients
/// have one strict sign, the origin is a convex combination of all four points.
template <class S>
struct VolumesAtOrigin {
  VolumesAtOrigin() = default;
  VolumesAtOrigin(const Vec3<S>& a, const Vec3<S>& b, const Vec3<S>& c, const Vec3<S>& d) {
    const Vec3<S> cd = c.cross(d), ab = a.cross(b);
    bcd = b.dot(cd), acd = a.dot(cd), abd = ab.dot(d), abc = ab.dot(c);
  }

  /// Whether each is beyond `error` on the side where the origin lies inside.
  template <class Error>
  bool hold_origin(const Error& error) const {
    return (bcd > error && acd < -error && abd > error && abc < -error) ||
           (bcd < -error && acd > error && abd < -error && abc > error);
  }

  S bcd = 0, acd = 0, abd = 0, abc = 0;
};

}  // namespace gjk::detail
