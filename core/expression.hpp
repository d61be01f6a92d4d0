/// What the report writes for the vectors and numbers that decide: "AB×AO×AB", "ABn·AO". Here they are values. The
/// rules make them from their operands, and names are made of them at the end.
///
/// A is the newest vertex of the simplex that is processed, O the origin. X×Y×Z is (X×Y)×Z. ABn and ABCn are the
/// normals of Eqs. 10, 11 and 14.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "simplex.hpp"

namespace gjk {

/// A vector with a name of its own: AO, an edge "AB", or the normal of an edge or a face, "ABn", "ABCn".
struct NamedVector {
  enum class Kind { to_origin, edge, normal };

  Kind kind = Kind::to_origin;
  Roles of = {};  ///< of AO none

  static constexpr NamedVector edge(Role P, Role Q) { return {Kind::edge, {P, Q}}; }
  static constexpr NamedVector normal(const Roles& of) { return {Kind::normal, of}; }
  constexpr bool operator==(const NamedVector&) const = default;
};

inline constexpr NamedVector AO{};

/// Made of one or two vectors. Written as its name in code, too: event.expression == "AB×AO×AB".
struct Expression {
  enum class Form {
    none,
    vector,                ///< X
    negative,              ///< −X
    product,               ///< X×Y
    triple,                ///< X×Y×X
    dot,                   ///< X·Y
    component,             ///< X.x, the component `axis`
    component_of_product,  ///< (X×Y).x
    reach,                 ///< w·d, of Eq. 9
    largest_reach,         ///< max w·d, of all points w of the difference
    gap,                   ///< −w·d
    volume,                ///< P·(Q×R), X being of P, Q and R: six times that between three vertices and the origin
    as_told                ///< by another program, which does not say how it was made
  };

  Form form = Form::none;
  NamedVector X = {}, Y = {};
  int axis = 0;

  constexpr Expression() = default;
  constexpr Expression(Form form_, const NamedVector& X_ = {}, const NamedVector& Y_ = {}, int axis_ = 0)
      : form(form_), X(X_), Y(Y_), axis(axis_) {}
  constexpr Expression(const NamedVector& vector) : form(Form::vector), X(vector) {}
  /// What names no expression does not compile.
  template <std::size_t length>
  consteval Expression(const char (&text)[length]) : Expression(named(std::string_view(text, length - 1)).value()) {}

  /// Returns: nothing where nothing is called so.
  static constexpr std::optional<Expression> named(std::string_view text);

  constexpr bool empty() const { return form == Form::none; }
  constexpr bool operator==(const Expression&) const = default;
};

// -- Names ------------------------------------------------------------------------------------------------------------

inline std::string to_string(const NamedVector& vector) {
  switch (vector.kind) {
    case NamedVector::Kind::to_origin: return "AO";
    case NamedVector::Kind::edge: return to_string(vector.of);
    case NamedVector::Kind::normal: break;
  }
  return to_string(vector.of) + "n";
}

/// Returns: "AB×AO×AB"; nothing of none.
inline std::string to_string(const Expression& expression) {
  const std::string X = to_string(expression.X), Y = to_string(expression.Y), axis = {'.', "xyz"[expression.axis]};
  switch (expression.form) {
    case Expression::Form::none: return "";
    case Expression::Form::vector: return X;
    case Expression::Form::negative: return "−" + X;
    case Expression::Form::product: return X + "×" + Y;
    case Expression::Form::triple: return X + "×" + Y + "×" + X;
    case Expression::Form::dot: return X + "·" + Y;
    case Expression::Form::component: return X + axis;
    case Expression::Form::component_of_product: return "(" + X + "×" + Y + ")" + axis;
    case Expression::Form::reach: return "w·d";
    case Expression::Form::largest_reach: return "max w·d";
    case Expression::Form::gap: return "−w·d";
    case Expression::Form::volume: return X.substr(0, 1) + "·(" + X[1] + "×" + X[2] + ")";
    case Expression::Form::as_told: break;
  }
  return "as told";
}

/// Returns: nothing where no vector is called so.
constexpr std::optional<NamedVector> vector_named(std::string_view text) {
  if (text == "AO") return AO;
  const bool is_normal = text.ends_with('n');
  if (is_normal) text.remove_suffix(1);
  const std::optional<Roles> of = Roles::named(text);
  if (!of || of->size() < 2 || (!is_normal && of->size() > 2)) return std::nullopt;
  return NamedVector{is_normal ? NamedVector::Kind::normal : NamedVector::Kind::edge, *of};
}

namespace detail {

/// Takes words off the front of a text.
struct NameReader {
  std::string_view rest;

  constexpr bool take(std::string_view word) {
    if (!rest.starts_with(word)) return false;
    rest.remove_prefix(word.size());
    return true;
  }
  constexpr std::optional<NamedVector> take_vector() {
    std::size_t length = 0;
    while (length < rest.size() && std::string_view("ABCDOn").find(rest[length]) != std::string_view::npos) ++length;
    const std::optional<NamedVector> vector = vector_named(rest.substr(0, length));
    rest.remove_prefix(length);
    return vector;
  }
  /// ".x" at the end.
  constexpr std::optional<int> take_axis() {
    for (const std::string_view axis : {".x", ".y", ".z"})
      if (rest == axis) return axis[1] - 'x';
    return std::nullopt;
  }
  /// "C·(B×A)".
  constexpr std::optional<Expression> take_volume() {
    const std::string_view all = rest;
    if (all.size() != 9 || all.substr(1, 3) != "·(" || all.substr(5, 2) != "×" || all[8] != ')') return std::nullopt;
    Roles of;
    for (const char letter : {all[0], all[4], all[7]}) {
      const std::optional<Role> role = role_named(letter);
      if (!role || of.has(*role)) return std::nullopt;
      of.add(*role);
    }
    return Expression(Expression::Form::volume, {NamedVector::Kind::edge, of});
  }
};

}  // namespace detail

constexpr std::optional<Expression> Expression::named(std::string_view text) {
  if (text.empty()) return Expression();
  for (const auto& [name, form] : {std::pair{std::string_view("w·d"), Form::reach},
                                   {"max w·d", Form::largest_reach},
                                   {"−w·d", Form::gap},
                                   {"as told", Form::as_told}})
    if (text == name) return Expression(form);
  detail::NameReader reader{text};
  if (const auto volume = reader.take_volume()) return volume;
  const bool is_negative = reader.take("−"), in_brackets = !is_negative && reader.take("(");
  const std::optional<NamedVector> X = reader.take_vector();
  if (!X) return std::nullopt;
  if (is_negative) return reader.rest.empty() ? std::optional(Expression(Form::negative, *X)) : std::nullopt;
  if (reader.rest.empty()) return in_brackets ? std::nullopt : std::optional(Expression(*X));
  if (const auto axis = in_brackets ? std::nullopt : reader.take_axis())
    return Expression(Form::component, *X, {}, *axis);
  const bool is_dot = !in_brackets && reader.take("·");
  if (!is_dot && !reader.take("×")) return std::nullopt;
  const std::optional<NamedVector> Y = reader.take_vector();
  if (!Y) return std::nullopt;
  if (in_brackets) {
    const auto axis = reader.take(")") ? reader.take_axis() : std::nullopt;
    return axis ? std::optional(Expression(Form::component_of_product, *X, *Y, *axis)) : std::nullopt;
  }
  if (reader.rest.empty()) return Expression(is_dot ? Form::dot : Form::product, *X, *Y);
  if (is_dot || !reader.take("×") || reader.take_vector() != X || !reader.rest.empty()) return std::nullopt;
  return Expression(Form::triple, *X, *Y);
}

}  // namespace gjk
