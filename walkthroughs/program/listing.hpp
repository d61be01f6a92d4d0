/// What `gjkstep list` prints.
#pragma once

#include <ostream>
#include <vector>

#include "walkthroughs/model/walkthrough.hpp"

namespace walkthroughs {

/// Writes one line for each walkthrough, name and summary, the folders one after the other with an empty line between.
void write_list(std::ostream& out, const std::vector<Walkthrough>& walkthroughs);

/// Writes a table with a header: name, case (of those that have none their summary), section of the report, how the
/// search ends, and the number of frames. Runs the scenes.
void write_table(std::ostream& out, const std::vector<const Walkthrough*>& walkthroughs);

}  // namespace walkthroughs
