#include "walkthroughs/query/query_certified.hpp"

#include <optional>
#include <variant>

#include "core/certified/balls.hpp"
#include "core/certified/certified.hpp"
#include "core/certified/shapes.hpp"
#include "walkthroughs/query/query_certificate.hpp"
#include "walkthroughs/query/query_support_error.hpp"

namespace walkthroughs {
namespace {

using reading::ObjectAsWritten;

/// What is decided exactly.
template <class S>
using ExactShape = std::variant<gjk::PointSet<S>, gjk::Sphere<S>>;

/// Returns: nothing where its points are computed: of cylinders, of sums, and where a pose moves it.
template <class S>
std::optional<ExactShape<S>> exact_shape(const ObjectAsWritten& object) {
  if (object.pose && moves(*object.pose)) return std::nullopt;
  const auto shape = converted<S>(object.form, InScalar<S>{});
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
  const QueryObject<S> one = query_object<S>(std::move(pair.a)), other = query_object<S>(std::move(pair.b));
  write_answer(gjk::certified_shapes<S>(one, other), query.evidence, out);
}

}  // namespace

void answer_certified(PairAsWritten&& pair, const QueryOptions& query, std::string& out) {
  if (query.scalar == QueryScalar::binary32)
    answer_in<float>(std::move(pair), query, out);
  else
    answer_in<double>(std::move(pair), query, out);
}

}  // namespace walkthroughs
