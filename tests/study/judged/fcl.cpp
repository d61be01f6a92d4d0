// Has FCL judged (Debian: apt-get install libfcl-dev). fcl::collide() and fcl::distance() are asked, in doubles.
//
//     c++ -O2 -I/usr/include/eigen3 judge.cpp fcl.cpp -lfcl -lccd -o fcl-judged && gjkstep judge -- ./fcl-judged
//
// FCL_WAY in the environment chooses what is asked; without it this is collide:
//     collide            fcl::collide() with its usual solver. This is no GJK, but libccd's portal refinement (MPR)
//                        (of 20,000 random degenerate pairs it has never ended with 2)
//     collide-indep      fcl::collide() with the GJK that FCL has of its own
//     distance           fcl::distance() with its usual solver, a GJK after libccd; 0 or less: they meet
//     distance-indep     fcl::distance() with the GJK that FCL has of its own; 0 or less: they meet
//
// A pair is given as two fcl::Convex without faces. FCL then looks for the farthest point among all points.
// The faces would only speed up this search, and a hull program would be needed to know them.
#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <array>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

using Points = std::vector<std::array<double, 3>>;

static fcl::CollisionObjectd object_of(const Points& points) {
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  for (const auto& p : points) vertices->emplace_back(p[0], p[1], p[2]);
  return fcl::CollisionObjectd(
      std::make_shared<fcl::Convexd>(vertices, 0, std::make_shared<const std::vector<int>>(), false));
}

bool collide(const Points& a, const Points& b) {
  static const char* const asked = std::getenv("FCL_WAY");
  static const std::string way = asked == nullptr ? "collide" : asked;
  const fcl::GJKSolverType solver = way.find("indep") == std::string::npos ? fcl::GST_LIBCCD : fcl::GST_INDEP;
  const fcl::CollisionObjectd object_a = object_of(a), object_b = object_of(b);
  if (way.find("distance") == std::string::npos) {
    fcl::CollisionRequestd request;
    request.gjk_solver_type = solver;
    fcl::CollisionResultd result;
    return fcl::collide(&object_a, &object_b, request, result) > 0;
  }
  fcl::DistanceRequestd request;
  request.gjk_solver_type = solver;
  fcl::DistanceResultd result;
  return fcl::distance(&object_a, &object_b, request, result) <= 0;
}
