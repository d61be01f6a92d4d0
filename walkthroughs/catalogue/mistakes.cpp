// Each mistake on a pair on which it shows: small whole numbers, in the plane where there is such a pair.

#include <algorithm>
#include <utility>

#include "walkthroughs/catalogue/catalogue.hpp"

namespace walkthroughs {
namespace {

/// Two triangles; a triangle and a segment, where both searches are to find the same first point.
struct MistakenPair {
  Mistake mistake;
  std::vector<Point> a, b;
};

/// In the report's order.
std::vector<MistakenPair> pairs() {
  const std::vector<Point> wide{{0, 0, 0}, {-1, 2, 0}, {-1, 0, 0}}, narrow{{-1, 0, 0}, {0, 0, 0}, {0, 1, 0}};
  return {
      {Mistake::wrong_side_of_b, {{0, 1, 0}, {-1, 0, 0}, {1, 0, 0}}, {{0, 2, 0}, {0, -1, 0}}},
      {Mistake::first_point_tested, {{-1, 1, 0}, {0, 0, 0}, {-1, -1, 0}}, {{2, 0, 0}, {1, 1, 0}, {1, 0, 0}}},
      {Mistake::touching_is_apart, {{-1, -2, 0}, {0, -1, 0}, {0, 0, 0}}, {{-1, 0, 0}, {0, 0, 0}, {-1, -1, 0}}},
      {Mistake::as_printed, {{-1, -1, 0}, {0, 0, 0}, {-1, 0, 0}}, {{0, 1, 0}, {1, 0, 0}, {0, 2, 0}}},
      {Mistake::origin_at_vertex_missed, {{0, 0, 0}, {-2, -2, 0}, {-1, 0, 0}}, {{0, 0, 0}, {0, 2, 0}, {1, 0, 0}}},
      {Mistake::origin_on_segment_missed, {{1, 1, 0}, {1, 0, 0}, {0, -1, 0}}, {{1, 0, 0}, {0, 0, 0}, {0, 1, 0}}},
      {Mistake::direction_from_vertex, {{-1, 0, 0}, {-1, 1, 0}, {0, -1, 0}}, {{1, 0, 0}, {1, 1, 0}, {0, 0, 0}}},
      {Mistake::triangle_normal_reversed, {{0, 1, 0}, {2, 0, 0}, {-2, 0, 0}}, {{0, -1, 0}, {-1, -1, 0}, {-1, 1, 0}}},
      {Mistake::triangle_abn_inward, wide, narrow},
      {Mistake::triangle_acn_inward, wide, narrow},
      {Mistake::edge_normal_as_direction, {{1, 1, 0}, {-1, -1, 0}, {0, -2, 0}}, {{1, 1, 2}, {-1, -2, 1}, {-2, 1, 2}}},
      {Mistake::two_dimensions_only, {{0, 1, 1}, {-1, 2, 0}, {1, -1, 1}}, {{2, 0, 1}, {0, -1, -1}, {0, 0, 0}}},
      {Mistake::origin_in_triangle_missed, wide, narrow},
      {Mistake::order_kept_below_triangle, {{1, 0, 1}, {0, 0, -1}, {1, 0, 0}}, {{0, -2, -2}, {1, 2, 0}, {-1, -1, 0}}},
      {Mistake::abcn_inward, {{-1, 0, 0}, {0, 0, 0}, {1, -1, 1}}, {{-1, 2, 1}, {-2, 1, -1}, {-1, -1, 0}}},
      {Mistake::acdn_inward, {{-1, 0, -1}, {1, 1, 0}, {0, 0, 0}}, {{0, 1, 0}, {1, 3, -1}, {1, 0, -2}}},
      {Mistake::adbn_inward, {{0, 1, -1}, {1, 0, 0}, {-2, 0, 1}}, {{-2, -1, 1}, {0, 2, 1}, {-1, 2, -1}}},
      {Mistake::edge_normals_reused, {{-1, 0, 0}, {1, 0, -1}, {0, -2, 0}}, {{-1, -1, 0}, {1, 1, -2}, {1, -1, 0}}},
      {Mistake::abn_reused_for_adb, {{0, -2, 0}, {2, -1, 2}, {-2, 0, -1}}, {{2, 1, 1}, {0, 0, 1}, {0, -2, 1}}},
      {Mistake::order_of_adb, {{-1, 2, 1}, {0, -1, 1}, {2, 0, -1}}, {{1, 0, 0}, {0, 1, 0}, {0, -2, -2}}},
      {Mistake::origin_in_face_seen_outside, {{-1, -2, 1}, {0, -2, 1}, {0, 1, -1}}, {{0, 0, 1}, {0, 2, 2}, {0, 1, -2}}},
  };
}

Scene scene_of(const MistakenPair& pair) {
  const auto is_flat = [](const std::vector<Point>& vertices) {
    return std::ranges::all_of(vertices, [](const Point& p) { return p.z() == 0; });
  };
  return {.name = "the report",
          .a = {"triangle a", points(pair.a)},
          .b = {pair.b.size() == 2 ? "segment b" : "triangle b", points(pair.b)},
          .dimension = is_flat(pair.a) && is_flat(pair.b) ? Dimension::plane : Dimension::space};
}

}  // namespace

Walkthrough beside_the_report(Mistake mistake, Scene right) {
  const wrong_on_purpose::Description& known = wrong_on_purpose::description_of(mistake);
  Scene wrong = mistaken(right, mistake);
  wrong.name = wrong_on_purpose::number_of(mistake);
  right.name = "the report";
  return {.name = "mistakes/" + std::string(known.word),
          .title = "A mistake, " + wrong.name + ", and the report's algorithm",
          .source = "ARL-TR-7474, Section " + std::string(known.section),
          .summary = std::string(known.meaning),
          .layout = Layout::until_they_part,
          .naming = Naming::roles,
          .scenes = {std::move(wrong), std::move(right)}};
}

std::vector<Walkthrough> mistakes() {
  std::vector<Walkthrough> all;
  for (const MistakenPair& pair : pairs()) all.push_back(beside_the_report(pair.mistake, scene_of(pair)));
  return all;
}

}  // namespace walkthroughs
