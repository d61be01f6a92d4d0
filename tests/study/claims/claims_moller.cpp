#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/gjk.hpp"
#include "tests/study/claims/claims_measured.hpp"
#include "tests/study/claims/claims_verdict.hpp"
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

bool share_a_vertex(const Triangles<double>& t) {
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

Contact contact_of(const Pair& pair) {
  if (share_a_vertex(triangles_of<double>(pair))) return Contact::common_vertex;
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

/// By Way: snapping is not GJK's.
template <class Rules>
std::array<gjk::Status, ways> ask_gjk(const Triangles<double>& t, const Triangles<float>& f) {
  const gjk::Status in_double = ask_gjk<Rules>(t), in_float = ask_gjk<Rules>(f);
  return {in_double, in_float, in_double, in_float};
}

/// By Way.
std::array<bool, ways> ask_moller(const Triangles<double>& t, const Triangles<float>& f) {
  return {moller_1997::meet(t.a, t.b, Distances::as_computed), moller_1997::meet(f.a, f.b, Distances::as_computed),
          moller_1997::meet(t.a, t.b, Distances::small_ones_snapped),
          moller_1997::meet(f.a, f.b, Distances::small_ones_snapped)};
}

/// `contact` is found once it is needed: exact arithmetic takes its time.
void compare(gjk::Status gjk, bool moller, bool meet, const Pair& pair, std::optional<Contact>& contact,
             Comparison& sum) {
  const bool yes = gjk == gjk::Status::intersecting;
  sum.undecided += gjk == gjk::Status::undecided ? 1 : 0;
  if (yes == moller) {
    ++(yes ? sum.both_yes : sum.both_no);
    return;
  }
  if (!contact) contact = contact_of(pair);
  (yes ? sum.only_gjk : sum.only_moller)[static_cast<std::size_t>(*contact)].add(meet);
}

void ask_about(const Pair& pair, MollerCounts& sum) {
  const Triangles<double> t = triangles_of<double>(pair);
  const Triangles<float> f = triangles_of<float>(pair);
  const bool meet = truth(pair) == Truth::intersecting, share = share_a_vertex(t);
  const std::array gjk{ask_gjk<gjk::AsIntended>(t, f), ask_gjk<gjk::AsPrinted>(t, f)};
  const std::array<bool, ways> moller = ask_moller(t, f);
  std::optional<Contact> contact;
  for (std::size_t w = 0; w < ways; ++w) {
    for (std::size_t rules = 0; rules < gjk.size(); ++rules)
      compare(gjk[rules][w], moller[w], meet, pair, contact, sum.compared[rules][w]);
    if (share) sum.common_vertex_seen[w].add(moller[w]);
  }
  ++sum.pairs;
  sum.meet += meet ? 1 : 0;
  sum.edges_touch += nearly_touch(t) && edges_touch(found_exactly(pair)) ? 1 : 0;
}

// -- Kinds of triangles -----------------------------------------------------------------------------------------------

/// Coordinates k/divisor for k = 0 … levels - 1, all alike.
TriangleKind coarse(int levels, int divisor = 1) {
  const std::string most = grouped(static_cast<std::uint64_t>(levels - 1));
  std::string name = divisor == 1 ? "whole numbers 0 … " + most
                                  : "k/" + grouped(static_cast<std::uint64_t>(divisor)) + " for k = 0 … " + most;
  return {std::move(name), [=](std::uint64_t seed, std::uint64_t index) {
            Dice dice(seed, "coarse-triangles", index);
            return rounded_to_float(coarse_triangles(dice, levels, divisor));
          }};
}

Rate sum_of(const std::array<Rate, contacts>& rates) {
  return std::accumulate(rates.begin(), rates.end(), Rate{}, [](Rate sum, const Rate& r) { return sum += r; });
}

}  // namespace

// -- Comparison -------------------------------------------------------------------------------------------------------

Rate Comparison::all_only_gjk() const { return sum_of(only_gjk); }
Rate Comparison::all_only_moller() const { return sum_of(only_moller); }

Rate Comparison::agreement() const {
  const std::uint64_t agree = both_yes + both_no;
  return {agree, agree + all_only_gjk().trials + all_only_moller().trials};
}

Rate Comparison::gjk_right() const {
  Rate rate = all_only_gjk();
  return rate += all_only_moller().opposite();
}

Comparison& Comparison::operator+=(const Comparison& other) {
  both_yes += other.both_yes;
  both_no += other.both_no;
  undecided += other.undecided;
  for (std::size_t i = 0; i < contacts; ++i) {
    only_gjk[i] += other.only_gjk[i];
    only_moller[i] += other.only_moller[i];
  }
  return *this;
}

MollerCounts& MollerCounts::operator+=(const MollerCounts& other) {
  pairs += other.pairs;
  meet += other.meet;
  edges_touch += other.edges_touch;
  for (std::size_t w = 0; w < ways; ++w) {
    for (std::size_t rules = 0; rules < compared.size(); ++rules) compared[rules][w] += other.compared[rules][w];
    common_vertex_seen[w] += other.common_vertex_seen[w];
  }
  return *this;
}

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
  };
  return all;
}

const TriangleKind& common_vertex_kind() {
  static const TriangleKind kind{"a common vertex, whole numbers 0 … 100", [](std::uint64_t seed, std::uint64_t index) {
                                   Dice dice(seed, "common-vertex", index);
                                   return coarse_triangles_with_a_common_corner(dice, 101);
                                 }};
  return kind;
}

MollerCounts measure_moller(const TriangleKind& kind, const ClaimsOptions& options) {
  return over_pairs<MollerCounts>(options.pairs, options.threads, [&](MollerCounts& sum, std::uint64_t index) {
    ask_about(kind.make(options.seed, index), sum);
  });
}

}  // namespace study
