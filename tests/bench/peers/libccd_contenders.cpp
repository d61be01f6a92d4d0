#include <ccd/ccd.h>

#include "tests/bench/peers/contender.hpp"
#include "tests/bench/peers/shapes.hpp"

namespace peers {
namespace {

using study::Vec;

void assign(ccd_vec3_t* to, const Vec& from) { ccdVec3Set(to, from.x(), from.y(), from.z()); }

/// Some point well inside, which MPR starts from.
Vec center(const study::Body& body) {
  const auto* points = std::get_if<study::Points>(&body);
  if (const auto* ball = std::get_if<study::Ball>(&body)) return ball->center;
  if (!points) return std::get<study::Can>(body).center;
  Vec sum = Vec::Zero();
  for (const Vec& point : *points) sum += point;
  return sum / static_cast<double>(points->size());
}

struct Object {
  explicit Object(const study::Body& body) : shape(any_shape(body)), middle(center(body)) {}
  AnyShape shape;
  Vec middle;
};

void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* found) {
  const AnyShape& shape = static_cast<const Object*>(object)->shape;
  const Vec d(direction->v[0], direction->v[1], direction->v[2]);
  const auto ask = [&](const auto& one) { assign(found, one.support(d).point); };
  const auto* points = std::get_if<PointSet>(&shape);
  points ? ask(*points) : std::visit(ask, shape);
}

void middle(const void* object, ccd_vec3_t* found) { assign(found, static_cast<const Object*>(object)->middle); }

ccd_t settings() {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = support;
  ccd.center1 = ccd.center2 = middle;
  ccd.max_iterations = 100;  // as in its manual; by default there is no limit
  return ccd;
}

template <auto intersect>
class Query {
 public:
  explicit Query(const study::Pair& pair) : a_(pair.a), b_(pair.b), settings_(settings()) {}
  Answer operator()() const { return intersect(&a_, &b_, &settings_) ? Answer::intersecting : Answer::separated; }

 private:
  Object a_, b_;
  ccd_t settings_;
};

}  // namespace

std::vector<Contender> libccd_contenders() {
  const std::string settings =
      ", at most 100 iterations, else as by default; its user writes the support function: ours";
  return {{"libccd GJK", "libccd " GJKSTEP_LIBCCD_VERSION ", `ccdGJKIntersect`" + settings,
           batch_of<Query<ccdGJKIntersect>>},
          {"libccd MPR", "libccd " GJKSTEP_LIBCCD_VERSION ", `ccdMPRIntersect`" + settings,
           batch_of<Query<ccdMPRIntersect>>}};
}

}  // namespace peers
