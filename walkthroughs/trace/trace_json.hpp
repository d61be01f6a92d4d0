/// Traces as JSON Lines.
///
/// The first line says what the rest is: schema name and version, walkthrough, scalar, how it is presented, and the scenes
/// in full. Each further line is one event of one scene, in order. A trace is complete: it can be drawn and checked
/// without a search, and without this program's catalogue.
///
/// Vectors are arrays of three numbers in scene units. Every finite number reads back as the same double; any other is one
/// of the words "inf", "-inf" and "nan". The scalar of the first line is that of these numbers; a scene that was searched in
/// another, or with another zero test, says so by a key of its own, and readers that do not know the key refuse it. trace_schema() says
/// which keys and words a line may have.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <iosfwd>
#include <string>
#include <vector>

#include "walkthroughs/model/truth.hpp"
#include "walkthroughs/model/walkthrough.hpp"

namespace walkthroughs::trace {

/// Version 2, which is read, too, has no boxes and capsules, and all its lengths are larger than 0.
inline constexpr int trace_version = 3, oldest_trace_version = 2;

/// Returns: one event as in a trace, but for its scene; keys in their order.
nlohmann::ordered_json event_json(const gjk::Event<double>& event);

/// Returns: the scene as scene_in() reads it, with the walkthrough's title, panels, letters and mistake. Its name is left out, of which
/// scene files know nothing. Requires: in the plane, no object with a pose.
nlohmann::ordered_json scene_json(const Walkthrough& walkthrough, const Scene& scene);

/// Returns: the line behind the events of a scene that says what is true beside their answer; null where there is nothing to
/// say.
nlohmann::ordered_json truth_json(const Scene& scene, const Truth& truth, gjk::Status shown);

/// Returns: the JSON Schema (draft 2020-12) of one line of a trace.
std::string trace_schema();

/// Runs the scenes of `walkthrough`, of which there must be one, and writes their traces.
void write_traces(std::ostream& out, const Walkthrough& walkthrough);

/// Returns: the same, of scenes that have been run. Requires: for each scene a trace, and the truth beside it.
std::string traces_json(const Walkthrough& walkthrough, const std::vector<Trace>& traces,
                        const std::vector<Truth>& truths);

}  // namespace walkthroughs::trace
