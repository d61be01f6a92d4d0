// The report's algorithm with an absolute tolerance, whatever the size of the sets, and no other fault: the judge's tests judge it.
//
//     JUDGED_TOLERANCE=1e-6 judged-tolerant
#include "core/gjk.hpp"
#include "point_set.hpp"

static const double tolerance = std::atof(std::getenv("JUDGED_TOLERANCE"));

/// What is not farther beyond than that is not beyond.
struct Tolerant : gjk::AsIntended {
  static bool is_on_segment(const auto& direction) { return direction.value.norm() <= tolerance; }
  static bool is_beyond_edge(const auto& AXn_AO) { return AXn_AO.value > tolerance; }
  static bool is_above_face(const auto& APQn_AO) { return APQn_AO.value > tolerance; }
  static gjk::Side side_of_triangle(const auto& ABCn_AO) {
    return std::abs(ABCn_AO.value) <= tolerance ? gjk::Side::in_plane : ABCn_AO.side();
  }
};

bool collide(const judge::Points& a, const judge::Points& b) {
  return gjk::collision<double, Tolerant>(set_of(a), set_of(b)).status == gjk::Status::intersecting;
}
