/// When is what the first search has found a proof? The bounds of C1 and C2 where they stand, and the arithmetic that they
/// assume.
#include <cfenv>
#include <limits>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "core/certified/cylinders.hpp"
#include "core/certified/grown.hpp"
#include "core/certified/shapes.hpp"
#include "tests/core/certified_support.hpp"

namespace gjk::test {
namespace certified_filter_test {

// -- C1 ---------------------------------------------------------------------------------------------------------------

TEMPLATE_TEST_CASE("C1: w·d = -16u·s is no proof, the next number is one", "[certified]", float, double) {
  using S = TestType;
  using V = Vec3<S>;
  const V d(-1, 2, -4), extent_a(1, 2, 3), extent_b(4, 5, 6);
  const S bound = static_cast<S>(-16 * u<S> * (5 + 14 + 36));
  REQUIRE_FALSE(detail::SeparationFilter<S>(d, bound, extent_a, extent_b).holds());
  REQUIRE(detail::SeparationFilter<S>(d, below(bound), extent_a, extent_b).holds());
  REQUIRE_FALSE(detail::SeparationFilter<S>(d, -bound, extent_a, extent_b).holds());
  REQUIRE_FALSE(detail::SeparationFilter<S>(d, S(55), extent_a, extent_b).holds());
}

TEMPLATE_TEST_CASE("C1: a far point of either set makes a direction no proof", "[certified]", float, double) {
  using S = TestType;
  using V = Vec3<S>;
  const V p(1, 0, 0), q(1 + 17 * std::numeric_limits<S>::epsilon(), 0, 0);
  REQUIRE(proven(pair_of<S>({p}, {q})).proof == Proof::direction);
  REQUIRE(proven(pair_of<S>({p, V(-99, 0, 0)}, {q})).proof == Proof::exact_fallback);
  REQUIRE(proven(pair_of<S>({p}, {q, V(99, 0, 0)})).proof == Proof::exact_fallback);
}

/// s is the product of `reach` and `d`, and w·d is far beyond the bound.
template <class S>
bool proves_at(S reach, S d) {
  using V = Vec3<S>;
  return detail::SeparationFilter<S>(V(0, d, 0), static_cast<S>(-static_cast<double>(reach) * d / 4), V(0, reach, 0),
                                     V(9, 0, 9))
      .holds();
}

TEST_CASE("C1: s is neither so small that what underflows counts nor so large that something overflows",
          "[certified]") {
  REQUIRE_FALSE(proves_at(0x1p-450, 0x1p-450));
  REQUIRE(proves_at(above(0x1p-450), 0x1p-450));
  REQUIRE_FALSE(proves_at(0x1p511, 0x1p511));
  REQUIRE(proves_at(below(0x1p511), 0x1p511));
  REQUIRE_FALSE(proves_at(0x1p-50F, 0x1p-50F));
  REQUIRE(proves_at(above(0x1p-50F), 0x1p-50F));
  REQUIRE_FALSE(proves_at(0x1p63F, 0x1p63F));
  REQUIRE(proves_at(below(0x1p63F), 0x1p63F));
}

TEMPLATE_TEST_CASE("C1: what is infinite or not a number proves nothing", "[certified]", float, double) {
  using S = TestType;
  using V = Vec3<S>;
  const S infinity = std::numeric_limits<S>::infinity(), nan = std::numeric_limits<S>::quiet_NaN();
  const V one(1, 1, 1);
  REQUIRE(detail::SeparationFilter<S>(one, -1, one, one).holds());
  REQUIRE_FALSE(detail::SeparationFilter<S>(V(1, infinity, 1), -1, one, one).holds());
  REQUIRE_FALSE(detail::SeparationFilter<S>(V(1, nan, 1), -1, one, one).holds());
  REQUIRE_FALSE(detail::SeparationFilter<S>(one, nan, one, one).holds());
  REQUIRE_FALSE(detail::SeparationFilter<S>(one, -1, V(1, 1, infinity), one).holds());
}

// -- C2 ---------------------------------------------------------------------------------------------------------------

template <class S>
using Corners = std::array<Vec3<S>, 4>;

/// Asked with the corners in all orders: a corner stands in each place and both orientations occur. Requires: one answer.
template <class S>
bool enclose(const Corners<S>& corners) {
  std::array<std::size_t, 4> order{0, 1, 2, 3};
  int yes = 0;
  do {
    yes += detail::ContainmentFilter<S>(corners[order[0]], corners[order[1]], corners[order[2]], corners[order[3]])
               .holds();
  } while (std::next_permutation(order.begin(), order.end()));
  REQUIRE((yes == 0 || yes == 24));
  return yes == 24;
}

/// Encloses the origin, its coefficients being x, y, z and 1.
template <class S>
Corners<S> around_origin(S x = 1, S y = 1, S z = 1) {
  using V = Vec3<S>;
  return {V(-x, -y, -z), V(1, 0, 0), V(0, 1, 0), V(0, 0, 1)};
}

TEMPLATE_TEST_CASE("C2: a determinant of 64uM³ is no proof, the next number is one, whichever it is", "[certified]",
                   float, double) {
  using S = TestType;
  const S bound = static_cast<S>(64 * u<S>);
  REQUIRE_FALSE(enclose(around_origin<S>(1, 1, bound)));
  REQUIRE(enclose(around_origin<S>(1, 1, above(bound))));
  REQUIRE_FALSE(enclose(around_origin<S>(1, bound, 1)));
  REQUIRE(enclose(around_origin<S>(above(bound), 1, 1)));
  REQUIRE_FALSE(enclose<S>(around_origin<S>(1, 1, -above(bound))));
}

TEMPLATE_TEST_CASE("C2: M is the largest coordinate of all four points", "[certified]", float, double) {
  using S = TestType;
  const S M = 8, bound = static_cast<S>(64 * u<S>);
  for (std::size_t longest = 0; longest < 4; ++longest) {
    const auto enclose_with =
        [=](S z) {  // of the first three points the determinant is −z, times M if it is one of them
          Corners<S> corners = around_origin<S>(1, 1, z);
          corners[longest] *= M;
          return enclose(corners);
        };
    const S z = bound * M * M * (longest < 3 ? 1 : M);
    INFO("point " << longest);
    REQUIRE_FALSE(enclose_with(z));
    REQUIRE(enclose_with(above(z)));
  }
}

TEMPLATE_TEST_CASE("C2: where a mean is off by δ, a determinant of 64uM³ + 8δM² is no proof, the next number is one",
                   "[certified]", float, double) {
  using S = TestType;
  const double delta = 0x1p-20;
  const S bound = static_cast<S>(64 * u<S> + 8 * delta);
  const auto enclose_with = [=](S z, S M) {
    const Corners<S> corners = around_origin<S>(M, M, z);
    return detail::ContainmentFilter<S>(corners[0], M * corners[1], M * corners[2], M * corners[3], delta * double(M))
        .holds();
  };
  for (const S M : {S(1), S(4)}) {
    REQUIRE_FALSE(enclose_with(bound * M, M));
    REQUIRE(enclose_with(above(bound * M), M));
  }
  const auto [a, b, c, d] = around_origin<S>();
  REQUIRE_FALSE(detail::ContainmentFilter<S>(a, b, c, d, std::numeric_limits<double>::infinity()).holds());
}

TEMPLATE_TEST_CASE("C2: the mean of n points is known to nur, of a quarter of 1/u points and no more", "[certified]",
                   float, double) {
  using S = TestType;
  REQUIRE(detail::error_of_mean<S>(7, 3) == 21 * u<S>);
  const auto most = static_cast<std::size_t>(0.25 / u<S>);
  REQUIRE(detail::error_of_mean<S>(most, 3) == 0.75);
  REQUIRE(std::isinf(detail::error_of_mean<S>(most + 1, 3)));
}

TEMPLATE_TEST_CASE(
    "C2: the vertex that a search started from is known as badly as both means, and one that is no mean, not",
    "[certified]", float, double) {
  using S = TestType;
  const PointSet<S> a({{0, 0.75, 0}, {0, 0, 0.5}, {0, 0, 0}, {0.25, 0, 0}}), b({{0, -0.5, 0}, {0, 0, 0}});
  const auto error_of = [&](const SupportPoint<S>& of_a, const SupportPoint<S>& of_b) {
    Simplex<S> simplex;
    simplex.add(MinkowskiDifference<S, PointSet<S>, PointSet<S>>(a, b).vertex({1, 0, 0}));
    simplex.add({of_a, of_b, of_a.point - of_b.point});
    return detail::error_of_start(simplex, a, b);
  };
  CHECK(error_of(a.mean(), b.mean()) == (4 * 0.75 + 2 * 0.5) * u<S>);
  CHECK(error_of(a.support({0, 1, 0}), b.support({0, -1, 0})) == 0);
  CHECK(std::isinf(error_of(a.points()[0], b.mean())));
  CHECK(std::isinf(error_of(a.mean(), b.points()[0])));
}

TEMPLATE_TEST_CASE("C2: points that leave the origin outside, or on their hull, are no proof", "[certified]", float,
                   double) {
  using S = TestType;
  for (int signs = 0; signs < 8; ++signs) {
    const auto component = [=](int bit) { return signs & bit ? S(-1) : S(1); };
    INFO("signs " << signs);
    REQUIRE(enclose(around_origin<S>(component(1), component(2), component(4))) == (signs == 0));
  }
  REQUIRE_FALSE(enclose(around_origin<S>(1, 1, 0)));
  REQUIRE_FALSE(enclose(around_origin<S>(1, 0, 0)));
  REQUIRE_FALSE(enclose(around_origin<S>(0, 0, 0)));
  Corners<S> flat = around_origin<S>();
  flat[3] = flat[2];
  REQUIRE_FALSE(enclose(flat));
}

template <class S>
bool enclose_with_length(S length) {
  Corners<S> corners = around_origin<S>();
  for (Vec3<S>& corner : corners) corner *= length;
  return enclose(corners);
}

TEST_CASE("C2: points are neither so near that what underflows counts nor so far that something overflows",
          "[certified]") {
  REQUIRE_FALSE(enclose_with_length(0x1p-330));
  REQUIRE(enclose_with_length(above(0x1p-330)));
  REQUIRE(enclose_with_length(below(0x1p330)));
  REQUIRE_FALSE(enclose_with_length(0x1p330));
  REQUIRE_FALSE(enclose_with_length(0x1p-40F));
  REQUIRE(enclose_with_length(above(0x1p-40F)));
  REQUIRE(enclose_with_length(below(0x1p40F)));
  REQUIRE_FALSE(enclose_with_length(0x1p40F));
}

TEST_CASE("C2: of a proof that cannot be tried neither numbers nor a bound are told", "[certified]") {
  const auto told = [](double length) {
    const Corners<double> corners = around_origin<double>(length, length, length);
    return detail::ContainmentFilter<double>(corners[0], corners[1], corners[2], corners[3]).told();
  };
  CHECK(told(0x1p330).numbers.empty());
  CHECK(told(0x1p330).bound == 0);
  CHECK(told(2).numbers.size() == 4);
  CHECK(told(2).bound == 64 * u<double> * 8);
}

TEMPLATE_TEST_CASE("C2: what is infinite or not a number proves nothing", "[certified]", float, double) {
  using S = TestType;
  for (const S wrong : {std::numeric_limits<S>::infinity(), std::numeric_limits<S>::quiet_NaN()})
    for (std::size_t i = 0; i < 4; ++i) {
      Corners<S> corners = around_origin<S>();
      corners[i].y() = wrong;
      REQUIRE_FALSE(enclose(corners));
    }
}

// -- The assumptions --------------------------------------------------------------------------------------------------

// Made before anything is set otherwise, which they would refuse.
const Grown ball(Sphere<double>({0, 0, 0}, 1));
const AxialCylinder can = AxialCylinder::of({0, 0, 0}, {0, 0, 1}, 1, 1).value();

/// What certified answers did under another arithmetic, which has passed when this returns.
struct Tried {
  bool is_usual, has_thrown;
};
template <class SetBack>
Tried tried_then(const SetBack& set_back) {
  const PointSet<double> a({Vec3<double>(0, 0, 0)});
  volatile bool is_usual = detail::arithmetic_is_usual(), has_thrown = false;  // known before anything is set back
  volatile bool behaves = detail::arithmetic_behaves_as_usual();
  const auto throws = [](const auto& call) {
    try {
      call();
    } catch (const std::runtime_error&) {
      return true;
    }
    return false;
  };
  has_thrown = throws([&] { certified_collision(a, a); });
  volatile bool all_throw =
      throws([&] { certified_shapes(a, a); }) && throws([&] { certified_collision(ball, ball); }) &&
      throws([&] { certified_status(can, can); }) && throws([&] { certified_status(can, ball); }) && throws([] {
        Grown(Sphere<double>({0, 0, 0}, 1));
      });
  set_back();
  REQUIRE(all_throw == has_thrown);
  REQUIRE(behaves == is_usual);
  return {is_usual, has_thrown};
}

TEST_CASE("Rounding to nearest is usual, any other is refused", "[certified]") {
  const auto rounding = [](int mode) {
    const int before = std::fegetround();
    std::fesetround(mode);
    return tried_then([=] { std::fesetround(before); });
  };
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    INFO("mode " << mode);
    const Tried tried = rounding(mode);
    REQUIRE_FALSE(tried.is_usual);
    REQUIRE(tried.has_thrown);
  }
  const Tried usual = rounding(FE_TONEAREST);
  REQUIRE(usual.is_usual);
  REQUIRE_FALSE(usual.has_thrown);
}

#if defined(__SSE2__)
TEST_CASE("Arithmetic that flushes denormal results to zero, or takes denormal operands as zero, is refused",
          "[certified]") {
  constexpr unsigned flush_results = 1U << 15, operands_are_zero = 1U << 6;
  for (const unsigned flag : {flush_results, operands_are_zero, flush_results | operands_are_zero}) {
    INFO("flag " << flag);
    const unsigned before = _mm_getcsr();
    _mm_setcsr(before | flag);
    const Tried tried = tried_then([=] { _mm_setcsr(before); });
    REQUIRE_FALSE(tried.is_usual);
    REQUIRE(tried.has_thrown);
  }
  REQUIRE(detail::arithmetic_is_usual());
}
#endif

}  // namespace certified_filter_test
}  // namespace gjk::test
