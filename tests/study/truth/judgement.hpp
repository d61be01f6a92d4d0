/// A truth, and what proves it.
#pragma once

#include <cstddef>

#include "tests/study/pairs/pair.hpp"

namespace study {

enum class Proof {
  predicates,    ///< CGAL's, which are exact
  formulas,      ///< in fractions, of round bodies
  error_bounds,  ///< a linear program solved in doubles, whose answer is farther from the opposite one than any error
  fractions      ///< the same, where these bounds are too wide: with a certificate in fractions
};
inline constexpr std::size_t proofs = 4;

struct Judgement {
  Truth truth;
  Proof proof;
};

}  // namespace study
