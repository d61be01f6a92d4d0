#include "walkthroughs/wrong_on_purpose/mistakes.hpp"

#include <algorithm>
#include <array>

namespace walkthroughs::wrong_on_purpose {
namespace {

using gjk::RuleSet;

constexpr std::string_view crossing_line = "if not the first and P·d < 0";
constexpr std::string_view triangle_edges_line = "ABn ← AB×ABCn,  ACn ← ABCn×AC";
constexpr std::string_view first_faces_line = "ABCn ← AB×AC,  ACDn ← AC×AD";

constexpr WrongLine m1[] = {{1, "P ← support(a, d) − support(b, −d)", "P ← support(a, d) − support(b, d)"}};
constexpr WrongLine m2[] = {{1, crossing_line, "if P·d < 0"}};
constexpr WrongLine m3[] = {{1, crossing_line, "if not the first and P·d ≤ 0"}};
constexpr WrongLine m4[] = {{1, "separated", "go on, and say so only where the simplex does not contain the origin"}};
constexpr WrongLine m5[] = {{2, "if AO = 0", "not asked"}};
constexpr WrongLine m6[] = {{3, "if v = 0", "not asked"}};
constexpr WrongLine m7[] = {{3, "v ← (AB×AO)×AB", "v ← AO", "v"},
                            {4, "keep [B, A],  d ← (AB×AO)×AB", "keep [B, A],  d ← AO"},
                            {4, "keep [C, A],  d ← (AC×AO)×AC", "keep [C, A],  d ← AO"},
                            {5, "keep [B, A],  d ← (AB×AO)×AB", "keep [B, A],  d ← AO"},
                            {5, "keep [C, A],  d ← (AC×AO)×AC", "keep [C, A],  d ← AO"},
                            {5, "keep [D, A],  d ← (AD×AO)×AD", "keep [D, A],  d ← AO"}};
constexpr WrongLine m8[] = {{4, "ABCn ← AB×AC", "ABCn ← AC×AB"}};
constexpr WrongLine m9[] = {{4, triangle_edges_line, "ABn ← ABCn×AB,  ACn ← ABCn×AC"}};
constexpr WrongLine m10[] = {{4, triangle_edges_line, "ABn ← AB×ABCn,  ACn ← AC×ABCn"}};
constexpr WrongLine m11[] = {{4, "keep [B, A],  d ← (AB×AO)×AB", "keep [B, A],  d ← ABn"},
                             {4, "keep [C, A],  d ← (AC×AO)×AC", "keep [C, A],  d ← ACn"},
                             {5, "keep [B, A],  d ← (AB×AO)×AB", "keep [B, A],  d ← ABn"},
                             {5, "keep [C, A],  d ← (AC×AO)×AC", "keep [C, A],  d ← ACn"},
                             {5, "keep [D, A],  d ← (AD×AO)×AD", "keep [D, A],  d ← ADn"}};
constexpr WrongLine m12[] = {{4, "if ABCn·AO = 0", "not asked: the origin is in ABC, wherever it is"}};
constexpr WrongLine m13[] = {{4, "if ABCn·AO = 0", "not asked: what is not above is below"}};
constexpr WrongLine m14[] = {{4, "keep [C, A, B],  d ← −ABCn", "keep [C, B, A],  d ← −ABCn"}};
constexpr WrongLine m15[] = {{5, first_faces_line, "ABCn ← AC×AB,  ACDn ← AC×AD"}};
constexpr WrongLine m16[] = {{5, first_faces_line, "ABCn ← AB×AC,  ACDn ← AD×AC"}};
constexpr WrongLine m17[] = {{5, "ADBn ← AD×AB", "ADBn ← AB×AD"}};
constexpr WrongLine m18[] = {{5, "else if ACn·AO > 0", "else if ACn·AO > 0, with the ACn of ABC"},
                             {5, "else if ADn·AO > 0", "else if ADn·AO > 0, with the ADn of ACD"}};
constexpr WrongLine m19[] = {{5, "if ABn·AO > 0", "if ABn·AO > 0, with the ABn of ABC"}};
constexpr WrongLine m20[] = {{5, "else keep [B, D, A],  d ← ADBn", "else keep [D, B, A],  d ← ADBn"}};
constexpr WrongLine m21[] = {{5, "if ABCn·AO > 0", "if ABCn·AO ≥ 0"},
                             {5, "else if ACDn·AO > 0", "else if ACDn·AO ≥ 0"},
                             {5, "else if ADBn·AO > 0", "else if ADBn·AO ≥ 0"}};

constexpr PairsToNotice unseen{780'000, true};
constexpr std::array<PairsToNotice, 3> shown_by(PairsToNotice triangles, PairsToNotice tetrahedra,
                                                PairsToNotice on_grid) {
  return {triangles, tetrahedra, on_grid};
}

/// The last columns are how many random triangles, tetrahedra and triangles on a grid show the mistake: as the study has measured them
/// (tests/study/results/claims-mistakes.csv, with which a test compares them).
constexpr std::array<Description, 21> mistakes{{
    {Mistake::wrong_side_of_b, "m1-wrong-side-of-b", "support(B, d) in place of support(B, −d) (Eq. 8)", "2.4", "", m1,
     shown_by(10, 4, 8)},
    {Mistake::first_point_tested, "m2-first-point-tested", "the crossing test is applied to the first point, too",
     "3.1.3", "1-simplex-r2-cannot-happen", m2, shown_by(unseen, unseen, unseen), RuleSet::eager},
    {Mistake::touching_is_apart, "m3-touching-is-apart", "<= in place of < in Eq. 9", "3.1.3",
     "1-simplex-r2-cannot-happen", m3, shown_by(unseen, unseen, 92)},
    {Mistake::as_printed, "m4-as-printed", "the simplex is processed after Eq. 9 has said no (Algorithm 1 as printed)",
     "3.1.4", "1-simplex-r2-cannot-happen", m4, shown_by(140, 600, 130), RuleSet::as_printed},
    {Mistake::origin_at_vertex_missed, "m5-origin-at-vertex", "the origin on the first vertex is not recognised",
     "3.2.1", "0-simplex-a-is-origin", m5, shown_by(unseen, unseen, 2'100)},
    {Mistake::origin_on_segment_missed, "m6-origin-on-segment",
     "the origin on the segment is not recognised: a search along the zero vector", "3.2.2", "1-simplex-on-segment", m6,
     shown_by(unseen, unseen, 400)},
    {Mistake::direction_from_vertex, "m7-direction-from-vertex",
     "the direction is taken from the vertex (AO), not from the edge: ping-pong", "3.2.2", "1-simplex-r3", m7,
     shown_by(5, 10, 5)},
    {Mistake::triangle_normal_reversed, "m8-triangle-normal-reversed",
     "ABCn of the triangle in the wrong order, and ABn, ACn with it", "3.2.3", "2-simplex-r1-above", m8,
     shown_by(10, 4, 8)},
    {Mistake::triangle_abn_inward, "m9-abn-inward", "ABn of the triangle points inward", "3.2.3", "2-simplex-r3", m9,
     shown_by(11, 4, 10)},
    {Mistake::triangle_acn_inward, "m10-acn-inward", "ACn of the triangle points inward", "3.2.3", "2-simplex-r7", m10,
     shown_by(10, 4, 9)},
    {Mistake::edge_normal_as_direction, "m11-edge-normal-as-direction", "ABn, ACn, ADn used as 3D search direction",
     "3.2.3", "2-simplex-r3", m11, shown_by(unseen, unseen, unseen)},
    {Mistake::two_dimensions_only, "m12-two-dimensions-only", "2D only: inside the three edges is inside", "3.2.3",
     "2-simplex-r1-above", m12, shown_by(9, 12, 10)},
    {Mistake::origin_in_triangle_missed, "m13-origin-in-triangle", "the origin in the triangle is not recognised",
     "3.2.3", "2-simplex-r1-in-plane", m13, shown_by(unseen, unseen, unseen)},
    {Mistake::order_kept_below_triangle, "m14-order-below-triangle",
     "the order is not changed when moving below the triangle", "3.2.3", "2-simplex-r1-below", m14,
     shown_by(620, 800, 860)},
    {Mistake::abcn_inward, "m15-face-abcn-inward", "ABCn of the tetrahedron points inward", "3.2.4",
     "3-simplex-face-abc", m15, shown_by(11, 5, 15)},
    {Mistake::acdn_inward, "m16-face-acdn-inward", "ACDn of the tetrahedron points inward", "3.2.4",
     "3-simplex-face-acd", m16, shown_by(10, 4, 13)},
    {Mistake::adbn_inward, "m17-face-adbn-inward", "ADBn of the tetrahedron points inward", "3.2.4",
     "3-simplex-face-adb", m17, shown_by(10, 4, 14)},
    {Mistake::edge_normals_reused, "m18-edge-normals-reused",
     "the edge normals of the face before are used again: ACn for ACD, ADn for ADB", "3.2.4",
     "3-simplex-face-acd-edge-ac", m18, shown_by(190'000, 12'000, 270'000)},
    {Mistake::abn_reused_for_adb, "m19-abn-reused", "ABn of ABC is used again for ADB", "3.2.4",
     "3-simplex-face-adb-edge-ab", m19, shown_by(250'000, 18'000, 230'000)},
    {Mistake::order_of_adb, "m20-order-of-face-adb", "face ADB is kept in the wrong order", "3.2.4",
     "3-simplex-face-adb", m20, shown_by(34'000, 48'000, 16'000)},
    {Mistake::origin_in_face_seen_outside, "m21-origin-in-face",
     "the origin in a face of the tetrahedron counts as outside", "3.2.4", "3-simplex-on-face", m21,
     shown_by(unseen, unseen, 56)},
}};

}  // namespace

std::span<const Description> all() { return mistakes; }

const Description& description_of(Mistake mistake) { return mistakes.at(static_cast<std::size_t>(mistake)); }

const Description* named(std::string_view word) {
  const auto found = std::ranges::find(all(), word, &Description::word);
  return found == all().end() ? nullptr : &*found;
}

const PairsToNotice& pairs_to_notice(Mistake mistake, TestPairs pairs) {
  return description_of(mistake).to_notice.at(static_cast<std::size_t>(pairs));
}

std::string PairsToNotice::text() const {
  std::string digits = std::to_string(static_cast<long long>(count));
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, ",");
  return (is_more ? "more than " : "about ") + digits;
}

bool is_none_along_axes(Mistake mistake) { return mistake == Mistake::first_point_tested; }

std::string number_of(Mistake mistake) { return "M" + std::to_string(static_cast<int>(mistake) + 1); }

}  // namespace walkthroughs::wrong_on_purpose
