/// Algorithms 2 to 5, each asked about one simplex: every region, in every scalar, and in exact numbers with every order of the
/// vertices against linear equations.
#include "core/rules.hpp"

#include <map>

#include "tests/core/rules_support.hpp"

namespace gjk::test {
namespace rules_test {

// -- Algorithms 2 and 3: a vertex, a segment --------------------------------------------------------------------------

TEST_CASE("Algorithm 2: a vertex is the origin, or the search goes straight toward it", "[rules]") {
  const Outcome elsewhere{"A: yes", "A", "AO"}, at_origin{"A: yes", "", ""};
  const Points vertex{{0, 0, 0}};
  require_outcomes(In::all_frames, vertex, "",
                   {{{0, 0, 0}, at_origin},
                    {{3, 0, 0}, elsewhere},
                    {{0, -2, 0}, elsewhere},
                    {{1, -2, 3}, elsewhere},
                    {{-5, 4, 1}, elsewhere}});
  const auto told = ask_rules<double>({{1, -2, 3}});
  REQUIRE(to_string(told.regions[0].expression) == "AO");
  REQUIRE(told.direction == Vec3<double>(-1, 2, -3));
}

// The middle of the segment is a lattice point, and so are places beside it in all directions.
const Points segment{{0, 0, 0}, {4, 2, -2}}, segment_turned{segment[1], segment[0]};
const std::string skipped_by_algorithm_3 = "B R1, A R2";
const Outcome beside_segment{"AB R3 or R4: yes", "BA", "AB×AO×AB"}, on_segment{"AB: yes", "", ""};

TEST_CASE(
    "Algorithm 3: beside a segment (R3 or R4) the search leaves it at a right angle; on it the origin is contained",
    "[rules]") {
  for (const Points& BA : {segment, segment_turned}) {
    std::vector<OutcomeAt> beside, on;
    for (const Point& p : Points{{2, 1, 1}, {2, 1, -3}, {3, 0, 1}, {1, 2, -1}, {1, 0, -3}, {2, 4, 2}})
      beside.push_back({p, beside_segment});
    for (const Point& p : Points{{0, 0, 0}, {2, 1, -1}, {4, 2, -2}})  // one end, the middle, the other end
      on.push_back({p, on_segment});
    require_outcomes(In::all_frames, BA, skipped_by_algorithm_3, beside);
    require_outcomes(In::frames_without_rounding, BA, skipped_by_algorithm_3, on);
  }
  REQUIRE(to_string(ask_rules<double>({{1, 2, 3}, {4, 5, 7}}).region("AB").expression) == "AB×AO×AB");
}

TEST_CASE("Algorithm 3 agrees with linear equations wherever the origin is beyond neither end", "[rules]") {
  int beside = 0, on = 0;
  for (const auto& frame : frames<Rational>())
    for (const Points& BA : {segment, segment_turned})
      for (int x = -2; x <= 6; ++x)
        for (int y = -2; y <= 4; ++y)
          for (int z = -4; z <= 2; ++z) {
            const auto simplex = seen_from({x, y, z}, BA, frame);
            const auto coordinates = coordinates_of_origin(simplex);
            if (coordinates[0] < 0 || coordinates[1] < 0) continue;
            INFO(frame.name << ", origin at " << x << " " << y << " " << z);
            const bool is_on = toward_origin(simplex) == ExactVec(ExactVec::Zero());
            ++(is_on ? on : beside);
            require_outcome(is_on ? on_segment : beside_segment, skipped_by_algorithm_3, simplex);
          }
  REQUIRE(on == 3 * 6 * 2);
  REQUIRE(beside > 1000);
}

// -- Algorithm 4: a triangle ------------------------------------------------------------------------------------------

namespace triangle {

// Acute, so that each edge's region is where Fig. 7 draws it; even, so that the middles of its edges are lattice points.
const Point C{0, 0, 0}, B{12, 0, 0}, A{4, 10, 0};
const Points CBA{C, B, A};
constexpr int above = -3, below = 3;  // AB×AC points to -z

const std::string skipped_by_algorithm_4 = "B R4, BC R5, C R6, A R2";

const Outcome R3{"AB R3: yes", "BA", "AB×AO×AB"};
const Outcome R7{"AB R3: no, AC R7: yes", "CA", "AC×AO×AC"};
const Outcome R1_above{"AB R3: no, AC R7: no, ABC R1: yes", "CBA", "ABCn"};
const Outcome R1_below{"AB R3: no, AC R7: no, ABC R1: yes", "CAB", "−ABCn"};
const Outcome R1_in_plane{"AB R3: no, AC R7: no, ABC R1: yes", "", ""};

TEST_CASE("Algorithm 4: beyond AB (R3), beyond AC (R7), above and below the triangle (R1)", "[rules]") {
  require_outcomes(In::all_frames, CBA, skipped_by_algorithm_4,
                   {{{12, 8, above}, R3},
                    {{12, 8, below}, R3},
                    {{-4, 6, above}, R7},
                    {{-4, 6, below}, R7},
                    {{6, 4, above}, R1_above},
                    {{6, 4, below}, R1_below}});
}

TEST_CASE("Algorithm 4: in the plane of the triangle, and straight above and below its edges", "[rules]") {
  std::vector<OutcomeAt> expected{
      {{12, 8, 0}, R3},          {{-4, 6, 0}, R7},            // beyond AB, beyond AC
      {{8, 5, above}, R1_above}, {{8, 5, below}, R1_below},   // over AB, which is not beyond it
      {{2, 5, above}, R1_above}, {{2, 5, below}, R1_below}};  // over AC
  for (const Point& on : {Point{6, 4, 0}, {8, 5, 0}, {2, 5, 0}, {6, 0, 0}, A, B, C})
    expected.push_back({on, R1_in_plane});
  require_outcomes(In::frames_without_rounding, CBA, skipped_by_algorithm_4, expected);
}

TEST_CASE("Algorithm 4: where both edges at an obtuse A see the origin, AB is asked first", "[rules]") {
  const std::vector<Vec3<Rational>> simplex =
      seen_from<Rational>({0, -9, 0}, {{-8, 4, 0}, {8, 4, 0}, {0, 0, 0}}, axis_aligned<Rational>("1", 1));
  REQUIRE(coordinates_of_origin(simplex)[0] < 0);  // beyond AB
  REQUIRE(coordinates_of_origin(simplex)[1] < 0);  // beyond AC
  require_outcome(R3, skipped_by_algorithm_4, simplex);
}

/// The region of Fig. 7, from coordinates in place of normals. Returns: nothing where the history of Algorithm 1 rules
/// the place out, that is beyond BC or beyond a corner.
std::optional<Outcome> outcome_by_coordinates(const ExactVecs& cba) {
  const auto of_triangle = coordinates_of_origin(cba);
  const auto within = [](const ExactVecs& edge) {
    const auto c = coordinates_of_origin(edge);
    return c[0] >= 0 && c[1] >= 0;
  };
  if (of_triangle[2] < 0) return std::nullopt;
  if (of_triangle[0] < 0) return within({cba[1], cba[2]}) ? std::optional(R3) : std::nullopt;
  if (of_triangle[1] < 0) return within({cba[0], cba[2]}) ? std::optional(R7) : std::nullopt;
  const Rational height = orientation({0, 0, 0}, cba[2], cba[1], cba[0]);  // of the origin over AB×AC
  return height > 0 ? R1_above : height < 0 ? R1_below : R1_in_plane;
}

/// ABn·AO is minus C's coordinate, ACn·AO minus B's, times four times the square of the area; also where rejected.
void require_values_by_coordinates(const Told<Rational>& told, const ExactVecs& cba) {
  const auto coordinates = coordinates_of_origin(cba);
  const Rational area = gram_determinant(cba);
  REQUIRE(std::get<Rational>(told.region("AB").value) == -coordinates[0] * area);
  if (told.decided != R3.decided) REQUIRE(std::get<Rational>(told.region("AC").value) == -coordinates[1] * area);
  if (told.regions.back().feature == "ABC")
    REQUIRE(std::get<Rational>(told.region("ABC").value) == orientation({0, 0, 0}, cba[2], cba[1], cba[0]));
}

TEST_CASE(
    "Algorithm 4 agrees with linear equations in every region it can be called in, whatever the order of vertices",
    "[rules][unsanitized]") {
  std::map<std::string, int> reached;
  for (const auto& frame : frames<Rational>()) {
    Points order = CBA;
    std::sort(order.begin(), order.end());
    do
      for (int x = -5; x <= 17; x += 2)
        for (int y = -4; y <= 12; y += 2)
          for (const int z : {-4, 0, 3}) {
            const auto simplex = seen_from({x, y, z}, order, frame);
            const auto expected = outcome_by_coordinates(simplex);
            if (!expected) continue;
            INFO(frame.name << ", origin at " << x << " " << y << " " << z);
            const auto told = require_outcome(*expected, skipped_by_algorithm_4, simplex);
            require_values_by_coordinates(told, simplex);
            ++reached[expected->expression];
          }
    while (std::next_permutation(order.begin(), order.end()));
  }
  for (const Outcome& outcome : {R3, R7, R1_above, R1_below, R1_in_plane}) {
    INFO(outcome.decided << " " << outcome.next);
    REQUIRE(reached[outcome.expression] >= 100);
  }
}

}  // namespace triangle

// -- Algorithm 5: a tetrahedron ---------------------------------------------------------------------------------------

namespace tetrahedron {

// As in the comment of process_3simplex: BCD on the ground, counter-clockwise seen from above, A above them.
const Point B{-6, 0, 0}, C{0, -6, 0}, D{6, 6, 0}, A{0, 0, 8};
const Points DCBA{D, C, B, A};
// All faces alike: each of the twelve orders that keep A in the direction of BC×BD sees the same shape.
const Points regular{{0, 0, 0}, {0, 6, 6}, {6, 0, 6}, {6, 6, 0}};

const std::string skipped_by_algorithm_5 = "B, C, D, BC, CD, DB, BCD, A";

/// A face APQ of the report's Algorithm 5, and what it does beyond AQ, beyond AP, and above the face. Written out from
/// the report's listing.
struct FaceOutcomes {
  char P, Q;
  std::string face, edge_AQ, edge_AP;
  std::string keep_face;
};
const std::vector<FaceOutcomes> faces{
    {'B', 'C', "ABC", "AC", "AB", "CBA"}, {'C', 'D', "ACD", "AD", "AC", "DCA"}, {'D', 'B', "ADB", "AB", "AD", "BDA"}};
enum class Part { edge_AQ, edge_AP, whole };

const Outcome inside{"ABC: no, ACD: no, ADB: no, ABCD: yes", "", ""};

std::string triple_text(const std::string& edge) { return edge + "×AO×" + edge; }

Outcome outcome_of(std::size_t which, Part part) {
  const FaceOutcomes& f = faces[which];
  std::string decided;
  for (std::size_t i = 0; i < which; ++i) append(decided, faces[i].face + ": no");
  append(decided, f.face + ": yes");
  append(decided, f.edge_AQ + " of " + f.face + (part == Part::edge_AQ ? ": yes" : ": no"));
  if (part == Part::edge_AQ) return {decided, std::string{f.Q, 'A'}, triple_text(f.edge_AQ)};
  append(decided, f.edge_AP + " of " + f.face + (part == Part::edge_AP ? ": yes" : ": no"));
  if (part == Part::edge_AP) return {decided, std::string{f.P, 'A'}, triple_text(f.edge_AP)};
  return {decided, f.keep_face, f.face + "n"};
}

TEST_CASE("Algorithm 5: each face, each edge and the inside", "[rules]") {
  require_outcomes(In::all_frames, DCBA, skipped_by_algorithm_5,
                   {{{0, 0, 2}, inside},
                    {{-4, -4, 3}, outcome_of(0, Part::whole)},
                    {{-1, -8, 5}, outcome_of(0, Part::edge_AQ)},
                    {{-8, -1, 5}, outcome_of(0, Part::edge_AP)},
                    {{4, -1, 4}, outcome_of(1, Part::whole)},
                    {{8, 4, 5}, outcome_of(1, Part::edge_AQ)},
                    {{4, -5, 6}, outcome_of(1, Part::edge_AP)},  // seen by ACD alone
                    {{-1, 4, 4}, outcome_of(2, Part::whole)},    // the only face that changes the order
                    {{-5, 4, 6}, outcome_of(2, Part::edge_AQ)},  // seen by ADB alone
                    {{1, 6, 8}, outcome_of(2, Part::edge_AP)}});
}

TEST_CASE("Algorithm 5: the origin exactly on the tetrahedron is contained", "[rules]") {
  std::vector<OutcomeAt> expected;
  const Points vertices{A, B}, on_edges{{-3, 0, 4}, {0, -3, 4}, {3, 3, 4}, {-3, -3, 0}},
      on_faces{{-2, -1, 4}, {1, -1, 4}, {-1, 1, 4}, {0, 0, 0}};
  for (const Points* points : {&vertices, &on_edges, &on_faces})
    for (const Point& on : *points) expected.push_back({on, inside});
  require_outcomes(In::frames_without_rounding, DCBA, skipped_by_algorithm_5, expected);
}

/// What the report's listing does, from coordinates in place of normals: a face sees the origin where the coordinate of
/// the vertex off it is negative, an edge of a face where the coordinate of the face's third vertex is.
Outcome outcome_by_coordinates(const ExactVecs& dcba) {
  const auto coordinates = coordinates_of_origin(dcba);
  const auto at = [&](char role) { return static_cast<std::size_t>('D' - role); };
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const char P = faces[i].P, Q = faces[i].Q, off = static_cast<char>('B' + 'C' + 'D' - P - Q);
    if (coordinates[at(off)] >= 0) continue;
    const auto in_face = coordinates_of_origin({dcba[at(P)], dcba[at(Q)], dcba[at('A')]});
    return outcome_of(i, in_face[0] < 0 ? Part::edge_AQ : in_face[1] < 0 ? Part::edge_AP : Part::whole);
  }
  return inside;
}

/// APQn·AO is minus the coordinate of the vertex off the face, times six times the volume; an edge's value minus that of
/// the face's third vertex, times four times the square of the face's area.
void require_values_by_coordinates(const Told<Rational>& told, const ExactVecs& dcba) {
  const auto at = [&](char role) { return static_cast<std::size_t>('D' - role); };
  const auto coordinates = coordinates_of_origin(dcba);
  const Rational volume = orientation(dcba[3], dcba[2], dcba[1], dcba[0]);
  for (const FaceOutcomes& f : faces) {
    if (told.decided.find(f.face + ":") == std::string::npos) continue;
    const char off = static_cast<char>('B' + 'C' + 'D' - f.P - f.Q);
    REQUIRE(std::get<Rational>(told.region(f.face).value) == -coordinates[at(off)] * volume);
    const ExactVecs face{dcba[at(f.P)], dcba[at(f.Q)], dcba[at('A')]};
    const auto in_face = coordinates_of_origin(face);
    for (const auto& [edge, off_edge] : {std::pair{f.edge_AQ, in_face[0]}, std::pair{f.edge_AP, in_face[1]}})
      if (told.decided.find(edge + " of " + f.face) != std::string::npos)
        REQUIRE(std::get<Rational>(told.region(edge, f.face).value) == -off_edge * gram_determinant(face));
  }
}

/// The last search left BCD toward the origin and crossed it: the origin is above BCD, and not higher than A.
bool has_history(const ExactVecs& dcba) {
  const Rational height = coordinates_of_origin(dcba)[3];
  return 0 < height && height <= 1;
}

void agree_everywhere(const Points& tetrahedron, int low, int high, const Frame<Rational>& frame,
                      std::map<std::string, int>& reached) {
  std::array<std::size_t, 4> order{0, 1, 2, 3};
  do {
    Points dcba;
    for (const std::size_t i : order) dcba.push_back(tetrahedron[i]);
    const ExactVecs unmoved = seen_from({0, 0, 0}, dcba, frame);
    if (orientation(unmoved[3], unmoved[2], unmoved[1], unmoved[0]) <= 0) continue;  // P5
    for (int x = low; x <= high; x += 3)
      for (int y = low; y <= high; y += 3)
        for (int z = low; z <= high; z += 3) {
          const auto simplex = seen_from({x, y, z}, dcba, frame);
          if (!has_history(simplex)) continue;
          INFO(frame.name << ", origin at " << x << " " << y << " " << z);
          const Outcome expected = outcome_by_coordinates(simplex);
          const auto told = require_outcome(expected, skipped_by_algorithm_5, simplex);
          require_values_by_coordinates(told, simplex);
          ++reached[expected.decided];
        }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST_CASE("Algorithm 5 agrees with linear equations in every region, whatever order keeps A in the direction of BC×BD",
          "[rules][unsanitized][full]") {
  std::map<std::string, int> reached;
  for (const auto& frame : frames<Rational>()) {
    agree_everywhere(DCBA, -9, 9, frame, reached);
    agree_everywhere(regular, -3, 9, frame, reached);
  }
  REQUIRE(reached.size() == 10);  // two edges and the face for each of three faces, and the inside
  for (const auto& [decided, times] : reached) {
    INFO(decided);
    REQUIRE(times >= 50);
  }
}

}  // namespace tetrahedron

}  // namespace rules_test
}  // namespace gjk::test
