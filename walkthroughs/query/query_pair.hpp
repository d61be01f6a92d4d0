/// The two objects of a query: as its line gives them, and in the scalar that it is asked in.
#pragma once

#include <concepts>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "core/certified/fraction.hpp"
#include "core/gjk.hpp"
#include "core/rule_sets.hpp"
#include "core/shapes.hpp"
#include "walkthroughs/model/first_direction.hpp"
#include "walkthroughs/model/scene.hpp"
#include "walkthroughs/query/query_options.hpp"
#include "walkthroughs/text/scene_values.hpp"

namespace walkthroughs::query {

/// A shape of core/: a form and, where one moves it, its pose. Without that nothing is turned, so that the answer is that of
/// the form itself to the last bit.
template <class S>
class QueryObject {
 public:
  QueryObject(Asked<S> form, const std::optional<gjk::Pose<S>>& pose)
      : shape_(pose ? Shape(gjk::Posed<S, Asked<S>>(std::move(form), *pose)) : Shape(std::move(form))) {}

  /// Not inlined into each of the 21 searches that collision() is here: it takes longer to compile, for nothing.
  [[gnu::noinline]] gjk::SupportPoint<S> support(const gjk::Vec3<S>& d) const {
    return std::visit([&](const auto& shape) { return shape.support(d); }, shape_);
  }
  const auto& shape() const { return shape_; }

 private:
  using Shape = std::variant<Asked<S>, gjk::Posed<S, Asked<S>>>;
  Shape shape_;
};

/// Turns what was read into a scalar, number by number. Requires: that it was read for that scalar (reading::Numbers).
template <class S>
struct InScalar : Cast<S> {
  gjk::Vec3<S> direction(const Point& p) const {
    if constexpr (std::same_as<S, float>)
      return reading::direction_in_float(p);
    else
      return Cast<S>::point(p);
  }
};

template <class S>
Asked<S> asked_form(AnyShape&& shape) {
  if constexpr (std::same_as<S, double>)
    return Asked<S>(std::move(shape));
  else
    return Asked<S>(converted<S>(shape, InScalar<S>{}));
}

template <class S>
gjk::Pose<S> pose_in(const Pose& pose) {
  gjk::Pose<S> converted;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      converted.rotation(row, column) = static_cast<S>(pose.rotation(row, column));
  converted.translation = Cast<S>{}.point(pose.translation);
  return converted;
}

/// Requires: as InScalar.
template <class S>
QueryObject<S> query_object(reading::ObjectAsWritten&& object) {
  std::optional<gjk::Pose<S>> pose;
  if (object.pose && !is_at_rest(*object.pose)) pose = pose_in<S>(*object.pose);
  return {asked_form<S>(std::move(object.form)), pose};
}

/// Returns: a point inside, in the scalar: of points without a pose gjk::PointSet::mean(). Requires: as InScalar.
template <class S>
gjk::Vec3<S> point_inside(const reading::ObjectAsWritten& object) {
  const gjk::Vec3<S> own = middle<S>(converted<S>(object.form, InScalar<S>{}));
  return object.pose && !is_at_rest(*object.pose) ? pose_in<S>(*object.pose)(own) : own;
}

struct PairAsWritten {
  reading::ObjectAsWritten a, b;
};

/// Returns: the pair, or what is wrong with the line.
Reading<PairAsWritten> read_pair(std::string_view line, const QueryOptions& query);

/// Returns: a point inside.
Point center_of(const reading::ObjectAsWritten& object);

/// Rules that test the first point, too, begin between the centers, as in scenes.
template <class S>
gjk::Options<S> search_options(const PairAsWritten& pair, const QueryOptions& query) {
  gjk::Options<S> options;
  options.iteration_limit = query.iteration_limit;
  if (query.first_direction)
    options.first_direction = Cast<S>{}.point(*query.first_direction);
  else if (query.start == QueryStart::inside)
    options.inside = gjk::PointOfEach<S>{point_inside<S>(pair.a), point_inside<S>(pair.b)};
  else if (query.start == QueryStart::between || gjk::first_point(query.rules) == gjk::FirstPoint::tested)
    options.first_direction = direction_between_centers<S>(center_of(pair.a), center_of(pair.b));
  return options;
}

}  // namespace walkthroughs::query
