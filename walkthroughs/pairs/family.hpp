/// A family of pairs.
///
/// Pair `index` of a family depends on the seed, the family's name and the index alone: so any process can make any part
/// of a family, and the order in which pairs are made does not matter.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "walkthroughs/pairs/pair.hpp"

namespace walkthroughs::pairs {

struct Family {
  std::string name;  ///< "flat-1e-6"
  std::string what;  ///< in one line, with the gap where there is one: "triangles flattened to z·1e-6"
  std::optional<std::uint64_t> size = {};  ///< how many pairs there are, where all can be listed; else without end
  std::function<Pair(std::uint64_t seed, std::uint64_t index)> make;  ///< Requires: index < size, where there is one
};

}  // namespace walkthroughs::pairs
