/// Two real objects and how to ask GJK about them; and what came of it.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/events.hpp"
#include "core/rule_sets.hpp"
#include "core/shapes.hpp"
#include "walkthroughs/model/any_shape.hpp"
#include "walkthroughs/wrong_on_purpose/mistakes.hpp"

namespace walkthroughs::model {

using Point = gjk::Vec3<double>;
using Pose = gjk::Pose<double>;

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

/// An object as a shape of core/ in numbers of S. Counts its calls on the object itself, which must outlive it.
template <class S>
class AskedObject {
 public:
  explicit AskedObject(const Object& object);

  /// The farthest point of a moved form is the moved farthest point along d turned back. A form at rest is asked about d
  /// itself, as in a plain call of the algorithm: products with a d that was turned back do not overflow or vanish.
  gjk::SupportPoint<S> support(const gjk::Vec3<S>& d) const;

 private:
  const Object& object_;
  Asked<S> form_;
  gjk::Pose<S> pose_;
  bool is_at_rest_;
};

/// Returns: the convex hull of `vertices`, given in any order.
inline Points points(std::vector<Point> vertices) { return vertices; }

/// Returns: the vertices of a point set where the pose puts them; none for other shapes.
std::vector<Point> vertices_of(const Object& object);

/// Returns: the middle of its form where the pose puts it: a point inside.
Point center_of(const Object& object);

using gjk::RuleSet;
using ZeroTest = gjk::ZeroTestKind;

using wrong_on_purpose::Mistake;

/// In which numbers the search computes: double or float. The words are those of IEEE 754.
enum class Scalar { binary64, binary32 };

/// What a scalar cannot tell apart.
struct Precision {
  double epsilon;       ///< from 1 to the next number
  double least_normal;  ///< below it numbers lose digits
  double least;         ///< the smallest number above 0
  double largest;       ///< beyond it there is only infinity
};

constexpr Precision precision_of(Scalar scalar) {
  const auto of = []<class Limits>(Limits) {
    return Precision{Limits::epsilon(), Limits::min(), Limits::denorm_min(), Limits::max()};
  };
  return scalar == Scalar::binary32 ? of(std::numeric_limits<float>{}) : of(std::numeric_limits<double>{});
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
};

/// Returns: the scene with every number rounded to the nearest float, to be searched in float. So the objects that are
/// drawn are those that are searched, and what goes wrong is the search's doing.
/// Errors: std::range_error, with the number, where one is beyond all floats or a length or direction vanishes.
Scene in_float(Scene scene);

/// Returns: the scene, to be searched with that mistake. Its crossing test, zero test and scalar become the usual ones: of runs with
/// others no mistake is known.
Scene mistaken(Scene scene, Mistake mistake);

/// Returns: the scene with the first direction from the center of a to that of b; with the usual one where there is none.
Scene from_center_to_center(Scene scene);

/// Why no answer about an object can be proven, and which key of it says so.
struct ObjectionToProof {
  std::string key, why;
};
/// Returns: nothing where it can be: of points that no pose moves.
std::optional<ObjectionToProof> objection_to_proof(const AnyShape& form, const Pose& pose);

using Trace = gjk::Trace<double>;

}  // namespace walkthroughs::model
