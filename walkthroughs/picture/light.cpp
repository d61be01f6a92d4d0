#include "walkthroughs/picture/light.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "walkthroughs/model/farthest_face.hpp"
#include "walkthroughs/model/labelled_hull.hpp"

namespace walkthroughs::picture {
namespace {

using render::Vec2;

constexpr int rim_points = 72;

Point light_of(const render::Camera& camera) {
  return (0.6 * camera.toward_viewer() + 0.65 * camera.up() - 0.45 * camera.right()).normalized();
}

/// Returns: the part of a picture that gets at least so much light: what a surface turns to a cone of directions around the
/// light. Directions away from the viewer count as those of the outline.
std::vector<Vec2> lit_part(const auto& support, double light, const Lens& lens) {
  const DirectionFrame frame(light_of(*lens.camera));
  const Point& viewer = lens.camera->toward_viewer();
  const double cosine = 2 * light - 1, sine = std::sqrt(1 - cosine * cosine);
  std::vector<Vec2> part;
  for (int i = 0; i < rim_points; ++i) {
    const double angle = 2 * std::numbers::pi * i / rim_points;
    Point outward = frame.at(cosine, Vec2(std::cos(angle), std::sin(angle)) * sine);
    outward -= std::min(0.0, outward.dot(viewer)) * viewer;
    part.push_back(lens(support(outward)));
  }
  return convex_hull(std::move(part));
}

std::vector<std::vector<Vec2>> all_lit_parts(const auto& support, const Lens& lens) {
  std::vector<std::vector<Vec2>> parts;
  for (const double light : light_steps) parts.push_back(lit_part(support, light, lens));
  return parts;
}

}  // namespace

double light_on(const Point& outward, const render::Camera& camera) {
  return (1 + outward.stableNormalized().dot(light_of(camera))) / 2;
}

std::vector<std::vector<Vec2>> lit_parts(const Object& object, const Lens& lens) {
  const PosedForm<double> form(Asked<double>(object.form), object.pose);  // which counts no call
  return all_lit_parts([&](const Point& d) { return form.support(d).point; }, lens);
}

std::vector<std::vector<Vec2>> lit_parts_of_difference(const Scene& scene, const Lens& lens) {
  const AskedObject<double> a(scene.a), b(scene.b);
  const gjk::MinkowskiDifference<double, AskedObject<double>, AskedObject<double>> difference(a, b);
  return all_lit_parts([&](const Point& d) { return difference.vertex(d).w; }, lens);
}

}  // namespace walkthroughs::picture
