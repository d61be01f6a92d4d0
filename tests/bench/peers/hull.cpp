#include "tests/bench/peers/hull.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <set>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace peers {
namespace {

using Triangle = std::array<int, 3>;

/// One run of Qhull on points in space, with coplanar faces cut into triangles; freed with everything it has allocated.
class Qhull {
 public:
  explicit Qhull(const study::Points& points) {
    for (const study::Vec& p : points) coordinates_.insert(coordinates_.end(), {p.x(), p.y(), p.z()});
    qh_zero(&state_, messages_.get());
    char command[] = "qhull Qt Pp";
    const int count = static_cast<int>(points.size());
    failed_ = qh_new_qhull(&state_, 3, count, coordinates_.data(), False, command, nullptr, messages_.get()) != 0;
  }
  ~Qhull() {
    qh_freeqhull(&state_, !qh_ALL);
    int short_memory = 0, long_memory = 0;
    qh_memfreeshort(&state_, &short_memory, &long_memory);
  }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;

  std::vector<Triangle> triangles() {
    std::vector<Triangle> list;
    if (failed_) return list;
    for (facetT* facet = state_.facet_list; facet != nullptr && facet->next != nullptr; facet = facet->next)
      list.push_back(triangle(facet));
    return list;
  }

 private:
  /// Qhull lists the corners of such a face in either order; its normal points outward.
  Triangle triangle(facetT* facet) {
    Triangle triangle{};
    std::array<study::Vec, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      coordT* const p = static_cast<vertexT*>(SETelem_(facet->vertices, static_cast<int>(i)))->point;
      triangle[i] = qh_pointid(&state_, p);
      corners[i] = {p[0], p[1], p[2]};
    }
    const study::Vec outward(facet->normal[0], facet->normal[1], facet->normal[2]);
    if ((corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(outward) < 0) std::swap(triangle[0], triangle[1]);
    return triangle;
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

std::vector<Triangle> faces_of_hull(const study::Points& points) {
  if (points.size() < 4) return {};
  const std::vector<Triangle> triangles = Qhull(points).triangles();
  std::set<int> corners;
  for (const Triangle& triangle : triangles) corners.insert(triangle.begin(), triangle.end());
  return corners.size() == points.size() ? triangles : std::vector<Triangle>{};
}

}  // namespace peers
