#include "walkthroughs/picture/lens.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "render/length.hpp"
#include "walkthroughs/story/decision.hpp"

namespace walkthroughs::picture {
namespace {

constexpr double azimuth_step = 15;
constexpr double elevations[] = {12, 20, 28, 40, 55};
constexpr double wanted_cosine = 0.7;  // between a normal that decides and the line of sight: neither hidden nor end-on

/// A decision in space: what it was about, and the plane that must be seen for it.
struct Decision {
  std::vector<Point> points;        ///< the vertices and the origin
  Point normal = Point::Zero();     ///< of the triangle, or of the face; zero for a segment or a point
  bool either_side_will_do = true;  ///< a triangle may be seen from below, a face of a tetrahedron must not be hidden
};

Decision decision_of(const gjk::Simplex<double>& simplex, const Point& face_normal) {
  Decision decision{{Point::Zero()}, Point::Zero(), simplex.size() < 4};
  for (int i = 0; i < simplex.size(); ++i) decision.points.push_back(simplex[i].w);
  if (simplex.size() == 3)
    decision.normal = (simplex[1].w - simplex[0].w).cross(simplex[2].w - simplex[0].w);
  else
    decision.normal = face_normal;
  return decision;
}

/// Returns: one decision for each simplex that was processed.
std::vector<Decision> decisions_of(const Trace& trace) {
  std::vector<Decision> found;
  gjk::Simplex<double> simplex;
  Point face_normal = Point::Zero();
  for (const auto& event : trace.events) {
    if (const auto* added = std::get_if<gjk::VertexAdded<double>>(&event)) {
      simplex = added->simplex;
      face_normal.setZero();
    }
    const auto* tested = std::get_if<gjk::RegionTested<double>>(&event);
    if (!tested || tested->verdict == gjk::Verdict::skipped || tested->simplex_size < 2) continue;
    if (tested->normal && tested->face.empty() && !asks_along_edge(*tested)) face_normal = *tested->normal;
    const double* value = std::get_if<double>(&tested->value);
    const bool in_plane_of_face = tested->simplex_size == 4 && value && *value == 0;  // to be seen, though rejected
    if ((tested->verdict == gjk::Verdict::chosen || in_plane_of_face) && tested->face.empty())
      found.push_back(decision_of(simplex, face_normal));
  }
  return found;
}

double extent(const std::vector<Point>& points) {
  double size = 0;
  for (const Point& p : points)
    for (const Point& q : points) size = std::max(size, render::length_of(p - q));
  return size;
}

/// Returns: how far apart the two nearest of the points are in the picture, as a share of their extent in space.
double clearance(const std::vector<Point>& points, const render::Camera& camera) {
  const double size = extent(points);
  double least = 1;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      if (points[i] != points[j]) least = std::min(least, (camera(points[i]) - camera(points[j])).norm() / size);
  return least;
}

/// Returns: 1 where the plane is seen best, 0 where it is seen edge-on, less where it is hidden.
double frontality(const Decision& decision, const render::Camera& camera) {
  if (decision.normal.isZero(0)) return 1;
  double cosine = decision.normal.stableNormalized().dot(camera.toward_viewer());
  if (decision.either_side_will_do) cosine = std::abs(cosine);
  return cosine <= 0 ? cosine : 1 - std::abs(cosine - wanted_cosine) / wanted_cosine;
}

/// Returns: the directions of the moves that the crossing test judges, of length 1.
std::vector<Point> moves_of(const Trace& trace) {
  std::vector<Point> moves;
  for (const auto& event : trace.events)
    if (const auto* found = std::get_if<gjk::SupportFound<double>>(&event))
      if (found->iteration > 1 && found->direction.allFinite()) moves.push_back(found->direction.stableNormalized());
  return moves;
}

/// Returns: how long the shortest of these vectors of length 1 is in the picture.
double shortest(const std::vector<Point>& moves, const render::Camera& camera) {
  double least = 1;
  for (const Point& move : moves) least = std::min(least, camera(move).norm());
  return least;
}

/// Returns: how well a camera shows all decisions; the worst counts as much as the mean.
double score(const std::vector<Decision>& decisions, const render::Camera& camera) {
  double sum = 0, least = std::numeric_limits<double>::infinity();
  for (const Decision& decision : decisions) {
    const double one = 2 * clearance(decision.points, camera) + frontality(decision, camera);
    sum += one;
    least = std::min(least, one);
  }
  return sum / static_cast<double>(decisions.size()) + least;
}

/// Returns: the cameras from among which one is chosen, made once: sines take longer than what is seen by them.
const std::vector<render::Camera>& cameras() {
  static const std::vector<render::Camera> cameras = [] {
    std::vector<render::Camera> all;
    for (double azimuth = 0; azimuth < 360; azimuth += azimuth_step)
      for (const double elevation : elevations) all.emplace_back(azimuth - 52.5, elevation);
    return all;
  }();
  return cameras;
}

}  // namespace

std::vector<std::size_t> Lens::back_to_front(const std::vector<render::Face>& faces) const {
  if (camera) return render::back_to_front(faces, *camera);
  std::vector<std::size_t> all(faces.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

render::Camera choose_camera(const Trace& trace) {
  std::vector<Decision> decisions = decisions_of(trace);
  std::erase_if(decisions,
                [](const Decision& each) { return !std::isfinite(extent(each.points)) || extent(each.points) == 0; });
  if (decisions.empty()) return {-60, 20};
  const std::vector<Point> moves = moves_of(trace);
  const std::vector<render::Camera>& all = cameras();
  std::vector<double> scores;
  for (const render::Camera& camera : all) scores.push_back(score(decisions, camera) + shortest(moves, camera));
  return all[static_cast<std::size_t>(std::ranges::max_element(scores) - scores.begin())];
}

}  // namespace walkthroughs::picture
