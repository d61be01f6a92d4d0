/// The filter of certified.hpp: what the first search has found is proven in its own numbers. Static error bounds cover
/// what was rounded on the way (C1, C2). Needs Eigen only.
#pragma once

#include <cstddef>
#include <limits>

#include "../events.hpp"
#include "../tetrahedron.hpp"
#include "bounded.hpp"

namespace gjk::detail {

/// The powers of two between which the proofs stay, so that overflow and underflow do not count.
template <class S>
struct Range;
template <>
struct Range<double> {
  static constexpr double least_reach = 0x1p-900, largest_reach = 0x1p1022, least_norm = 0x1p-330,
                          largest_norm = 0x1p330;
};
template <>
struct Range<float> {
  static constexpr double least_reach = 0x1p-100, largest_reach = 0x1p126, least_norm = 0x1p-40, largest_norm = 0x1p40;
};

/// C1. Returns: whether d separates the sets. Their support functions have found w·d as `support_value`.
///
/// The static error bound:
///  1. s = Σ (r_A + r_B)|d| is as far as points can be along d (r: PointSet::extent()).
///  2. The scan computes a·d to 3u of its part of s. So no point lies farther than the one found by more than 6u·s.
///  3. w = a − b and w·d are off by 4u·s.
///  4. Together 10u·s. 16u·s is asked for, since s and this very product are rounded, too.
///  5. Fifteen products may underflow, each by half the least denormal number. They are those of the point found and of
///     one that is farther in both scans, and of w·d. Where s is not tiny they are far below the 6u·s left over.
///  6. Where s is not huge, nothing overflows.
template <class S>
class SeparationFilter {
 public:
  SeparationFilter(const Vec3<S>& d, const S& support_value, const Vec3<S>& extent_a, const Vec3<S>& extent_b)
      : gap_(-static_cast<double>(support_value)),
        s_((extent_a.template cast<double>() + extent_b.template cast<double>())
               .dot(d.template cast<double>().cwiseAbs())) {}

  bool holds() const { return gap_ > bound() && is_applicable(); }
  FilterTried<S> told() const {
    FilterTried<S> event{.proof = Proof::direction, .bound = bound(), .holds = holds()};
    if (is_applicable()) event.numbers = {{"−w·d", gap_}};
    return event;
  }

 private:
  double bound() const { return 16 * roundoff_of<S> * s_; }
  bool is_applicable() const { return s_ > Range<S>::least_reach && s_ < Range<S>::largest_reach; }

  double gap_, s_;
};

/// C2. Returns: whether the origin lies strictly inside the tetrahedron, by its VolumesAtOrigin.
///
/// The static error bound, M being the largest component of all:
///  1. Each of the six products of three components in v is at most M³.
///  2. Each meets 8 roundings: three differences a − b, product, difference, product, two sums.
///  3. 48uM³ is the error, and 64uM³ is asked for.
///
/// `mean_error`: how far the components of one of the points may be off beside that, see error_of_mean(). Each product
/// has one of them at most, times M². So `mean_error` makes an error of 6M² times itself, and 8M² times it is asked
/// for.
template <class S>
class ContainmentFilter {
 public:
  ContainmentFilter(const Vec3<S>& a, const Vec3<S>& b, const Vec3<S>& c, const Vec3<S>& d, double mean_error = 0) {
    const auto size_ab = a.cwiseAbs().cwiseMax(b.cwiseAbs()), size_cd = c.cwiseAbs().cwiseMax(d.cwiseAbs());
    const double M = static_cast<double>(size_ab.cwiseMax(size_cd).maxCoeff());
    is_applicable_ = M > Range<S>::least_norm && M < Range<S>::largest_norm;
    if (!is_applicable_) return;
    error_ = (64 * roundoff_of<S> * M + 8 * mean_error) * (M * M);
    volumes_ = VolumesAtOrigin<S>(a, b, c, d);
  }

  bool holds() const { return is_applicable_ && volumes_.hold_origin(error_); }
  /// Of the simplex [D, C, B, A].
  FilterTried<S> told() const {
    FilterTried<S> event{.proof = Proof::tetrahedron, .bound = error_, .holds = holds()};
    const auto& [bcd, acd, abd, abc] = volumes_;
    if (is_applicable_) event.numbers = {{"C·(B×A)", bcd}, {"D·(A×B)", -acd}, {"A·(D×C)", abd}, {"B·(C×D)", -abc}};
    return event;
  }

 private:
  bool is_applicable_ = false;
  double error_ = 0;
  VolumesAtOrigin<S> volumes_ = {};
};

/// C2. Returns: by how much the components of the mean of n points of that extent may be off, see PointSet::mean().
///
/// If nu is at most a quarter, terms of u² add less than what ContainmentFilter asks for beyond. A denormal quotient is
/// off by less than the least number. That is nothing beside what M has to be.
template <class S>
double error_of_mean(std::size_t n, S extent) {
  const double nu = static_cast<double>(n) * roundoff_of<S>;
  return nu <= 0.25 ? nu * static_cast<double>(extent) : std::numeric_limits<double>::infinity();
}

}  // namespace gjk::detail
