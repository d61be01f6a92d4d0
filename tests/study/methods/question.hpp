/// A pair as shapes of one scalar: what GJK is asked. Made before the clock starts.
#pragma once

#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <concepts>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "core/gjk.hpp"
#include "core/shapes.hpp"
#include "tests/study/pairs/pair.hpp"

namespace study {

/// Fractions of whole numbers of any length. Without expression templates: Eigen's own are enough.
using Exact = boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

/// The forms that a scalar can ask about. Balls and cans have no exact support function: it holds square roots.
template <class S>
struct FormsOf {
  using type = std::variant<gjk::PointSet<S>, gjk::Sphere<S>, gjk::Cylinder<S>>;
};
template <>
struct FormsOf<Exact> {
  using type = std::variant<gjk::PointSet<Exact>>;
};
template <class S>
using Form = typename FormsOf<S>::type;

struct Question {
  virtual ~Question() = default;
};

template <class S>
struct QuestionOf : Question {
  QuestionOf(Form<S> first, Form<S> second, gjk::Vec3<S> direction)
      : a(std::move(first)), b(std::move(second)), between_centers(std::move(direction)) {}
  Form<S> a, b;
  gjk::Vec3<S> between_centers;  ///< where rules begin that test the first point, too
};

// -- Rounding ---------------------------------------------------------------------------------------------------------

/// A pair as a scalar writes it, in doubles again.
struct RoundedPair {
  Pair pair;
  bool differs;  ///< from the pair that was given
};

/// Rounds numbers to S and remembers what that did to them.
template <class S>
class Rounding {
 public:
  bool in_range() const { return in_range_; }  ///< no number became infinite, and none zero that was not
  bool differs() const { return differs_; }

  double operator()(double x) {
    if constexpr (std::same_as<S, float>) {
      const double y = static_cast<double>(static_cast<float>(x));
      in_range_ = in_range_ && std::isfinite(y) && (y == 0) == (x == 0);
      differs_ = differs_ || x != y;
      return y;
    } else {
      return x;
    }
  }
  Vec operator()(const Vec& v) { return Vec((*this)(v.x()), (*this)(v.y()), (*this)(v.z())); }
  Body operator()(const Points& points) {
    Points all;
    for (const Vec& p : points) all.push_back((*this)(p));
    return all;
  }
  Body operator()(const Ball& ball) { return Ball{(*this)(ball.center), (*this)(ball.radius)}; }
  Body operator()(const Can& can) {
    return Can{(*this)(can.center), (*this)(can.axis), (*this)(can.radius), (*this)(can.height)};
  }
  Body operator()(const Body& body) {
    return std::visit([this](const auto& form) { return (*this)(form); }, body);
  }

 private:
  bool in_range_ = true, differs_ = false;
};

/// Returns: empty where a number leaves the range of S.
template <class S>
std::optional<RoundedPair> rounded(const Pair& pair) {
  Rounding<S> rounding;
  const Body a = rounding(pair.a), b = rounding(pair.b);
  if (!rounding.in_range()) return std::nullopt;
  return RoundedPair{{a, b}, rounding.differs()};
}

// -- Shapes -----------------------------------------------------------------------------------------------------------

template <class S>
gjk::Vec3<S> vec_of(const Vec& v) {
  return {static_cast<S>(v.x()), static_cast<S>(v.y()), static_cast<S>(v.z())};
}

/// Returns: the body as a shape of S; empty where S cannot ask about such a body.
template <class S>
std::optional<Form<S>> form_of(const Body& body) {
  if (const Points* const points = std::get_if<Points>(&body)) {
    std::vector<gjk::Vec3<S>> all;
    for (const Vec& p : *points) all.push_back(vec_of<S>(p));
    return gjk::PointSet<S>(std::move(all));
  }
  if constexpr (std::floating_point<S>) {
    if (const Ball* const ball = std::get_if<Ball>(&body))
      return gjk::Sphere<S>(vec_of<S>(ball->center), static_cast<S>(ball->radius));
    const Can& can = std::get<Can>(body);
    return gjk::Cylinder<S>(vec_of<S>(can.center), vec_of<S>(can.axis), static_cast<S>(can.radius),
                            static_cast<S>(can.height));
  }
  return std::nullopt;
}

struct CenterOf {
  Vec operator()(const Points& points) const {
    Vec sum = Vec::Zero();
    for (const Vec& p : points) sum += p;
    return sum / static_cast<double>(points.size());
  }
  Vec operator()(const auto& round) const { return round.center; }
};

/// Returns: the direction from a point inside the first body to one inside the second, found in doubles as scene files have
/// it; the usual one where S has none.
template <class S>
gjk::Vec3<S> between_centers(const Pair& pair) {
  const auto direction =
      vec_of<S>(gjk::first_direction_between(std::visit(CenterOf{}, pair.a), std::visit(CenterOf{}, pair.b)));
  return gjk::is_usable_direction(direction) ? direction : gjk::Options<S>{}.first_direction;
}

/// Returns: what to ask of GJK in S; empty where S cannot ask about such bodies.
template <class S>
std::unique_ptr<Question> question_of(const Pair& pair) {
  std::optional<Form<S>> a = form_of<S>(pair.a), b = form_of<S>(pair.b);
  if (!a || !b) return nullptr;
  return std::make_unique<QuestionOf<S>>(std::move(*a), std::move(*b), between_centers<S>(pair));
}

}  // namespace study
