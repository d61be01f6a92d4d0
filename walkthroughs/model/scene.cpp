#include "walkthroughs/model/scene.hpp"

#include <cmath>
#include <cstring>
#include <stdexcept>

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

bool is_same(const Object& one, const Object& other) {
  return one.form == other.form && one.pose.rotation == other.pose.rotation &&
         one.pose.translation == other.pose.translation;
}

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

void round_to_float(Object& object, std::optional<Object>& as_read) {
  const Object before = object;
  object.form = converted<double>(object.form, NearestFloats{});
  for (double& x : object.pose.rotation.reshaped()) x = nearest_float(x);
  object.pose.translation = nearest_float(object.pose.translation);
  if (!is_same(object, before)) as_read = before;
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
