/// What the exact fallback of certified_collision() tells, in which words. Nothing here decides anything.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../telling.hpp"
#include "bounded.hpp"
#include "dyadic.hpp"
#include "fraction.hpp"

namespace gjk::detail {

/// A polynomial as it is called, and in the plane of which face its normal lies.
struct SignWords {
  Expression expression;
  Roles face = {};
  bool operator==(const SignWords&) const = default;
};

/// The powers of two with which numbers were multiplied where they were computed.
struct Powers {
  int bounded = 0;  ///< doubles that know their error
  int whole = 0;    ///< whole numbers
};

/// Returns: x times 2^power, reduced: "-3/1024", "12".
inline std::string fraction_text(const Whole& x, int power) {
  const Fraction scale(Whole(Whole(1) << static_cast<unsigned>(std::abs(power))));
  return (power >= 0 ? Fraction(x) * scale : Fraction(x) / scale).str();
}

template <class S>
FeatureKept<S> kept(const Simplex<S>& before, const Roles& roles, bool contains_origin) {
  return {.before = before, .after = before.only(roles), .kept = roles, .contains_origin = contains_origin};
}

/// Hands events on. Each search knows only what it has found itself. So here a vertex of the exact fallback is new only
/// where none of the first search lies at its place.
template <class S, class Obs>
class OneRun {
 public:
  explicit OneRun(Obs& observer) : observer_(observer) {}

  template <class Event>
  void operator()(Event event) {
    if constexpr (std::same_as<Event, SupportFound<S>>) event.is_new = remember(event.vertex.w) && event.is_new;
    observer_(std::move(event));
  }

 private:
  bool remember(const Vec3<S>& w) {
    if (std::find(found_.begin(), found_.end(), w) != found_.end()) return false;
    found_.push_back(w);
    return true;
  }

  Obs& observer_;
  std::vector<Vec3<S>> found_;
};

/// Tells what the exact fallback does. It tells each sign once a simplex, however often it is asked for.
template <class S, class Obs = const NobodyListens>
class FallbackTeller {
 public:
  static constexpr bool somebody_listens = Teller<Obs>::somebody_listens;

  FallbackTeller() requires(!somebody_listens) = default;
  explicit FallbackTeller(Teller<Obs>& tell) : tell_(&tell) {}

  template <class MakeEvent>
  void operator()(MakeEvent&& make) const {
    if constexpr (somebody_listens) (*tell_)(std::forward<MakeEvent>(make));
  }

  /// Makes the letters those of a new simplex.
  void name_anew() {
    letters_ = in_order;
    told_.clear();
  }
  /// Roles change with what is kept. Letters do not until the next vertex comes.
  void keep(const Roles& roles) {
    const std::array<Role, 4> before = letters_;
    int i = roles.size();
    for (const Role role : roles) letters_[static_cast<std::size_t>(--i)] = before[static_cast<std::size_t>(role)];
  }
  /// "AX".
  NamedVector edge(Role X) const { return NamedVector::edge(called(Role::A), called(X)); }
  /// "AXn".
  NamedVector normal(Role X) const { return NamedVector::normal({called(Role::A), called(X)}); }
  /// "AXYn".
  NamedVector normal(Role X, Role Y) const { return NamedVector::normal({called(Role::A), called(X), called(Y)}); }
  /// AXY in the order of the alphabet.
  Roles face(Role X, Role Y) const {
    return {called(Role::A), std::min(called(X), called(Y)), std::max(called(X), called(Y))};
  }

  /// `exact`: where the sign was in doubt.
  template <class Words>
  void sign(const Words& words, const Powers& powers, const Bounded& value, const Whole* exact,
            const std::optional<Vertex<S>>& vertex = {}) const {
    if constexpr (somebody_listens) {
      const SignWords told = words();
      if (!vertex && std::find(told_.begin(), told_.end(), told) != told_.end()) return;
      told_.push_back(told);
      (*tell_)([&] {
        SignTaken<S> event{.expression = told.expression, .face = told.face, .vertex = vertex};
        write(value, powers.bounded, event);
        if (exact) event.exact = fraction_text(*exact, -powers.whole);
        event.sign = exact ? exact->sign() : sign_of(value);
        return event;
      });
    }
  }

 private:
  static constexpr std::array<Role, 4> in_order{Role::A, Role::B, Role::C, Role::D};

  /// By the letter that the role had when the newest vertex came.
  Role called(Role role) const { return letters_[static_cast<std::size_t>(role)]; }

  /// Divides by the power of two, unless that would lose digits.
  static void write(const Bounded& x, int power, SignTaken<S>& event) {
    const Bounded own{std::scalbn(x.value, -power), std::scalbn(x.error, -power)};
    const auto is_kept = [](double before, double after) { return before == 0 || std::isnormal(after); };
    const bool is_exact = is_kept(x.value, own.value) && is_kept(x.error, own.error);
    event.value = (is_exact ? own.value : x.value) + 0.0;  // no −0
    event.error = is_exact ? own.error : x.error;
    if (!is_exact) event.power = power;
  }

  Teller<Obs>* tell_ = nullptr;
  std::array<Role, 4> letters_ = in_order;  // by role
  mutable std::vector<SignWords> told_;
};

}  // namespace gjk::detail
