/// Events of a trace, read back: each line after the first, field by field as event_fields.hpp lists them.
#pragma once

#include "core/events.hpp"
#include "walkthroughs/text/document.hpp"

namespace walkthroughs {

/// Returns: the event of a line, which says its scene besides. Requires: an object. What is wrong is complained about.
gjk::Event<double> read_event(const Value& line);

}  // namespace walkthroughs
