/// Traces as JSON Lines.
///
/// The first line says what the rest is: schema name and version, walkthrough, scalar, and the scenes in full. Each further
/// line is one event of one scene, in order. Vectors are arrays of three numbers in scene units; every finite
/// number reads back as the same double, and any other is null.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "walkthroughs/walkthrough.hpp"

namespace walkthroughs {

inline constexpr int trace_version = 1;

/// Returns: one event as in a trace, but for its scene.
std::string event_json(const gjk::Event<double>& event);

/// Runs the scenes of `walkthrough` and writes their traces.
void write_traces(std::ostream& out, const Walkthrough& walkthrough);

}  // namespace walkthroughs
