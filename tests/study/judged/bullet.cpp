// Has Bullet judged (Debian: apt-get install libbullet-dev). Debian has it twice: in floats, and in doubles.
//
//     c++ -O2 judge.cpp bullet.cpp $(pkg-config --cflags bullet) -lBulletCollision -lLinearMath -o bullet-judged
//     c++ -O2 judge.cpp bullet.cpp $(pkg-config --cflags bullet-float64) -lBulletCollision-float64
//         -lLinearMath-float64 -o bullet-judged              (one line: with BT_USE_DOUBLE_PRECISION, from pkg-config)
//     gjkstep judge -- ./bullet-judged
//
// Asked is btGjkPairDetector with the solvers of btDefaultCollisionConfiguration: btVoronoiSimplexSolver and
// btGjkEpaPenetrationDepthSolver. A btCollisionWorld asks it, too, about two convex shapes.
// The world would add its contact manifold, which keeps points that are 0.02 apart. That is no part of a GJK.
// The margin is 0, since a margin makes the shapes larger. They meet where the distance found is not positive.
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <array>
#include <vector>

using Points = std::vector<std::array<double, 3>>;

static void set(btConvexHullShape& shape, const Points& points) {
  for (const auto& p : points) shape.addPoint(btVector3(btScalar(p[0]), btScalar(p[1]), btScalar(p[2])), false);
  shape.recalcLocalAabb();
  shape.setMargin(0);
}

bool collide(const Points& a, const Points& b) {
  btConvexHullShape shape_a, shape_b;
  set(shape_a, a);
  set(shape_b, b);
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver depth;
  btGjkPairDetector detector(&shape_a, &shape_b, &simplex, &depth);
  btGjkPairDetector::ClosestPointInput input;
  input.m_transformA.setIdentity();
  input.m_transformB.setIdentity();
  btPointCollector closest;
  detector.getClosestPoints(input, closest, nullptr);
  return closest.m_hasResult && closest.m_distance <= 0;
}
