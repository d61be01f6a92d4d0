/// How well the points of a query's objects are known, so that gjk::certified_shapes() takes them.
#pragma once

#include "core/certified/support_error.hpp"
#include "walkthroughs/query/query_object.hpp"

namespace walkthroughs {

template <class S>
gjk::SupportError support_error(const Asked<S>& asked);

template <class S>
gjk::SupportError support_error(const AskedSum<S>& asked) {
  return gjk::support_error(asked.sum());
}
template <class S>
gjk::SupportError support_error(const Asked<S>& asked) {
  return std::visit([](const auto& form) { return support_error(form); }, asked.form());
}
template <class S>
gjk::SupportError support_error(const QueryObject<S>& object) {
  return std::visit([](const auto& shape) { return support_error(shape); }, object.shape());
}

template <class S>
gjk::Vec3<S> near_support(const Asked<S>& asked, const gjk::Vec3<S>& d);

template <class S>
gjk::Vec3<S> near_support(const AskedSum<S>& asked, const gjk::Vec3<S>& d) {
  return gjk::near_support(asked.sum(), d);
}
template <class S>
gjk::Vec3<S> near_support(const Asked<S>& asked, const gjk::Vec3<S>& d) {
  return std::visit([&](const auto& form) { return near_support(form, d); }, asked.form());
}
template <class S>
gjk::Vec3<S> near_support(const QueryObject<S>& object, const gjk::Vec3<S>& d) {
  return std::visit([&](const auto& shape) { return near_support(shape, d); }, object.shape());
}

}  // namespace walkthroughs
