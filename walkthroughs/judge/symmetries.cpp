#include "walkthroughs/judge/symmetries.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/certified/certified.hpp"

namespace walkthroughs::judge {
namespace {

template <class Change>
PointPair changed(PointPair pair, const Change& change) {
  for (Points* const set : {&pair.a, &pair.b})
    for (Vec& p : *set) p = change(p);
  return pair;
}

PointPair permuted(PointPair pair, Dice& dice) {
  dice.shuffle(pair.a);
  dice.shuffle(pair.b);
  return pair;
}

PointPair repeated(PointPair pair, Dice& dice) {
  for (Points* const set : {&pair.a, &pair.b})
    for (int more = dice.whole(1, 4); more > 0; --more) {
      const Vec again = (*set)[static_cast<std::size_t>(dice.whole(0, static_cast<int>(set->size()) - 1))];
      set->insert(set->begin() + dice.whole(0, static_cast<int>(set->size())), again);
    }
  return pair;
}

/// One of the 48 motions of the cube: axes change places and directions.
PointPair turned(const PointPair& pair, Dice& dice) {
  std::vector<int> axes{0, 1, 2};
  dice.shuffle(axes);
  const Vec signs(static_cast<double>(dice.sign()), static_cast<double>(dice.sign()), static_cast<double>(dice.sign()));
  return changed(
      pair, [&](const Vec& p) { return Vec(signs[0] * p[axes[0]], signs[1] * p[axes[1]], signs[2] * p[axes[2]]); });
}

/// To one end of the range as often as anywhere else in it.
std::optional<PointPair> scaled(const PointPair& pair, Dice& dice) {
  using Limits = std::numeric_limits<double>;
  int least = Limits::min_exponent - Limits::digits - 4000, most = 4000;
  for (const Points* const set : {&pair.a, &pair.b})
    for (const Vec& p : *set)
      for (const double x : p) {
        if (x == 0) continue;
        const gjk::detail::BinaryFraction fraction(x);
        least = std::max(least, Limits::min_exponent - Limits::digits - fraction.e);
        most = std::min(most, Limits::max_exponent - 1 - std::ilogb(x));
      }
  if (least > most) return std::nullopt;
  const int choice = dice.whole(0, 3), power = choice == 0 ? least : choice == 1 ? most : dice.whole(least, most);
  return changed(pair, [&](const Vec& p) {
    return Vec(std::scalbn(p.x(), power), std::scalbn(p.y(), power), std::scalbn(p.z(), power));
  });
}

/// By as much as the sets are wide, about; rounded to what all coordinates have room for.
std::optional<PointPair> moved(const PointPair& pair, Dice& dice) {
  double widest = 0;
  for (const Points* const set : {&pair.a, &pair.b})
    for (const Vec& p : *set) widest = std::max(widest, p.cwiseAbs().maxCoeff());
  if (widest == 0) return std::nullopt;
  for (int bits = 12; bits >= 0; bits -= 3) {
    const double unit = std::scalbn(1.0, std::ilogb(widest) - bits);
    const Vec t(unit * static_cast<double>(dice.whole(-3, 3)), unit * static_cast<double>(dice.whole(-3, 3)),
                unit * static_cast<double>(dice.sign()));
    const auto after_move = changed(pair, [&](const Vec& p) { return Vec(p + t); });
    bool is_exact = true;  // a sum is where subtracting each part gives the other
    for (const auto set : {&PointPair::a, &PointPair::b})
      for (std::size_t i = 0; i < (pair.*set).size(); ++i) {
        const Vec &before = (pair.*set)[i], &now = (after_move.*set)[i];
        is_exact = is_exact && now - t == before && now - before == t && now.allFinite();
      }
    if (is_exact) return after_move;
  }
  return std::nullopt;
}

}  // namespace

std::optional<PointPair> after(Symmetry symmetry, const PointPair& pair, Dice& dice) {
  switch (symmetry) {
    case Symmetry::as_it_is: return pair;
    case Symmetry::exchanged: return PointPair{pair.b, pair.a};
    case Symmetry::permuted: return permuted(pair, dice);
    case Symmetry::repeated: return repeated(pair, dice);
    case Symmetry::turned: return turned(pair, dice);
    case Symmetry::scaled: return scaled(pair, dice);
    case Symmetry::moved: return moved(pair, dice);
  }
  return std::nullopt;
}

}  // namespace walkthroughs::judge
