/// The vectors of Algorithms 2-5. With each value goes what the zero test needs to know of its factors. With an
/// observer its name and formula go with it, too. All are made by the same operation. So none can be that of another
/// product. What nobody needs takes no room and no time.
#pragma once

#include <concepts>
#include <optional>
#include <type_traits>

#include "expression.hpp"
#include "zero_test.hpp"

namespace gjk {

/// On which side of a plane a point lies, as seen along the plane's normal.
enum class Side { in_plane, above, below };

template <class S>
bool is_zero(const Vec3<S>& v) {
  return v.x() == S(0) && v.y() == S(0) && v.z() == S(0);
}

namespace detail {

// -- What vectors are called ------------------------------------------------------------------------------------------

/// "ABn", made as "AB×ABCn". A product without a name of its own is called by its formula.
struct Words {
  Expression called, formula = {};

  explicit constexpr Words(const NamedVector& vector) : called(vector) {}
  Words cross(const Words& Y) const {
    Words product(*this);
    product.called = product.formula = {Expression::Form::product, called.X, Y.called.X};
    return product;
  }
  Words triple(const Words& Y) const { return without_formula({Expression::Form::triple, called.X, Y.called.X}); }
  Words minus() const { return without_formula({Expression::Form::negative, called.X}); }
  Words named(const NamedVector& vector) const {
    Words words(vector);
    words.formula = formula;
    return words;
  }
  Words as_normal_of(const Words& AX) const { return named(NamedVector::normal(AX.called.X.of)); }

 private:
  static Words without_formula(const Expression& expression) {
    Words words(expression.X);
    words.called = expression;
    return words;
  }
};

/// What is told where nobody listens.
struct NoWords {
  static constexpr Expression called = {}, formula = {};

  constexpr explicit NoWords(const NamedVector&) {}
  constexpr NoWords cross(NoWords) const { return *this; }
  constexpr NoWords triple(NoWords) const { return *this; }
  constexpr NoWords minus() const { return *this; }
  constexpr NoWords named(const NamedVector&) const { return *this; }
  constexpr NoWords as_normal_of(NoWords) const { return *this; }
};

/// A vector that nobody wants to hear of.
struct NoVector {
  static constexpr NoWords told{NamedVector()};
  static constexpr std::nullopt_t value = std::nullopt;
};

// -- Scalar products --------------------------------------------------------------------------------------------------

/// X·Y, and X itself where somebody listens. Where the product is not a number, each of the three questions is answered
/// with no.
template <class S, class Size, class Factor>
struct Product {
  S value;
  [[no_unique_address]] Size size;
  [[no_unique_address]] Factor X;

  bool is_zero() const { return size.snap(value) == S(0); }
  bool is_positive() const { return size.snap(value) > S(0); }
  bool is_negative() const { return size.snap(value) < S(0); }

  /// Returns: the side of the point to which Y leads. X is the normal of the plane from which it leads there. What is
  /// not a number is below, too.
  Side side() const { return is_zero() ? Side::in_plane : is_positive() ? Side::above : Side::below; }
};

// -- Vectors ----------------------------------------------------------------------------------------------------------

template <class S, class Size, class Told>
struct ToOrigin;

/// A vector of the rules, with what the zero test and the listeners need.
template <class S, class Size, class Told>
struct Vector {
  Vec3<S> value;
  [[no_unique_address]] Size size;
  [[no_unique_address]] Told told;

  /// Returns: whether it counts as the zero vector; no where it is not a number.
  bool is_zero() const { return gjk::is_zero(size.snap(value)); }

  Vector named(const NamedVector& name) const { return {value, size, told.named(name)}; }
  /// "ABn" where AX is AB.
  template <class SizeAX>
  Vector as_normal_of(const Vector<S, SizeAX, Told>& AX) const {
    return {value, size, told.as_normal_of(AX.told)};
  }
  Vector operator-() const { return {-value, size, told.minus()}; }

  /// Returns: X×Y, this being X.
  template <class SizeY>
  auto cross(const Vector<S, SizeY, Told>& Y) const {
    using SizeXY = decltype(size * Y.size);
    return Vector<S, SizeXY, Told>{value.cross(Y.value), size * Y.size, told.cross(Y.told)};
  }

  /// Returns: X·Y.
  template <class SizeY>
  auto dot(const Vector<S, SizeY, Told>& Y) const {
    return product(value.dot(Y.value), size * Y.size);
  }
  /// Returns: X·AO, computed as −(X·A). The sign of a product that is 0 depends on that, and it is told.
  template <class SizeAO>
  auto dot(const ToOrigin<S, SizeAO, Told>& AO) const {
    return product(-value.dot(AO.A()), AO.size * size);
  }

 private:
  template <class SizeXY>
  auto product(const S& XY, const SizeXY& size_XY) const {
    if constexpr (std::same_as<Told, NoWords>)
      return Product<S, SizeXY, NoVector>{XY, size_XY, {}};
    else
      return Product<S, SizeXY, Vector>{XY, size_XY, *this};
  }
};

template <class S, class Size, class Told>
Vector<S, Size, Told> vector(const Vec3<S>& value, const Size& size, const Told& told) {
  return {value, size, told};
}

/// AO = −A.
template <class S, class Size, class Told>
struct ToOrigin : Vector<S, Size, Told> {
  Vec3<S> A() const { return -this->value; }
};

template <class S, class Size, class Told>
ToOrigin<S, Size, Told> to_origin_from(const Vec3<S>& A, const Size& size, const Told& told) {
  return {{-A, size, told}};
}

/// Returns: (X×Y)×X, the part of Y perpendicular to X, |X|² times as long.
template <class S, class SizeX, class SizeY, class Told>
auto triple(const Vector<S, SizeX, Told>& X, const Vector<S, SizeY, Told>& Y) {
  const auto size = Y.size * (X.size * X.size);
  return Vector<S, std::remove_const_t<decltype(size)>, Told>{X.value.cross(Y.value).cross(X.value), size,
                                                              X.told.triple(Y.told)};
}

}  // namespace detail
}  // namespace gjk
