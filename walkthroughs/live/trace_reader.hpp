/// The reader of traces, who asks for any search.
#pragma once

#include <optional>
#include <string_view>

#include "walkthroughs/trace/trace_text.hpp"

namespace walkthroughs::live {

/// Returns: trace_in(); nothing in the program that pages load first, which has no reader.
std::optional<Reading<TraceFile>> trace_of_page(std::string_view text);

}  // namespace walkthroughs::live
