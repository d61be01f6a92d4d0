#include "walkthroughs/query/query_certified.hpp"

#include <variant>

#include "core/certified.hpp"
#include "walkthroughs/model/scene.hpp"
#include "walkthroughs/query/query_certificate.hpp"
#include "walkthroughs/text/document.hpp"

namespace walkthroughs {
namespace {

using reading::ObjectAsWritten;

/// `key`: of the object in its line. Errors: DocumentError.
template <class S>
gjk::PointSet<S> certifiable_set(const ObjectAsWritten& object, const std::string& key) {
  if (const auto objection = objection_to_proof(object.form, object.pose.value_or(Pose{})))
    throw DocumentError(1, key + "." + objection->key, objection->why + ", or leave out --certified");
  const Points& points = std::get<Points>(object.form);
  std::vector<gjk::Vec3<S>> list;
  list.reserve(points.size());
  for (const Point& p : points) list.push_back(Cast<S>{}.point(p));
  return gjk::PointSet<S>(std::move(list));
}

template <class S>
void answer_in(const PairAsWritten& pair, const QueryOptions& query, std::string& out) {
  const gjk::PointSet<S> a = certifiable_set<S>(pair.a, "a"), b = certifiable_set<S>(pair.b, "b");
  const gjk::Options<S> options = search_options<S>(pair, query);
  const gjk::CertifiedResult result = gjk::with_rules(
      query.rules, query.zero_test, [&]<class Rules>() { return gjk::certified_collision<S, Rules>(a, b, options); });
  write_answer(result, CertificateWriter<S>{a, b, query.evidence, out});
}

}  // namespace

void answer_certified(const PairAsWritten& pair, const QueryOptions& query, std::string& out) {
  if (query.scalar == QueryScalar::binary32)
    answer_in<float>(pair, query, out);
  else
    answer_in<double>(pair, query, out);
}

}  // namespace walkthroughs
