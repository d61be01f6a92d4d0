/// Where searches begin that test the first point, too, unless they are told where.
#pragma once

#include "core/gjk.hpp"
#include "walkthroughs/rooms.hpp"

namespace walkthroughs::model {

/// Returns: the direction from one center to the other, found in doubles as files have them; the usual one where these
/// coincide or S has no such direction.
template <class S>
gjk::Vec3<S> direction_between_centers(const gjk::Vec3<double>& center_a, const gjk::Vec3<double>& center_b) {
  const gjk::Vec3<double> d = gjk::first_direction_between(center_a, center_b);
  const gjk::Vec3<S> direction(static_cast<S>(d.x()), static_cast<S>(d.y()), static_cast<S>(d.z()));
  return gjk::is_usable_direction(direction) ? direction : gjk::Options<S>{}.first_direction;
}

}  // namespace walkthroughs::model
