#include "walkthroughs/model/exact_shape.hpp"

#include <optional>
#include <variant>

#include "core/certified/exact_fallback.hpp"
#include "core/certified/shapes.hpp"
#include "core/certified/support_error.hpp"

namespace walkthroughs::model {

// How well the points of objects are known, so that gjk::certified_shapes() takes them.

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

namespace {

template <class S>
gjk::ShapesResult bounded_answer(const Object& a, const Object& b) {
  const auto posed = [](const Object& o) { return PosedForm<S>(Asked<S>(converted<S>(o.form, Cast<S>{})), o.pose); };
  return gjk::certified_shapes<S>(posed(a), posed(b));
}

}  // namespace

ExactAnswer exact_answer(const Object& a, const Object& b) {
  const auto *points_a = std::get_if<Points>(&a.form), *points_b = std::get_if<Points>(&b.form);
  if (!points_a || !points_b || moves(a.pose) || moves(b.pose)) return {bounded_answer<double>(a, b).status};
  const gjk::NobodyListens nobody;
  gjk::detail::Teller<const gjk::NobodyListens> tell(nobody, gjk::CrossingTest::on);
  gjk::IndexPairs first;
  first.add({0, 0});
  gjk::CertifiedResult result;
  gjk::detail::decide_exactly(gjk::PointSet<double>(*points_a), gjk::PointSet<double>(*points_b), first, tell, result);
  const auto* feature = std::get_if<gjk::SeparatingFeature>(&result.certificate);
  return {result.status, feature ? feature->of : std::get<gjk::CommonSimplex>(result.certificate).of};
}

bool is_near_contact(const Object& a, const Object& b, Scalar scalar) {
  return with_scalar(scalar, [&]<class S>() { return bounded_answer<S>(a, b).status == gjk::Status::undecided; });
}

}  // namespace walkthroughs::model
