/// Light and shade of bodies in space.
#pragma once

#include <array>
#include <vector>

#include "walkthroughs/picture/lens.hpp"

namespace walkthroughs::picture {

/// How much light a surface gets: 0 where it is turned away from the light, 1 where it faces it. The light comes from above the
/// viewer's left shoulder. Round surfaces are drawn in these steps.
inline constexpr std::array light_steps{0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.88, 0.95};
double light_on(const Point& outward, const render::Camera& camera);

/// Returns: of what has no faces, the part of its picture that gets at least so much light, a convex outline for each of
/// `light_steps`. Counts no support call. Requires: a lens with a camera.
std::vector<std::vector<render::Vec2>> lit_parts(const Object& object, const Lens& lens);
/// The same of the difference. Asks the support functions.
std::vector<std::vector<render::Vec2>> lit_parts_of_difference(const Scene& scene, const Lens& lens);

}  // namespace walkthroughs::picture
