/// The two objects of a query, as its line gives them.
#pragma once

#include <string_view>

#include "core/gjk.hpp"
#include "core/rule_sets.hpp"
#include "walkthroughs/model/first_direction.hpp"
#include "walkthroughs/query/query_object.hpp"
#include "walkthroughs/query/query_options.hpp"
#include "walkthroughs/text/scene_object.hpp"

namespace walkthroughs {

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

}  // namespace walkthroughs
