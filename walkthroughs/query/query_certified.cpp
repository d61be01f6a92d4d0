#include "walkthroughs/query/query_certified.hpp"

#include <optional>
#include <variant>

#include "core/certified/balls.hpp"
#include "core/certified/support_error.hpp"

// How well the points of a query's objects are known, so that gjk::certified_shapes() takes them.

namespace walkthroughs::model {

template <class S>
gjk::SupportError support_error(const AskedSum<S>& asked) {
  return gjk::support_error(asked.sum());
}
template <class S>
gjk::Vec3<S> near_support(const AskedSum<S>& asked, const gjk::Vec3<S>& d) {
  return gjk::near_support(asked.sum(), d);
}

/// Of a shape that has one form of several.
template <template <class> class Shape, class S>
requires requires(const Shape<S>& shape) { shape.form(); }
gjk::SupportError support_error(const Shape<S>& shape) {
  return std::visit([](const auto& form) { return support_error(form); }, shape.form());
}
template <template <class> class Shape, class S>
requires requires(const Shape<S>& shape) { shape.form(); }
gjk::Vec3<S> near_support(const Shape<S>& shape, const gjk::Vec3<S>& d) {
  return std::visit([&](const auto& form) { return near_support(form, d); }, shape.form());
}

}  // namespace walkthroughs::model

namespace walkthroughs::query {
namespace {

/// What is decided exactly.
template <class S>
using ExactShape = std::variant<gjk::PointSet<S>, gjk::Sphere<S>>;

/// Returns: nothing where its points are computed: of cylinders, of sums, and where a pose moves it.
template <class S>
std::optional<ExactShape<S>> exact_shape(const Object& object) {
  if (moves(object.pose)) return std::nullopt;
  const auto shape = converted<S>(object.form, reading::InScalar<S>{});
  if (const auto* points = std::get_if<PointsOf<S>>(&shape)) return gjk::PointSet<S>(*points);
  if (const auto* ball = std::get_if<BallOf<S>>(&shape)) return gjk::Sphere<S>(ball->center, ball->radius);
  return std::nullopt;
}

template <class S>
struct Answer {
  const PairAsWritten& pair;
  const QueryOptions& query;
  std::string& out;

  void operator()(const gjk::PointSet<S>& a, const gjk::PointSet<S>& b) const {
    const gjk::Options<S> options = search_options<S>(pair, query);
    const gjk::CertifiedResult result = gjk::with_rules(
        query.rules, query.zero_test, [&]<class Rules>() { return gjk::certified_collision<S, Rules>(a, b, options); });
    write_answer(result, CertificateWriter<S>{a, b, query.evidence, out});
  }
  /// One of them is a ball.
  void operator()(const auto& a, const auto& b) const { write_answer_of_balls(gjk::certified_status(a, b), out); }
};

template <class S>
void answer_in(PairAsWritten&& pair, const QueryOptions& query, std::string& out) {
  const auto a = exact_shape<S>(pair.a), b = exact_shape<S>(pair.b);
  if (a && b) return std::visit(Answer<S>{pair, query, out}, *a, *b);
  const PosedForm<S> one = query_object<S>(std::move(pair.a)), other = query_object<S>(std::move(pair.b));
  write_answer(gjk::certified_shapes<S>(one, other), query.evidence, out);
}

}  // namespace

void answer_certified(PairAsWritten&& pair, const QueryOptions& query, std::string& out) {
  const auto answer = query.scalar == QueryScalar::binary32 ? answer_in<float> : answer_in<double>;
  answer(std::move(pair), query, out);
}

}  // namespace walkthroughs::query
