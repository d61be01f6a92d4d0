#include "walkthroughs/story/exact.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <cmath>
#include <cstdio>

#include "walkthroughs/story/words.hpp"

namespace walkthroughs::story {
namespace {

constexpr std::size_t longest_fraction = 24;

using Decimal = boost::multiprecision::cpp_dec_float_50;

Decimal decimal(const gjk::Fraction& x) { return Decimal(numerator(x).str()) / Decimal(denominator(x).str()); }

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

ExactVector exact(const Point& p) { return {gjk::Fraction(p.x()), gjk::Fraction(p.y()), gjk::Fraction(p.z())}; }

std::string number(const gjk::Fraction& x) {
  const double near = x.convert_to<double>();
  return x == 0 || std::isnormal(near) ? number(near) : with_true_minus(decimal(x).str(6));
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

double nearest_double(const std::string& fraction) { return decimal(gjk::Fraction(fraction)).convert_to<double>(); }

std::string short_fraction(const std::string& fraction) {
  if (fraction.size() <= longest_fraction) return with_true_minus(fraction);
  const Decimal x = decimal(gjk::Fraction(fraction));
  int exponent = static_cast<int>(x.backend().order());
  double mantissa = Decimal(x * pow(Decimal(10), -exponent)).convert_to<double>();
  if (std::abs(mantissa) >= 9.9995) {  // which would be rounded to 10
    mantissa /= 10;
    ++exponent;
  }
  char digits[64];
  std::snprintf(digits, sizeof digits, "≈ %.4ge%d", mantissa, exponent);
  return with_true_minus(digits);
}

}  // namespace walkthroughs::story
