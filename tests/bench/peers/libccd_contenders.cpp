#include <ccd/ccd.h>

#include "tests/bench/peers/contender.hpp"
#include "tests/bench/peers/shapes.hpp"

namespace peers {
namespace {

using study::Vec;

void assign(ccd_vec3_t* to, const Vec& from) { ccdVec3Set(to, from.x(), from.y(), from.z()); }

/// How a support function finds the farthest of many points.
enum class Scan {
  simple,   ///< a loop, as in the examples of libccd's manual
  gjkstep,  ///< gjk::PointSet, which goes through large sets in blocks
};

struct Object {
  explicit Object(const study::Body& body) : shape(any_shape(body)), middle(center(body)) {
    if (const auto* given = std::get_if<study::Points>(&body))
      for (const Vec& point : *given) assign(&points.emplace_back(), point);
  }
  AnyShape shape;
  std::vector<ccd_vec3_t> points;
  Vec middle;
};

const ccd_vec3_t& farthest(const std::vector<ccd_vec3_t>& points, const ccd_vec3_t& direction) {
  const ccd_vec3_t* best = &points.front();
  ccd_real_t most = ccdVec3Dot(best, &direction);
  for (const ccd_vec3_t& point : points) {
    const ccd_real_t reach = ccdVec3Dot(&point, &direction);
    if (reach > most) {
      most = reach;
      best = &point;
    }
  }
  return *best;
}

template <Scan scan>
void support(const void* asked, const ccd_vec3_t* direction, ccd_vec3_t* found) {
  const Object& object = *static_cast<const Object*>(asked);
  if (scan == Scan::simple && !object.points.empty()) return ccdVec3Copy(found, &farthest(object.points, *direction));
  const Vec d(direction->v[0], direction->v[1], direction->v[2]);
  const auto ask = [&](const auto& one) { assign(found, one.support(d).point); };
  const auto* points = std::get_if<PointSet>(&object.shape);
  points ? ask(*points) : std::visit(ask, object.shape);
}

void middle(const void* object, ccd_vec3_t* found) { assign(found, static_cast<const Object*>(object)->middle); }

ccd_t settings(ccd_support_fn support) {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = support;
  ccd.center1 = ccd.center2 = middle;
  ccd.max_iterations = 100;  // as in its manual, for its GJK; by default there is no limit
  return ccd;
}

template <auto intersect, Scan scan>
class Query {
 public:
  explicit Query(const study::Pair& pair) : a_(pair.a), b_(pair.b), settings_(settings(support<scan>)) {}
  Answer operator()() const { return intersect(&a_, &b_, &settings_) ? Answer::intersecting : Answer::separated; }

 private:
  Object a_, b_;
  ccd_t settings_;
};

}  // namespace

std::vector<Contender> libccd_contenders() {
  const std::string limit = ", at most 100 iterations, else as by default",
                    no_limit = ", as by default: it has no limit";
  const std::string simple = "; its user writes the support function: a loop over its vectors";
  const std::string version = "libccd " GJKSTEP_LIBCCD_VERSION ", ";
  return {
      {"libccd GJK", version + "`ccdGJKIntersect`" + limit + simple, batch_of<Query<ccdGJKIntersect, Scan::simple>>},
      {"libccd MPR", version + "`ccdMPRIntersect`" + no_limit + simple, batch_of<Query<ccdMPRIntersect, Scan::simple>>},
      {.name = "libccd MPR, our support",
       .how = "the same with the support function of `core/shapes.hpp`",
       .prepare = batch_of<Query<ccdMPRIntersect, Scan::gjkstep>>,
       .borrows = true}};
}

}  // namespace peers
