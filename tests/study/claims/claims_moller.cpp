#include <algorithm>
#include <cmath>

#include "core/gjk.hpp"
#include "tests/study/claims/claims.hpp"
#include "tests/study/methods/moller_1997.hpp"
#include "tests/study/pairs/over_pairs.hpp"
#include "tests/study/pairs/pairs.hpp"
#include "tests/study/pairs/random_triangles.hpp"
#include "tests/study/truth/exact_number.hpp"
#include "tests/study/truth/oracle.hpp"

namespace study {
namespace {

using moller_1997::Distances;
using moller_1997::Triangle;
using moller_1997::triangle_of;
using Exact = study::Exact;

template <class S>
struct Triangles {
  Triangle<S> a, b;

  explicit Triangles(const Pair& pair)
      : a(triangle_of<S>(std::get<Points>(pair.a))), b(triangle_of<S>(std::get<Points>(pair.b))) {}
};

/// By way of triangles of floats: GCC 12 drops some of the roundings of x.cast<float>().cast<double>().
Pair rounded_to_float(Pair pair) {
  for (Body* const body : {&pair.a, &pair.b}) {
    const auto rounded = triangle_of<float>(std::get<Points>(*body));
    *body = Points{rounded[0].cast<double>(), rounded[1].cast<double>(), rounded[2].cast<double>()};
  }
  return pair;
}

// -- How triangles lie ------------------------------------------------------------------------------------------------

bool have_a_common_vertex(const Triangles<double>& t) {
  return std::ranges::any_of(t.a, [&](const auto& corner) { return std::ranges::find(t.b, corner) != t.b.end(); });
}

/// Where it is false, they do not touch as edges_touch() asks for; it is quicker.
bool nearly_touch(const Triangles<double>& t) {
  const auto finding = moller_1997::find(t.a, t.b, Distances::as_computed);
  if (finding.how != moller_1997::How::intervals) return false;
  const auto &i = finding.first, &j = finding.second;
  const double size = std::max({std::fabs(i.least), std::fabs(i.most), std::fabs(j.least), std::fabs(j.most)});
  return std::min(std::fabs(i.most - j.least), std::fabs(j.most - i.least)) <= 1e-9 * size;
}

/// One common point, inside an edge of each, and not in one plane: no corner lies in the other's plane, so that the ends
/// of the intervals lie inside edges, and an end of one is an end of the other.
bool edges_touch(const moller_1997::Finding<Exact>& finding) {
  if (finding.how != moller_1997::How::intervals) return false;
  for (const auto& distances : {finding.first_distances, finding.second_distances})
    if (std::ranges::count(distances, Exact(0)) > 0) return false;
  return finding.first.most == finding.second.least || finding.second.most == finding.first.least;
}

moller_1997::Finding<Exact> found_exactly(const Pair& pair) {
  const Triangles<Exact> t(pair);
  return moller_1997::find(t.a, t.b, Distances::as_computed);
}

// -- Both tests, in all ways ------------------------------------------------------------------------------------------

template <class Rules, class S>
gjk::Status ask_gjk(const Triangles<S>& t) {
  const auto set = [](const Triangle<S>& corners) { return gjk::PointSet<S>({corners[0], corners[1], corners[2]}); };
  return gjk::collision<S, Rules>(set(t.a), set(t.b)).status;
}

/// By way: snapping is not GJK's.
template <class Rules>
std::array<gjk::Status, way_names.size()> ask_gjk(const Triangles<double>& t, const Triangles<float>& f) {
  const gjk::Status in_double = ask_gjk<Rules>(t), in_float = ask_gjk<Rules>(f);
  return {in_double, in_float, in_double, in_float};
}

/// By way.
std::array<bool, way_names.size()> ask_moller(const Triangles<double>& t, const Triangles<float>& f) {
  return {moller_1997::meet(t.a, t.b, Distances::as_computed), moller_1997::meet(f.a, f.b, Distances::as_computed),
          moller_1997::meet(t.a, t.b, Distances::small_ones_snapped),
          moller_1997::meet(f.a, f.b, Distances::small_ones_snapped)};
}

void ask_about(const Pair& pair, Comparisons& sum) {
  using enum Compared;
  const Triangles<double> t(pair);
  const Triangles<float> f(pair);
  const bool meets = truth(pair) == Truth::intersecting, shares = have_a_common_vertex(t),
             touches_so = nearly_touch(t) && edges_touch(found_exactly(pair));
  const std::array by_gjk{ask_gjk<gjk::AsIntended>(t, f), ask_gjk<gjk::AsPrinted>(t, f)};
  const auto by_moller = ask_moller(t, f);
  for (std::size_t rules = 0; rules < by_gjk.size(); ++rules)
    for (std::size_t way = 0; way < by_moller.size(); ++way) {
      const bool yes = by_gjk[rules][way] == gjk::Status::intersecting, moller = by_moller[way];
      Comparison& counts = sum[rules][way];
      ++counts[Compared::pairs];
      counts[meet] += meets;
      counts[touch_so] += touches_so;
      counts[share_a_vertex] += shares;
      counts[share_seen_by_moller] += shares && moller;
      counts[undecided] += by_gjk[rules][way] == gjk::Status::undecided;
      ++counts[yes ? (moller ? both_yes : only_gjk) : (moller ? only_moller : both_no)];
      if (yes == moller) continue;
      counts[yes ? only_gjk_right : only_moller_right] += meets;
      counts[only_gjk_touch_so] += yes && touches_so;
      counts[only_gjk_share_a_vertex] += yes && shares;
      counts[only_moller_beyond_plane] += moller && found_exactly(pair).how == moller_1997::How::beyond_a_plane;
    }
}

// -- Kinds of triangles -----------------------------------------------------------------------------------------------

/// Coordinates k/divisor for k = 0 … levels - 1, all alike.
TriangleKind coarse(std::string name, int levels, int divisor = 1) {
  return {std::move(name), [=](std::uint64_t seed, std::uint64_t index) {
            Dice dice(seed, "coarse-triangles", index);
            return rounded_to_float(coarse_triangles(dice, levels, divisor));
          }};
}

}  // namespace

const std::vector<TriangleKind>& triangle_kinds() {
  static const std::vector<TriangleKind> all{
      {"random triangles",
       [&family = family_named("triangles")](std::uint64_t seed, std::uint64_t index) {
         return rounded_to_float(family.make(seed, index));
       }},
      coarse("whole numbers 0 … 10", 11),
      coarse("whole numbers 0 … 30", 31),
      coarse("whole numbers 0 … 100", 101),
      coarse("whole numbers 0 … 200", 201),
      coarse("whole numbers 0 … 1,000", 1001),
      coarse("k/100 for k = 0 … 100", 101, 100),
      coarse("k/1,000 for k = 0 … 1,000", 1001, 1000),
      coarse("k/32,767 for k = 0 … 32,767", 32768, 32767),
      {"a common vertex, whole numbers 0 … 100",
       [](std::uint64_t seed, std::uint64_t index) {
         Dice dice(seed, "common-vertex", index);
         return coarse_triangles_with_a_common_corner(dice, 101);
       }},
  };
  return all;
}

Comparisons compare_with_moller(const TriangleKind& kind, const ClaimsOptions& options) {
  return over_pairs<Comparisons>(options.pairs, options.threads, [&](Comparisons& sum, std::uint64_t index) {
    ask_about(kind.make(options.seed, index), sum);
  });
}

}  // namespace study
