#include "walkthroughs/picture/hull.hpp"

#include <algorithm>
#include <numbers>
#include <tuple>

namespace walkthroughs {
namespace {

using render::Vec2;

constexpr int outline_directions = 180;
constexpr int rim_points = 72;
constexpr std::size_t most_differences = 20'000;  // more vertices could not be told apart in a picture

bool turns_left(const Vec2& p, const Vec2& q, const Vec2& r) {
  const Vec2 u = q - p, v = r - q;
  return u.x() * v.y() - u.y() * v.x() > 0;
}

/// Appends the chain of left turns through `points` to `hull`, and drops its last point, where the next chain begins.
template <class Points>
void append_chain(const Points& points, std::vector<Vec2>& hull) {
  const std::size_t start = hull.size();
  for (const Vec2& p : points) {
    while (hull.size() >= start + 2 && !turns_left(hull[hull.size() - 2], hull.back(), p)) hull.pop_back();
    hull.push_back(p);
  }
  if (hull.size() > start + 1) hull.pop_back();
}

std::vector<Vec2> through(const Lens& lens, const std::vector<Point>& points) {
  std::vector<Vec2> picture;
  for (const Point& p : points) picture.push_back(lens(p));
  return picture;
}

std::vector<Point> differences(const std::vector<Point>& a, const std::vector<Point>& b) {
  std::vector<Point> list;
  for (const Point& p : a)
    for (const Point& q : b) list.push_back(p - q);
  return list;
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

std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  const auto key = [](const Vec2& p) { return std::tuple(p.x(), p.y()); };
  std::ranges::sort(points, {}, key);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<Vec2> hull;
  append_chain(points, hull);
  std::ranges::reverse(points);
  if (points.size() > 1) append_chain(points, hull);
  return hull;
}

std::string LabelledHull::name(const Point& w) const {
  const auto corner = std::ranges::find(corners, Vec2(w.head<2>()));
  if (corner == corners.end()) return "";
  const auto index = corner - corners.begin();
  const std::string letter(1, static_cast<char>('A' + index % 26));
  return index < 26 ? letter : letter + std::to_string(index / 26);
}

LabelledHull difference_hull(const Scene& scene) {
  std::vector<Vec2> corners = convex_hull(through(Lens{}, differences(vertices_of(scene.a), vertices_of(scene.b))));
  if (corners.empty()) return {};
  const auto first = std::ranges::max_element(corners, {}, [](const Vec2& p) { return std::tuple(p.x(), p.y()); });
  std::rotate(corners.begin(), first, corners.end());
  return {corners};
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
