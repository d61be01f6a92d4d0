/// What to know about a scene before it is drawn.
#pragma once

#include <string>
#include <vector>

#include "walkthroughs/model/scene.hpp"

namespace walkthroughs::story {

/// Runs the search. Returns: a sentence for each: products of its numbers overflow or vanish; the objects are in contact
/// within rounding; the search answers otherwise than the truth. None of a scene that leaves the truth out.
std::vector<std::string> warnings_about(const Scene& scene);

}  // namespace walkthroughs::story
