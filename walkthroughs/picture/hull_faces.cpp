#include <algorithm>
#include <cstdio>
#include <memory>

#include "walkthroughs/picture/body.hpp"

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace walkthroughs::picture {
namespace {

/// The one place that knows Qhull, which was chosen because it copes with coplanar points: one run, freed with everything it has
/// allocated.
struct Qhull {
  explicit Qhull(std::FILE* messages) { qh_zero(&state, messages); }
  ~Qhull() {
    qh_freeqhull(&state, !qh_ALL);
    int short_memory = 0, long_memory = 0;
    qh_memfreeshort(&state, &short_memory, &long_memory);
  }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;

  /// Counter-clockwise seen from outside, where Qhull's normal points to.
  render::Face face(facetT* facet) {
    render::Face face;
    setT* corners = qh_facet3vertex(&state, facet);
    for (int i = 0; i < qh_setsize(&state, corners); ++i) {
      const coordT* p = static_cast<vertexT*>(SETelem_(corners, i))->point;
      face.corners.emplace_back(p[0], p[1], p[2]);
    }
    qh_settempfree(&state, &corners);
    const Point outward(facet->normal[0], facet->normal[1], facet->normal[2]);
    if (face.outward().dot(outward) < 0) std::ranges::reverse(face.corners);
    return face;
  }

  qhT state;
};

}  // namespace

std::vector<render::Face> hull_faces(const std::vector<Point>& points) {
  if (points.size() < 4) return {};
  std::vector<double> coordinates;
  for (const Point& p : points) coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> messages(std::fopen("/dev/null", "w"), std::fclose);
  Qhull hull(messages.get());
  char command[] = "qhull Pp";
  const int count = static_cast<int>(points.size()), dimension = 3;
  if (qh_new_qhull(&hull.state, dimension, count, coordinates.data(), False, command, nullptr, messages.get()) != 0)
    return {};
  std::vector<render::Face> faces;
  for (facetT* facet = hull.state.facet_list; facet != nullptr && facet->next != nullptr; facet = facet->next)
    faces.push_back(hull.face(facet));
  return faces;
}

}  // namespace walkthroughs::picture
