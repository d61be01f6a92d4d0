#include "render/camera.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

#include "tests/kit/catch.hpp"

namespace camera_test {

using namespace render;

namespace {

const std::vector<Camera> cameras = {{0, 0}, {90, 0}, {30, 20}, {-125, 35}, {200, -50}, {47, 89}};

/// Faces of a box along the axes, in the order -x +x -y +y -z +z.
std::vector<Face> box(const Vec3& low, const Vec3& high) {
  const auto corner = [&](int x, int y, int z) {
    return Vec3(x ? high.x() : low.x(), y ? high.y() : low.y(), z ? high.z() : low.z());
  };
  return {{{corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0)}},
          {{corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1)}},
          {{corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1)}},
          {{corner(0, 1, 0), corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0)}},
          {{corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0), corner(1, 0, 0)}},
          {{corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1)}}};
}

/// A triangle seen by Camera(0, 0), for which a point's place in the picture is (y, z) and -x its depth.
Face triangle(const Vec3& a, const Vec3& b, const Vec3& c) { return {{a, b, c}}; }

/// Returns: where face `index` stands in `order`.
std::ptrdiff_t place(const std::vector<std::size_t>& order, std::size_t index) {
  return std::ranges::find(order, index) - order.begin();
}

std::size_t count_hidden(const std::vector<Edge>& edges) {
  return static_cast<std::size_t>(std::ranges::count_if(edges, &Edge::hidden));
}

}  // namespace

// ---------------------------------------------------------------------------------------------- Camera

TEST_CASE("a turned camera is the one with the larger azimuth, and keeps its height") {
  const Camera camera(30, 20);
  REQUIRE(camera.turned(50).toward_viewer().isApprox(Camera(80, 20).toward_viewer()));
  REQUIRE(camera.turned(360).toward_viewer().isApprox(camera.toward_viewer()));
  REQUIRE(camera.turned(123).up().z() == Approx(camera.up().z()));
}

TEST_CASE("a quarter turn is exact") {
  for (const double azimuth : {-450.0, -90.0, 0.0, 90.0, 180.0, 270.0, 360.0, 720.0})
    REQUIRE(Camera(azimuth, 0).toward_viewer().cwiseAbs().sum() == 1);
}

// ---------------------------------------------------------------------------------------------- Face

TEST_CASE("a face without area has no normal") {
  REQUIRE(triangle({0, 0, 0}, {1, 2, 3}, {2, 4, 6}).outward().isZero());
  REQUIRE(Face{{{1, 2, 3}, {4, 5, 6}}}.outward().isZero());
}

// ---------------------------------------------------------------------------------------------- back_to_front

TEST_CASE("the far faces of a box are drawn before the near ones, in whatever order they are given") {
  for (const Camera& camera : cameras) {
    auto faces = box({-1, -2, -3}, {1, 2, 3});
    for (int rotation = 0; rotation < 6; ++rotation) {
      const auto order = back_to_front(faces, camera);
      REQUIRE(order.size() == 6);
      for (std::size_t back = 0; back < 6; ++back)
        for (std::size_t front = 0; front < 6; ++front)
          if (camera.sees(-faces[back].outward()) && camera.sees(faces[front].outward()))
            REQUIRE(place(order, back) < place(order, front));
      std::rotate(faces.begin(), faces.begin() + 1, faces.end());
    }
  }
}

TEST_CASE("a long face that leads away is drawn after the short one behind its near end") {
  // The middle of the long face lies farther away than that of the short one, and it is in front of it all the same.
  const std::vector<Face> faces = {triangle({0, 0, 0}, {-10, 10, 0}, {-5, 5, 5}),
                                   triangle({-1.5, 1, 1}, {-1.5, 1, 0}, {-2.5, 2, 1})};
  const Camera camera(0, 0);
  REQUIRE(camera.depth(faces[0].middle()) > camera.depth(faces[1].middle()));
  REQUIRE(back_to_front(faces, camera) == std::vector<std::size_t>{1, 0});
  REQUIRE(back_to_front({faces[1], faces[0]}, camera) == std::vector<std::size_t>{0, 1});
}

TEST_CASE("of two bodies one before the other, all of the far one is drawn first") {
  const Camera camera(0, 0);
  std::vector<Face> faces = box({5, -1, -1}, {6, 1, 1});
  std::ranges::copy(box({0, -2, -2}, {1, 2, 2}), std::back_inserter(faces));
  const auto order = back_to_front(faces, camera);
  // Those seen from the side cover nothing and may come anywhere.
  REQUIRE(place(order, 6) < place(order, 7));
  REQUIRE(place(order, 7) < place(order, 0));
  REQUIRE(place(order, 0) < place(order, 1));
}

TEST_CASE("faces that overlap in a circle are all drawn, once") {
  // Each of three long bars lies over the next one.
  const std::vector<Face> faces = {triangle({1, -5, 0}, {-1, 5, 0}, {0, 0, 1}),
                                   triangle({1, 3, -4}, {-1, -2, 5}, {0, 1, 1}),
                                   triangle({1, 2, 5}, {-1, -3, -4}, {0, 0, 2})};
  auto order = back_to_front(faces, Camera(0, 0));
  std::ranges::sort(order);
  REQUIRE(order == std::vector<std::size_t>{0, 1, 2});
  REQUIRE(back_to_front({}, Camera(0, 0)).empty());
}

// ---------------------------------------------------------------------------------------------- edges_of

TEST_CASE("a box has twelve edges, of which three are hidden from where three faces are seen") {
  const auto edges = edges_of(box({-1, -2, -3}, {1, 2, 3}), Camera(30, 20));
  REQUIRE(edges.size() == 12);
  REQUIRE(count_hidden(edges) == 3);
  for (const Edge& edge : edges) {
    const bool at_far_corner = edge.from == Vec3(-1, -2, -3) || edge.to == Vec3(-1, -2, -3);
    REQUIRE(edge.hidden == at_far_corner);
  }
}

// ---------------------------------------------------------------------------------------------- many faces

namespace {

/// A ball of so many rings, each of twice as many four-sided faces and, at the poles, triangles.
std::vector<Face> globe(int rings) {
  const auto at = [&](int ring, int step) {
    if (ring == 0 || ring == rings) return Vec3(0, 0, ring == 0 ? 1 : -1);
    const double down = std::numbers::pi * ring / rings, around = std::numbers::pi * (step % (2 * rings)) / rings;
    return Vec3(std::sin(down) * std::cos(around), std::sin(down) * std::sin(around), std::cos(down));
  };
  std::vector<Face> faces;
  for (int ring = 0; ring < rings; ++ring)
    for (int step = 0; step < 2 * rings; ++step) {
      Face face{{at(ring, step), at(ring + 1, step), at(ring + 1, step + 1), at(ring, step + 1)}};
      if (ring == 0) face.corners.pop_back();
      if (ring + 1 == rings) face.corners.erase(face.corners.begin() + 1);
      faces.push_back(face);
    }
  return faces;
}

}  // namespace

TEST_CASE("all faces of a fine ball are drawn once, those turned away before those in front of them") {
  const std::vector<Face> faces = globe(24);
  const Camera camera(30, 20);
  const std::vector<std::size_t> order = back_to_front(faces, camera);
  std::vector<std::size_t> place(faces.size(), faces.size());
  for (std::size_t at = 0; at < order.size(); ++at) place[order[at]] = at;
  REQUIRE(std::ranges::count(place, faces.size()) == 0);
  int behind = 0;
  for (std::size_t back = 0; back < faces.size(); ++back)
    for (std::size_t front = 0; front < faces.size(); ++front)
      if (!camera.sees(faces[back].outward()) && camera.sees(faces[front].outward()) &&
          (camera(faces[back].middle()) - camera(faces[front].middle())).norm() < 0.01) {
        ++behind;
        REQUIRE(place[back] < place[front]);
      }
  REQUIRE(behind > 30);
}

TEST_CASE("a ball of 20,000 faces has each of its edges once") {
  constexpr int rings = 100;
  // Down from each pole and along each ring between the poles.
  REQUIRE(edges_of(globe(rings), Camera(30, 20)).size() == 2 * rings * (rings + rings - 1));
}

}  // namespace camera_test
