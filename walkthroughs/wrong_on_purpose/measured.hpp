/// How long mistakes stay unnoticed, as the study has measured it (tests/study/results/claims.md).
#pragma once

#include <string>

#include "walkthroughs/wrong_on_purpose/mistakes.hpp"

namespace walkthroughs::wrong_on_purpose {

enum class TestPairs { triangles, tetrahedra, grid_triangles };

/// How many random pairs show a mistake in 95 of 100 tests.
struct PairsToNotice {
  double count = 0;
  bool is_more = false;  ///< none of those that were tried has shown it

  /// Returns: "about 190,000" or "more than 780,000".
  std::string text() const;
};

PairsToNotice pairs_to_notice(Mistake mistake, TestPairs pairs);

/// Returns: whether a search that is begun along an axis is wrong with it nowhere, however many pairs are tried. That is proven: P·d of
/// the first point is then a single difference, whose sign no rounding changes, and P·d < 0 proves separation wherever it is found.
bool is_none_along_axes(Mistake mistake);

}  // namespace walkthroughs::wrong_on_purpose
