#include "walkthroughs/story/exact.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "walkthroughs/story/words.hpp"

namespace walkthroughs::story {
namespace {

constexpr std::size_t longest_fraction = 24;

/// A number as its mantissa, which has one digit before the point, times a power of ten.
struct Decimal {
  std::string mantissa;
  int exponent;
};

/// Returns: the number to so many digits. Requires: it is not 0.
Decimal decimal(const gjk::Fraction& x, int digits) {
  const auto length = [](const auto& whole) { return static_cast<int>(whole.str().size()); };
  int exponent = length(numerator(gjk::Fraction(abs(x)))) - length(denominator(x));
  const gjk::Fraction power = pow(numerator(gjk::Fraction(10)), static_cast<unsigned>(std::abs(exponent)));
  gjk::Fraction mantissa = exponent < 0 ? x * power : x / power;  // above 0.1, below 10
  if (abs(mantissa) < 1) {
    mantissa *= 10;
    --exponent;
  }
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, mantissa.convert_to<double>());
  if (const std::string rounded = text; !rounded.ends_with("10")) return {rounded, exponent};
  return {x < 0 ? "-1" : "1", exponent + 1};  // it has a digit more
}

/// Returns: with two digits behind the point.
std::string fixed(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%s%.2f", x < 0 ? "−" : "", std::abs(x));
  return text;
}

gjk::Fraction largest(const ExactVector& v) {
  gjk::Fraction most = 0;
  for (const gjk::Fraction& x : v) most = std::max(most, gjk::Fraction(abs(x)));
  return most;
}

}  // namespace

std::string number(const gjk::Fraction& x) {
  const double near = x.convert_to<double>();
  if (x == 0 || std::isnormal(near)) return number(near);
  const Decimal most = decimal(x, 6);
  char exponent[16];
  std::snprintf(exponent, sizeof exponent, "e%+d", most.exponent);  // as printf() writes numbers beyond doubles, too
  return with_true_minus(most.mantissa + exponent);
}

std::string place(const gjk::Fraction& x) {
  const double near = x.convert_to<double>();
  return std::abs(near) < 1e4 || std::abs(near) >= 1e12 ? number(x) : fixed(near);
}

std::string vector(const ExactVector& v, Dimension dimension, std::string (*text)(const gjk::Fraction&)) {
  return "(" + text(v.x()) + ", " + text(v.y()) + (dimension == Dimension::plane ? ")" : ", " + text(v.z()) + ")");
}

std::string length(const ExactVector& v) {
  const gjk::Fraction scale = largest(v);  // so that no square of a double over- or underflows
  if (scale == 0) return number(scale);
  Point scaled;
  for (int i = 0; i < 3; ++i) scaled[i] = gjk::Fraction(v[i] / scale).convert_to<double>();
  return number(gjk::Fraction(scale * gjk::Fraction(scaled.norm())));
}

double nearest_double(const std::string& fraction) { return gjk::Fraction(fraction).convert_to<double>(); }

std::string short_fraction(const std::string& fraction) {
  if (fraction.size() <= longest_fraction) return with_true_minus(fraction);
  const Decimal most = decimal(gjk::Fraction(fraction), 4);
  return "≈ " + with_true_minus(most.mantissa + "e" + std::to_string(most.exponent));
}

}  // namespace walkthroughs::story
