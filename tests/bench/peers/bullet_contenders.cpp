#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <cmath>
#include <limits>

#include "tests/bench/peers/contender.hpp"

namespace peers {
namespace {

btVector3 vector(const study::Vec& v) { return {v.x(), v.y(), v.z()}; }

struct Placed {
  std::unique_ptr<btConvexShape> shape;
  btTransform place = btTransform::getIdentity();
};

Placed placed(const study::Points& points) {
  auto hull = std::make_unique<btConvexHullShape>();
  for (const study::Vec& point : points) hull->addPoint(vector(point), false);
  hull->recalcLocalAabb();
  hull->setMargin(0);
  return {std::move(hull)};
}

Placed placed(const study::Ball& ball) {
  return {std::make_unique<btSphereShape>(ball.radius), btTransform(btQuaternion::getIdentity(), vector(ball.center))};
}

Placed placed(const study::Can& can) {
  auto cylinder = std::make_unique<btCylinderShapeZ>(btVector3(can.radius, can.radius, can.height / 2));
  cylinder->setMargin(0);
  const btQuaternion turn = shortestArcQuat(btVector3(0, 0, 1), vector(can.axis).normalized());
  return {std::move(cylinder), btTransform(turn, vector(can.center))};
}

Placed placed(const study::Body& body) {
  return std::visit([](const auto& one) { return placed(one); }, body);
}

/// How far the two reach beyond what GJK is shown of them: 0, but for balls, of which GJK sees the center only.
btScalar margins(const Placed& a, const Placed& b) { return a.shape->getMargin() + b.shape->getMargin(); }

/// What Bullet's collision algorithms call: GJK, and EPA where shapes overlap.
class PairDetector {
 public:
  explicit PairDetector(const study::Pair& pair)
      : a_(placed(pair.a)), b_(placed(pair.b)), solvers_(std::make_unique<Solvers>()) {
    // Touching is a contact. A distance is not asked for: GJK may stop as soon as it knows that there is one.
    farthest_contact_ = std::pow(margins(a_, b_), 2) + std::numeric_limits<btScalar>::min();
  }

  Answer operator()() const {
    btGjkPairDetector detector(a_.shape.get(), b_.shape.get(), &solvers_->simplex, &solvers_->penetration);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = a_.place;
    input.m_transformB = b_.place;
    input.m_maximumDistanceSquared = farthest_contact_;
    Contact contact;
    detector.getClosestPoints(input, contact, nullptr);
    return contact.touches ? Answer::intersecting : Answer::separated;
  }

 private:
  struct Solvers {
    btVoronoiSimplexSolver simplex;
    btGjkEpaPenetrationDepthSolver penetration;
  };
  struct Contact : btGjkPairDetector::Result {
    void setShapeIdentifiersA(int, int) override {}
    void setShapeIdentifiersB(int, int) override {}
    void addContactPoint(const btVector3&, const btVector3&, btScalar distance) override { touches = distance <= 0; }
    bool touches = false;
  };

  Placed a_, b_;
  std::unique_ptr<Solvers> solvers_;
  btScalar farthest_contact_;  ///< squared, between the shapes without their margins
};

/// GJK alone, which ends as soon as the origin is enclosed.
class GjkAlone {
 public:
  explicit GjkAlone(const study::Pair& pair) : a_(placed(pair.a)), b_(placed(pair.b)) {}

  Answer operator()() const {
    btGjkEpaSolver2::sResults results;
    const bool apart =
        btGjkEpaSolver2::Distance(a_.shape.get(), a_.place, b_.shape.get(), b_.place, btVector3(1, 0, 0), results);
    if (apart) return results.distance > margins(a_, b_) ? Answer::separated : Answer::intersecting;
    return results.status == btGjkEpaSolver2::sResults::Penetrating ? Answer::intersecting : Answer::undecided;
  }

 private:
  Placed a_, b_;
};

}  // namespace

std::vector<Contender> bullet_contenders() {
  return {{"Bullet GJK+EPA",
           "Bullet " GJKSTEP_BULLET_VERSION " in double, `btGjkPairDetector` with `btVoronoiSimplexSolver` and "
           "`btGjkEpaPenetrationDepthSolver`, no margins, no distance asked for (`m_maximumDistanceSquared` next to 0)",
           batch_of<PairDetector>},
          {"Bullet GJK",
           "Bullet " GJKSTEP_BULLET_VERSION " in double, `btGjkEpaSolver2::Distance`, which is GJK without EPA; its "
           "\"failed\" counts as undecided",
           batch_of<GjkAlone>}};
}

}  // namespace peers
