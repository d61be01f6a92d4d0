#include "tests/study/judge/symmetries.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/certified/certified.hpp"

namespace study {
namespace {

template <class S>
using Points = walkthroughs::model::PointsOf<S>;

template <class S, class Change>
PairOfSets<S> changed(PairOfSets<S> pair, const Change& change) {
  for (Points<S>* const set : {&pair.a, &pair.b})
    for (gjk::Vec3<S>& p : *set) p = change(p);
  return pair;
}

template <class S>
PairOfSets<S> permuted(PairOfSets<S> pair, Dice& dice) {
  dice.shuffle(pair.a);
  dice.shuffle(pair.b);
  return pair;
}

template <class S>
PairOfSets<S> repeated(PairOfSets<S> pair, Dice& dice) {
  for (Points<S>* const set : {&pair.a, &pair.b})
    for (int more = dice.whole(1, 4); more > 0; --more) {
      const gjk::Vec3<S> again = (*set)[static_cast<std::size_t>(dice.whole(0, static_cast<int>(set->size()) - 1))];
      set->insert(set->begin() + dice.whole(0, static_cast<int>(set->size())), again);
    }
  return pair;
}

/// One of the 48 motions of the cube: axes change places and directions.
template <class S>
PairOfSets<S> turned(const PairOfSets<S>& pair, Dice& dice) {
  std::vector<int> axes{0, 1, 2};
  dice.shuffle(axes);
  const gjk::Vec3<S> signs(static_cast<S>(dice.sign()), static_cast<S>(dice.sign()), static_cast<S>(dice.sign()));
  return changed(pair, [&](const gjk::Vec3<S>& p) {
    return gjk::Vec3<S>(signs[0] * p[axes[0]], signs[1] * p[axes[1]], signs[2] * p[axes[2]]);
  });
}

/// To one end of the range as often as anywhere else in it.
template <class S>
std::optional<PairOfSets<S>> scaled(const PairOfSets<S>& pair, Dice& dice) {
  using Limits = std::numeric_limits<S>;
  int least = Limits::min_exponent - Limits::digits - 4000, most = 4000;
  for (const Points<S>* const set : {&pair.a, &pair.b})
    for (const gjk::Vec3<S>& p : *set)
      for (const S x : p) {
        if (x == 0) continue;
        const gjk::detail::BinaryFraction fraction(static_cast<double>(x));
        least = std::max(least, Limits::min_exponent - Limits::digits - fraction.e);
        most = std::min(most, Limits::max_exponent - 1 - std::ilogb(x));
      }
  if (least > most) return std::nullopt;
  const int choice = dice.whole(0, 3), power = choice == 0 ? least : choice == 1 ? most : dice.whole(least, most);
  return changed(pair, [&](const gjk::Vec3<S>& p) {
    return gjk::Vec3<S>(std::scalbn(p.x(), power), std::scalbn(p.y(), power), std::scalbn(p.z(), power));
  });
}

/// By as much as the sets are wide, about; rounded to what all coordinates have room for.
template <class S>
std::optional<PairOfSets<S>> moved(const PairOfSets<S>& pair, Dice& dice) {
  S widest = 0;
  for (const Points<S>* const set : {&pair.a, &pair.b})
    for (const gjk::Vec3<S>& p : *set) widest = std::max(widest, p.cwiseAbs().maxCoeff());
  if (widest == 0) return std::nullopt;
  for (int bits = 12; bits >= 0; bits -= 3) {
    const S unit = std::scalbn(S(1), std::ilogb(widest) - bits);
    const gjk::Vec3<S> t(unit * static_cast<S>(dice.whole(-3, 3)), unit * static_cast<S>(dice.whole(-3, 3)),
                         unit * static_cast<S>(dice.sign()));
    const auto after_move = changed(pair, [&](const gjk::Vec3<S>& p) { return gjk::Vec3<S>(p + t); });
    bool is_exact = true;  // a sum is where subtracting each part gives the other
    for (const auto set : {&PairOfSets<S>::a, &PairOfSets<S>::b})
      for (std::size_t i = 0; i < (pair.*set).size(); ++i) {
        const gjk::Vec3<S>&before = (pair.*set)[i], &now = (after_move.*set)[i];
        is_exact = is_exact && now - t == before && now - before == t && now.allFinite();
      }
    if (is_exact) return after_move;
  }
  return std::nullopt;
}

}  // namespace

template <class S>
std::optional<PairOfSets<S>> after(Symmetry symmetry, const PairOfSets<S>& pair, Dice& dice) {
  switch (symmetry) {
    case Symmetry::as_it_is: return pair;
    case Symmetry::exchanged: return PairOfSets<S>{pair.b, pair.a};
    case Symmetry::permuted: return permuted(pair, dice);
    case Symmetry::repeated: return repeated(pair, dice);
    case Symmetry::turned: return turned(pair, dice);
    case Symmetry::scaled: return scaled(pair, dice);
    case Symmetry::moved: return moved(pair, dice);
  }
  return std::nullopt;
}

template std::optional<PairOfSets<double>> after(Symmetry, const PairOfSets<double>&, Dice&);

}  // namespace study
