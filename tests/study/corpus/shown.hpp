/// What a pair shows: whom it misleads.
#pragma once

#include <cstddef>
#include <vector>

#include "tests/study/pairs/pairs.hpp"

namespace study {

struct Shown {
  std::vector<bool> by_mistake;  ///< in the order of mistakes(): it answers wrongly, and the report's algorithm rightly
  bool sound_fails = false;      ///< the report's algorithm in doubles answers wrongly itself
};

/// A search that ends without an answer says no, as Algorithm 1 does at its limit.
/// Requires: two sets of points.
Shown shown_by(const Pair& pair);

/// The same, of one mistake alone.
bool shows(const Pair& pair, std::size_t mistake);

}  // namespace study
