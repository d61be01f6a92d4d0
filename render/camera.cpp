#include "render/camera.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

namespace render {
namespace {

/// Returns: the cosine of an angle in degrees, exact at multiples of 90.
double cosine(double degrees) {
  const double turned = std::fmod(std::abs(degrees), 360);
  if (turned == 90 || turned == 270) return 0;
  return std::cos(turned * std::numbers::pi / 180);
}

double sine(double degrees) { return cosine(degrees - 90); }

/// The shadow of a face on the picture, and the plane it lies in.
struct Seen {
  Box around;     // scene units
  Vec3 normal;    // of length 1, toward the viewer; zero for a face seen edge-on, which covers nothing
  double offset;  // the plane is where normal·p = offset
};

constexpr double thickness =
    1e-9;  // of a plane, in sizes of the coordinates: neighbours share corners, but for rounding

Seen seen(const Face& face, const Camera& camera) {
  Seen result{{camera(face.corners.front()), camera(face.corners.front())}, face.outward().stableNormalized(), 0};
  for (const Vec3& corner : face.corners) {
    result.around.min = result.around.min.cwiseMin(camera(corner));
    result.around.max = result.around.max.cwiseMax(camera(corner));
  }
  const double facing = camera.toward_viewer().dot(result.normal);
  result.normal *= std::abs(facing) <= thickness ? 0 : std::copysign(1, facing);
  result.offset = result.normal.dot(face.middle());
  return result;
}

/// Returns: whether no corner of `face` lies on the viewer's side of the plane (`side` 1), or none beyond it (-1).
bool keeps_to_one_side(const Face& face, const Seen& plane, double side) {
  return std::ranges::all_of(face.corners, [&](const Vec3& corner) {
    return side * (plane.normal.dot(corner) - plane.offset) <= thickness * corner.cwiseAbs().maxCoeff();
  });
}

/// Which of the faces must be drawn before which, after Newell, Newell and Sancha (1972).
struct Overlaps {
  const std::vector<Face>& faces;
  std::vector<Seen> look;

  /// Returns: whether i may be drawn before j: it lies behind the plane of j, or j before the plane of i.
  bool may_precede(std::size_t i, std::size_t j) const {
    return keeps_to_one_side(faces[i], look[j], 1) || keeps_to_one_side(faces[j], look[i], -1);
  }
  bool must_precede(std::size_t i, std::size_t j) const {
    const bool apart = !look[i].around.overlaps(look[j].around) || look[i].normal.isZero() || look[j].normal.isZero();
    return !apart && !may_precede(j, i) && may_precede(i, j);
  }
};

}  // namespace

Camera::Camera(double azimuth, double elevation)
    : azimuth_(azimuth),
      elevation_(elevation),
      right_(-sine(azimuth), cosine(azimuth), 0),
      up_(-sine(elevation) * cosine(azimuth), -sine(elevation) * sine(azimuth), cosine(elevation)),
      toward_viewer_(cosine(elevation) * cosine(azimuth), cosine(elevation) * sine(azimuth), sine(elevation)) {}

Vec3 Face::outward() const {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
  return sum;
}

Vec3 Face::middle() const {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& corner : corners) sum += corner;
  return sum / static_cast<double>(corners.size());
}

std::vector<std::size_t> back_to_front(const std::vector<Face>& faces, const Camera& camera) {
  std::vector<std::size_t> waiting(faces.size()), order;
  std::iota(waiting.begin(), waiting.end(), std::size_t{0});
  std::ranges::stable_sort(waiting, std::ranges::greater{},
                           [&](std::size_t i) { return camera.depth(faces[i].middle()); });
  Overlaps overlaps{faces, {}};
  for (const Face& face : faces) overlaps.look.push_back(seen(face, camera));
  std::vector<std::size_t> before(faces.size(), 0);  // how many of those still waiting must be drawn before each
  for (const std::size_t i : waiting)
    for (const std::size_t j : waiting) before[j] += overlaps.must_precede(i, j);

  while (!waiting.empty()) {
    auto next = std::ranges::find_if(waiting, [&](std::size_t i) { return before[i] == 0; });
    if (next == waiting.end()) next = waiting.begin();  // faces in a circle: no order is right
    const std::size_t drawn = *next;
    waiting.erase(next);
    for (const std::size_t j : waiting) before[j] -= overlaps.must_precede(drawn, j);
    order.push_back(drawn);
  }
  return order;
}

std::vector<Edge> edges_of(const std::vector<Face>& faces, const Camera& camera) {
  std::vector<Edge> edges;
  for (const Face& face : faces) {
    const bool hidden = !camera.sees(face.outward());
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      const Vec3 &from = face.corners[i], &to = face.corners[(i + 1) % face.corners.size()];
      const auto known = std::ranges::find_if(edges, [&](const Edge& edge) {
        return (edge.from == to && edge.to == from) || (edge.from == from && edge.to == to);
      });
      if (known == edges.end())
        edges.push_back({from, to, hidden});
      else
        known->hidden = known->hidden && hidden;
    }
  }
  return edges;
}

}  // namespace render
