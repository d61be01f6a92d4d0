#include "walkthroughs/model/scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <utility>

#include "walkthroughs/model/number_text.hpp"

namespace walkthroughs::model {

bool is_at_rest(const Pose& pose) {
  const Pose rest;
  return std::memcmp(pose.rotation.data(), rest.rotation.data(), sizeof(double[9])) == 0 &&
         std::memcmp(pose.translation.data(), rest.translation.data(), sizeof(double[3])) == 0;
}

bool moves(const Pose& pose) {
  return pose.rotation != Eigen::Matrix3d::Identity() || pose.translation != Point::Zero();
}

bool is_same(const Object& one, const Object& other) { return one.form == other.form && one.pose == other.pose; }

double distance_from_rotation(const Eigen::Matrix3d& matrix) {
  const Eigen::Matrix3d product = matrix.transpose() * matrix;
  if (!(matrix.determinant() > 0)) return std::numeric_limits<double>::infinity();
  return (product - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
}

namespace {

/// Returns: the quaternion times a power of two, so that its square neither overflows nor vanishes.
gjk::Quaternion near_one(const gjk::Quaternion& q) {
  const int exponent = std::ilogb(std::max({std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)}));
  const auto scaled = [exponent](double x) { return std::scalbn(x, -exponent); };
  return {scaled(q.w), scaled(q.x), scaled(q.y), scaled(q.z)};
}

}  // namespace

template <class S>
Eigen::Matrix<S, 3, 3> matrix_of(const gjk::Quaternion& quaternion) {
  const gjk::Quaternion q = near_one(quaternion);
  const S w = q.w, x = q.x, y = q.y, z = q.z, square = w * w + x * x + y * y + z * z;
  Eigen::Matrix<S, 3, 3> matrix;
  matrix << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),  //
      2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),        //
      2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z;
  return matrix / square;
}
template Eigen::Matrix<double, 3, 3> matrix_of(const gjk::Quaternion& quaternion);
template Eigen::Matrix<long double, 3, 3> matrix_of(const gjk::Quaternion& quaternion);

std::vector<Point> vertices_of(const Object& object) {
  std::vector<Point> vertices;
  if (const auto* set = std::get_if<Points>(&object.form))
    for (const Point& p : *set) vertices.push_back(object.pose(p));
  return vertices;
}

Point center_of(const Object& object) { return put<double>(object.pose, middle<double>(object.form)); }

Scene from_center_to_center(Scene scene) {
  const Point a = center_of(scene.a), b = center_of(scene.b);
  scene.options.first_direction = with_scalar(
      scene.scalar, [&]<class S>() -> Point { return direction_between_centers<S>(a, b).template cast<double>(); });
  return scene;
}

Scene mistaken(Scene scene, Mistake mistake) {
  scene.mistake = mistake;
  scene.rules = wrong_on_purpose::description_of(mistake).rules;
  scene.options.crossing_test = gjk::CrossingTest::on;
  scene.zero_test = ZeroTest::exact;
  scene.scalar = Scalar::binary64;
  scene.certified = false;
  return scene;
}

bool may_be_mistaken(const Scene& scene) {
  return scene.rules == RuleSet::as_intended && scene.options.crossing_test == gjk::CrossingTest::on &&
         scene.zero_test == ZeroTest::exact && scene.scalar == Scalar::binary64 && !scene.certified;
}

// -- Other scalars ----------------------------------------------------------------------------------------------------

namespace {

double nearest_float(double x) {
  const double rounded = static_cast<float>(x);
  if (!std::isfinite(rounded)) throw std::range_error(number_text(x) + " is beyond all floats");
  return rounded;
}

Point nearest_float(const Point& p) {
  return p.unaryExpr([](double x) { return nearest_float(x); });
}

double positive_float(double length) {
  const double rounded = nearest_float(length);
  if (rounded == 0) throw std::range_error(number_text(length) + " is too small for a float and becomes 0");
  return rounded;
}

struct NearestFloats {
  Point point(const Point& p) const { return nearest_float(p); }
  Point direction(const Point& d) const { return nearest_float(d); }
  double length(double x) const { return x == 0 ? 0 : positive_float(x); }
};

}  // namespace

void round_to_float(Object& object) {
  object.form = converted<double>(object.form, NearestFloats{});
  for (double& x : object.pose.rotation.reshaped()) x = nearest_float(x);
  object.pose.translation = nearest_float(object.pose.translation);
  if (!object.pose.quaternion) return;
  gjk::Quaternion& q = *object.pose.quaternion;
  q = near_one(q);
  for (double* x : {&q.w, &q.x, &q.y, &q.z}) *x = nearest_float(*x);
}

namespace {

/// Keeps the object as read where that is another.
void round_to_float(Object& object, std::optional<Object>& as_read) {
  Object before = object;
  round_to_float(object);
  if (!is_same(object, before)) as_read = std::move(before);
}

}  // namespace

Scene in_float(Scene scene) {
  scene.scalar = Scalar::binary32;
  round_to_float(scene.a, scene.a_as_read);
  round_to_float(scene.b, scene.b_as_read);
  Point& first = scene.options.first_direction;
  const Point given = first;
  first = nearest_float(first);
  if (first.isZero(0)) positive_float(given.cwiseAbs().maxCoeff());
  return scene;
}

}  // namespace walkthroughs::model
