#include "walkthroughs/text/scene_object.hpp"

#include <cmath>
#include <numbers>

#include "walkthroughs/text/scene_limits.hpp"

namespace walkthroughs::reading {
namespace {

/// Returns: cosine and sine, exact for quarter turns.
std::pair<double, double> cosine_and_sine(double degrees) {
  const double rest = std::remainder(degrees, 360);
  if (rest == 0) return {1, 0};
  if (std::abs(rest) == 180) return {-1, 0};
  if (std::abs(rest) == 90) return {0, rest > 0 ? 1 : -1};
  const double radians = rest * (std::numbers::pi / 180);
  return {std::cos(radians), std::sin(radians)};
}

/// Rodrigues' formula.
Eigen::Matrix3d rotation_about(const Point& axis, double degrees) {
  const Point n = (axis / axis.cwiseAbs().maxCoeff()).normalized();  // in two steps: |axis|² may under- or overflow
  const auto [cosine, sine] = cosine_and_sine(degrees);
  Eigen::Matrix3d cross;
  cross << 0, -n.z(), n.y(), n.z(), 0, -n.x(), -n.y(), n.x(), 0;
  return cosine * Eigen::Matrix3d::Identity() + (1 - cosine) * n * n.transpose() + sine * cross;
}

Eigen::Matrix3d read_rotation(const Value& value, const Space& space) {
  expect_object(value, {"axis", "degrees"}, "an object with 'axis' and 'degrees'");
  const auto axis_given = value.member("axis");
  Point axis(0, 0, 1);
  if (axis_given || !space.is_plane()) {
    const Value axis_value = required(value, "axis", "give it as a direction [x, y, z]");
    axis = Space{Dimension::space}.direction(axis_value);
    if (space.is_plane() && (axis.x() != 0 || axis.y() != 0))
      axis_value.fail("turns the object out of the plane; with \"dimension\": 2 leave the axis out");
  }
  return rotation_about(axis, number(required(value, "degrees", "give the angle as a number")));
}

Pose read_pose(const Value& value, const Space& space) {
  expect_object(value, {"translation", "rotation"}, "an object with 'translation' and 'rotation'");
  Pose pose;
  if (const auto rotation = value.member("rotation")) pose.rotation = read_rotation(*rotation, space);
  if (const auto translation = value.member("translation")) pose.translation = space.point(*translation);
  return pose;
}

}  // namespace

ObjectAsWritten read_object(const Value& value, const Space& space) {
  ObjectAsWritten object;
  if (!expect_object(value, object_keys(), "an object with a shape")) return object;
  object.form = read_shape(value, space);
  if (const auto name = value.member("name")) object.name = words(*name, scene_limits::name);
  if (const auto pose = value.member("pose")) object.pose = read_pose(*pose, space);
  return object;
}

}  // namespace walkthroughs::reading
