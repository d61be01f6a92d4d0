#include "render/camera.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
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
  std::vector<std::size_t> order(faces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::ranges::greater{},
                           [&](std::size_t i) { return camera.depth(faces[i].middle()); });
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
