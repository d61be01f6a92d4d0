#include "walkthroughs/query/query_certified.hpp"

#include <concepts>
#include <optional>
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

/// In numbers of S, which hold those of the pair.
template <class S>
void answer_in(const PairAsWritten& pair, const QueryOptions& query, std::string& out) {
  if (const auto a = points_of<S>(pair.a), b = points_of<S>(pair.b); a && b) {
    const gjk::Options<S> options = search_options<S>(pair, query);
    const auto prove = [&]<class Rules>() { return gjk::certified_collision<S, Rules>(*a, *b, options); };
    const gjk::CertifiedResult result = gjk::with_rules(query.rules, query.zero_test, prove);
    return write_answer(result, CertificateWriter<S>{*a, *b, query.evidence, out});
  }
  const auto a = exact_shape(pair.a.form, pair.a.pose), b = exact_shape(pair.b.form, pair.b.pose);
  if (a && b) return write_answer(gjk::certified_collision(*a, *b), *a, *b, query.evidence, out);
  if (const auto status = exact_status_of_cylinders(pair.a, pair.b)) return write_answer_of_cylinders(*status, out);
  write_answer(bounded_answer<S>(pair.a, pair.b), query.evidence, out);
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
