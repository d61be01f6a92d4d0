#include "walkthroughs/story/progress.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include "core/certified/check.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs::story {
namespace {

struct NearestIn {
  Simplex of;
  gjk::NearestPoint point;
};

Simplex without(const Simplex& simplex, int left_out) {
  Simplex facet;
  for (int i = 0; i < simplex.size(); ++i)
    if (i != left_out) facet.add(simplex[i]);
  return facet;
}

/// The point nearest on its line, plane or space, where the simplex holds it. Otherwise that of a facet, as also where the vertices
/// depend on each other: the facets are all of such a simplex. Requires: at least one vertex, finite.
NearestIn nearest_in(const Simplex& simplex) {
  std::vector<gjk::detail::Fractions> points;
  for (const Vertex& vertex : simplex) points.push_back(gjk::detail::fractions(vertex.w));
  auto whole = gjk::detail::nearest_point_of(points);
  if (whole && std::ranges::none_of(whole->weights, [](const gjk::Fraction& t) { return t < 0; }))
    return {simplex, std::move(*whole)};
  std::optional<NearestIn> best;
  const auto square = [](const NearestIn& each) { return gjk::detail::dot(each.point.v, each.point.v); };
  for (int i = 0; i < simplex.size(); ++i)
    if (NearestIn facet = nearest_in(without(simplex, i)); !best || square(facet) < square(*best))
      best = std::move(facet);
  return std::move(*best);
}

ExactVector exact_vector(const Point& p) { return {gjk::Fraction(p.x()), gjk::Fraction(p.y()), gjk::Fraction(p.z())}; }

bool can_be_measured(const Simplex& simplex) {
  return std::ranges::all_of(simplex, [](const Vertex& vertex) {
    return vertex.w.allFinite() && vertex.a.point.allFinite() && vertex.b.point.allFinite();
  });
}

/// Brings `progress` to the simplex that the search has now.
void measure(Progress& progress, const Simplex& simplex) {
  const auto [of, point] = nearest_in(simplex);
  progress.nearest = {point.v[0], point.v[1], point.v[2]};
  progress.on_a = progress.on_b = ExactVector::Zero();
  for (int k = 0; k < of.size(); ++k) {
    progress.on_a += exact_vector(of[k].a.point) * point.weights[static_cast<std::size_t>(k)];
    progress.on_b += exact_vector(of[k].b.point) * point.weights[static_cast<std::size_t>(k)];
  }
  Point near;
  for (int i = 0; i < 3; ++i) near[i] = progress.nearest[i].convert_to<double>();
  progress.distance = near.stableNorm();
}

/// What may still change the simplex of its iteration, or shows that nothing will.
bool decides_simplex(const gjk::Event<double>& event) {
  return std::holds_alternative<gjk::CrossingTested<double>>(event) ||
         std::holds_alternative<gjk::VertexAdded<double>>(event) ||
         std::holds_alternative<gjk::RegionTested<double>>(event) ||
         std::holds_alternative<gjk::SimplexReduced<double>>(event) ||
         std::holds_alternative<gjk::FeatureKept<double>>(event);
}

}  // namespace

std::vector<Progress> progress_of(const Telling& telling) {
  std::vector<std::pair<Progress, Simplex>> iterations;
  Moment now;
  for (std::size_t i = 0; i < telling.trace.events.size(); ++i) {
    advance(now, telling.trace.events[i]);
    if (!decides_simplex(telling.trace.events[i]) || now.simplex.size() == 0) continue;
    if (iterations.empty() || iterations.back().first.iteration != now.iteration) iterations.emplace_back();
    iterations.back().first.iteration = now.iteration;
    iterations.back().first.event = i;
    iterations.back().first.is_fallback = now.in_exact_fallback;
    iterations.back().second = now.simplex;
  }
  std::vector<Progress> all;
  for (auto& [progress, simplex] : iterations) {
    if (!can_be_measured(simplex)) continue;
    measure(progress, simplex);
    all.push_back(std::move(progress));
  }
  return all;
}

std::size_t known_at(const std::vector<Progress>& progress, std::size_t event) {
  return static_cast<std::size_t>(
      std::ranges::count_if(progress, [event](const Progress& each) { return each.event <= event; }));
}

std::string progress_told(const std::vector<Progress>& progress, std::size_t known, Dimension dimension) {
  if (known == 0) return "There is no simplex so far.";
  const Progress& now = progress[known - 1];
  const std::string after = "After iteration " + std::to_string(now.iteration);
  const std::string where = now.nearest.isZero() ? " the origin is in the simplex: the distance is 0."
                                                 : " the kept simplex is " + length(now.nearest) + " from the origin.";
  return after + where + " Nearest there: " + vector(now.on_a, dimension) + " of a, " + vector(now.on_b, dimension) +
         " of b.";
}

}  // namespace walkthroughs::story
