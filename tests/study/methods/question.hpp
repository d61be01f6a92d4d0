/// A pair as shapes of one scalar: what GJK is asked. Made before the clock starts.
#pragma once

#include <cmath>
#include <concepts>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include "core/gjk.hpp"
#include "core/shapes.hpp"
#include "tests/study/pairs/pairs.hpp"
#include "tests/study/truth/exact_number.hpp"
#include "walkthroughs/model/scene.hpp"

namespace study {

/// Fractions of whole numbers of any length. Without expression templates: Eigen's own are enough.
using Exact = study::Exact;

/// The shapes of core/ that bodies turn into in S, those that S can ask about.
template <class S>
using Form = walkthroughs::model::AskedForms<
    std::variant<walkthroughs::model::PointsOf<S>, walkthroughs::model::BallOf<S>, walkthroughs::model::CylinderOf<S>>>;

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

  double length(double x) {
    if constexpr (std::same_as<S, float>) {
      const double y = static_cast<double>(static_cast<float>(x));
      in_range_ = in_range_ && std::isfinite(y) && (y == 0) == (x == 0);
      differs_ = differs_ || x != y;
      return y;
    } else {
      return x;
    }
  }
  Vec point(const Vec& v) { return {length(v.x()), length(v.y()), length(v.z())}; }
  Vec direction(const Vec& v) { return point(v); }

 private:
  bool in_range_ = true, differs_ = false;
};

/// Returns: empty where a number leaves the range of S.
template <class S>
std::optional<RoundedPair> rounded(const Pair& pair) {
  Rounding<S> rounding;
  const Body a = walkthroughs::model::converted<double>(pair.a, rounding),
             b = walkthroughs::model::converted<double>(pair.b, rounding);
  if (!rounding.in_range()) return std::nullopt;
  return RoundedPair{{a, b}, rounding.differs()};
}

// -- Shapes -----------------------------------------------------------------------------------------------------------

/// Returns: the body as a shape of S; empty where S cannot ask about such a body.
template <class S>
std::optional<Form<S>> form_of(const Body& body) {
  const auto form = [](auto shape) -> std::optional<Form<S>> {
    if constexpr (walkthroughs::model::CanBeAsked<decltype(shape)>)
      return walkthroughs::model::RowOf<decltype(shape)>::asked(std::move(shape));
    else
      return std::nullopt;
  };
  return std::visit(form, walkthroughs::model::converted<S>(body, walkthroughs::model::Cast<S>{}));
}

template <class S>
gjk::Vec3<S> between_centers(const Pair& pair) {
  const auto middle = [](const Body& body) {
    return std::visit([](const auto& form) { return walkthroughs::model::RowOf<decltype(form)>::middle(form); }, body);
  };
  return walkthroughs::model::direction_between_centers<S>(middle(pair.a), middle(pair.b));
}

/// Returns: what to ask of GJK in S; empty where S cannot ask about such bodies.
template <class S>
std::unique_ptr<Question> question_of(const Pair& pair) {
  std::optional<Form<S>> a = form_of<S>(pair.a), b = form_of<S>(pair.b);
  if (!a || !b) return nullptr;
  return std::make_unique<QuestionOf<S>>(std::move(*a), std::move(*b), between_centers<S>(pair));
}

}  // namespace study
