/// Is a trace what its search says? The search is run again, with the rules, the scalar and the options of its scene, on shapes
/// that answer with the points that the trace has found: so everything that follows from these must be the same, to the bit.
///
/// The points themselves are held to the shapes of the scene (farthest.cpp). A certified search, whose proofs are about the points
/// of both sets, is run on these.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "walkthroughs/model/scene.hpp"

namespace walkthroughs::trace {

/// Where a trace and its search part.
struct Parting {
  std::size_t event;  ///< the first that is not the search's; where there is none the trace has ended before the search
  std::string what;   ///< "'verdict' is "crossed", but the search says "not-crossed"", or the event that is missing
};

/// Returns: what speaks against `found` as a farthest point of `object` along `direction`, within the rounding of a pose,
/// of a direction's length and of dot products in `scalar`; empty where nothing does. Requires: a direction that is finite
/// and not zero.
std::string objection_to(const gjk::SupportPoint<double>& found, const Object& object, const Point& direction,
                         Scalar scalar);

/// Returns: nothing where these events are those of the search.
std::optional<Parting> parting_from_search(const Scene& scene, const std::vector<gjk::Event<double>>& events);

/// Returns: what speaks against that line behind the events of a scene, which says what is true beside their answer; empty where
/// nothing does. `expected`: the line, see truth_json().
std::string objection_to_truth(std::string_view line, const nlohmann::ordered_json& expected);

/// Returns: whether no event follows this one in the search of `scene`.
bool is_last(const gjk::Event<double>& event, const Scene& scene);

}  // namespace walkthroughs::trace
