/// The objects of a query, in the scalar that it is asked in.
#pragma once

#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <concepts>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/shapes.hpp"
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/text/scene_object.hpp"

namespace walkthroughs {

/// Fractions without limit. Expression templates are off, because Eigen keeps what a function of the scalar returns.
using Exact = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

/// Spheres and cylinders need square roots, which leave the fractions.
template <class S>
struct FormsIn {
  using Type = std::variant<gjk::PointSet<S>>;
};
template <std::floating_point S>
struct FormsIn<S> {
  using Type = std::variant<gjk::PointSet<S>, gjk::Sphere<S>, gjk::Cylinder<S>>;
};

/// A shape of core/: a form and, where one is given, its pose.
template <class S>
class QueryObject {
 public:
  using Form = typename FormsIn<S>::Type;

  QueryObject(Form form, std::optional<gjk::Pose<S>> pose) : form_(std::move(form)), pose_(std::move(pose)) {}

  /// Without a pose nothing is turned, so that the answer is that of the form itself to the last bit.
  gjk::SupportPoint<S> support(const gjk::Vec3<S>& d) const {
    if (!pose_) return support_of_form(d);
    gjk::SupportPoint<S> found = support_of_form(pose_->turned_back(d));
    found.point = (*pose_)(found.point);
    return found;
  }

  /// Returns: a point inside, as center_of() of scene.hpp does.
  gjk::Vec3<S> center() const {
    const gjk::Vec3<S> own = std::visit([](const auto& form) { return center_of_form(form); }, form_);
    return pose_ ? (*pose_)(own) : own;
  }

 private:
  static gjk::Vec3<S> center_of_form(const gjk::PointSet<S>& set) {
    gjk::Vec3<S> sum = set.points()[0];
    for (std::size_t i = 1; i < set.points().size(); ++i) sum += set.points()[i];
    return sum / S(static_cast<double>(set.points().size()));
  }
  static gjk::Vec3<S> center_of_form(const auto& round) { return round.center(); }

  gjk::SupportPoint<S> support_of_form(const gjk::Vec3<S>& d) const {
    return std::visit([&](const auto& form) { return form.support(d); }, form_);
  }

  Form form_;
  std::optional<gjk::Pose<S>> pose_;
};

/// Turns what was read into a scalar, number by number. Only float cannot hold all numbers of a query.
/// Errors: DocumentError that begins with `place`.
template <class S>
class InScalar {
 public:
  explicit InScalar(std::string place) : place_(std::move(place)) {}

  S operator()(double x) const {
    const S converted = static_cast<S>(x);
    if constexpr (std::floating_point<S>)
      if (!std::isfinite(converted)) fail(x, "is beyond the largest float, 3.4e38");
    return converted;
  }
  S length(double x) const {
    const S converted = (*this)(x);
    if (converted == S(0)) fail(x, "is so small that it is 0 as a float");
    return converted;
  }
  gjk::Vec3<S> operator()(const Point& p) const { return {(*this)(p.x()), (*this)(p.y()), (*this)(p.z())}; }
  gjk::Vec3<S> direction(const Point& p) const {
    if constexpr (std::same_as<S, float>)
      return reading::direction_in_float(p);
    else
      return (*this)(p);
  }
  gjk::Pose<S> operator()(const Pose& pose) const {
    gjk::Pose<S> converted;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) converted.rotation(row, column) = (*this)(pose.rotation(row, column));
    converted.translation = (*this)(pose.translation);
    return converted;
  }

  typename QueryObject<S>::Form operator()(const Points& set) const {
    std::vector<gjk::Vec3<S>> points;
    points.reserve(set.points().size());
    for (const Point& p : set.points()) points.push_back((*this)(p));
    return gjk::PointSet<S>(std::move(points));
  }
  typename QueryObject<S>::Form operator()(const Ball& ball) const {
    if constexpr (std::floating_point<S>)
      return gjk::Sphere<S>((*this)(ball.center()), length(ball.radius()));
    else
      fail_round("sphere");
  }
  typename QueryObject<S>::Form operator()(const reading::CylinderAsWritten& cylinder) const {
    if constexpr (std::floating_point<S>)
      return gjk::Cylinder<S>((*this)(cylinder.center), direction(cylinder.axis), length(cylinder.radius),
                              length(cylinder.height));
    else
      fail_round("cylinder");
  }

 private:
  [[noreturn]] void fail(double x, const std::string& reason) const {
    throw DocumentError(1, place_,
                        number_text(x) + " " + reason + "; choose another unit of length, or --scalar double");
  }
  [[noreturn]] void fail_round(const std::string& kind) const {
    throw DocumentError(1, place_,
                        "a " + kind +
                            " cannot be asked in exact numbers, because its points need square roots; give "
                            "points, or choose another --scalar");
  }

  std::string place_;
};

/// `place`: "a" or "b". Errors: DocumentError.
template <class S>
QueryObject<S> query_object(const reading::ObjectAsWritten& object, const std::string& place) {
  const InScalar<S> in_scalar(place);
  std::optional<gjk::Pose<S>> pose;
  if (object.pose) pose = in_scalar(*object.pose);
  return {std::visit(in_scalar, object.form), std::move(pose)};
}

}  // namespace walkthroughs
