#include "walkthroughs/model/scene.hpp"

#include <cmath>
#include <cstring>
#include <stdexcept>

#include "walkthroughs/model/first_direction.hpp"
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

template <class S>
AskedObject<S>::AskedObject(const Object& object)
    : object_(object),
      form_(converted<S>(object.form, Cast<S>{})),
      pose_{object.pose.rotation.cast<S>(), object.pose.translation.cast<S>()},
      is_at_rest_(walkthroughs::model::is_at_rest(object.pose)) {}

template <class S>
gjk::SupportPoint<S> AskedObject<S>::support(const gjk::Vec3<S>& d) const {
  ++object_.support_calls;
  if (is_at_rest_) return form_.support(d);
  gjk::SupportPoint<S> found = form_.support(pose_.turned_back(d));
  found.point = pose_(found.point);
  return found;
}

template class AskedObject<double>;
template class AskedObject<float>;

std::vector<Point> vertices_of(const Object& object) {
  std::vector<Point> vertices;
  if (const auto* set = std::get_if<Points>(&object.form))
    for (const Point& p : *set) vertices.push_back(object.pose(p));
  return vertices;
}

Point center_of(const Object& object) {
  const Point own = middle<double>(object.form);
  return is_at_rest(object.pose) ? own : object.pose(own);
}

Scene from_center_to_center(Scene scene) {
  const Point a = center_of(scene.a), b = center_of(scene.b);
  scene.options.first_direction = scene.scalar == Scalar::binary32
                                      ? direction_between_centers<float>(a, b).cast<double>()
                                      : direction_between_centers<double>(a, b);
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

void round_to_float(Object& object) {
  object.form = converted<double>(object.form, NearestFloats{});
  for (double& x : object.pose.rotation.reshaped()) x = nearest_float(x);
  object.pose.translation = nearest_float(object.pose.translation);
}

}  // namespace

Scene in_float(Scene scene) {
  scene.scalar = Scalar::binary32;
  round_to_float(scene.a);
  round_to_float(scene.b);
  Point& first = scene.options.first_direction;
  const Point given = first;
  first = nearest_float(first);
  if (first.isZero(0)) positive_float(given.cwiseAbs().maxCoeff());
  return scene;
}

std::optional<ObjectionToProof> objection_to_proof(const AnyShape& form, const Pose& pose) {
  if (!std::holds_alternative<Points>(form))
    return ObjectionToProof{
        std::string(key_of(form)),
        "a " + kind_of(form, Dimension::space) +
            " cannot be certified in a scene, whose proofs are drawn for sets of points only. Give points"};
  if (moves(pose))
    return ObjectionToProof{"pose",
                            "an object that its pose moves cannot be certified, because its points are rounded then. "
                            "Give the points where they are"};
  return std::nullopt;
}

}  // namespace walkthroughs::model
