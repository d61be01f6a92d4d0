#include "walkthroughs/model/exact_shape.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include "core/certified/cylinders.hpp"
#include "core/certified/support_error.hpp"

namespace walkthroughs::model {

// How well the points of objects are known, so that gjk::certified_shapes() takes them.

template <class S>
gjk::SupportError support_error(const AskedSum<S>& asked) {
  return gjk::support_error(asked.sum());
}
template <class S>
gjk::Vec3<S> near_support(const AskedSum<S>& asked, const gjk::Vec3<S>& d) {
  return gjk::near_support(asked.sum(), d);
}

template <class S>
gjk::SupportError support_error(const Asked<S>& asked) {
  return std::visit([](const auto& form) { return support_error(form); }, asked.form());
}
template <class S>
gjk::Vec3<S> near_support(const Asked<S>& asked, const gjk::Vec3<S>& d) {
  return std::visit([&](const auto& form) { return near_support(form, d); }, asked.form());
}

namespace {

/// Turns points and axes, not radii and heights.
template <class S>
struct Turn {
  Eigen::Matrix<S, 3, 3> rotation;

  /// The matrix of the pose is no better than the floats that it may have been rounded to; a quaternion is what it is.
  explicit Turn(const Pose& pose) : rotation(pose.rotation.cast<S>()) {
    if (pose.quaternion) rotation = matrix_of<gjk::detail::Wide<S>>(*pose.quaternion).template cast<S>();
  }
  S length(S x) const { return x; }
  gjk::Vec3<S> point(const gjk::Vec3<S>& p) const { return rotation * p; }
  gjk::Vec3<S> direction(const gjk::Vec3<S>& d) const { return rotation * d; }
};

template <class S>
AnyShapeOf<S> turned(const AnyShapeOf<S>& shape, const Turn<S>& turn) {
  const auto turn_one = [&](const auto& one) -> AnyShapeOf<S> {
    if constexpr (requires { one.summands; })
      return SumOf<S>{{turned(one.summands[0], turn), turned(one.summands[1], turn)}};
    else
      return converted<S>(AnyShapeOf<S>(one), turn);
  };
  return visit_shape(turn_one, shape);
}

/// Numbers of S, all lengths times `unit`.
template <class S>
struct Scaled {
  S unit;

  S length(double x) const { return static_cast<S>(x) * unit; }
  gjk::Vec3<S> point(const Point& p) const { return p.cast<S>() * unit; }
  gjk::Vec3<S> direction(const Point& d) const { return d.cast<S>(); }
};

/// An object where its pose puts it.
template <class S>
struct Placed {
  gjk::MinkowskiSum<S, Asked<S>, gjk::PointSet<S>> sum;

  Placed(const Object& object, const Scaled<S>& scaled)
      : sum(Asked<S>(turned(converted<S>(object.form, scaled), Turn<S>(object.pose))),
            gjk::PointSet<S>({scaled.point(object.pose.translation)})) {}

  /// Beside that of the sum:
  ///  - Each number of the matrix of a quaternion is off by 10u, which moves a point x by 30u|x| at most.
  ///  - The product with x, 3√3u|x|.
  friend gjk::SupportError support_error(const Placed& placed) {
    gjk::SupportError known = gjk::support_error(placed.sum);
    known.error += 40 * gjk::detail::roundoff_of<S> * known.size;
    return known;
  }
  friend gjk::Vec3<S> near_support(const Placed& placed, const gjk::Vec3<S>& d) {
    return gjk::near_support(placed.sum, d);
  }
};

template <class S>
gjk::ShapesResult answer_in(const Object& a, const Object& b, S unit = 1) {
  return gjk::certified_shapes<S>(Placed<S>(a, {unit}), Placed<S>(b, {unit}));
}

}  // namespace

gjk::ShapesResult bounded_answer(const Object& a, const Object& b) {
  gjk::ShapesResult result = answer_in<double>(a, b);
  if (result.status != gjk::Status::undecided) return result;
  // Sums of the largest doubles are none. What a smaller unit loses of the least ones is nothing beside these.
  const int exponent = std::isinf(result.gap) ? 32 : 0;
  result = answer_in<long double>(a, b, std::scalbn(1.0L, -exponent));
  result.gap = std::scalbn(result.gap, exponent);
  return result;
}

namespace {

gjk::Motion motion_of(const Pose& pose) {
  if (pose.quaternion) return {*pose.quaternion, pose.translation};
  return {pose.rotation, pose.translation};
}

/// The sets of points and the balls that a shape is the sum of.
struct Summands {
  std::vector<gjk::MovedPoints> sets;
  std::vector<double> radii;
  std::int64_t points = 1;

  /// Returns: whether the shape is such a sum, and was added.
  bool add(const AnyShape& shape) {
    return std::visit([this](const auto& one) { return (*this)(one); }, shape);
  }

  bool operator()(const Points& points) { return add_set(points); }
  bool operator()(const Ball& ball) {
    radii.push_back(ball.radius);
    return add_set({ball.center});
  }
  /// Half of the least doubles is none.
  bool operator()(const BoxOf<double>& box) {
    return 2 * (box.size / 2) == box.size && (*this)(ShapeRow<BoxOf<double>>::as_sum(box));
  }
  bool operator()(const CapsuleOf<double>& capsule) {
    radii.push_back(capsule.radius);
    return add_set({capsule.from, capsule.to});
  }
  bool operator()(const Cylinder&) { return false; }
  bool operator()(const Sum& sum) { return add(sum.summands[0]) && add(sum.summands[1]); }

 private:
  bool add_set(Points set) {
    points *= static_cast<std::int64_t>(set.size());
    if (points > gjk::Grown::most_points) return false;
    sets.push_back({std::move(set)});
    return true;
  }
};

std::optional<gjk::AxialCylinder> axial(const Object& object) {
  const auto* cylinder = std::get_if<Cylinder>(&object.form);
  if (!cylinder) return std::nullopt;
  return gjk::AxialCylinder::of(cylinder->center, cylinder->axis, cylinder->radius, cylinder->height,
                                motion_of(object.pose));
}

}  // namespace

std::optional<gjk::Grown> exact_shape(const AnyShape& shape, const Pose& pose) {
  Summands summands;
  if (!summands.add(shape)) return std::nullopt;
  const gjk::Motion motion = motion_of(pose);
  for (gjk::MovedPoints& set : summands.sets) set.motion.turn = motion.turn;
  summands.sets[0].motion.translation = motion.translation;  // of the sum, once
  return gjk::Grown(std::move(summands.sets), std::move(summands.radii));
}

std::optional<gjk::Status> exact_status_of_cylinders(const Object& a, const Object& b) {
  const auto can = axial(a), other = axial(b);
  if (can && other) return can->axis() == other->axis() ? std::optional(certified_status(*can, *other)) : std::nullopt;
  if (other) return exact_status_of_cylinders(b, a);
  const auto grown = can ? exact_shape(b.form, b.pose) : std::nullopt;
  return grown ? certified_status(*can, *grown) : std::nullopt;
}

ExactAnswer exact_answer(const Object& a, const Object& b) {
  const auto grown_a = exact_shape(a.form, a.pose), grown_b = exact_shape(b.form, b.pose);
  if (grown_a && grown_b) {
    const gjk::GrownResult result = gjk::certified_collision(*grown_a, *grown_b);
    return {result.status, result.nearest};
  }
  if (const auto status = exact_status_of_cylinders(a, b)) return {*status};
  const gjk::ShapesResult result = bounded_answer(a, b);
  return {result.status, {}, result.gap};
}

namespace {

bool is_flat(const Object& object) {
  const auto* corners = std::get_if<Points>(&object.form);
  return corners && is_at_rest(object.pose) && std::ranges::all_of(*corners, [](const Point& p) { return p.z() == 0; });
}

/// Returns: the prism over corners in the plane, up and down.
Object prism_over(const Object& flat, double height) {
  Object prism = flat;
  Points& corners = std::get<Points>(prism.form);
  for (Point corner : std::get<Points>(flat.form)) {
    corner.z() = height;
    corners.push_back(corner);
  }
  for (std::size_t i = 0; i < corners.size() / 2; ++i) corners[i].z() = -height;
  return prism;
}

double size_of(const Object& flat) {
  double size = 0;
  for (const Point& corner : std::get<Points>(flat.form)) size = std::max(size, corner.lpNorm<Eigen::Infinity>());
  return size;
}

}  // namespace

bool is_near_contact(const Object& a, const Object& b, Scalar scalar) {
  const auto is_open = [scalar](const Object& one, const Object& other) {
    return with_scalar(scalar, [&]<class S>() { return answer_in<S>(one, other).status == gjk::Status::undecided; });
  };
  // Nothing lies inside of a flat difference, and so a proof in doubles never finds the origin there. Prisms meet where the corners do.
  if (!is_flat(a) || !is_flat(b)) return is_open(a, b);
  const double height = std::max(size_of(a), size_of(b));
  return is_open(prism_over(a, height), prism_over(b, height));
}

}  // namespace walkthroughs::model
