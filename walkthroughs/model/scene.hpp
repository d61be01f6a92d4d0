/// Two real objects and how to ask GJK about them; and what came of it.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/gjk.hpp"
#include "core/rule_sets.hpp"
#include "walkthroughs/model/any_shape.hpp"
#include "walkthroughs/wrong_on_purpose/mistakes.hpp"

namespace walkthroughs::model {

using Point = gjk::Vec3<double>;

/// First turned about the origin, then moved.
struct Pose {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Point translation = Point::Zero();
  /// What an exact answer must know of the rotation: as a quaternion it was read, and its matrix is rounded.
  std::optional<gjk::Quaternion> quaternion = {};
  /// As a matrix it was read. It is taken as it stands, and need not be a rotation but to rotation_tolerance.
  bool matrix_as_written = false;

  Point operator()(const Point& p) const { return gjk::Pose<double>{rotation, translation}(p); }
  friend bool operator==(const Pose&, const Pose&) = default;
};

/// Of each number of the product of a written matrix and its transpose.
inline constexpr double rotation_tolerance = 1e-5;

/// Returns: by how much these products differ from the identity at most. What is mirrored differs by more than all else.
double distance_from_rotation(const Eigen::Matrix3d& matrix);

/// Returns: the matrix of the rotation, in doubles or long doubles. Requires: a finite quaternion, not zero.
template <class S = double>
Eigen::Matrix<S, 3, 3> matrix_of(const gjk::Quaternion& quaternion);
extern template Eigen::Matrix<double, 3, 3> matrix_of(const gjk::Quaternion& quaternion);
extern template Eigen::Matrix<long double, 3, 3> matrix_of(const gjk::Quaternion& quaternion);

/// Returns: whether the pose leaves everything where it is. The sign of zero counts: it decides that of the points found.
bool is_at_rest(const Pose& pose);
/// Returns: whether it moves anything: the sign of zero does not count.
bool moves(const Pose& pose);

/// A convex object of a scene.
struct Object {
  std::string name;  ///< as a caption calls it: "triangle"
  AnyShape form;
  Pose pose = {};

  mutable std::size_t support_calls = 0;  ///< so that a test can see who asks
};

/// Returns: whether they are the same in the same place, whatever they are called.
bool is_same(const Object& one, const Object& other);

template <class S>
gjk::Pose<S> pose_in(const Pose& pose) {
  return {pose.rotation.cast<S>(), pose.translation.cast<S>()};
}

/// Returns: where the pose puts a point.
template <class S>
gjk::Vec3<S> put(const Pose& pose, const gjk::Vec3<S>& p) {
  return is_at_rest(pose) ? p : pose_in<S>(pose)(p);
}

/// A shape of core/: a form and, where one moves it, its pose. A form at rest is asked about d itself, as in a plain call of
/// the algorithm: products with a d that was turned back do not overflow or vanish, and the answer is that of the form itself
/// to the last bit.
template <class S>
class PosedForm {
 public:
  PosedForm(Asked<S> form, const Pose& pose)
      : form_(is_at_rest(pose) ? Form(std::move(form))
                               : Form(gjk::Posed<S, Asked<S>>(std::move(form), pose_in<S>(pose)))) {}

  /// Not inlined into each of the searches that collision() is here: it takes longer to compile, for nothing.
  [[gnu::noinline]] gjk::SupportPoint<S> support(const gjk::Vec3<S>& d) const {
    return std::visit([&](const auto& form) { return form.support(d); }, form_);
  }

 private:
  using Form = std::variant<Asked<S>, gjk::Posed<S, Asked<S>>>;
  Form form_;
};

/// An object as a shape of core/ in numbers of S. Counts its calls on the object itself, which must outlive it.
template <class S>
class AskedObject {
 public:
  explicit AskedObject(const Object& object)
      : object_(object), form_(Asked<S>(converted<S>(object.form, Cast<S>{})), object.pose) {}

  gjk::SupportPoint<S> support(const gjk::Vec3<S>& d) const {
    ++object_.support_calls;
    return form_.support(d);
  }

 private:
  const Object& object_;
  PosedForm<S> form_;
};

/// Returns: the convex hull of `vertices`, given in any order.
inline Points points(std::vector<Point> vertices) { return vertices; }

/// Returns: the vertices of a point set where the pose puts them; none for other shapes.
std::vector<Point> vertices_of(const Object& object);

/// Returns: the middle of its form where the pose puts it: a point inside.
Point center_of(const Object& object);

/// Returns: the direction from one center to the other, found in doubles as files have them; the usual one where these
/// coincide or S has no such direction.
template <class S>
gjk::Vec3<S> direction_between_centers(const Point& center_a, const Point& center_b) {
  const gjk::Vec3<S> direction = gjk::first_direction_between(center_a, center_b).cast<S>();
  return gjk::is_usable_direction(direction) ? direction : gjk::Options<S>{}.first_direction;
}

using gjk::RuleSet;
using ZeroTest = gjk::ZeroTestKind;

using wrong_on_purpose::Mistake;

/// In which numbers the search computes: double or float. The words are those of IEEE 754.
enum class Scalar { binary64, binary32 };

/// Calls use.template operator()<S>(), such as [&]<class S>() { ... }, with the type of that scalar. Returns: what it returns.
template <class Use>
constexpr auto with_scalar(Scalar scalar, Use&& use) {
  return scalar == Scalar::binary32 ? use.template operator()<float>() : use.template operator()<double>();
}

/// What a scalar cannot tell apart.
struct Precision {
  double epsilon;       ///< from 1 to the next number
  double least_normal;  ///< below it numbers lose digits
  double least;         ///< the smallest number above 0
  double largest;       ///< beyond it there is only infinity
};

constexpr Precision precision_of(Scalar scalar) {
  return with_scalar(scalar, []<class S>() {
    using Limits = std::numeric_limits<S>;
    return Precision{Limits::epsilon(), Limits::min(), Limits::denorm_min(), Limits::max()};
  });
}

/// Everything that decides a run. Lengths are in the scene's own unit.
struct Scene {
  std::string name;  ///< tells the scenes of one walkthrough apart: "left"
  Object a, b;
  gjk::Options<double> options = {};
  Dimension dimension = Dimension::plane;
  RuleSet rules = RuleSet::as_intended;
  ZeroTest zero_test = ZeroTest::exact;
  Scalar scalar = Scalar::binary64;  ///< binary32: every number of the scene is a float, see in_float()
  bool certified = false;  ///< proven, and where that fails decided by the exact fallback; by certified_collision()
  std::optional<Mistake> mistake = {};  ///< that the search makes on purpose; only with what mistaken() leaves as usual
  /// The objects before their numbers were rounded to float, where that has changed them.
  std::optional<Object> a_as_read = {}, b_as_read = {};
  bool leaves_truth_out = false;  ///< whether nothing is told but what the search answers
};

/// Rounds every number of the object to the nearest float. Errors: std::range_error as in_float().
void round_to_float(Object& object);

/// Returns: the scene with every number rounded to the nearest float, to be searched in float. So the objects that are
/// drawn are those that are searched, and what goes wrong is the search's doing. The scene keeps the objects as read.
/// Errors: std::range_error, with the number, where one is beyond all floats or a length or direction vanishes.
Scene in_float(Scene scene);

/// Returns: the scene, to be searched with that mistake. Its crossing test, zero test and scalar become the usual ones: of runs with
/// others no mistake is known.
Scene mistaken(Scene scene, Mistake mistake);

/// Returns: whether a mistake can be made in it: the report's rules as intended, and all else as usual.
bool may_be_mistaken(const Scene& scene);

/// Returns: the scene with the first direction from the center of a to that of b; with the usual one where there is none.
Scene from_center_to_center(Scene scene);

// -- Asking ------------------------------------------------------------------------------------------------------------

using Trace = gjk::Trace<double>;

/// Returns: whether this program has the search. Only what pages load first lacks some, for which it would be twice as large: in
/// floats, with a zero test, with a mistake, and the proofs of what is certified.
bool has_search(const Scene& scene);

/// Requires: has_search(scene). Returns: every event of GJK on the two objects, computed in the scene's scalar; a double holds every float. Of a scene that
/// is certified those of the proofs, too.
Trace run(const Scene& scene);

/// Who answers for the objects of a scene: a farthest point along `d`.
struct SupportFunctions {
  std::function<gjk::SupportPoint<double>(const Point&)> a, b;
};

/// Returns: the same, the objects being asked through `supports`. Requires: a scene that is not certified.
Trace run(const Scene& scene, const SupportFunctions& supports);

}  // namespace walkthroughs::model
