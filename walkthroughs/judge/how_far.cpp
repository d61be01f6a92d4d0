#include "walkthroughs/judge/how_far.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include "core/certified/certified.hpp"
#include "core/certified/check.hpp"
#include "core/certified/dyadic.hpp"
#include "walkthroughs/pairs/dice.hpp"
#include "walkthroughs/pairs/graded.hpp"

namespace walkthroughs::judge {
namespace {

constexpr std::size_t few_points = 24;  // points of a set, all of whose edges are looked at

double diagonal_of(const PointPair& pair) {
  Vec least = pair.a[0], most = pair.a[0];
  for (const Points* const set : {&pair.a, &pair.b})
    for (const Vec& p : *set) {
      least = least.cwiseMin(p);
      most = most.cwiseMax(p);
    }
  return (most - least).stableNorm();
}

/// A pair times a power of two, so that no difference overflows.
struct Scaled {
  PointPair pair;
  int power = 0;  ///< it is 2^-power times as large
  double diagonal = 0;

  explicit Scaled(PointPair original) : pair(std::move(original)) {
    const double most = largest_number(pair);
    if (most == 0) return;
    power = std::ilogb(most) + 2;
    for (Points* const set : {&pair.a, &pair.b})
      for (Vec& p : *set)
        for (double& x : p) x = std::scalbn(x, -power);
    diagonal = diagonal_of(pair);
  }
};

/// Returns: the pair of size 1, about 0, so that no product overflows or vanishes.
PointPair of_size_one(const PointPair& pair, double diagonal) {
  PointPair scaled = pair;
  const Vec middle = pair.a[0];
  for (Points* const set : {&scaled.a, &scaled.b})
    for (Vec& p : *set) p = (p - middle) / diagonal;
  return scaled;
}

// -- Apart ------------------------------------------------------------------------------------------------------------

double gap_of(const PointPair& pair) { return nearest_point(pair).stableNorm(); }

// -- In each other ----------------------------------------------------------------------------------------------------

struct Supported {
  double value;  ///< of the support function of the difference
  Vec vertex;    ///< where it is
};

Supported supported(const PointPair& pair, const Vec& d) {
  const auto farthest = [](const Points& points, const Vec& d) -> const Vec& {
    return *std::ranges::max_element(points, {}, [&](const Vec& p) { return p.dot(d); });
  };
  const Vec w = farthest(pair.a, d) - farthest(pair.b, -d);
  return {w.dot(d), w};
}

/// Along which the difference reaches least beyond 0, as far as is known.
struct Shallowest {
  double depth = std::numeric_limits<double>::infinity();
  Vec direction = Vec::Zero();

  void look(const PointPair& pair, const Vec& d) {
    const double length = d.norm();
    if (length == 0) return;
    for (const Vec& unit : {Vec(d / length), Vec(-d / length)})
      if (const double value = supported(pair, unit).value; value < depth) *this = {value, unit};
  }
};

/// From each point of a set to each other one.
std::vector<Vec> edges_of(const PointPair& pair) {
  std::vector<Vec> edges;
  for (const Points* const set : {&pair.a, &pair.b})
    for (std::size_t i = 0; i < set->size(); ++i)
      for (std::size_t j = 0; j < i; ++j) edges.push_back((*set)[i] - (*set)[j]);
  return edges;
}

/// From there downhill: the value falls against the part of the vertex that is across the direction.
void descend(const PointPair& pair, Vec d, bool in_plane, Shallowest& best) {
  double step = 0.5;
  for (int i = 0; i < 60; ++i, step *= 0.9) {
    if (in_plane) d.z() = 0;
    if (d.norm() == 0) return;
    d.normalize();
    const auto [value, vertex] = supported(pair, d);
    if (value < best.depth) best = {value, d};
    const Vec across = vertex - value * d;
    if (across.norm() == 0) return;
    d -= step * across.normalized();
  }
}

bool are_few(const PointPair& pair) { return pair.a.size() <= few_points && pair.b.size() <= few_points; }

Shallowest shallowest(const PointPair& pair, bool in_plane) {
  Shallowest best;
  if (are_few(pair)) {
    const std::vector<Vec> edges = edges_of(pair);
    for (std::size_t i = 0; i < edges.size(); ++i)
      if (in_plane)
        best.look(pair, edges[i].cross(Vec::UnitZ()));
      else
        for (std::size_t j = 0; j < i; ++j) best.look(pair, edges[i].cross(edges[j]));
    if (best.depth == std::numeric_limits<double>::infinity()) best.depth = 0;  // all in a line: of no depth
    return best;
  }
  Dice dice(1, "descents", 0);
  for (int i = 0; i < 12; ++i)
    descend(pair, i < 6 ? Vec(Vec::Unit(i / 2) * (i % 2 ? 1 : -1)) : dice.direction(), in_plane, best);
  return best;
}

// -- Contact, exactly ---------------------------------------------------------------------------------------------------

using Exact = std::array<gjk::detail::Dyadic, 3>;

Exact exact_vector(const Vec& from, const Vec& to) {
  Exact vector;
  for (int i = 0; i < 3; ++i)
    vector[static_cast<std::size_t>(i)] = gjk::detail::Dyadic(to[i]) - gjk::detail::Dyadic(from[i]);
  return vector;
}

Exact cross(const Exact& u, const Exact& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

int side_of(const Exact& v, const Exact& normal) {
  return sign_of(v[0] * normal[0] + v[1] * normal[1] + v[2] * normal[2]);
}

bool is_zero(const Exact& v) {
  return std::ranges::all_of(v, [](const auto& x) { return sign_of(x) == 0; });
}

/// Planes between two sets that touch. Each goes through the points of both that a common point is made of, whichever that is.
struct PlanesBetween {
  std::vector<Exact> in_it;      ///< vectors that lie in every such plane
  std::vector<Exact> on_a_side;  ///< vectors that are on one side of it, all on the same, or lie in it

  bool have_normal(const Exact& normal) const {
    if (std::ranges::any_of(in_it, [&](const Exact& v) { return side_of(v, normal) != 0; })) return false;
    const auto reaches = [&](int side) {
      return std::ranges::any_of(on_a_side, [&](const Exact& v) { return side_of(v, normal) == side; });
    };
    return !(reaches(1) && reaches(-1));
  }
};

/// Requires: that they meet.
PlanesBetween planes_between(const PointPair& pair) {
  const gjk::PointSet<double> a(pair.a), b(pair.b);
  const auto simplex = std::get<gjk::CommonSimplex>(gjk::certified_collision(a, b).certificate);
  const gjk::detail::Fractions weights = gjk::weights_of(simplex, a, b).value();
  std::vector<std::pair<const Vec*, const Vec*>> common;
  for (int i = 0; i < simplex.of.size(); ++i)
    if (weights[static_cast<std::size_t>(i)] > 0)
      common.emplace_back(&a.points()[static_cast<std::size_t>(simplex.of[i].a)],
                          &b.points()[static_cast<std::size_t>(simplex.of[i].b)]);
  const Vec &of_a = *common[0].first, &of_b = *common[0].second;
  PlanesBetween planes;
  for (const auto& [p, q] : common)
    for (const Vec* const each : {p, q}) planes.in_it.push_back(exact_vector(of_a, *each));
  for (const Vec& p : pair.a) planes.on_a_side.push_back(exact_vector(of_a, p));
  for (const Vec& p : pair.b) planes.on_a_side.push_back(exact_vector(p, of_b));
  for (std::vector<Exact>* const list : {&planes.in_it, &planes.on_a_side}) std::erase_if(*list, is_zero);
  return planes;
}

}  // namespace

HowFar how_far(const Case& asked, bool in_plane) {
  const Scaled scaled(asked.pair);
  if (scaled.diagonal == 0) return {};
  if (!asked.meet()) {
    const double gap = gap_of(scaled.pair);
    return {std::scalbn(gap, scaled.power), gap / scaled.diagonal, false};
  }
  if (only_touch(asked.pair, in_plane)) return {};
  const double depth = std::max(0.0, shallowest(of_size_one(scaled.pair, scaled.diagonal), in_plane).depth);
  return {std::scalbn(depth * scaled.diagonal, scaled.power), depth, !are_few(asked.pair)};
}

double relative_to_size(double length, const PointPair& pair) {
  const Scaled scaled(pair);
  if (scaled.diagonal == 0) return 0;
  return std::min(std::scalbn(length, -scaled.power) / scaled.diagonal, std::numeric_limits<double>::max());
}

bool only_touch(const PointPair& pair, bool in_plane) {
  const PlanesBetween planes = planes_between(pair);
  // Two vectors span it: some that lie in it; where these are too few, such a plane can be turned until others do.
  const std::vector<Exact> upright{{0, 0, 1}};
  std::vector<Exact> first = planes.on_a_side, second = in_plane ? upright : first;
  if (!planes.in_it.empty()) first = {planes.in_it[0]};
  for (const Exact& v : planes.in_it)
    if (!in_plane && !is_zero(cross(first[0], v))) second = {v};
  bool are_in_a_line = true;
  for (const Exact& u : first)
    for (const Exact& v : second) {
      const Exact normal = cross(u, v);
      if (is_zero(normal)) continue;
      if (planes.have_normal(normal)) return true;
      are_in_a_line = false;
    }
  return are_in_a_line;
}

bool one_is_inside(const PointPair& pair, bool in_plane) {
  const auto all_are_inside = [in_plane](const Points& inner, const Points& outer) {
    return std::ranges::all_of(inner, [&](const Vec& p) {
      const PointPair one{{p}, outer};
      return truth_of(one) == gjk::Status::intersecting && !only_touch(one, in_plane);
    });
  };
  return all_are_inside(pair.a, pair.b) || all_are_inside(pair.b, pair.a);
}

}  // namespace walkthroughs::judge
