#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/detail/convexity_based_algorithm/gjk.h>
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>

#include "tests/bench/peers/contender.hpp"

namespace peers {
namespace {

using Convex = fcl::Convex<double>;
using Sphere = fcl::Sphere<double>;
using Cylinder = fcl::Cylinder<double>;
using Place = fcl::Transform3<double>;

/// Without faces FCL scans all points. With them it would climb along edges where there are more than 32, which takes ten
/// times as long for 256 points.
Convex shape(const study::Points& points) {
  return {std::make_shared<const std::vector<study::Vec>>(points), 0, std::make_shared<std::vector<int>>()};
}
Sphere shape(const study::Ball& ball) { return Sphere(ball.radius); }
Cylinder shape(const study::Can& can) { return {can.radius, can.height}; }

Place place(const study::Points&) { return Place::Identity(); }
Place place(const study::Ball& ball) { return Place(Eigen::Translation3d(ball.center)); }
Place place(const study::Can& can) {
  const auto turn = Eigen::Quaterniond::FromTwoVectors(study::Vec::UnitZ(), can.axis);
  return Eigen::Translation3d(can.center) * turn;
}

/// A shape where it lies.
struct Placed {
  using Shape = std::variant<Convex, Sphere, Cylinder>;
  explicit Placed(const study::Body& body)
      : shape(std::visit([](const auto& one) { return Shape(peers::shape(one)); }, body)),
        place(std::visit([](const auto& one) { return peers::place(one); }, body)) {}

  Shape shape;
  Place place;
};

class LibccdSolver {
 public:
  explicit LibccdSolver(const study::Pair& pair) : a_(pair.a), b_(pair.b) {}

  Answer operator()() const {
    const auto intersect = [&](const auto& a, const auto& b) {
      return solver_.shapeIntersect(a, a_.place, b, b_.place, nullptr) ? Answer::intersecting : Answer::separated;
    };
    return std::visit(intersect, a_.shape, b_.shape);
  }

 private:
  Placed a_, b_;
  fcl::detail::GJKSolver_libccd<double> solver_;
};

/// As in GJKSolver_indep::shapeIntersect, whose EPA a plain question does not need.
class IndependentGjk {
 public:
  explicit IndependentGjk(const study::Pair& pair) : a_(pair.a), b_(pair.b) {}

  Answer operator()() const {
    const auto base = [](const auto& shape) { return static_cast<const fcl::ShapeBase<double>*>(&shape); };
    fcl::detail::MinkowskiDiff<double> difference;
    difference.shapes[0] = std::visit(base, a_.shape);
    difference.shapes[1] = std::visit(base, b_.shape);
    difference.toshape1.noalias() = b_.place.linear().transpose() * a_.place.linear();
    difference.toshape0 = a_.place.inverse(Eigen::Isometry) * b_.place;
    fcl::detail::GJK<double> gjk(128, fcl::constants<double>::gjk_default_tolerance());
    switch (gjk.evaluate(difference, study::Vec(-1, 0, 0))) {
      case fcl::detail::GJK<double>::Inside: return Answer::intersecting;
      case fcl::detail::GJK<double>::Valid: return Answer::separated;
      case fcl::detail::GJK<double>::Failed: break;
    }
    return Answer::undecided;
  }

 private:
  Placed a_, b_;
};

}  // namespace

std::vector<Contender> fcl_contenders() {
  const std::string shapes = "; `fcl::Convex` without faces, which is faster than with";
  return {
      {"FCL libccd",
       "FCL " GJKSTEP_FCL_VERSION ", `GJKSolver_libccd::shapeIntersect` (MPR; of two balls a formula)" + shapes,
       batch_of<LibccdSolver>},
      {"FCL GJK",
       "FCL " GJKSTEP_FCL_VERSION ", `detail::GJK::evaluate` as `GJKSolver_indep` calls it, without its EPA" + shapes,
       batch_of<IndependentGjk>}};
}

}  // namespace peers
