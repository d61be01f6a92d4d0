#include "walkthroughs/trace/trace_expression.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "walkthroughs/model/precision.hpp"

namespace walkthroughs {
namespace {

constexpr std::string_view times = "×", minus = "−";

double largest(const Point& p) { return p.cwiseAbs().maxCoeff(); }

/// Returns: how far the product of a component of u and one of v may be off, for errors of both.
double carried(const RoundedVector& u, const RoundedVector& v) {
  return largest(u.value) * v.error + largest(v.value) * u.error + u.error * v.error;
}

/// The operations in numbers of S.
template <class S>
class Arithmetic {
 public:
  explicit Arithmetic(const gjk::Simplex<double>& simplex) : simplex_(simplex) {}

  static RoundedScalar dot(const RoundedVector& u, const RoundedVector& v) {
    return {in(u).dot(in(v)), 3 * carried(u, v) + 6 * rounding * largest(u.value) * largest(v.value) + vanishing};
  }

  RoundedVector operator()(std::string_view expression) const {
    std::size_t end = expression.find(times);
    RoundedVector product = vector_of(expression.substr(0, end));
    while (end != std::string_view::npos) {
      expression.remove_prefix(end + times.size());
      end = expression.find(times);
      product = cross(product, vector_of(expression.substr(0, end)));
    }
    return product;
  }

 private:
  /// Relative error of a sum or product, doubled; and what is lost where one vanishes.
  static constexpr double rounding = std::numeric_limits<S>::epsilon();
  static constexpr double vanishing = 8 * static_cast<double>(std::numeric_limits<S>::denorm_min());

  static gjk::Vec3<S> in(const RoundedVector& v) { return v.value.cast<S>(); }

  /// Each component is a difference of two products.
  static RoundedVector cross(const RoundedVector& u, const RoundedVector& v) {
    return {in(u).cross(in(v)).template cast<double>(),
            2 * carried(u, v) + 4 * rounding * largest(u.value) * largest(v.value) + vanishing};
  }

  Point point(char letter) const { return simplex_.point(static_cast<gjk::Role>(letter - 'A')); }

  RoundedVector from_to(char from, char to) const {
    if (to == 'O') return {-point(from)};
    const Point value = (in({point(to)}) - in({point(from)})).template cast<double>();
    return {value, rounding * largest(value)};
  }

  RoundedVector vector_of(std::string_view word) const {
    if (word.ends_with('n')) return cross(from_to(word[0], word[1]), from_to(word[0], word[2]));
    return from_to(word[0], word[1]);
  }

  const gjk::Simplex<double>& simplex_;
};

}  // namespace

RoundedScalar dot(const RoundedVector& u, const RoundedVector& v, Scalar scalar) {
  return scalar == Scalar::binary32 ? Arithmetic<float>::dot(u, v) : Arithmetic<double>::dot(u, v);
}

RoundedVector evaluate(std::string_view expression, const gjk::Simplex<double>& simplex, Scalar scalar) {
  const bool is_negated = expression.starts_with(minus);
  if (is_negated) expression.remove_prefix(minus.size());
  RoundedVector product =
      scalar == Scalar::binary32 ? Arithmetic<float>(simplex)(expression) : Arithmetic<double>(simplex)(expression);
  if (is_negated) product.value = -product.value;
  return product;
}

double length_of(const gjk::Vertex<double>& vertex) { return vertex.a.point.lpNorm<1>() + vertex.b.point.lpNorm<1>(); }

double size_of(std::string_view expression, const gjk::Simplex<double>& simplex) {
  const auto vertex = [&](char letter) { return simplex[static_cast<gjk::Role>(letter - 'A')]; };
  const auto length = [&](char from, char to) {
    return to == 'O' ? length_of(vertex(from)) : (vertex(to).w - vertex(from).w).lpNorm<1>();
  };
  double size = 1;
  const auto multiply = [&](std::string_view word) {
    size *= length(word[0], word[1]);
    if (word.ends_with('n')) size *= length(word[0], word[2]);
  };
  std::size_t end = expression.find(times);
  multiply(expression.substr(0, end));
  while (end != std::string_view::npos) {
    expression.remove_prefix(end + times.size());
    end = expression.find(times);
    multiply(expression.substr(0, end));
  }
  return size;
}

bool may_count_as_zero(double product, double size, Scalar scalar) {
  return std::abs(product) <= 16.01 * precision_of(scalar).epsilon * size;  // the lengths are rounded too
}

bool may_count_as_zero(const Point& product, double size, Scalar scalar) {
  return may_count_as_zero(product.lpNorm<1>(), size, scalar);
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
