#include "walkthroughs/query/query_certified.hpp"

#include <optional>
#include <utility>
#include <variant>

#include "core/certified/check_grown.hpp"
#include "walkthroughs/model/exact_shape.hpp"

namespace walkthroughs::query {
namespace {

/// Returns: the points of an object that nothing moves.
template <class S>
std::optional<gjk::PointSet<S>> points_of(const Object& object) {
  if (moves(object.pose) || !std::holds_alternative<Points>(object.form)) return std::nullopt;
  return gjk::PointSet<S>(std::get<PointsOf<S>>(converted<S>(object.form, Cast<S>{})));
}

}  // namespace

template <class S>
Provable<S> provable(const PairAsWritten& pair, const QueryOptions& query) {
  if (auto a = points_of<S>(pair.a), b = points_of<S>(pair.b); a && b)
    return ProvablePoints<S>{search_options<S>(pair, query), query.rules, query.zero_test, std::move(*a),
                             std::move(*b)};
  auto a = exact_shape(pair.a.form, pair.a.pose), b = exact_shape(pair.b.form, pair.b.pose);
  if (a && b) return ProvableGrown{std::move(*a), std::move(*b)};
  return ProvableOthers{pair.a, pair.b};
}
template Provable<double> provable(const PairAsWritten&, const QueryOptions&);

template <class S>
gjk::CertifiedResult proven(const ProvablePoints<S>& pair) {
  return gjk::with_rules(pair.rules, pair.zero_test, [&]<class Rules>() {
    return gjk::certified_collision<S, Rules>(pair.a, pair.b, pair.options);
  });
}
template gjk::CertifiedResult proven(const ProvablePoints<double>&);

namespace {

/// Appends what proves the answer about two grown sets; in fractions with what a check of it computes.
void write_answer(const gjk::GrownResult& result, const gjk::Grown& a, const gjk::Grown& b, QueryEvidence evidence,
                  std::string& out) {
  write_status(result, out);
  write_indices(result.nearest, out += ",\"proof\":\"distance\",\"certificate\":{\"nearest\":");
  if (evidence == QueryEvidence::fractions) {
    const auto nearest = *gjk::nearest_point_of(result.nearest, a, b);
    write_numbers(nearest.weights, out += ",\"weights\":");
    write_numbers(nearest.v, out += ",\"point\":");
  }
  out += "}}\n";
}

template <class S>
struct Writer {
  QueryEvidence evidence;
  std::string& out;

  void operator()(const ProvablePoints<S>& pair) const {
    write_answer(proven(pair), CertificateWriter<S>{pair.a, pair.b, evidence, out});
  }
  void operator()(const ProvableGrown& pair) const {
    write_answer(gjk::certified_collision(pair.a, pair.b), pair.a, pair.b, evidence, out);
  }
  void operator()(const ProvableOthers& pair) const {
    if (const auto status = exact_status_of_cylinders(pair.a, pair.b)) return write_answer_of_cylinders(*status, out);
    write_answer(bounded_answer(pair.a, pair.b), evidence, out);
  }
};

template <class S>
void answer_in(const PairAsWritten& pair, const QueryOptions& query, std::string& out) {
  std::visit(Writer<S>{query.evidence, out}, provable<S>(pair, query));
}

/// Returns: the object in floats, of which doubles hold each.
Object in_float(Object object) {
  object.form = converted<double>(converted<float>(object.form, reading::InScalar<float>{}), Cast<double>{});
  round_to_float(object);
  return object;
}

}  // namespace

void answer_certified(PairAsWritten&& pair, const QueryOptions& query, std::string& out) {
  if (query.scalar == QueryScalar::binary32)
    return answer_in<float>({in_float(std::move(pair.a)), in_float(std::move(pair.b))}, query, out);
  answer_in<double>(pair, query, out);
}

}  // namespace walkthroughs::query
