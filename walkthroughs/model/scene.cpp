#include "walkthroughs/model/scene.hpp"

#include <cmath>
#include <cstring>
#include <stdexcept>

#include "core/gjk.hpp"
#include "core/rule_sets.hpp"
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/model/widened.hpp"

namespace walkthroughs {

namespace {

/// The farthest point of a moved form is the moved farthest point along d turned back. A form at rest is asked about d
/// itself, as in a plain call of the algorithm: products with a d that was turned back do not overflow or vanish.
template <class S, class Form>
gjk::SupportPoint<S> support_of(const Form& form, const gjk::Pose<S>* pose, const gjk::Vec3<S>& d) {
  if (!pose) return std::visit([&](const auto& shape) { return shape.support(d); }, form);
  const gjk::Vec3<S> own_d = pose->turned_back(d);
  gjk::SupportPoint<S> found = std::visit([&](const auto& shape) { return shape.support(own_d); }, form);
  found.point = (*pose)(found.point);
  return found;
}

}  // namespace

bool Object::is_at_rest() const {
  const Pose rest;
  return std::memcmp(pose.rotation.data(), rest.rotation.data(), sizeof(double[9])) == 0 &&
         std::memcmp(pose.translation.data(), rest.translation.data(), sizeof(double[3])) == 0;
}

gjk::SupportPoint<double> Object::support(const Point& d) const {
  ++support_calls;
  return support_of(form, is_at_rest() ? nullptr : &pose, d);
}

std::vector<Point> vertices_of(const Object& object) {
  std::vector<Point> vertices;
  if (const auto* set = std::get_if<Points>(&object.form))
    for (const Point& p : set->points()) vertices.push_back(object.pose(p));
  return vertices;
}

namespace {

struct CenterOf {
  Point operator()(const Points& set) const {
    Point sum = Point::Zero();
    for (const Point& p : set.points()) sum += p;
    return sum / static_cast<double>(set.points().size());
  }
  Point operator()(const auto& round) const { return round.center(); }
};

}  // namespace

Point center_of(const Object& object) {
  const Point own = std::visit(CenterOf{}, object.form);
  return object.is_at_rest() ? own : object.pose(own);
}

Scene from_center_to_center(Scene scene) {
  const Point direction = gjk::first_direction_between(center_of(scene.a), center_of(scene.b));
  if (gjk::is_usable_direction(direction)) scene.options.first_direction = direction;
  return scene;
}

// -- Other scalars ----------------------------------------------------------------------------------------------------

namespace {

/// A form of an object in numbers of S.
template <class S>
struct FormIn {
  using Any = std::variant<gjk::PointSet<S>, gjk::Sphere<S>, gjk::Cylinder<S>>;

  static S in(double x) { return static_cast<S>(x); }
  static gjk::Vec3<S> in(const Point& p) { return p.cast<S>(); }

  Any operator()(const Points& set) const {
    std::vector<gjk::Vec3<S>> points;
    points.reserve(set.points().size());
    for (const Point& p : set.points()) points.push_back(in(p));
    return gjk::PointSet<S>(std::move(points));
  }
  Any operator()(const Ball& ball) const { return gjk::Sphere<S>(in(ball.center()), in(ball.radius())); }
  Any operator()(const Cylinder& can) const {
    return gjk::Cylinder<S>(in(can.center()), in(can.axis()), in(can.radius()), in(can.height()));
  }
};

/// An object in numbers of S; counts its calls on the object itself, which must outlive it.
template <class S>
class ObjectIn {
 public:
  explicit ObjectIn(const Object& object)
      : object_(object),
        form_(std::visit(FormIn<S>{}, object.form)),
        pose_{object.pose.rotation.cast<S>(), object.pose.translation.cast<S>()},
        is_at_rest_(object.is_at_rest()) {}

  gjk::SupportPoint<S> support(const gjk::Vec3<S>& d) const {
    ++object_.support_calls;
    return support_of(form_, is_at_rest_ ? nullptr : &pose_, d);
  }

 private:
  const Object& object_;
  typename FormIn<S>::Any form_;
  gjk::Pose<S> pose_;
  bool is_at_rest_;
};

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
  decltype(Object::form) operator()(const Points& set) const {
    std::vector<Point> points;
    points.reserve(set.points().size());
    for (const Point& p : set.points()) points.push_back(nearest_float(p));
    return Points(std::move(points));
  }
  decltype(Object::form) operator()(const Ball& ball) const {
    return Ball(nearest_float(ball.center()), positive_float(ball.radius()));
  }
  decltype(Object::form) operator()(const Cylinder& can) const {
    return Cylinder(nearest_float(can.center()), nearest_float(can.axis()), positive_float(can.radius()),
                    positive_float(can.height()));
  }
};

void round_to_float(Object& object) {
  object.form = std::visit(NearestFloats{}, object.form);
  for (double& x : object.pose.rotation.reshaped()) x = nearest_float(x);
  object.pose.translation = nearest_float(object.pose.translation);
}

/// The one place where what a scene says becomes template arguments: calls run<S, Rules>().
template <class Run>
void with_types_of(const Scene& scene, Run&& run) {
  const auto in = [&]<class S>(S) {
    gjk::with_rules(scene.rules, scene.zero_test, [&]<class Rules>() { run.template operator()<S, Rules>(); });
  };
  switch (scene.scalar) {
    case Scalar::binary64: return in(double{});
    case Scalar::binary32: return in(float{});
  }
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

Trace run(const Scene& scene) {
  Trace trace;
  with_types_of(scene, [&]<class S, class Rules>() {
    const gjk::Options<S> options{.first_direction = scene.options.first_direction.cast<S>(),
                                  .iteration_limit = scene.options.iteration_limit,
                                  .crossing_test = scene.options.crossing_test};
    const auto tell = [&](const auto& event) { trace(widened(event)); };
    gjk::collision<S, Rules>(ObjectIn<S>(scene.a), ObjectIn<S>(scene.b), options, tell);
  });
  return trace;
}

}  // namespace walkthroughs
