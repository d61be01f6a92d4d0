/// Algorithm 5: a tetrahedron.
///
/// Negative control. Each mistake below was made by hand, one at a time, in a copy of core/, and all tests were run. The
/// numbers say how many test cases of rules_0_1, rules_2simplex, rules_3simplex, gjk, properties, random, events and shapes
/// noticed. Random pairs alone overlook what later iterations correct: R3 along ABn, R7 before R3, AP before AQ.
///
/// mistake                                 0_1 2sim 3sim  gjk prop rand   ev   sh
/// triple: Y×X×X                             3    4    2    8    -    6    5    1
/// triple: X×(X×Y)                           3    4    2    8    -    6    5    1
/// Algorithm 4: ABCn = AC×AB                 -    7    -    9    2    6    5    1
/// Algorithm 4: ABn = ABCn×AB                -    7    -    8    1    6    5    -
/// Algorithm 4: ACn = AC×ABCn                -    6    -    6    2    6    5    -
/// Algorithm 5: ABCn = AC×AB                 -    -    4    5    2    6    5    -
/// Algorithm 5: ACDn = AD×AC                 -    -    5    2    2    6    5    -
/// Algorithm 5: ADBn = AB×AD                 -    -    4    2    2    6    5    -
/// face: AQn = AQ×APQn                       -    -    3    2    2    4    2    -
/// face: APn = APQn×AP                       -    -    2    -    2    4    2    -
/// ABC edge normals reused for ACD, ADB      -    -    3    -    1    3    2    -
/// ACD handled with the normal ABCn          -    -    3    2    2    4    2    -
/// ADB handled with the normal ABCn          -    -    2    1    2    4    2    -
/// ADB handled with the normal ACDn          -    -    3    1    2    4    2    -
/// face kept as [P, Q, A]                    -    -    2    3    3    4    -    -
/// below: A and B not swapped                -    3    -    2    3    4    1    -
/// edge kept as [A, other]                   -    4    2    1    1    1    -    -
/// below: search along ABCn                  -    3    -    1    2    6    3    -
/// above: search along −ABCn                 -    3    -    1    2    6    4    -
/// R7 asked before R3                        -    6    -    -    -    -    -    -
/// AP asked before AQ                        -    -    2    -    -    -    -    -
/// Algorithm 3: search along AO              3    -    -    9    -    6    5    1
/// kept edge: search along AO                -    4    2    6    -    6    2    -
/// R3: search along ABn                      -    4    -    -    -    -    2    -
/// normal·AO >= 0 for > 0                    -    3    3    7    1    3    -    -
/// Algorithm 2: no zero test                 1    -    -    3    -    3    -    -
/// Algorithm 3: no zero test                 2    -    -    4    -    3    -    1
/// Algorithm 4: no zero test                 -    2    -    3    1    -    2    -
/// Eq. 8: support(B, d)                      -    -    -   11    3    6    -    3
/// Eq. 9: w·d <= 0                           -    -    -    4    -    3    1    -
/// Eq. 9 for the first point                 -    -    -    1    -    -    5    -
/// Algorithm 1: not crossed, goes on         -    -    -    6    1    6    3    1
/// Algorithm 1: limit = separated            -    -    -    2    -    -    2    -
/// one iteration more                        -    -    -    2    1    -    1    -
/// returning vertex ends the search          -    -    -    2    -    -    -    -
/// zero direction used                       -    -    -    1    1    -    2    -
/// infinite direction used                   -    -    -    2    1    -    -    -
/// proof: the opposite direction             -    -    -    3    -    1    3    -
/// Eq. 5: the last among equals              -    -    -    2    -    -    1    2
/// Eq. 6: d/|d| unscaled                     -    -    -    -    -    -    -    1
/// text of ADn's formula                     -    -    1    -    -    -    2    -
/// text of a direction                       -    3    2    -    -    -    2    -
#include <map>

#include "tests/core/rules_support.hpp"

namespace gjk::test {
namespace {

// As in the comment of process_3simplex: BCD on the ground, counter-clockwise seen from above, A above them.
const Point B{-6, 0, 0}, C{0, -6, 0}, D{6, 6, 0}, A{0, 0, 8};
const Points DCBA{D, C, B, A};
// All faces alike: each of the twelve orders that keep A in the direction of BC×BD sees the same shape.
const Points regular{{0, 0, 0}, {0, 6, 6}, {6, 0, 6}, {6, 6, 0}};

const std::string skipped_by_algorithm_5 = "B, C, D, BC, CD, DB, BCD, A";

template <class S>
void require_outcome_at(const Point& origin, const Outcome& expected, const std::vector<Frame<S>>& frames) {
  require_outcome_at(origin, DCBA, skipped_by_algorithm_5, expected, frames);
}

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

TEMPLATE_TEST_CASE("Algorithm 5: each face, each edge and the inside", "[rules]", float, double, long double,
                   Rational) {
  const auto everywhere = frames<TestType>();
  SECTION("inside") { require_outcome_at<TestType>({0, 0, 2}, inside, everywhere); }
  SECTION("above ABC keeps [C, B, A]") {
    require_outcome_at<TestType>({-4, -4, 3}, outcome_of(0, Part::whole), everywhere);
  }
  SECTION("beyond AC, seen by ABC, keeps [C, A]") {
    require_outcome_at<TestType>({-1, -8, 5}, outcome_of(0, Part::edge_AQ), everywhere);
  }
  SECTION("beyond AB, seen by ABC, keeps [B, A]") {
    require_outcome_at<TestType>({-8, -1, 5}, outcome_of(0, Part::edge_AP), everywhere);
  }
  SECTION("above ACD keeps [D, C, A]") {
    require_outcome_at<TestType>({4, -1, 4}, outcome_of(1, Part::whole), everywhere);
  }
  SECTION("beyond AD, seen by ACD, keeps [D, A]") {
    require_outcome_at<TestType>({8, 4, 5}, outcome_of(1, Part::edge_AQ), everywhere);
  }
  SECTION("beyond AC, seen by ACD alone, keeps [C, A]") {
    require_outcome_at<TestType>({4, -5, 6}, outcome_of(1, Part::edge_AP), everywhere);
  }
  SECTION("above ADB keeps [B, D, A]: the only face that changes the order") {
    require_outcome_at<TestType>({-1, 4, 4}, outcome_of(2, Part::whole), everywhere);
  }
  SECTION("beyond AB, seen by ADB alone, keeps [B, A]") {
    require_outcome_at<TestType>({-5, 4, 6}, outcome_of(2, Part::edge_AQ), everywhere);
  }
  SECTION("beyond AD, seen by ADB alone, keeps [D, A]") {
    require_outcome_at<TestType>({1, 6, 8}, outcome_of(2, Part::edge_AP), everywhere);
  }
}

TEMPLATE_TEST_CASE("Algorithm 5: the origin exactly on the tetrahedron is contained", "[rules]", float, double,
                   long double, Rational) {
  const auto exactly = frames_without_rounding<TestType>();
  SECTION("at A") { require_outcome_at<TestType>(A, inside, exactly); }
  SECTION("at a vertex of the ground") { require_outcome_at<TestType>(B, inside, exactly); }
  SECTION("on AB") { require_outcome_at<TestType>({-3, 0, 4}, inside, exactly); }
  SECTION("on AC") { require_outcome_at<TestType>({0, -3, 4}, inside, exactly); }
  SECTION("on AD") { require_outcome_at<TestType>({3, 3, 4}, inside, exactly); }
  SECTION("on BC") { require_outcome_at<TestType>({-3, -3, 0}, inside, exactly); }
  SECTION("on the face ABC") { require_outcome_at<TestType>({-2, -1, 4}, inside, exactly); }
  SECTION("on the face ACD") { require_outcome_at<TestType>({1, -1, 4}, inside, exactly); }
  SECTION("on the face ADB") { require_outcome_at<TestType>({-1, 1, 4}, inside, exactly); }
  SECTION("on the face BCD") { require_outcome_at<TestType>({0, 0, 0}, inside, exactly); }
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
          "[rules][unsanitized]") {
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

TEST_CASE("Algorithm 5: in the plane of a face but outside it, another face takes the origin", "[rules]") {
  // In the plane of ABC, where x + y = -6 + 3/4 z, beyond its edge AC.
  for (const auto& frame : frames<Rational>()) {
    INFO(frame.name);
    const auto simplex = seen_from({2, -5, 4}, DCBA, frame);
    const auto told = ask_rules(simplex);
    REQUIRE(std::get<Rational>(told.region("ABC").value) == 0);
    REQUIRE(told.region("ABC").verdict == Verdict::rejected);
    REQUIRE(told.region("ACD").verdict == Verdict::chosen);
  }
}

TEST_CASE("Algorithm 5 gives each face its own edge normals", "[rules]") {
  const auto above_ABC = ask_rules(seen_from<double>({-4, -4, 3}, DCBA, axis_aligned("1", 1.0)));
  const auto above_ACD = ask_rules(seen_from<double>({4, -1, 4}, DCBA, axis_aligned("1", 1.0)));
  const auto above_ADB = ask_rules(seen_from<double>({-1, 4, 4}, DCBA, axis_aligned("1", 1.0)));
  REQUIRE(above_ABC.region("AC", "ABC").formula == "ABCn×AC");
  REQUIRE(above_ABC.region("AB", "ABC").formula == "AB×ABCn");
  REQUIRE(above_ACD.region("AD", "ACD").formula == "ACDn×AD");
  REQUIRE(above_ACD.region("AC", "ACD").formula == "AC×ACDn");
  REQUIRE(above_ADB.region("AB", "ADB").formula == "ADBn×AB");
  REQUIRE(above_ADB.region("AD", "ADB").formula == "AD×ADBn");
  REQUIRE(above_ABC.region("AC", "ABC").normal != above_ACD.region("AC", "ACD").normal);
}

}  // namespace
}  // namespace gjk::test
