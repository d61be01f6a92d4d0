/// Events of a search in other numbers, told in doubles. A double holds every float; other numbers are rounded.
#pragma once

#include <type_traits>

#include "core/events.hpp"

namespace walkthroughs {

template <class S>
double widened(const S& x) {
  return static_cast<double>(x);
}

template <class S>
gjk::Vec3<double> widened(const gjk::Vec3<S>& v) {
  return {widened(v.x()), widened(v.y()), widened(v.z())};
}

template <class S>
gjk::SupportPoint<double> widened(const gjk::SupportPoint<S>& p) {
  return {widened(p.point), p.index};
}

template <class S>
gjk::Vertex<double> widened(const gjk::Vertex<S>& v) {
  return {widened(v.a), widened(v.b), widened(v.w)};
}

template <class S>
gjk::Simplex<double> widened(const gjk::Simplex<S>& simplex) {
  gjk::Simplex<double> wide;
  for (int i = 0; i < simplex.size(); ++i) wide.add(widened(simplex[i]));
  return wide;
}

// -- Events -----------------------------------------------------------------------------------------------------------

template <class S>
gjk::SearchStarted<double> widened(const gjk::SearchStarted<S>& e) {
  return {e.iteration, widened(e.direction), e.why};
}

template <class S>
gjk::SupportFound<double> widened(const gjk::SupportFound<S>& e) {
  return {e.iteration, widened(e.direction), widened(e.vertex), e.is_new};
}

template <class S>
gjk::CrossingTested<double> widened(const gjk::CrossingTested<S>& e) {
  return {e.iteration, e.value ? std::optional(widened(*e.value)) : std::nullopt, e.verdict};
}

template <class S>
gjk::VertexAdded<double> widened(const gjk::VertexAdded<S>& e) {
  return {e.iteration, widened(e.simplex)};
}

template <class S>
gjk::RegionTested<double> widened(const gjk::RegionTested<S>& e) {
  gjk::RegionTested<double> wide{e.iteration, e.simplex_size, e.feature, e.label, e.face, e.expression, e.formula, {},
                                 {},          e.relation,     e.verdict, e.reason};
  if (e.normal) wide.normal = widened(*e.normal);
  if (const auto* number = std::get_if<S>(&e.value)) wide.value = widened(*number);
  if (const auto* vector = std::get_if<gjk::Vec3<S>>(&e.value)) wide.value = widened(*vector);
  return wide;
}

template <class S>
gjk::SimplexReduced<double> widened(const gjk::SimplexReduced<S>& e) {
  return {e.iteration, widened(e.before), widened(e.after), e.kept, e.dropped, e.why};
}

template <class S>
gjk::DirectionChosen<double> widened(const gjk::DirectionChosen<S>& e) {
  return {e.iteration, e.expression, widened(e.direction)};
}

template <class S>
gjk::Finished<double> widened(const gjk::Finished<S>& e) {
  const gjk::Result<S>& result = e.result;
  gjk::Finished<double> wide{e.iteration,
                             {result.status, result.reason, result.iterations, widened(result.simplex), std::nullopt}};
  if (const auto& proof = result.separation)
    wide.result.separation = {widened(proof->direction), widened(proof->vertex), widened(proof->support_value)};
  return wide;
}

}  // namespace walkthroughs
