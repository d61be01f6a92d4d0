#include "walkthroughs/live/trace_reader.hpp"

namespace walkthroughs::live {

std::optional<Reading<TraceFile>> trace_of_page([[maybe_unused]] std::string_view text) {
#ifdef GJKSTEP_FEW_SEARCHES
  return std::nullopt;
#else
  return trace_in(text);
#endif
}

}  // namespace walkthroughs::live
