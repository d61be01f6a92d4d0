#include <algorithm>
#include <cstdio>
#include <memory>

#include "walkthroughs/picture/body.hpp"

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace walkthroughs::picture {
namespace {

/// The one place that knows Qhull, which was chosen because it copes with coplanar points: one run on points in space;
/// freed with everything it has allocated.
class Qhull {
 public:
  explicit Qhull(std::vector<double> coordinates) : coordinates_(std::move(coordinates)) {
    qh_zero(&state_, messages_.get());
    char command[] = "qhull Pp";
    const int count = static_cast<int>(coordinates_.size() / 3);
    failed_ = qh_new_qhull(&state_, 3, count, coordinates_.data(), False, command, nullptr, messages_.get()) != 0;
  }
  ~Qhull() {
    qh_freeqhull(&state_, !qh_ALL);
    int short_memory = 0, long_memory = 0;
    qh_memfreeshort(&state_, &short_memory, &long_memory);
  }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;

  std::vector<render::Face> faces() {
    std::vector<render::Face> list;
    if (failed_) return list;
    for (facetT* facet = state_.facet_list; facet != nullptr && facet->next != nullptr; facet = facet->next)
      list.push_back(face(facet));
    return list;
  }

 private:
  /// Counter-clockwise seen from outside, where Qhull's normal points to.
  render::Face face(facetT* facet) {
    render::Face face;
    setT* corners = qh_facet3vertex(&state_, facet);
    for (int i = 0; i < qh_setsize(&state_, corners); ++i) {
      const coordT* p = static_cast<vertexT*>(SETelem_(corners, i))->point;
      face.corners.emplace_back(p[0], p[1], p[2]);
    }
    qh_settempfree(&state_, &corners);
    const Point outward(facet->normal[0], facet->normal[1], facet->normal[2]);
    if (face.outward().dot(outward) < 0) std::ranges::reverse(face.corners);
    return face;
  }

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::vector<double> coordinates_;  // Qhull keeps pointers into it
  std::unique_ptr<std::FILE, Close> messages_{std::fopen("/dev/null", "w")};
  qhT state_;
  bool failed_ = false;
};

}  // namespace

std::vector<render::Face> hull_faces(const std::vector<Point>& points) {
  if (points.size() < 4) return {};
  std::vector<double> coordinates;
  for (const Point& p : points) coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
  return Qhull(std::move(coordinates)).faces();
}

}  // namespace walkthroughs::picture
