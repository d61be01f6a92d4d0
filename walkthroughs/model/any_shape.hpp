/// The shapes of scenes, queries, traces and the study, each as plain numbers and as one row that says what is true of it.
///
/// A shape is told by its fields. Whoever reads, writes, converts or measures shapes visits those and knows none of the
/// shapes: ShapeRow<Shape>::fields(visit, shapes...) calls visit(kind of field, that field of each of the shapes). A new shape is
/// a struct, its place in AnyShapeOf and a ShapeRow. Where it is a sum of others, its row says so, and nothing else must know it;
/// else what must (how it is drawn, how a trace of it is checked) does not compile before it does.
#pragma once

#include <algorithm>
#include <boost/mp11.hpp>
#include <concepts>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/shapes.hpp"
#include "walkthroughs/rooms.hpp"

namespace walkthroughs::model {

/// Scenes of the plane z = 0 are drawn flat; those of space through a camera.
enum class Dimension { plane, space };

// -- The shapes -------------------------------------------------------------------------------------------------------

/// The convex hull of these points: at least one, in any order; they may coincide or be coplanar.
template <class S>
using PointsOf = std::vector<gjk::Vec3<S>>;

/// A closed ball; in the plane a disc; without radius a point.
template <class S>
struct BallOf {
  gjk::Vec3<S> center;
  S radius;
  friend bool operator==(const BallOf&, const BallOf&) = default;
};

/// A closed cylinder with flat caps; `axis` of any length but zero, `height` from cap to cap, `center` halfway. Without height it is
/// a disc, without radius a segment.
template <class S>
struct CylinderOf {
  gjk::Vec3<S> center, axis;
  S radius, height;
  friend bool operator==(const CylinderOf&, const CylinderOf&) = default;
};

/// A box along the axes, of so much in x, y and z.
template <class S>
struct BoxOf {
  gjk::Vec3<S> center, size;
  friend bool operator==(const BoxOf&, const BoxOf&) = default;
};

/// All points within `radius` of the segment.
template <class S>
struct CapsuleOf {
  gjk::Vec3<S> from, to;
  S radius;
  friend bool operator==(const CapsuleOf&, const CapsuleOf&) = default;
};

template <class S>
struct SumOf;

template <class S>
using AnyShapeOf = std::variant<PointsOf<S>, BallOf<S>, CylinderOf<S>, BoxOf<S>, CapsuleOf<S>, SumOf<S>>;

/// The Minkowski sum of two shapes, all X + Y (Section 2.3, Eq. 3).
template <class S>
struct SumOf {
  std::vector<AnyShapeOf<S>> summands;  ///< two
  friend bool operator==(const SumOf&, const SumOf&) = default;
};

using Points = PointsOf<double>;
using Ball = BallOf<double>;
using Cylinder = CylinderOf<double>;
using Sum = SumOf<double>;
using AnyShape = AnyShapeOf<double>;

/// The kinds of fields, which decide what may stand there and how it is rounded.
namespace field {

struct Place {  ///< Vec3<S>
  std::string_view name;
};
struct Direction {  ///< Vec3<S>, not zero; only the ratios of its components count
  std::string_view name;
};
struct Length {  ///< S, not negative
  std::string_view name;
};
struct Size {                   ///< Vec3<S>, not negative
  std::string_view name, half;  ///< and its name in files that give half of it
};
struct Places {};  ///< PointsOf<S>, all that there is to say about the shape
struct Shapes {};  ///< std::vector<AnyShapeOf<S>>, two; also all that there is

}  // namespace field

// -- What GJK asks ----------------------------------------------------------------------------------------------------

template <class S>
class Asked;

/// The sum as a shape of core/. Copies share it.
template <class S>
class AskedSum {
 public:
  explicit AskedSum(SumOf<S> sum)
      : both_(new Both{{Asked<S>(std::move(sum.summands[0])), Asked<S>(std::move(sum.summands[1]))}}) {}

  /// Eq. 7.
  gjk::SupportPoint<S> support(const gjk::Vec3<S>& d) const { return both_->sum.support(d); }
  const auto& sum() const { return both_->sum; }

 private:
  struct Both {  // not known before Asked is
    gjk::MinkowskiSum<S, Asked<S>, Asked<S>> sum;
  };
  std::shared_ptr<const Both> both_;
};

// -- The rows ---------------------------------------------------------------------------------------------------------

/// Of each shape: `key`, its name in files; `kind` and `kind_in_plane`, its name in sentences, the latter empty where there
/// is none in the plane; `example`, its fields in a scene file; In<T>, the shape in numbers of T; fields(). Of a shape that is a sum
/// by a name of its own as_sum(), of the others middle(), a point inside, and of round ones reach(), within which of it they lie. Where its support function can be computed in S asked(), the
/// shape of core/ that has it.
template <class Shape>
struct ShapeRow;

template <class S>
gjk::Vec3<S> middle(const AnyShapeOf<S>& shape);

template <class S>
struct ShapeRow<PointsOf<S>> {
  static constexpr std::string_view key = "points", kind = "point set", kind_in_plane = kind,
                                    example = "[[0, 0, -1], [0, 0, 1], [1, 0, 0]]";
  template <class T>
  using In = PointsOf<T>;

  static void fields(auto&& visit, auto&... lists) { visit(field::Places{}, lists...); }
  static gjk::Vec3<S> middle(const PointsOf<S>& points) {
    gjk::Vec3<S> sum = gjk::Vec3<S>::Zero();
    for (const gjk::Vec3<S>& point : points) sum += point;
    return sum / static_cast<S>(points.size());
  }
  static auto asked(PointsOf<S> points) { return gjk::PointSet<S>(std::move(points)); }
};

template <class S>
struct ShapeRow<BallOf<S>> {
  static constexpr std::string_view key = "sphere", kind = "sphere", kind_in_plane = "disc",
                                    example = R"({"center": [0, 0, 0], "radius": 1})";
  template <class T>
  using In = BallOf<T>;

  static void fields(auto&& visit, auto&... balls) {
    visit(field::Place{"center"}, balls.center...);
    visit(field::Length{"radius"}, balls.radius...);
  }
  static gjk::Vec3<S> middle(const BallOf<S>& ball) { return ball.center; }
  static S reach(const BallOf<S>& ball) { return ball.radius; }
  static auto asked(const BallOf<S>& ball) requires std::floating_point<S> {
    return gjk::Sphere<S>(ball.center, ball.radius);
  }
};

template <class S>
struct ShapeRow<CylinderOf<S>> {
  static constexpr std::string_view key = "cylinder", kind = "cylinder", kind_in_plane = "",
                                    example = R"({"center": [0, 0, 0], "axis": [0, 0, 1], "radius": 1, "height": 2})";
  template <class T>
  using In = CylinderOf<T>;

  static void fields(auto&& visit, auto&... cylinders) {
    visit(field::Place{"center"}, cylinders.center...);
    visit(field::Direction{"axis"}, cylinders.axis...);
    visit(field::Length{"radius"}, cylinders.radius...);
    visit(field::Length{"height"}, cylinders.height...);
  }
  static gjk::Vec3<S> middle(const CylinderOf<S>& cylinder) { return cylinder.center; }
  static S reach(const CylinderOf<S>& cylinder) { return cylinder.height / 2 + cylinder.radius; }
  static auto asked(const CylinderOf<S>& cylinder) requires std::floating_point<S> {
    return gjk::Cylinder<S>(cylinder.center, cylinder.axis, cylinder.radius, cylinder.height);
  }
};

template <class S>
struct ShapeRow<SumOf<S>> {
  static constexpr std::string_view
      key = "sum",
      kind = "sum", kind_in_plane = kind,
      example = R"([{"points": [[0, 0, -1], [0, 0, 1]]}, {"sphere": {"center": [0, 0, 0], "radius": 1}}])";
  template <class T>
  using In = SumOf<T>;

  static void fields(auto&& visit, auto&... sums) { visit(field::Shapes{}, sums.summands...); }
  static gjk::Vec3<S> middle(const SumOf<S>& sum) {
    return walkthroughs::model::middle<S>(sum.summands[0]) + walkthroughs::model::middle<S>(sum.summands[1]);
  }
  static auto asked(SumOf<S> sum) { return AskedSum<S>(std::move(sum)); }
};

template <class S>
struct ShapeRow<BoxOf<S>> {
  static constexpr std::string_view key = "box", kind = "box", kind_in_plane = "rectangle",
                                    example = R"({"center": [0, 0, 0], "size": [1, 2, 3]})";
  template <class T>
  using In = BoxOf<T>;

  static void fields(auto&& visit, auto&... boxes) {
    visit(field::Place{"center"}, boxes.center...);
    visit(field::Size{"size", "half_extents"}, boxes.size...);
  }
  /// The center and the corners around it: neither is rounded.
  static SumOf<S> as_sum(const BoxOf<S>& box) {
    PointsOf<S> corners{-box.size / S(2)};
    for (int axis = 0; axis < 3; ++axis)
      for (std::size_t i = corners.size(); i-- > 0 && box.size[axis] != S(0);) {
        corners.push_back(corners[i]);
        corners.back()[axis] = box.size[axis] / S(2);
      }
    return {{PointsOf<S>{box.center}, corners}};
  }
  static auto asked(const BoxOf<S>& box) { return AskedSum<S>(as_sum(box)); }
};

template <class S>
struct ShapeRow<CapsuleOf<S>> {
  static constexpr std::string_view key = "capsule", kind = "capsule", kind_in_plane = kind,
                                    example = R"({"from": [0, 0, -1], "to": [0, 0, 1], "radius": 1})";
  template <class T>
  using In = CapsuleOf<T>;

  static void fields(auto&& visit, auto&... capsules) {
    visit(field::Place{"from"}, capsules.from...);
    visit(field::Place{"to"}, capsules.to...);
    visit(field::Length{"radius"}, capsules.radius...);
  }
  static SumOf<S> as_sum(const CapsuleOf<S>& capsule) {
    return {{PointsOf<S>{capsule.from, capsule.to}, BallOf<S>{gjk::Vec3<S>::Zero(), capsule.radius}}};
  }
  static auto asked(const CapsuleOf<S>& capsule) requires std::floating_point<S> {
    return AskedSum<S>(as_sum(capsule));
  }
};

template <class Shape>
using RowOf = ShapeRow<std::remove_cvref_t<Shape>>;

/// Calls use(std::type_identity<Shape>{}) for each kind of shape.
template <class Use>
void for_each_kind(Use&& use) {
  const auto each = [&]<class... Shapes>(std::type_identity<std::variant<Shapes...>>) {
    (use(std::type_identity<Shapes>{}), ...);
  };
  each(std::type_identity<AnyShape>{});
}

// -- What is the same for all -----------------------------------------------------------------------------------------

template <class Shape>
concept NamedSum = requires(const Shape& shape) {
  ShapeRow<Shape>::as_sum(shape);
};

/// Returns: visitor(shape), of a sum with a name of its own visitor(sum).
template <class Visitor, class... Shapes>
auto visit_shape(Visitor&& visitor, const std::variant<Shapes...>& shape) {
  const auto visit = [&]<class Shape>(const Shape& one) {
    if constexpr (NamedSum<Shape>)
      return visitor(ShapeRow<Shape>::as_sum(one));
    else
      return visitor(one);
  };
  return std::visit(visit, shape);
}

/// Returns: a point inside.
template <class S>
gjk::Vec3<S> middle(const AnyShapeOf<S>& shape) {
  return visit_shape([](const auto& one) { return RowOf<decltype(one)>::middle(one); }, shape);
}

/// Calls visit(kind of field, value) for each field of the shape.
template <class Visit, class... Shapes>
void visit_fields(Visit&& visit, const std::variant<Shapes...>& shape) {
  std::visit([&](const auto& one) { RowOf<decltype(one)>::fields(visit, one); }, shape);
}

/// Turns one field after the other.
template <class T, class Numbers>
struct Conversion {
  Numbers& numbers;

  void operator()(field::Place, const auto& from, gjk::Vec3<T>& to) const { to = numbers.point(from); }
  void operator()(field::Direction, const auto& from, gjk::Vec3<T>& to) const { to = numbers.direction(from); }
  void operator()(field::Length, const auto& from, T& to) const { to = numbers.length(from); }
  void operator()(field::Size, const auto& from, gjk::Vec3<T>& to) const {
    const auto size = [this](const auto& x) {
      if constexpr (requires { numbers.size(x); })
        return numbers.size(x);
      else
        return numbers.length(x);
    };
    for (int axis = 0; axis < 3; ++axis) to[axis] = size(from[axis]);
  }
  void operator()(field::Places, const auto& from, PointsOf<T>& to) const {
    to.reserve(from.size());
    for (const auto& point : from) to.push_back(numbers.point(point));
  }
  void operator()(field::Shapes, const auto& from, std::vector<AnyShapeOf<T>>& to) const {
    for (const auto& summand : from) to.push_back(converted<T>(summand, numbers));
  }
};

/// Returns: the shape in numbers of T. `numbers`: has point(), direction() and length(), which turn one each and may throw;
/// size() where sides of boxes are turned otherwise than other lengths.
template <class T, class Numbers, class... Shapes>
std::variant<typename ShapeRow<Shapes>::template In<T>...> converted(const std::variant<Shapes...>& shape,
                                                                     Numbers&& numbers) {
  using Converted = std::variant<typename ShapeRow<Shapes>::template In<T>...>;
  const auto convert = [&](const auto& from) -> Converted {
    typename RowOf<decltype(from)>::template In<T> to{};
    RowOf<decltype(from)>::fields(Conversion<T, std::remove_reference_t<Numbers>>{numbers}, from, to);
    return to;
  };
  return std::visit(convert, shape);
}

/// Numbers of T nearest to those given, without looking at them.
template <class T>
struct Cast {
  T length(const auto& x) const { return static_cast<T>(x); }
  gjk::Vec3<T> point(const auto& p) const { return {length(p.x()), length(p.y()), length(p.z())}; }
  gjk::Vec3<T> direction(const auto& d) const { return point(d); }
};

/// Returns: the name of the shape in files.
std::string_view key_of(const AnyShape& shape);

/// Returns: what the shape is, and a sum's two: "sum of a point set and a disc".
std::string kind_of(const AnyShape& shape, Dimension dimension);

/// Returns: the same with the number of points: "sum of 3 points and a disc".
std::string described(const AnyShape& shape, Dimension dimension);

/// Returns: an example of each shape as files have it, a line each: "sphere": {"center": [0, 0, 0], "radius": 1}.
std::string shapes_in_lines(const std::string& before, const std::string& after);

// -- Asking -----------------------------------------------------------------------------------------------------------

template <class Shape>
concept CanBeAsked = requires(Shape shape) {
  ShapeRow<Shape>::asked(std::move(shape));
};

/// A shape whose support function does not compute in the numbers asked for. what() says of which kind.
struct CannotBeAsked : std::domain_error {
  using std::domain_error::domain_error;
};

template <class Shape>
using IsAskedItself = std::bool_constant<CanBeAsked<Shape> && !NamedSum<Shape>>;
template <class Shape>
using AskedForm = decltype(ShapeRow<Shape>::asked(std::declval<Shape>()));

/// The shapes of core/ that a variant of shapes turns into, those that can be asked.
template <class Variant>
using AskedForms = boost::mp11::mp_transform<AskedForm, boost::mp11::mp_copy_if<Variant, IsAskedItself>>;

/// Returns: the shape, which is used up, as core/ asks it. Errors: CannotBeAsked.
template <class... Shapes>
auto asked(std::variant<Shapes...>&& shape) {
  const auto form = [](auto& one) -> AskedForms<std::variant<Shapes...>> {
    using Shape = std::remove_cvref_t<decltype(one)>;
    if constexpr (CanBeAsked<Shape>)
      return ShapeRow<Shape>::asked(std::move(one));
    else
      throw CannotBeAsked("a " + std::string(ShapeRow<Shape>::kind));
  };
  return std::visit(form, shape);
}

/// A shape of core/ of whatever form.
template <class S>
class Asked {
 public:
  /// Errors: CannotBeAsked.
  explicit Asked(AnyShapeOf<S> shape) : form_(asked(std::move(shape))) {}

  gjk::SupportPoint<S> support(const gjk::Vec3<S>& d) const {
    return std::visit([&](const auto& form) { return form.support(d); }, form_);
  }
  const auto& form() const { return form_; }

 private:
  AskedForms<AnyShapeOf<S>> form_;
};

}  // namespace walkthroughs::model
