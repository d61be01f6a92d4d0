#include "walkthroughs/query/query_certified.hpp"

#include <variant>

#include "core/certified.hpp"
#include "walkthroughs/query/query_certificate.hpp"
#include "walkthroughs/text/document.hpp"

namespace walkthroughs {
namespace {

using reading::ObjectAsWritten;

bool moves(const Pose& pose) {
  return pose.rotation != Eigen::Matrix3d::Identity() || pose.translation != Point::Zero();
}

/// `key`: of the object in its line. Errors: DocumentError.
template <class S>
gjk::PointSet<S> certifiable_set(const ObjectAsWritten& object, const std::string& key) {
  const auto* const points = std::get_if<Points>(&object.form);
  if (!points)
    throw DocumentError(1, key + "." + std::string(key_of(object.form)),
                        "a " + kind_of(object.form, Dimension::space) +
                            " cannot be certified, because its points are computed, and so rounded; give points, or "
                            "leave out --certified");
  if (object.pose && moves(*object.pose))
    throw DocumentError(1, key + ".pose",
                        "an object that its pose moves cannot be certified, because its points are rounded then; give "
                        "the points where they are, or leave out --certified");
  std::vector<gjk::Vec3<S>> list;
  list.reserve(points->size());
  for (const Point& p : *points) list.push_back(Cast<S>{}.point(p));
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
