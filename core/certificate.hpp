/// What proves an answer about two sets of points to everyone who can multiply.
#pragma once

#include <string_view>
#include <variant>

#include "result.hpp"

namespace gjk {

/// The point a − b of the difference, by the indices of a and b in their sets.
struct IndexPair {
  static constexpr int mean = -1;  ///< in place of an index: the exact mean of all points of the set
  int a = 0, b = 0;
  friend bool operator==(const IndexPair&, const IndexPair&) = default;
};

/// One to four points of the difference; those of a certificate are affinely independent.
using IndexPairs = UpToFour<IndexPair>;

/// Apart: a·d < b·d for every a of A and b of B.
struct SeparatingDirection {
  Vec3<double> d;
  friend bool operator==(const SeparatingDirection&, const SeparatingDirection&) = default;
};

/// Apart, by a direction that need not be a vector of doubles. These one to three points of the difference span a
/// point, a line or a plane. Some point v of it is nearest to the origin, and −v separates the sets as a
/// SeparatingDirection does.
struct SeparatingFeature {
  IndexPairs of;
  friend bool operator==(const SeparatingFeature&, const SeparatingFeature&) = default;
};

/// Together: the convex hull of these points of the difference contains the origin.
struct CommonSimplex {
  IndexPairs of;
  friend bool operator==(const CommonSimplex&, const CommonSimplex&) = default;
};

using Certificate = std::variant<SeparatingDirection, SeparatingFeature, CommonSimplex>;

/// Returns: what the certificate says, if it holds.
inline Status claim_of(const Certificate& certificate) {
  return std::holds_alternative<CommonSimplex>(certificate) ? Status::intersecting : Status::separated;
}

/// What an answer was proven by.
enum class Proof {
  direction,       ///< that of the first search separates the sets by more than all that was rounded (C1)
  tetrahedron,     ///< that of the first search holds the origin, by more than all that was rounded (C2)
  exact_fallback,  ///< the signs that the exact fallback took (C3)
};

constexpr std::string_view to_string(Proof proof) {
  switch (proof) {
    case Proof::direction: return "direction";
    case Proof::tetrahedron: return "tetrahedron";
    case Proof::exact_fallback: return "second-search";
  }
  return "";
}

struct CertifiedResult {
  Status status = Status::undecided;  ///< never that, once it is returned
  Certificate certificate;
  Proof proof = Proof::exact_fallback;
  int iterations = 0;           ///< of the first search
  int fallback_iterations = 0;  ///< of the exact fallback; 0 where there was none
  friend bool operator==(const CertifiedResult&, const CertifiedResult&) = default;
};

}  // namespace gjk
