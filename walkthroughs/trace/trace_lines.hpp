/// The lines of a trace, read back one by one. What is wrong is complained about, as in scene_values.hpp.
#pragma once

#include "walkthroughs/model/walkthrough.hpp"
#include "walkthroughs/text/scene_values.hpp"

namespace walkthroughs::trace {

/// Reads the first line: what the rest is, and the scenes in full. Returns: the walkthrough, its remarks among the rest;
/// nothing in it computes. `version`: is set to that of the trace.
Walkthrough read_header(const Value& root, int& version);

/// Reads a line after the first, field by field as event_fields.hpp lists them. Returns: its event; the line says its scene
/// besides. Requires: an object.
gjk::Event<double> read_event(const Value& line);

/// What to do about a trace that is refused, whoever wrote it.
inline const std::string trace_advice =
    "Write it anew with 'gjkstep trace NAME'. 'gjkstep trace --schema' lists what a line may hold";

inline Value member(const Value& object, std::string_view key) {
  return text::reading::required(object, key, trace_advice);
}

}  // namespace walkthroughs::trace
