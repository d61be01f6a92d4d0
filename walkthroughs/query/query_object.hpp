/// The objects of a query, in the scalar that it is asked in.
#pragma once

#include <cmath>
#include <concepts>
#include <optional>
#include <string>
#include <utility>

#include "core/shapes.hpp"
#include "walkthroughs/model/exact_number.hpp"
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/text/scene_object.hpp"

namespace walkthroughs {

/// A shape of core/: a form and, where one is given, its pose.
template <class S>
class QueryObject {
 public:
  QueryObject(Asked<S> form, std::optional<gjk::Pose<S>> pose) : form_(std::move(form)), pose_(std::move(pose)) {}

  /// Without a pose nothing is turned, so that the answer is that of the form itself to the last bit.
  gjk::SupportPoint<S> support(const gjk::Vec3<S>& d) const {
    if (!pose_) return form_.support(d);
    gjk::SupportPoint<S> found = form_.support(pose_->turned_back(d));
    found.point = (*pose_)(found.point);
    return found;
  }

 private:
  Asked<S> form_;
  std::optional<gjk::Pose<S>> pose_;
};

/// Turns what was read into a scalar, number by number. Only float cannot hold all numbers of a query.
/// Errors: DocumentError that begins with `place`.
template <class S>
class InScalar {
 public:
  explicit InScalar(std::string place) : place_(std::move(place)) {}

  S number(double x) const {
    const S converted = static_cast<S>(x);
    if constexpr (std::floating_point<S>)
      if (!std::isfinite(converted)) fail(x, "is beyond the largest float, 3.4e38");
    return converted;
  }
  S length(double x) const {
    const S converted = number(x);
    if (converted == S(0)) fail(x, "is so small that it is 0 as a float");
    return converted;
  }
  gjk::Vec3<S> point(const Point& p) const { return {number(p.x()), number(p.y()), number(p.z())}; }
  gjk::Vec3<S> direction(const Point& p) const {
    if constexpr (std::same_as<S, float>)
      return reading::direction_in_float(p);
    else
      return point(p);
  }
  gjk::Pose<S> pose(const Pose& pose) const {
    gjk::Pose<S> converted;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) converted.rotation(row, column) = number(pose.rotation(row, column));
    converted.translation = point(pose.translation);
    return converted;
  }

  Asked<S> form(AnyShape&& shape) const {
    try {
      if constexpr (std::same_as<S, double>)
        return Asked<S>(std::move(shape));
      else
        return Asked<S>(converted<S>(shape, *this));
    } catch (const CannotBeAsked& error) {
      throw DocumentError(
          1, place_,
          std::string(error.what()) +
              " cannot be asked in exact numbers, because its points need square roots; give points, or "
              "choose another --scalar");
    }
  }

 private:
  [[noreturn]] void fail(double x, const std::string& reason) const {
    throw DocumentError(1, place_,
                        number_text(x) + " " + reason + "; choose another unit of length, or --scalar double");
  }

  std::string place_;
};

/// `place`: "a" or "b". Errors: DocumentError.
template <class S>
QueryObject<S> query_object(reading::ObjectAsWritten&& object, const std::string& place) {
  const InScalar<S> in_scalar(place);
  std::optional<gjk::Pose<S>> pose;
  if (object.pose) pose = in_scalar.pose(*object.pose);
  return {in_scalar.form(std::move(object.form)), std::move(pose)};
}

}  // namespace walkthroughs
