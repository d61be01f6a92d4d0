/// The values that the first line of a trace and its events have in common.
///
/// They complain about what is not as expected, as those of scene_values.hpp do.
#pragma once

#include <string>
#include <string_view>

#include "walkthroughs/text/scene_limits.hpp"
#include "walkthroughs/text/scene_values.hpp"
#include "walkthroughs/trace/trace_limits.hpp"

namespace walkthroughs::reading {

/// What to do about a trace that is refused, whoever wrote it.
inline const std::string trace_advice =
    "correct the trace ('gjkstep trace --schema' says what a line may hold), or write it anew with 'gjkstep trace "
    "NAME'";

inline Value member(const Value& object, std::string_view key) { return required(object, key, trace_advice); }

inline std::string sentence(const Value& value) { return words(value, trace_limits::words); }

inline int iteration(const Value& value) { return whole_number(value, 0, scene_limits::iterations); }

}  // namespace walkthroughs::reading
