/// The two objects of a query: as its line gives them, and in the scalar that it is asked in.
#pragma once

#include <concepts>
#include <string_view>
#include <utility>

#include "core/certified/fraction.hpp"
#include "walkthroughs/query/query_options.hpp"

namespace walkthroughs::query {

/// As the line gives them, their numbers those of the text.
struct PairAsWritten {
  Object a, b;
  bool has_notes = false;  ///< whether the line has some that its answer repeats
};

/// Returns: the pair, or what is wrong with the line.
Reading<PairAsWritten> read_pair(std::string_view line, const QueryOptions& query);

/// Returns: the object, which is used up, in the scalar that it was read for.
template <class S>
PosedForm<S> query_object(Object&& object) {
  if constexpr (std::same_as<S, double>)
    return {Asked<S>(std::move(object.form)), object.pose};
  else
    return {Asked<S>(converted<S>(object.form, reading::InScalar<S>{})), object.pose};
}

/// Returns: a point inside, in the scalar that the object was read for: of points without a pose gjk::PointSet::mean().
template <class S>
gjk::Vec3<S> point_inside(const Object& object) {
  return put<S>(object.pose, middle<S>(converted<S>(object.form, reading::InScalar<S>{})));
}

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
