#include "walkthroughs/trace_expression.hpp"

#include <bit>
#include <cmath>
#include <cstdint>

namespace walkthroughs {
namespace {

constexpr std::string_view times = "×", minus = "−";

double largest(const Point& p) { return p.cwiseAbs().maxCoeff(); }

/// Returns: how far the product of a component of u and one of v may be off, for errors of both.
double carried(const RoundedVector& u, const RoundedVector& v) {
  return largest(u.value) * v.error + largest(v.value) * u.error + u.error * v.error;
}

RoundedVector difference(const Point& to, const Point& from) {
  const Point value = to - from;
  return {value, rounding * largest(value)};
}

/// Each component is a difference of two products.
RoundedVector cross(const RoundedVector& u, const RoundedVector& v) {
  return {u.value.cross(v.value), 2 * carried(u, v) + 4 * rounding * largest(u.value) * largest(v.value) + vanishing};
}

RoundedVector vector_of(std::string_view word, const gjk::Simplex<double>& simplex) {
  const auto point = [&](char letter) { return simplex.point(static_cast<gjk::Role>(letter - 'A')); };
  const auto from_to = [&](char from, char to) {
    return to == 'O' ? RoundedVector{-point(from)} : difference(point(to), point(from));
  };
  if (word.ends_with('n')) return cross(from_to(word[0], word[1]), from_to(word[0], word[2]));
  return from_to(word[0], word[1]);
}

}  // namespace

RoundedScalar dot(const RoundedVector& u, const RoundedVector& v) {
  return {u.value.dot(v.value), 3 * carried(u, v) + 6 * rounding * largest(u.value) * largest(v.value) + vanishing};
}

RoundedVector evaluate(std::string_view expression, const gjk::Simplex<double>& simplex) {
  const bool is_negated = expression.starts_with(minus);
  if (is_negated) expression.remove_prefix(minus.size());
  std::size_t end = expression.find(times);
  RoundedVector product = vector_of(expression.substr(0, end), simplex);
  while (end != std::string_view::npos) {
    expression.remove_prefix(end + times.size());
    end = expression.find(times);
    product = cross(product, vector_of(expression.substr(0, end), simplex));
  }
  if (is_negated) product.value = -product.value;
  return product;
}

bool agrees(double recorded, const RoundedScalar& value) {
  if (!std::isfinite(value.value)) return !std::isfinite(recorded);
  return std::abs(recorded - value.value) <= 2 * value.error;
}

bool agrees(const Point& recorded, const RoundedVector& value) {
  for (int i = 0; i < 3; ++i)
    if (!agrees(recorded[i], {value.value[i], value.error})) return false;
  return true;
}

bool is_identical(double x, double y) {
  return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y) || (std::isnan(x) && std::isnan(y));
}

bool is_identical(const Point& p, const Point& q) {
  return is_identical(p.x(), q.x()) && is_identical(p.y(), q.y()) && is_identical(p.z(), q.z());
}

}  // namespace walkthroughs
