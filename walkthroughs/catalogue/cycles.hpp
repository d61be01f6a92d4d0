/// Two pairs of integer points on which the report's rules go round in a circle, in exact arithmetic, too.
#pragma once

#include "walkthroughs/model/scene.hpp"

namespace walkthroughs::catalogue {

Scene cycling_apart(const std::string& name);
Scene cycling_together(const std::string& name);

}  // namespace walkthroughs::catalogue
