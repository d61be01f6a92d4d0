/// What the study has written about mistakes; CMake reads it.
#pragma once

#include <string_view>

namespace walkthroughs::wrong_on_purpose {

/// "| M14 | 0.48 % (0.47–0.49) | …" a line, in the order of the mistakes. The last three cells: how many random triangles, random
/// tetrahedra and triangles on a grid show the mistake.
extern const std::string_view measured_rows;

}  // namespace walkthroughs::wrong_on_purpose
