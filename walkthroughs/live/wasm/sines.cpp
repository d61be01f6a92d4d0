// Sines and cosines, rounded right but for one in many millions. So nearly are those of glibc, while musl's, which WebAssembly's
// library has, err by four fifths of the last digit: outlines of round objects would have other corners in a page than in a file.

#include <cmath>
#include <numbers>

namespace {

/// The sum of two doubles, the second below the last digit of the first.
struct Twofold {
  double high = 0, low = 0;
};

/// Requires: a is not smaller, but for its sign.
constexpr Twofold sum(double a, double b) {
  const double high = a + b;
  return {high, b - (high - a)};
}

/// The half of the digits that comes first (Veltkamp, 1968).
constexpr double first_half(double a) {
  const double scaled = 0x8000001p0 * a;
  return scaled - (scaled - a);
}

/// Without rounding (Dekker, 1971).
constexpr Twofold product(double a, double b) {
  const double a1 = first_half(a), a2 = a - a1, b1 = first_half(b), b2 = b - b1, high = a * b;
  return {high, a2 * b2 - (((high - a1 * b1) - a2 * b1) - a1 * b2)};
}

constexpr Twofold operator*(const Twofold& a, const Twofold& b) {
  const auto [high, low] = product(a.high, b.high);
  return sum(high, low + (a.high * b.low + a.low * b.high));
}

constexpr Twofold one_minus(const Twofold& a) {
  const auto [high, low] = sum(1, -a.high);
  return sum(high, low - a.low);
}

constexpr Twofold reciprocal(double a) {
  const double high = 1 / a;
  const auto [one, rest] = product(high, a);
  return sum(high, ((1 - one) - rest) / a);
}

constexpr int terms = 12;

/// What Taylor's series has from `first`·(`first` + 1) on: each term is the last one times x² and one of these.
struct Factors {
  Twofold of[terms] = {};

  explicit constexpr Factors(int first) {
    for (int i = 0; i < terms; ++i) of[i] = reciprocal((first + 2 * i) * (first + 2 * i + 1));
  }
};

/// 1 - x²/(f(f+1)) + x⁴/(f(f+1)(f+2)(f+3)) - …
Twofold series(const Twofold& x, const Factors& factors) {
  const Twofold square = x * x;
  Twofold sum{1};
  for (int i = terms; i-- > 0;) sum = one_minus(square * factors.of[i] * sum);
  return sum;
}

constexpr Factors of_sine(2), of_cosine(1);

double rounded(const Twofold& x) { return x.high + x.low; }

}  // namespace

extern "C" {

/// musl's: x = y[0] + y[1] + n·π/2. Returns: n. Not of what is less than π/4 already: that would lose digits.
int __rem_pio2(double x, double* y);

/// The sine of x, `quarters` of a turn later.
static double sine_later(double x, int quarters) {
  double y[2] = {x, 0};
  if (!(std::fabs(x) <= std::numbers::pi / 4)) quarters += __rem_pio2(x, y);
  const Twofold rest{y[0], y[1]};
  const double found = rounded(quarters % 2 == 0 ? rest * series(rest, of_sine) : series(rest, of_cosine));
  return quarters & 2 ? -found : found;
}

double sin(double x) { return x == 0 ? x : sine_later(x, 0); }  // which keeps the sign of 0
double cos(double x) { return sine_later(x, 1); }
}
