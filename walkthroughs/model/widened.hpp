/// Events of a search in other numbers, told in doubles. A double holds every float; other numbers are rounded.
#pragma once

#include "walkthroughs/model/event_fields.hpp"

namespace walkthroughs::model {

/// Widens whatever a field of an event of scalar S may hold.
template <class S>
struct Widening {
  double operator()(const S& x) const { return static_cast<double>(x); }
  gjk::Vec3<double> operator()(const gjk::Vec3<S>& v) const { return {(*this)(v.x()), (*this)(v.y()), (*this)(v.z())}; }

  gjk::Simplex<double> operator()(const gjk::Simplex<S>& simplex) const {
    gjk::Simplex<double> wide;
    for (int i = 0; i < simplex.size(); ++i) wide.add((*this)(simplex[i]));
    return wide;
  }

  using Value = std::variant<std::monostate, double, gjk::Vec3<double>>;
  Value operator()(const std::variant<std::monostate, S, gjk::Vec3<S>>& value) const {
    return std::visit([this](const auto& each) { return Value((*this)(each)); }, value);
  }

  template <class T>
  auto operator()(const std::optional<T>& value) const {
    return value ? std::optional((*this)(*value)) : std::nullopt;
  }

  template <template <class> class R>
  requires Record<R<S>> R<double>
  operator()(const R<S>& record) const {
    R<double> wide{};
    const auto widen_fields = [&](const auto&... to) {
      std::apply([&](const auto&... from) { (widen_field(record, from, wide, to), ...); }, FieldsOf<R<S>>::list);
    };
    std::apply(widen_fields, FieldsOf<R<double>>::list);
    return wide;
  }

  template <class T>
  T operator()(const T& other) const {  // words, counts, enumerators
    return other;
  }

 private:
  void widen_field(const auto& record, const auto& from, auto& wide, const auto& to) const {
    if constexpr (requires { to.member; }) wide.*to.member = (*this)(record.*from.member);
  }
};

template <template <class> class E, class S>
E<double> widened(const E<S>& event) {
  E<double> wide = Widening<S>{}(event);
  wide.iteration = event.iteration;
  return wide;
}

/// What hears of a search and writes all of it in doubles. One type for all searches, so that each is compiled no more often than it
/// must be.
struct WidenedInto {
  gjk::Trace<double>& trace;
  void operator()(const auto& event) const { trace(widened(event)); }
};

}  // namespace walkthroughs::model
