/// In which region around a simplex does the origin lie, decided exactly: the report's Figs. 6 and 7, and the 15 features
/// of Section 3.2.4. A region belongs to the feature that lies closest to the origin (Section 3.1.2).
///
/// It shares nothing with Algorithms 2-5: only dot products of differences of vertices, and the sign of a volume. Numbers
/// are taken as they stand; what long double cannot decide for sure is decided in fractions.
#pragma once

#include <string>

#include "core/simplex.hpp"

namespace study {

/// A set of the report's letters: bit 0 for A, 1 for B, 2 for C, 3 for D.
using Feature = unsigned;

constexpr Feature feature_of(gjk::Role role) { return 1U << static_cast<unsigned>(role); }

/// Returns: "AB" for A and B.
std::string letters(Feature feature);

/// Returns: the feature of `simplex` in whose inside its point nearest to the origin lies; the whole simplex where it
/// contains the origin; 0 where the simplex is flat and none can be told.
Feature nearest_feature(const gjk::Simplex<double>& simplex);

/// Returns: whether the origin is a point of the feature, not only nearest to it.
///
/// Requires: `feature` is what nearest_feature() found, and not 0.
bool lies_on(const gjk::Simplex<double>& simplex, Feature feature);

/// Returns: whether XY·XO > 0, in which the report sees the origin on Y's side of X (Section 3.2.3).
bool lies_toward(const gjk::Simplex<double>& simplex, gjk::Role X, gjk::Role Y);

}  // namespace study
