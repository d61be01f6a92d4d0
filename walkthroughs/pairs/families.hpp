/// All families of pairs: what is hard about them is in their names.
#pragma once

#include <string>
#include <vector>

#include "walkthroughs/pairs/family.hpp"

namespace walkthroughs::pairs {

/// Returns: all of them, in the order of the tables.
const std::vector<Family>& families();

/// Errors: std::invalid_argument, with the name that was probably meant.
const Family& family_named(const std::string& name);

}  // namespace walkthroughs::pairs
