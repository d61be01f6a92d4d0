#include "walkthroughs/picture/body.hpp"

#include <algorithm>
#include <numbers>
#include <tuple>

#include "walkthroughs/model/labelled_hull.hpp"
#include "walkthroughs/picture/hull_faces.hpp"

namespace walkthroughs {
namespace {

using render::Vec2;

constexpr int outline_directions = 180;
constexpr int rim_points = 72;
constexpr std::size_t most_differences = 20'000;  // more vertices could not be told apart in a picture

std::vector<Vec2> through(const Lens& lens, const std::vector<Point>& points) {
  std::vector<Vec2> picture;
  for (const Point& p : points) picture.push_back(lens(p));
  return picture;
}

double angle_of(int step, int steps) { return 2 * std::numbers::pi * step / steps; }

/// Returns: the corners of `faces`, each once.
std::vector<Point> corners_of(const std::vector<render::Face>& faces) {
  const auto key = [](const Point& p) { return std::tuple(p.x(), p.y(), p.z()); };
  std::vector<Point> corners;
  for (const render::Face& face : faces) corners.insert(corners.end(), face.corners.begin(), face.corners.end());
  std::ranges::sort(corners, {}, key);
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

Body polytope(std::vector<Point> vertices, Dimension dimension) {
  if (dimension == Dimension::plane) {
    Body flat;
    for (const Vec2& corner : convex_hull(through(Lens{}, vertices)))
      flat.vertices.emplace_back(corner.x(), corner.y(), 0);
    return flat;
  }
  std::vector<render::Face> faces = hull_faces(vertices);
  if (!faces.empty()) vertices = corners_of(faces);
  return {std::move(vertices), std::move(faces)};
}

/// Points whose hull is the outline of a round object.
struct OutlinePoints {
  const Pose& pose;
  const Lens& lens;

  std::vector<Point> operator()(const Points&) const { return {}; }
  std::vector<Point> operator()(const Ball& ball) const {
    std::vector<Point> list;
    for (int i = 0; i < outline_directions; ++i)
      list.push_back(pose(ball.center()) + lens.direction(angle_of(i, outline_directions)) * ball.radius());
    return list;
  }
  std::vector<Point> operator()(const Cylinder& cylinder) const {
    std::vector<Point> list;
    for (const double end : {-1.0, 1.0})
      for (const Point& p : rim_of(cylinder, end)) list.push_back(pose(p));
    return list;
  }
};

}  // namespace

std::vector<Point> rim_of(const Cylinder& cylinder, double end) {
  const Point axis = cylinder.to_cap().normalized(), across = axis.unitOrthogonal(), other = axis.cross(across);
  std::vector<Point> rim;
  for (int i = 0; i < rim_points; ++i) {
    const double angle = angle_of(i, rim_points);
    rim.push_back(cylinder.center() + end * cylinder.to_cap() +
                  cylinder.radius() * (across * std::cos(angle) + other * std::sin(angle)));
  }
  return rim;
}

Body body_of(const Object& object, Dimension dimension) {
  std::vector<Point> vertices = vertices_of(object);
  return vertices.empty() ? Body{} : polytope(std::move(vertices), dimension);
}

Body body_of_difference(const Scene& scene, const Body& a, const Body& b) {
  if (a.vertices.size() * b.vertices.size() > most_differences) return {};
  std::vector<Point> all = differences(a.vertices, b.vertices);
  return all.empty() ? Body{} : polytope(std::move(all), scene.dimension);
}

std::vector<Vec2> outline(const Object& object, const Body& body, const Lens& lens) {
  if (!body.vertices.empty()) return convex_hull(through(lens, body.vertices));
  return convex_hull(through(lens, std::visit(OutlinePoints{object.pose, lens}, object.form)));
}

std::vector<Vec2> outline_of_difference(const Scene& scene, const Body& body, const Lens& lens) {
  if (!body.vertices.empty()) return convex_hull(through(lens, body.vertices));
  const gjk::MinkowskiDifference<double, Object, Object> difference(scene.a, scene.b);
  std::vector<Vec2> farthest;
  for (int i = 0; i < outline_directions; ++i)
    farthest.push_back(lens(difference.vertex(lens.direction(angle_of(i, outline_directions))).w));
  return convex_hull(std::move(farthest));
}

}  // namespace walkthroughs
