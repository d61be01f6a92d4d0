#include "render/camera.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

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
  for (const Vec3& corner : face.corners) result.around.add(camera(corner));
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

/// Returns: 0, 1, … `count` - 1 in the order of what `key` makes of them, equals as they are.
template <class Compare, class Key>
std::vector<std::size_t> sorted(std::size_t count, Compare compare, Key key) {
  std::vector<std::size_t> indices(count);
  std::iota(indices.begin(), indices.end(), std::size_t{0});
  std::ranges::stable_sort(indices, compare, key);
  return indices;
}

using Followers = std::vector<std::vector<std::size_t>>;  // for each face those that must be drawn after it

/// From left to right, so that only faces that share a column of the picture are compared.
Followers followers_of(const std::vector<Face>& faces, const Camera& camera) {
  Overlaps overlaps{faces, {}};
  for (const Face& face : faces) overlaps.look.push_back(seen(face, camera));
  const auto left = [&](std::size_t i) { return overlaps.look[i].around.min.x(); };
  const auto right = [&](std::size_t i) { return overlaps.look[i].around.max.x(); };
  const std::vector<std::size_t> from_left = sorted(faces.size(), std::ranges::less{}, left);
  Followers followers(faces.size());
  for (auto i = from_left.begin(); i != from_left.end(); ++i)
    for (auto j = i + 1; j != from_left.end() && left(*j) < right(*i); ++j) {
      if (overlaps.must_precede(*i, *j)) followers[*i].push_back(*j);
      if (overlaps.must_precede(*j, *i)) followers[*j].push_back(*i);
    }
  return followers;
}

}  // namespace

Camera Camera::turned(double degrees, double rise) const {
  constexpr double highest = 89;
  return {azimuth_ + degrees, rise == 0 ? elevation_ : std::clamp(elevation_ + rise, -highest, highest)};
}

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
  const std::vector<std::size_t> farthest_first =
      sorted(faces.size(), std::ranges::greater{}, [&](std::size_t i) { return camera.depth(faces[i].middle()); });
  const Followers followers = followers_of(faces, camera);
  std::vector<std::size_t> before(faces.size(), 0);  // how many of those still waiting must be drawn before each
  for (const std::vector<std::size_t>& each : followers)
    for (const std::size_t j : each) ++before[j];

  std::vector<std::size_t> place(faces.size()), order;
  std::set<std::size_t> waiting, ready;  // places in `farthest_first`
  for (std::size_t at = 0; at < faces.size(); ++at) {
    place[farthest_first[at]] = at;
    waiting.insert(at);
    if (before[farthest_first[at]] == 0) ready.insert(at);
  }
  while (!waiting.empty()) {
    const std::size_t next = ready.empty() ? *waiting.begin() : *ready.begin();  // in a circle no order is right
    waiting.erase(next);
    ready.erase(next);
    order.push_back(farthest_first[next]);
    for (const std::size_t j : followers[order.back()])
      if (--before[j] == 0 && waiting.contains(place[j])) ready.insert(place[j]);
  }
  return order;
}

std::vector<Edge> edges_of(const std::vector<Face>& faces, const Camera& camera) {
  std::vector<Edge> edges;
  const auto key = [](const Vec3& p) { return std::tuple(p.x(), p.y(), p.z()); };
  using Corner = std::tuple<double, double, double>;
  std::map<std::pair<Corner, Corner>, std::size_t> places;  // in `edges`, of the edge between two corners
  for (const Face& face : faces) {
    const bool hidden = !camera.sees(face.outward());
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      const Vec3 &from = face.corners[i], &to = face.corners[(i + 1) % face.corners.size()];
      const auto [known, is_new] = places.emplace(std::minmax({key(from), key(to)}), edges.size());
      if (is_new)
        edges.push_back({from, to, hidden});
      else
        edges[known->second].hidden = edges[known->second].hidden && hidden;
    }
  }
  return edges;
}

}  // namespace render
