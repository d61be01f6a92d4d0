/// A truth, and what proves it.
#pragma once

#include <cstddef>

#include "tests/study/pairs/pairs.hpp"

namespace study {

enum class Proof {
  predicates,  ///< CGAL's, which are exact
  formulas,    ///< in fractions, of round bodies
  certificate  ///< of a linear program, multiplied out in fractions
};
inline constexpr std::size_t proofs = 3;

struct Judgement {
  Truth truth;
  Proof proof;
};

}  // namespace study
