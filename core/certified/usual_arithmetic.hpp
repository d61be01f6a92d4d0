/// What everything that is proven assumes of arithmetic: that of IEEE, rounded to nearest, no denormal numbers flushed
/// to zero. What is found of settings that break it:
///  - GCC tells a program of -ffast-math and of each of its parts.
///  - clang 14 tells it of the whole and of -ffinite-math-only.
///  - Programs that clang links with -funsafe-math-optimizations flush denormal numbers. That is found when they run.
///  - clang's -fassociative-math and -freciprocal-math alone are found by nobody: do not use them.
#pragma once

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "gjkstep proves what it says by the rules of IEEE arithmetic: compile without -ffast-math and its parts"
#endif

#include <cfloat>
#include <limits>
#include <stdexcept>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace gjk::detail {

static_assert(FLT_EVAL_METHOD == 0, "bounds on rounding need doubles that are rounded to double at once");
static_assert(std::numeric_limits<double>::is_iec559);
static_assert(1e-300 != 0, "constants must be doubles: compile without -fsingle-precision-constant");

/// Whether arithmetic is what the proofs assume. No compiler may know beforehand. The first comparison finds denormal
/// results that are flushed to zero, and denormal operands that count as zero. The other two find rounding that is not
/// to nearest.
inline bool arithmetic_behaves_as_usual() {
  volatile double normal = 0x1.8p-1022, one = 1;
  volatile double denormal = normal - 0x1p-1022;
  const double x = one, quarter = 0x1p-54, three_quarters = 0x1.8p-53;
  return denormal != 0 && x + quarter == 1 && x + three_quarters > 1;
}

/// The same, asked with each query. Where a processor's settings can be read they are. The reason: denormal numbers as
/// operands take many processors a quarter of a query.
inline bool arithmetic_is_usual() {
#ifdef __SSE2__
  constexpr unsigned operands_are_zero = 1U << 6, results_are_flushed = 1U << 15, rounding = 3U << 13;
  return (_mm_getcsr() & (operands_are_zero | results_are_flushed | rounding)) == 0;
#else
  return arithmetic_behaves_as_usual();
#endif
}

/// Errors: std::runtime_error.
inline void expect_usual_arithmetic() {
  if (!arithmetic_is_usual())
    throw std::runtime_error(
        "nothing can be proven: this processor is set to flush denormal numbers to zero, or not to round to "
        "nearest; compile and link without -ffast-math, and leave the floating-point environment as it was");
}

}  // namespace gjk::detail
