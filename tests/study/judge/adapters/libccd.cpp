// libccd's GJK as a program that `gjkstep-study judge` can ask:
//
//     c++ libccd.cpp -lccd -o libccd-judged && gjkstep-study judge -- ./libccd-judged
#include <ccd/ccd.h>

#include "judge_main.hpp"

static double dot(const std::array<double, 3>& p, const ccd_vec3_t* d) {
  return p[0] * d->v[0] + p[1] * d->v[1] + p[2] * d->v[2];
}

/// The point farthest along d.
static void support(const void* object, const ccd_vec3_t* d, ccd_vec3_t* farthest) {
  const judge::Points& points = *static_cast<const judge::Points*>(object);
  const std::array<double, 3>* best = &points[0];
  for (const std::array<double, 3>& p : points)
    if (dot(p, d) > dot(*best, d)) best = &p;
  ccdVec3Set(farthest, (*best)[0], (*best)[1], (*best)[2]);
}

bool collide(const judge::Points& a, const judge::Points& b) {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = support;
  ccd.support2 = support;
  ccd.max_iterations = 100;
  return ccdGJKIntersect(&a, &b, &ccd) != 0;
}
