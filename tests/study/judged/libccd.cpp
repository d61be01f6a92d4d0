// Has libccd judged (Debian: apt-get install libccd-dev). ccdGJKIntersect() is asked: it needs a support function only.
//
//     c++ -O2 judge.cpp libccd.cpp -lccd -o libccd-judged && gjkstep judge -- ./libccd-judged
#include <ccd/ccd.h>

#include <array>
#include <vector>

#ifndef CCD_DOUBLE
#error "this libccd computes in floats: its answers about doubles would be wrong"
#endif

using Points = std::vector<std::array<double, 3>>;

static double dot(const std::array<double, 3>& p, const ccd_vec3_t* d) {
  return p[0] * d->v[0] + p[1] * d->v[1] + p[2] * d->v[2];
}

/// The point farthest along d.
static void support(const void* object, const ccd_vec3_t* d, ccd_vec3_t* farthest) {
  const Points& points = *static_cast<const Points*>(object);
  const std::array<double, 3>* best = &points[0];
  for (const std::array<double, 3>& p : points)
    if (dot(p, d) > dot(*best, d)) best = &p;
  ccdVec3Set(farthest, (*best)[0], (*best)[1], (*best)[2]);
}

bool collide(const Points& a, const Points& b) {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = support;
  ccd.support2 = support;
  ccd.max_iterations = 100;  // else there is no limit; at its limit it answers no
  return ccdGJKIntersect(&a, &b, &ccd) != 0;
}
