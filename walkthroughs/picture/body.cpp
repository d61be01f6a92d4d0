#include "walkthroughs/picture/body.hpp"

#include <algorithm>
#include <iterator>
#include <numbers>
#include <optional>
#include <set>
#include <tuple>

#include "render/length.hpp"
#include "walkthroughs/model/farthest_face.hpp"
#include "walkthroughs/model/labelled_hull.hpp"

namespace walkthroughs::picture {
namespace {

using render::Vec2;

constexpr int outline_directions = 180;
constexpr int rim_points = 72;
constexpr std::size_t most_differences = 20'000;  // more vertices could not be told apart in a picture
constexpr std::size_t most_in_outline = 360;      // corners that are drawn all
constexpr double alike = 1e-6;                    // radians, and parts of an object's size
constexpr double least_corner = 1e-5;  // of more, those that stand out so far, in parts of the outline's size

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

/// Returns: those that are farthest in directions all around, each once; no more than one above `most_corners`.
std::vector<Point> farthest_all_around(const std::vector<Point>& points) {
  const gjk::PointSet<double> set(points);
  std::set<int> farthest;
  for (const Point& direction : directions_all_around(4 * most_corners)) {
    if (farthest.size() > most_corners) break;
    farthest.insert(set.support(direction).index.value());
  }
  std::vector<Point> found;
  for (const int index : farthest) found.push_back(points[static_cast<std::size_t>(index)]);
  return found;
}

/// Returns: the points that stick out of a hull so far that a picture may show it.
std::vector<Point> outside(const std::vector<render::Face>& hull, const std::vector<Point>& points) {
  std::vector<Point> normals;
  double size = 0;
  for (const render::Face& face : hull) {
    normals.push_back(face.outward().stableNormalized());
    size = std::max(size, render::length_of(face.corners[0] - hull[0].corners[0]));
  }
  const auto is_inside = [&](const Point& p) {
    for (std::size_t i = 0; i < hull.size(); ++i)
      if (!(normals[i].dot(p - hull[i].corners[0]) <= alike * size)) return false;  // also what is too large to tell
    return true;
  };
  std::vector<Point> found;
  std::ranges::remove_copy_if(points, std::back_inserter(found), is_inside);
  return found;
}

/// Returns: points whose hull looks the same; nothing where they are surely more than `most_corners`. So no hull is made
/// that is not drawn.
std::optional<std::vector<Point>> without_inner_points(const std::vector<Point>& points) {
  if (points.size() <= most_corners) return points;
  std::vector<Point> corners = farthest_all_around(points);
  if (corners.size() > most_corners) return std::nullopt;
  const std::vector<render::Face> hull = hull_faces(corners);
  if (hull.empty()) return points;
  std::ranges::copy(outside(hull, points), std::back_inserter(corners));
  if (corners.size() > most_corners) return std::nullopt;
  return corners;
}

/// Of points in one plane: the way from the first to the one farthest from it, and the normal, zero where they are on one line.
struct SpanOfFlat {
  Point along, normal;
};

SpanOfFlat span_of_flat(const std::vector<Point>& points) {
  const auto distance_to_first = [&](const Point& p) { return (p - points[0]).norm(); };
  const Point along = *std::ranges::max_element(points, {}, distance_to_first) - points[0];
  const auto area = [&](const Point& p) { return along.cross(p - points[0]).norm(); };
  const Point normal = along.cross(*std::ranges::max_element(points, {}, area) - points[0]);
  const bool is_line = !(normal.norm() > alike * along.squaredNorm());
  return {along, is_line ? Point(Point::Zero()) : normal};
}

std::vector<Vec2> across(const std::vector<Point>& points, const DirectionFrame& frame) {
  std::vector<Vec2> list;
  for (const Point& p : points) list.push_back(frame.across(p));
  return list;
}

/// Returns: both sides of points in one plane; none of what has no area.
std::vector<render::Face> sides_of_flat(const std::vector<Point>& points) {
  const Point normal = span_of_flat(points).normal;
  if (normal.isZero(0)) return {};
  const DirectionFrame frame(normal);
  const std::vector<Vec2> corners = convex_hull(across(points, frame));
  if (corners.size() < 3) return {};
  render::Face front;
  for (const Vec2& corner : corners)
    front.corners.push_back(*std::ranges::find(points, corner, [&](const Point& p) { return frame.across(p); }));
  render::Face back = front;
  std::ranges::reverse(back.corners);
  return {std::move(front), std::move(back)};
}

Body only_outline(std::vector<Point> vertices) { return {std::move(vertices), {}, {}, true}; }

Body polytope(std::vector<Point> vertices, Dimension dimension) {
  if (dimension == Dimension::plane) {
    Body flat;
    for (const Vec2& corner : convex_hull(Lens{}(vertices))) flat.vertices.emplace_back(corner.x(), corner.y(), 0);
    return flat;
  }
  const std::optional<std::vector<Point>> fewer = without_inner_points(vertices);
  if (!fewer) return only_outline(std::move(vertices));
  std::vector<render::Face> faces = hull_faces(*fewer);
  if (faces.empty()) faces = sides_of_flat(*fewer);
  if (!faces.empty()) vertices = corners_of(faces);
  return {std::move(vertices), std::move(faces), {}};
}

// -- Corners ----------------------------------------------------------------------------------------------------------

/// Points whose hull a shape is; none of a round one, and of a sum with too many.
struct CornersOf {
  Dimension dimension;

  std::vector<Point> operator()(const Points& points) const { return points; }
  std::vector<Point> operator()(const Ball& ball) const {
    return ball.radius == 0 ? std::vector{ball.center} : std::vector<Point>{};
  }
  std::vector<Point> operator()(const Cylinder& cylinder) const {
    if (cylinder.radius != 0) return {};
    const Point to_end = RowOf<Cylinder>::asked(cylinder).to_cap();
    return {cylinder.center - to_end, cylinder.center + to_end};
  }
  std::vector<Point> operator()(const Sum& sum) const {
    std::vector<Point> corners[2];
    for (const std::size_t i : {0u, 1u}) {
      corners[i] = visit_shape(*this, sum.summands[i]);
      if (corners[i].empty()) return {};
      corners[i] = polytope(std::move(corners[i]), dimension).vertices;
    }
    std::vector<Point> sums;
    if (corners[0].size() * corners[1].size() > most_differences) return sums;
    for (const Point& p : corners[0])
      for (const Point& q : corners[1]) sums.push_back(p + q);
    return sums;
  }
};

// -- Outlines ---------------------------------------------------------------------------------------------------------

/// Returns: the direction of the axis, also of a disc, whose caps are one.
Point along(const gjk::Cylinder<double>& cylinder) {
  return cylinder.height() == 0 ? cylinder.axis() : cylinder.to_cap();
}

std::vector<Point> rim_of(const gjk::Cylinder<double>& cylinder, double end) {
  const Point axis = along(cylinder).normalized(), across = axis.unitOrthogonal(), other = axis.cross(across);
  std::vector<Point> rim;
  for (int i = 0; i < rim_points; ++i) {
    const double angle = angle_of(i, rim_points);
    rim.push_back(cylinder.center() + end * cylinder.to_cap() +
                  cylinder.radius() * (across * std::cos(angle) + other * std::sin(angle)));
  }
  return rim;
}

/// The outline of a shape where a pose puts it.
struct OutlineOf {
  const Pose& pose;
  const Lens& lens;

  std::vector<Vec2> operator()(const Points& points) const {
    std::vector<Vec2> list;
    for (const Point& p : points) list.push_back(lens(pose(p)));
    return convex_hull(std::move(list));
  }
  std::vector<Vec2> operator()(const Ball& ball) const {
    std::vector<Vec2> list;
    for (int i = 0; i < outline_directions; ++i)
      list.push_back(lens(pose(ball.center) + lens.direction(angle_of(i, outline_directions)) * ball.radius));
    return convex_hull(std::move(list));
  }
  std::vector<Vec2> operator()(const Cylinder& cylinder) const {
    std::vector<Vec2> list;
    for (const double end : {-1.0, 1.0})
      for (const Point& p : rim_of(RowOf<Cylinder>::asked(cylinder), end)) list.push_back(lens(pose(p)));
    return convex_hull(std::move(list));
  }
  /// Seen from far away the picture of a sum is the sum of the pictures.
  std::vector<Vec2> operator()(const Sum& sum) const {
    const Pose turned{pose.rotation, Point::Zero()};
    return sum_of_hulls(visit_shape(*this, sum.summands[0]), visit_shape(OutlineOf{turned, lens}, sum.summands[1]));
  }
};

/// Returns: an outline as it is; where it has very many corners, without those that no picture is large enough for.
std::vector<Vec2> seen(std::vector<Vec2> hull) {
  if (hull.size() <= most_in_outline) return hull;
  return render::simplified(hull, least_corner * render::Box::around(hull).longer_side());
}

// -- What is flat of a round object -----------------------------------------------------------------------------------

constexpr std::size_t most_directions = 200;  // more flat parts could not be told apart in a picture

void add_direction(const Point& direction, std::vector<Point>& list) {
  const Point unit = direction.stableNormalized();
  const auto is_it = [&](const Point& other) { return (other - unit).norm() < alike; };
  if (unit.norm() > 0.5 && list.size() < most_directions && std::ranges::none_of(list, is_it)) list.push_back(unit);
}

/// The directions that flat parts may face and those of straight lines on the surface, both ways.
struct Straight {
  std::vector<Point> normals, lines;

  void add_plane(const Point& normal) {
    for (const Point& each : {normal, Point(-normal)}) add_direction(each, normals);
  }
  void add_line(const Point& line) {
    for (const Point& each : {line, Point(-line)}) add_direction(each, lines);
  }
};

/// Returns: of points in one plane or on one line.
Straight straight_of_flat(const std::vector<Point>& points) {
  Straight found;
  const auto [along, normal] = span_of_flat(points);
  if (normal.isZero(0)) {
    found.add_line(along);
    return found;
  }
  const DirectionFrame frame(normal);
  const std::vector<Vec2> corners = convex_hull(across(points, frame));
  for (std::size_t i = 0; i < corners.size(); ++i)
    found.add_line(frame.at(0, corners[(i + 1) % corners.size()] - corners[i]));
  found.add_plane(normal);
  return found;
}

Straight straight_of_polytope(const std::vector<Point>& points) {
  const std::optional<std::vector<Point>> fewer = without_inner_points(points);
  if (!fewer) return {};
  const std::vector<render::Face> faces = hull_faces(*fewer);
  if (faces.empty()) return straight_of_flat(*fewer);
  Straight found;
  for (const render::Face& face : faces) {
    add_direction(face.outward(), found.normals);
    for (std::size_t i = 0; i < face.corners.size(); ++i)
      found.add_line(face.corners[(i + 1) % face.corners.size()] - face.corners[i]);
  }
  return found;
}

struct StraightOf {
  Straight operator()(const Points& points) const { return straight_of_polytope(points); }
  Straight operator()(const Ball&) const { return {}; }
  Straight operator()(const Cylinder& cylinder) const {
    Straight found;
    found.add_plane(cylinder.axis);
    found.add_line(cylinder.axis);
    return found;
  }
  /// Two lines that are not parallel span a flat part.
  Straight operator()(const Sum& sum) const {
    Straight all = visit_shape(*this, sum.summands[0]);
    const Straight other = visit_shape(*this, sum.summands[1]);
    const std::vector<Point> lines = all.lines;
    for (const Point& normal : other.normals) add_direction(normal, all.normals);
    for (const Point& line : lines)
      for (const Point& other_line : other.lines) {
        const Point normal = line.cross(other_line);
        if (normal.norm() > alike) add_direction(normal, all.normals);
      }
    for (const Point& line : other.lines) add_direction(line, all.lines);
    return all;
  }
};

/// The flat parts of a shape where a pose puts it.
struct FlatsOf {
  const Pose& pose;

  std::vector<Flat> operator()(const Points&) const { return {}; }  // a polytope has faces
  std::vector<Flat> operator()(const Ball&) const { return {}; }
  std::vector<Flat> operator()(const Cylinder& cylinder) const {
    const auto asked = RowOf<Cylinder>::asked(cylinder);
    std::vector<Flat> caps;
    for (const double end : {-1.0, 1.0})
      caps.push_back({moved(rim_of(asked, end)), pose.rotation * along(asked) * end});
    return caps;
  }
  std::vector<Flat> operator()(const Sum& sum) const {
    const double size = bound_of(sum);
    std::vector<Flat> flats;
    for (const Point& normal : StraightOf{}(sum).normals) {
      const DirectionFrame frame(normal);
      const FarthestFace face = farthest_face(sum, frame, {alike * size, alike});
      if (render::signed_area(face.hull) <= alike * size * size) continue;
      std::vector<Point> rim;
      for (const Vec2& corner : face.hull) rim.push_back(frame.at(face.reach, corner));
      flats.push_back({moved(rim), pose.rotation * normal});
    }
    return flats;
  }

 private:
  std::vector<Point> moved(std::vector<Point> points) const {
    for (Point& p : points) p = pose(p);
    return points;
  }
};

}  // namespace

std::vector<Point> directions_all_around(int count) {
  const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
  std::vector<Point> directions;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, level = std::sqrt(1 - z * z), angle = golden_angle * i;
    directions.emplace_back(level * std::cos(angle), level * std::sin(angle), z);
  }
  return directions;
}

Body body_of(const Object& object, Dimension dimension) {
  std::vector<Point> corners = visit_shape(CornersOf{dimension}, object.form);
  for (Point& corner : corners) corner = object.pose(corner);
  if (!corners.empty()) return polytope(std::move(corners), dimension);
  Body round;
  if (dimension == Dimension::space) round.flats = visit_shape(FlatsOf{object.pose}, object.form);
  return round;
}

Body body_of_difference(const Scene& scene, const Body& a, const Body& b) {
  if (a.vertices.size() * b.vertices.size() > most_differences) return {};
  std::vector<Point> all = differences(a.vertices, b.vertices);
  return all.empty() ? Body{} : polytope(std::move(all), scene.dimension);
}

std::vector<Vec2> outline(const Object& object, const Body& body, const Lens& lens) {
  if (!body.vertices.empty()) return seen(convex_hull(lens(body.vertices)));
  return seen(visit_shape(OutlineOf{object.pose, lens}, object.form));
}

namespace {

/// Asks the support function of a difference all around.
class AskedAround {
 public:
  AskedAround(const Scene& scene, const Lens& lens) : a_(scene.a), b_(scene.b), lens_(lens) {}

  Vec2 farthest(double angle) const { return lens_(difference_.vertex(lens_.direction(angle)).w); }

  /// Adds what lies between two angles, from that of `from` to before that of `to`.
  void add_between(double first, const Vec2& from, double last, const Vec2& to, const render::Box& where,
                   double tolerance, std::vector<Vec2>& points) const {
    const double middle = (first + last) / 2;
    const Vec2 between = farthest(middle);
    const double bend = render::distance_to_segment(between, from, to);
    render::Box around = render::Box::around(std::array{from, between, to});
    if (bend <= tolerance || !around.grown(bend).overlaps(where) || middle == first || middle == last) {
      points.push_back(from);
      return;
    }
    add_between(first, from, middle, between, where, tolerance, points);
    add_between(middle, between, last, to, where, tolerance, points);
  }

 private:
  const AskedObject<double> a_, b_;
  const gjk::MinkowskiDifference<double, AskedObject<double>, AskedObject<double>> difference_{a_, b_};
  const Lens& lens_;
};

}  // namespace

std::vector<Vec2> outline_of_difference(const Scene& scene, const Body& body, const Lens& lens) {
  if (!body.vertices.empty()) return seen(convex_hull(lens(body.vertices)));
  const AskedAround difference(scene, lens);
  std::vector<Vec2> farthest;
  for (int i = 0; i < outline_directions; ++i) farthest.push_back(difference.farthest(angle_of(i, outline_directions)));
  return convex_hull(std::move(farthest));
}

std::vector<Vec2> outline_nearby(const Scene& scene, const Lens& lens, const render::Box& where, double tolerance) {
  const AskedAround difference(scene, lens);
  std::vector<Vec2> points;
  for (int i = 0; i < outline_directions; ++i) {
    const double first = angle_of(i, outline_directions), last = angle_of(i + 1, outline_directions);
    difference.add_between(first, difference.farthest(first), last, difference.farthest(last), where, tolerance,
                           points);
  }
  return convex_hull(std::move(points));
}

}  // namespace walkthroughs::picture
