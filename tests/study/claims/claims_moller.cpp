#include <algorithm>
#include <cmath>
#include <optional>

#include "core/gjk.hpp"
#include "tests/study/claims/claims.hpp"
#include "tests/study/methods/moller_1997.hpp"
#include "tests/study/pairs/dice.hpp"
#include "tests/study/pairs/families.hpp"
#include "tests/study/pairs/over_pairs.hpp"
#include "tests/study/pairs/random_triangles.hpp"
#include "tests/study/truth/oracle.hpp"
#include "walkthroughs/model/exact_number.hpp"

namespace study {
namespace {

using moller_1997::Distances;
using moller_1997::Triangle;

using Exact = walkthroughs::Exact;

template <class S>
struct Triangles {
  Triangle<S> a, b;
};

template <class S>
Triangle<S> triangle_of(const Body& body) {
  const Points& points = std::get<Points>(body);
  Triangle<S> triangle;
  for (std::size_t i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) triangle[i][k] = S(points[i][k]);
  return triangle;
}

template <class S>
Triangles<S> triangles_of(const Pair& pair) {
  return {triangle_of<S>(pair.a), triangle_of<S>(pair.b)};
}

/// By way of triangles of floats: GCC 12 drops some of the roundings of x.cast<float>().cast<double>().
Pair rounded_to_float(Pair pair) {
  for (Body* const body : {&pair.a, &pair.b}) {
    const Triangle<float> rounded = triangle_of<float>(*body);
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
  const auto t = triangles_of<Exact>(pair);
  return moller_1997::find(t.a, t.b, Distances::as_computed);
}

/// Of a pair about which GJK and Möller's test disagree: how the triangles lie, by exact arithmetic.
enum class Contact { common_vertex, edges, beyond_plane, something_else };

Contact contact_of(const Pair& pair) {
  if (have_a_common_vertex(triangles_of<double>(pair))) return Contact::common_vertex;
  const auto finding = found_exactly(pair);
  if (edges_touch(finding)) return Contact::edges;
  return finding.how == moller_1997::How::beyond_a_plane ? Contact::beyond_plane : Contact::something_else;
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

/// `contact` is found once it is needed: exact arithmetic takes its time.
void compare(gjk::Status gjk, bool moller, bool meets, const Pair& pair, std::optional<Contact>& contact,
             Comparison& sum) {
  using enum Compared;
  const bool yes = gjk == gjk::Status::intersecting;
  sum[undecided] += gjk == gjk::Status::undecided;
  if (yes == moller) {
    ++sum[yes ? both_yes : both_no];
    return;
  }
  if (!contact) contact = contact_of(pair);
  ++sum[yes ? only_gjk : only_moller];
  sum[yes ? only_gjk_right : only_moller_right] += meets;
  sum[only_gjk_touch_so] += yes && contact == Contact::edges;
  sum[only_gjk_share_a_vertex] += yes && contact == Contact::common_vertex;
  sum[only_moller_beyond_plane] += moller && contact == Contact::beyond_plane;
}

void ask_about(const Pair& pair, Comparisons& sum) {
  using enum Compared;
  const Triangles<double> t = triangles_of<double>(pair);
  const Triangles<float> f = triangles_of<float>(pair);
  const bool meets = truth(pair) == Truth::intersecting, shares = have_a_common_vertex(t),
             touches_so = nearly_touch(t) && edges_touch(found_exactly(pair));
  const std::array by_gjk{ask_gjk<gjk::AsIntended>(t, f), ask_gjk<gjk::AsPrinted>(t, f)};
  const auto by_moller = ask_moller(t, f);
  std::optional<Contact> contact;
  for (std::size_t rules = 0; rules < by_gjk.size(); ++rules)
    for (std::size_t way = 0; way < by_moller.size(); ++way) {
      Comparison& counts = sum[rules][way];
      ++counts[Compared::pairs];
      counts[meet] += meets;
      counts[touch_so] += touches_so;
      counts[Compared::share_a_vertex] += shares;
      counts[share_seen_by_moller] += shares && by_moller[way];
      compare(by_gjk[rules][way], by_moller[way], meets, pair, contact, counts);
    }
}

// -- Kinds of triangles -----------------------------------------------------------------------------------------------

/// Returns: 1,000 of 1000.
std::string grouped(int number) {
  const std::string digits = std::to_string(number);
  return digits.size() <= 3 ? digits : digits.substr(0, digits.size() - 3) + ',' + digits.substr(digits.size() - 3);
}

/// Coordinates k/divisor for k = 0 … levels - 1, all alike.
TriangleKind coarse(int levels, int divisor = 1) {
  const std::string most = grouped(levels - 1);
  std::string name = divisor == 1 ? "whole numbers 0 … " + most : "k/" + grouped(divisor) + " for k = 0 … " + most;
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
      coarse(11),
      coarse(31),
      coarse(101),
      coarse(201),
      coarse(1001),
      coarse(101, 100),
      coarse(1001, 1000),
      coarse(32768, 32767),
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
