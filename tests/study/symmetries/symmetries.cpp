#include "tests/study/symmetries/symmetries.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <utility>
#include <variant>

#include "core/certificate_check.hpp"
#include "core/certified.hpp"
#include "tests/study/pairs/families.hpp"
#include "tests/study/pairs/over_pairs.hpp"

namespace study {
namespace {

template <class S>
using Points = walkthroughs::PointsOf<S>;

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

using Tallies = std::array<SymmetryTally, symmetry_names.size()>;

struct Sum {
  Tallies tallies{};
  Sum& operator+=(const Sum& more) {
    for (std::size_t i = 0; i < tallies.size(); ++i) tallies[i] += more.tallies[i];
    return *this;
  }
};

template <class S>
std::optional<Points<S>> in(const Body& body) {
  Points<S> points;
  for (const Vec& p : std::get<study::Points>(body)) points.push_back(p.cast<S>());
  const bool is_finite = std::ranges::all_of(points, [](const gjk::Vec3<S>& p) { return p.allFinite(); });
  return is_finite ? std::optional(points) : std::nullopt;
}

template <class S>
void ask(const PairOfSets<S>& pair, Dice dice, Sum& sum) {
  std::optional<gjk::Status> truth;
  for (std::size_t i = 0; i < symmetry_names.size(); ++i) {
    SymmetryTally& tally = sum.tallies[i];
    const auto changed = after(static_cast<Symmetry>(i), pair, dice);
    if (!changed) {
      ++tally.no_room;
      continue;
    }
    const gjk::PointSet<S> a(changed->a), b(changed->b);
    const gjk::CertifiedResult result = gjk::certified_collision(a, b);
    if (!truth) truth = result.status;
    ++tally.asked;
    tally.other_answers += result.status != *truth;
    tally.unproven += !gjk::holds(result.certificate, a, b) || gjk::claim_of(result.certificate) != result.status;
    tally.second_searches += result.proof == gjk::Proof::second_search;
  }
}

bool is_of_points(const Family& family, std::uint64_t seed) {
  const Pair first = family.make(seed, 0);
  return std::holds_alternative<study::Points>(first.a) && std::holds_alternative<study::Points>(first.b);
}

/// Returns: whether it is as it should be.
bool write_table(std::ostream& out, std::string_view scalar, const Sum& sum) {
  bool good = true;
  for (std::size_t i = 0; i < symmetry_names.size(); ++i) {
    const SymmetryTally& t = sum.tallies[i];
    out << "| " << scalar << " | " << symmetry_names[i] << " | " << t.asked << " | " << t.no_room << " | "
        << t.other_answers << " | " << t.unproven << " | " << t.second_searches << " |\n";
    good = good && t.asked > 0 && t.other_answers == 0 && t.unproven == 0;
  }
  return good;
}

}  // namespace

SymmetryTally& SymmetryTally::operator+=(const SymmetryTally& more) {
  asked += more.asked;
  no_room += more.no_room;
  other_answers += more.other_answers;
  unproven += more.unproven;
  second_searches += more.second_searches;
  return *this;
}

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

template std::optional<PairOfSets<float>> after(Symmetry, const PairOfSets<float>&, Dice&);
template std::optional<PairOfSets<double>> after(Symmetry, const PairOfSets<double>&, Dice&);

bool write_symmetries(std::ostream& out, const SymmetriesOptions& options) {
  std::vector<const Family*> asked;
  for (const Family& family : families())
    if (is_of_points(family, options.seed)) asked.push_back(&family);
  const auto pairs_of = [&](const Family& family) {
    return std::min(options.pairs, family.size.value_or(options.pairs));
  };
  std::uint64_t all = 0, done = 0;
  for (const Family* const family : asked) all += pairs_of(*family);
  Sum doubles, floats;
  for (const Family* const family : asked) {
    const auto ask_in = [&]<class S>(Sum& sum, std::uint64_t index) {
      const Pair pair = family->make(options.seed, index);
      const auto a = in<S>(pair.a), b = in<S>(pair.b);
      if (a && b) ask<S>({*a, *b}, Dice(options.seed, "symmetries of " + family->name, index), sum);
    };
    doubles += over_pairs<Sum>(pairs_of(*family), options.threads,
                               [&](Sum& sum, std::uint64_t index) { ask_in.template operator()<double>(sum, index); });
    floats += over_pairs<Sum>(pairs_of(*family), options.threads,
                              [&](Sum& sum, std::uint64_t index) { ask_in.template operator()<float>(sum, index); });
    options.progress(done += pairs_of(*family), all);
  }
  out << "# Certified answers, whatever is done to a pair\n\n"
      << all << " pairs of " << asked.size() << " families of points, seed " << options.seed
      << ", each asked again after what does not change whether they meet, without rounding\n"
         "anything. Every certificate is multiplied out in fractions. In float the pairs are rounded first, where "
         "floats can hold "
         "them.\n\n"
         "* made by: `gjkstep-study symmetries --pairs "
      << options.pairs << " --seed " << options.seed
      << "`\n\n"
         "| scalar | asked | pairs | no room | other answers | certificates that do not hold | second searches |\n"
         "| --- | --- | ---: | ---: | ---: | ---: | ---: |\n";
  const bool is_good_in_double = write_table(out, "double", doubles);
  return write_table(out, "float", floats) && is_good_in_double;
}

}  // namespace study
