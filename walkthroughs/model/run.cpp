#include <functional>
#include <variant>

#include "core/certified/certified.hpp"
#include "core/gjk.hpp"
#include "core/rule_sets.hpp"
#include "walkthroughs/model/event_fields.hpp"
#include "walkthroughs/model/scene.hpp"
#include "walkthroughs/wrong_on_purpose/rules.hpp"

namespace walkthroughs::model {
namespace {

// -- Events of a search in other numbers, told in doubles --------------------------------------------------------------

/// Widens whatever a field of an event of scalar S may hold.
template <class S>
struct Widening {
  double operator()(const S& x) const { return static_cast<double>(x); }
  gjk::Vec3<double> operator()(const gjk::Vec3<S>& v) const { return v.template cast<double>(); }

  gjk::Simplex<double> operator()(const gjk::Simplex<S>& simplex) const {
    gjk::Simplex<double> wide;
    for (const auto& vertex : simplex) wide.add((*this)(vertex));
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

// -- What a scene says -------------------------------------------------------------------------------------------------

#ifdef GJKSTEP_FEW_SEARCHES
constexpr bool has_all_searches = false;
#else
constexpr bool has_all_searches = true;
#endif

bool is_usual(const Scene& scene) {
  return scene.scalar == Scalar::binary64 && scene.zero_test == ZeroTest::exact && !scene.mistake && !scene.certified;
}

/// The one place where what a scene says becomes template arguments.
/// Calls run.template operator()<S, Rules>() with the scalar and the rules of a scene.
template <class Run>
void with_types_of(const Scene& scene, Run&& run) {
  if constexpr (!has_all_searches)
    return gjk::with_rules<gjk::ExactZeroTest>(scene.rules,
                                               [&]<class Rules>() { run.template operator()<double, Rules>(); });
  with_scalar(scene.scalar, [&]<class S>() {
    gjk::with_rules(scene.rules, scene.zero_test, [&]<class Rules>() { run.template operator()<S, Rules>(); });
  });
}

template <class S>
gjk::Options<S> options_in(const Scene& scene) {
  return {.first_direction = scene.options.first_direction.cast<S>(),
          .iteration_limit = scene.options.iteration_limit,
          .crossing_test = scene.options.crossing_test};
}

/// One shape for whoever answers, so that each search is compiled once.
template <class S>
struct Answering {
  const std::function<gjk::SupportPoint<double>(const Point&)>& answer;

  gjk::SupportPoint<S> support(const gjk::Vec3<S>& d) const {
    const gjk::SupportPoint<double> found = answer(d.template cast<double>());
    return {found.point.template cast<S>(), found.index};
  }
};

/// In numbers of S, which the doubles that carry them hold.
template <class S>
std::function<gjk::SupportPoint<double>(const Point&)> asking(const Object& object) {
  return
      [shape = AskedObject<S>(object)](const Point& d) { return Widening<S>{}(shape.support(d.template cast<S>())); };
}

SupportFunctions asking_the_objects_of(const Scene& scene) {
  return with_scalar(scene.scalar, [&]<class S>() { return SupportFunctions{asking<S>(scene.a), asking<S>(scene.b)}; });
}

// -- Scenes whose answer is proven ------------------------------------------------------------------------------------

template <class S>
gjk::PointSet<S> set_of(const Object& object) {
  return gjk::PointSet<S>(std::get<PointsOf<S>>(converted<S>(object.form, Cast<S>{})));
}

/// Requires: of both objects points, where they are asked for.
/// Returns: every event of certified_collision(), computed in the scene's scalar.
Trace run_certified(const Scene& scene) {
  Trace trace;
  with_types_of(scene, [&]<class S, class Rules>() {
    gjk::certified_collision<S, Rules>(set_of<S>(scene.a), set_of<S>(scene.b), options_in<S>(scene),
                                       WidenedInto{trace});
  });
  return trace;
}

}  // namespace

bool has_search(const Scene& scene) { return has_all_searches || is_usual(scene); }

Trace run(const Scene& scene) {
  if constexpr (has_all_searches)
    if (scene.certified) return run_certified(scene);
  return run(scene, asking_the_objects_of(scene));
}

Trace run(const Scene& scene, const SupportFunctions& supports) {
  Trace trace;
  const auto search = [&]<class S, class Rules>() {
    gjk::collision<S, Rules>(Answering<S>{supports.a}, Answering<S>{supports.b}, options_in<S>(scene),
                             WidenedInto{trace});
  };
  if constexpr (has_all_searches)
    if (scene.mistake) {
      wrong_on_purpose::with_mistake(*scene.mistake,
                                     [&]<class Rules>() { search.template operator()<double, Rules>(); });
      return trace;
    }
  with_types_of(scene, search);
  return trace;
}

}  // namespace walkthroughs::model
