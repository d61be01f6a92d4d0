// The region catalogue: every walkthrough regions/… really visits the region that its name claims (Section 3.2). Whatever a
// walkthrough says of itself is ignored; the traces are asked, and the geometry is worked out anew in exact numbers.

#include <functional>
#include <map>
#include <optional>

#include "tests/core/oracle.hpp"
#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
using gjk::Relation;
using gjk::Role;
using gjk::Status;
using gjk::Verdict;
using gjk::test::exact;
using gjk::test::ExactVec;
using gjk::test::ExactVecs;
using gjk::test::Rational;

namespace {

// -- What a trace says ------------------------------------------------------------------------------------------------

/// One iteration: the simplex that was processed, if the search came that far, and what was found out about it.
struct Iteration {
  gjk::SupportFound<double> support;
  gjk::CrossingTested<double> crossing;
  std::optional<Simplex> simplex;
  std::vector<gjk::RegionTested<double>> regions;
  std::optional<gjk::SimplexReduced<double>> reduction;
  std::optional<gjk::DirectionChosen<double>> direction;
};

struct Run {
  Scene scene;
  std::vector<Iteration> iterations;  ///< the first at 0
  gjk::Result<double> result;

  const Iteration& at(int iteration) const { return iterations.at(static_cast<std::size_t>(iteration - 1)); }
  int size() const { return static_cast<int>(iterations.size()); }
};

Run run_of(const Walkthrough& w) {
  Run run{w.scenes.at(0), {}, {}};
  for (const auto& event : walkthroughs::run(run.scene).events) {
    if (const auto* e = std::get_if<gjk::SupportFound<double>>(&event))
      run.iterations.push_back({*e, {}, {}, {}, {}, {}});
    if (const auto* e = std::get_if<gjk::CrossingTested<double>>(&event)) run.iterations.back().crossing = *e;
    if (const auto* e = std::get_if<gjk::VertexAdded<double>>(&event)) run.iterations.back().simplex = e->simplex;
    if (const auto* e = std::get_if<gjk::RegionTested<double>>(&event)) run.iterations.back().regions.push_back(*e);
    if (const auto* e = std::get_if<gjk::SimplexReduced<double>>(&event)) run.iterations.back().reduction = *e;
    if (const auto* e = std::get_if<gjk::DirectionChosen<double>>(&event)) run.iterations.back().direction = *e;
    if (const auto* e = std::get_if<gjk::Finished<double>>(&event)) run.result = e->result;
  }
  return run;
}

/// One decision as the tests name it: simplex size, feature, label, face, verdict and relation.
bool told(const Iteration& at, int size, const std::string& feature, const std::string& label, const std::string& face,
          Verdict verdict, Relation relation = Relation::positive) {
  return std::ranges::any_of(at.regions, [&](const auto& r) {
    return r.simplex_size == size && r.feature == feature && r.label == label && r.face == face &&
           r.verdict == verdict && (verdict == Verdict::skipped || r.relation == relation);
  });
}

bool skipped(const Iteration& at, int size, const std::string& feature, const std::string& label,
             const std::string& reason) {
  return told(at, size, feature, label, "", Verdict::skipped) && std::ranges::any_of(at.regions, [&](const auto& r) {
           return r.feature == feature && r.verdict == Verdict::skipped && r.reason == reason;
         });
}

/// Returns: the value of the one decision about that feature of that face.
double value_of(const Iteration& at, const std::string& feature, const std::string& face = "") {
  for (const auto& r : at.regions)
    if (r.feature == feature && r.face == face && r.verdict != Verdict::skipped) return std::get<double>(r.value);
  throw std::logic_error("nothing is told of " + feature);
}

bool kept(const Iteration& at, const std::string& kept, const std::string& dropped, const std::string& direction) {
  return at.reduction && at.reduction->kept == kept && at.reduction->dropped == dropped && at.direction &&
         at.direction->expression == direction;
}

bool contained(const Run& run, int iteration) {
  return run.size() == iteration && run.result.status == Status::intersecting;
}

/// The crossing test ends the run at `iteration` before the point found is added.
bool ended_by_crossing_test(const Run& run, int iteration) {
  return run.size() == iteration && run.result.status == Status::separated &&
         run.result.reason == gjk::Reason::origin_not_crossed && !run.at(iteration).simplex &&
         run.at(iteration).crossing.verdict == gjk::Crossing::not_crossed;
}

// -- Where the origin lies, in exact numbers --------------------------------------------------------------------------

ExactVec vertex(const Iteration& at, Role role) { return exact(at.simplex->point(role)); }
ExactVecs corners(const Iteration& at, const std::string& roles) {
  ExactVecs points;
  for (const char role : roles) points.push_back(vertex(at, static_cast<Role>(role - 'A')));
  return points;
}

bool is_origin(const ExactVec& v) { return v == ExactVec(ExactVec::Zero()); }

/// Returns: whether the origin lies on the line, in the plane or in the space through `points`.
bool in_span(const ExactVecs& points) { return is_origin(gjk::test::toward_origin(points)); }

/// Returns: whether the origin, seen straight down, lies within the segment, triangle or tetrahedron, off its borders.
bool all_positive(const ExactVecs& points) {
  const auto coordinates = gjk::test::coordinates_of_origin(points);
  return std::ranges::all_of(coordinates, [](const Rational& c) { return c > 0; });
}

bool strictly_inside(const ExactVecs& points) { return in_span(points) && all_positive(points); }

/// Returns: the coordinate of `points[i]`: negative where the origin, seen straight down, lies beyond the feature opposite.
Rational coordinate(const ExactVecs& points, std::size_t i) { return gjk::test::coordinates_of_origin(points).at(i); }

/// The seven regions of Figure 7 are cut out by the lines through the edges: which coordinates are negative. `points`: A, B,
/// C. R1 is the triangle, an edge's region has the opposite corner negative, a corner's region both others.
std::string region_of_figure_7(const ExactVecs& points) {
  const auto c = gjk::test::coordinates_of_origin(points);
  std::string negative;
  for (std::size_t i = 0; i < 3; ++i) {
    if (c[i] == 0) return "on a line";
    if (c[i] < 0) negative += "ABC"[i];
  }
  const std::map<std::string, std::string> regions{{"", "R1"},  {"BC", "R2"}, {"C", "R3"}, {"AC", "R4"},
                                                   {"A", "R5"}, {"AB", "R6"}, {"B", "R7"}};
  return regions.at(negative);
}

/// The regions of Figure 6, the sides seen along the move from B to A: positive z is left.
std::string region_of_figure_6(const ExactVec& A, const ExactVec& B) {
  const Rational along_A = coordinate({A, B}, 0);
  if (along_A < 0) return "R1";
  if (along_A > 1) return "R2";
  const Rational left = (A - B).cross(ExactVec(-B)).z();
  return left > 0 ? "R3" : left < 0 ? "R4" : "on AB";
}

/// Returns: whether the origin lies across the face `roles` from the vertex `off`.
bool sees_origin(const Iteration& at, const std::string& roles, char off) {
  ExactVecs points = corners(at, roles + off);
  return coordinate(points, 3) < 0;
}

// -- The claims -------------------------------------------------------------------------------------------------------

bool never_looks_at_R2(const Run& run) {
  return std::ranges::none_of(run.iterations, [](const Iteration& i) {
    return std::ranges::any_of(i.regions,
                               [](const auto& r) { return r.label == "R2" && r.verdict != Verdict::skipped; });
  });
}

constexpr const char* left_B = "the search has just moved away from B, toward the origin";
constexpr const char* left_BC = "the search has just moved away from BC, toward the origin";
constexpr const char* left_BCD = "the search has just moved away from BCD, toward the origin";
constexpr const char* kept_BC = "ruled out when the search kept BC";
constexpr const char* kept_BCD = "ruled out when the search kept BCD";
constexpr const char* crossed = "were the origin beyond A, the move to A would not have reached it";

bool side_of_1_simplex(const Run& run, const std::string& side) {
  const Iteration& at = run.at(2);
  return told(at, 2, "AB", "R3 or R4", "", Verdict::chosen, Relation::not_zero) && at.direction &&
         at.direction->expression == "AB×AO×AB" && region_of_figure_6(vertex(at, Role::A), vertex(at, Role::B)) == side;
}

bool edge_of_2_simplex(const Run& run, const std::string& label, const std::string& feature) {
  const Iteration& at = run.at(3);
  const std::string newest_last{feature[1], 'A'};
  return told(at, 3, feature, label, "", Verdict::chosen) &&
         kept(at, newest_last, feature == "AB" ? "C" : "B", feature + "×AO×" + feature) &&
         region_of_figure_7(corners(at, "ABC")) == label;
}

bool inside_2_simplex(const Run& run, Relation side) {
  const Iteration& at = run.at(3);
  const ExactVecs ABC = corners(at, "ABC");
  const Rational height = (ABC[1] - ABC[0]).cross(ABC[2] - ABC[0]).dot(ExactVec(-ABC[0]));
  const bool right_side = side == Relation::positive   ? height > 0
                          : side == Relation::negative ? height < 0
                                                       : height == 0;
  return told(at, 3, "AB", "R3", "", Verdict::rejected) && told(at, 3, "AC", "R7", "", Verdict::rejected) &&
         told(at, 3, "ABC", "R1", "", Verdict::chosen, side) && right_side;
}

/// The features left behind by the last move: told as skipped, and the origin is not there.
bool left_behind_2_simplex(const Run& run, const std::string& feature, const std::string& label,
                           const std::string& neighbour) {
  const Iteration& at = run.at(3);
  return skipped(at, 3, feature, label, feature == "BC" ? left_BC : kept_BC) && coordinate(corners(at, "ABC"), 0) > 0 &&
         region_of_figure_7(corners(at, "ABC")) == neighbour;
}

/// Faces are tested in the order ABC, ACD, ADB: those before `face` do not see the origin.
bool face_of_3_simplex(const Iteration& at, const std::string& face) {
  for (const auto& [before, off] : {std::pair{"ABC", 'D'}, {"ACD", 'B'}, {"ADB", 'C'}}) {
    if (before == face) return told(at, 4, face, "", "", Verdict::chosen) && sees_origin(at, face, off);
    if (!told(at, 4, before, "", "", Verdict::rejected) || sees_origin(at, before, off)) return false;
  }
  return false;
}

bool whole_face(const Run& run, int iteration, const std::string& face, const std::string& order) {
  const Iteration& at = run.at(iteration);
  const std::string P = face.substr(1, 1), Q = face.substr(2, 1);
  return face_of_3_simplex(at, face) && told(at, 4, "A" + Q, "", face, Verdict::rejected) &&
         told(at, 4, "A" + P, "", face, Verdict::rejected) && all_positive(corners(at, face)) && at.reduction &&
         at.reduction->kept == order && at.direction && at.direction->expression == face + "n";
}

bool edge_of_face(const Run& run, int iteration, const std::string& face, const std::string& edge) {
  const Iteration& at = run.at(iteration);
  std::string dropped;
  for (const char role : std::string("ABCD"))
    if (edge.find(role) == std::string::npos) dropped.insert(dropped.begin(), role);
  const std::size_t third = face[1] == edge[1] ? 2 : 1;  // the corner of the face that is not on the edge
  return face_of_3_simplex(at, face) && told(at, 4, edge, "", face, Verdict::chosen) &&
         kept(at, std::string{edge[1], 'A'}, dropped, edge + "×AO×" + edge) &&
         coordinate(corners(at, face), third) < 0 && all_positive(corners(at, edge));
}

bool no_face_sees(const Iteration& at) {
  return told(at, 4, "ABC", "", "", Verdict::rejected) && told(at, 4, "ACD", "", "", Verdict::rejected) &&
         told(at, 4, "ADB", "", "", Verdict::rejected) && told(at, 4, "ABCD", "", "", Verdict::chosen);
}

bool all_eight_skipped(const Iteration& at) {
  for (const char* feature : {"B", "C", "D", "BC", "CD", "DB"})
    if (!skipped(at, 4, feature, "", kept_BCD)) return false;
  return skipped(at, 4, "BCD", "", left_BCD) && skipped(at, 4, "A", "", crossed);
}

/// What the name of a walkthrough promises.
struct Claim {
  int iterations;
  Status status;
  std::function<bool(const Run&)> visits;
};

const std::map<std::string, Claim>& claims() {
  constexpr Status yes = Status::intersecting, no = Status::separated;
  static const std::map<std::string, Claim> all{
      {"0-simplex-elsewhere",
       {2, no,
        [](const Run& r) {
          return told(r.at(1), 1, "A", "", "", Verdict::chosen, Relation::not_zero) &&
                 !is_origin(vertex(r.at(1), Role::A)) && r.at(1).direction->expression == "AO";
        }}},
      {"0-simplex-a-is-origin",
       {1, yes,
        [](const Run& r) {
          return told(r.at(1), 1, "A", "", "", Verdict::chosen, Relation::zero) &&
                 is_origin(vertex(r.at(1), Role::A)) && contained(r, 1);
        }}},
      {"1-simplex-r3", {3, yes, [](const Run& r) { return side_of_1_simplex(r, "R3"); }}},
      {"1-simplex-r4", {3, no, [](const Run& r) { return side_of_1_simplex(r, "R4"); }}},
      {"1-simplex-on-segment",
       {2, yes,
        [](const Run& r) {
          return told(r.at(2), 2, "AB", "", "", Verdict::chosen, Relation::zero) &&
                 strictly_inside(corners(r.at(2), "AB")) && contained(r, 2);
        }}},
      {"1-simplex-a-is-origin",
       {2, yes,
        [](const Run& r) {
          return told(r.at(2), 2, "AB", "", "", Verdict::chosen, Relation::zero) &&
                 is_origin(vertex(r.at(2), Role::A)) && contained(r, 2);
        }}},
      {"1-simplex-r1-cannot-happen",
       {3, yes,
        [](const Run& r) {
          const ExactVec B = vertex(r.at(2), Role::B), to_A = vertex(r.at(2), Role::A) - B;
          return skipped(r.at(2), 2, "B", "R1", left_B) &&
                 r.at(1).direction->direction == -r.at(1).simplex->point(Role::A) && to_A.dot(ExactVec(-B)) > 0;
        }}},
      {"1-simplex-r2-cannot-happen",
       {2, no,
        [](const Run& r) {
          return ended_by_crossing_test(r, 2) && never_looks_at_R2(r) &&
                 region_of_figure_6(exact(r.at(2).support.vertex.w), vertex(r.at(1), Role::A)) == "R2";
        }}},
      {"2-simplex-r3", {4, yes, [](const Run& r) { return edge_of_2_simplex(r, "R3", "AB"); }}},
      {"2-simplex-r7", {4, yes, [](const Run& r) { return edge_of_2_simplex(r, "R7", "AC"); }}},
      {"2-simplex-r1-above",
       {4, yes,
        [](const Run& r) {
          return inside_2_simplex(r, Relation::positive) && region_of_figure_7(corners(r.at(3), "ABC")) == "R1" &&
                 !r.at(3).reduction && r.at(3).direction->expression == "ABCn";
        }}},
      {"2-simplex-r1-below",
       {4, yes,
        [](const Run& r) {
          return inside_2_simplex(r, Relation::negative) && region_of_figure_7(corners(r.at(3), "ABC")) == "R1" &&
                 kept(r.at(3), "CAB", "", "−ABCn");
        }}},
      {"2-simplex-r1-in-plane",
       {3, yes,
        [](const Run& r) {
          return inside_2_simplex(r, Relation::zero) && strictly_inside(corners(r.at(3), "ABC")) && contained(r, 3);
        }}},
      {"2-simplex-on-edge",
       {3, yes,
        [](const Run& r) {
          return inside_2_simplex(r, Relation::zero) && value_of(r.at(3), "AB") == 0 && value_of(r.at(3), "AC") < 0 &&
                 strictly_inside(corners(r.at(3), "AB")) && contained(r, 3);
        }}},
      {"2-simplex-on-vertex",
       {3, yes,
        [](const Run& r) {
          return inside_2_simplex(r, Relation::zero) && is_origin(vertex(r.at(3), Role::A)) &&
                 value_of(r.at(3), "AB") == 0 && value_of(r.at(3), "AC") == 0 && contained(r, 3);
        }}},
      {"2-simplex-r2-cannot-happen",
       {3, no,
        [](const Run& r) {
          const Iteration& before = r.at(2);
          return ended_by_crossing_test(r, 3) && never_looks_at_R2(r) &&
                 region_of_figure_7(
                     {exact(r.at(3).support.vertex.w), vertex(before, Role::A), vertex(before, Role::B)}) == "R2";
        }}},
      {"2-simplex-r4-cannot-happen", {4, no, [](const Run& r) { return left_behind_2_simplex(r, "B", "R4", "R3"); }}},
      {"2-simplex-r5-cannot-happen", {3, yes, [](const Run& r) { return left_behind_2_simplex(r, "BC", "R5", "R1"); }}},
      {"2-simplex-r6-cannot-happen", {4, no, [](const Run& r) { return left_behind_2_simplex(r, "C", "R6", "R7"); }}},
      {"3-simplex-face-abc", {5, yes, [](const Run& r) { return whole_face(r, 4, "ABC", "CBA"); }}},
      {"3-simplex-face-abc-edge-ac", {5, no, [](const Run& r) { return edge_of_face(r, 4, "ABC", "AC"); }}},
      {"3-simplex-face-abc-edge-ab", {5, no, [](const Run& r) { return edge_of_face(r, 4, "ABC", "AB"); }}},
      {"3-simplex-face-acd", {5, no, [](const Run& r) { return whole_face(r, 4, "ACD", "DCA"); }}},
      {"3-simplex-face-acd-edge-ad", {5, no, [](const Run& r) { return edge_of_face(r, 4, "ACD", "AD"); }}},
      {"3-simplex-face-acd-edge-ac", {5, no, [](const Run& r) { return edge_of_face(r, 4, "ACD", "AC"); }}},
      {"3-simplex-face-adb", {5, no, [](const Run& r) { return whole_face(r, 4, "ADB", "BDA"); }}},
      {"3-simplex-face-adb-edge-ab", {5, no, [](const Run& r) { return edge_of_face(r, 4, "ADB", "AB"); }}},
      {"3-simplex-face-adb-edge-ad", {5, no, [](const Run& r) { return edge_of_face(r, 4, "ADB", "AD"); }}},
      {"3-simplex-inside",
       {4, yes,
        [](const Run& r) {
          return no_face_sees(r.at(4)) && strictly_inside(corners(r.at(4), "ABCD")) && contained(r, 4);
        }}},
      {"3-simplex-on-face",
       {4, yes,
        [](const Run& r) {
          return no_face_sees(r.at(4)) && value_of(r.at(4), "ACD") == 0 && value_of(r.at(4), "ABC") < 0 &&
                 value_of(r.at(4), "ADB") < 0 && strictly_inside(corners(r.at(4), "ACD")) && contained(r, 4);
        }}},
      {"3-simplex-in-plane-of-face",
       {5, no,
        [](const Run& r) {
          const ExactVecs ABC = corners(r.at(4), "ABC");
          return value_of(r.at(4), "ABC") == 0 && in_span(ABC) && !gjk::test::contain_origin(ABC) &&
                 face_of_3_simplex(r.at(4), "ACD");
        }}},
      {"3-simplex-a-is-origin",
       {4, yes,
        [](const Run& r) {
          return no_face_sees(r.at(4)) && is_origin(vertex(r.at(4), Role::A)) && value_of(r.at(4), "ABC") == 0 &&
                 value_of(r.at(4), "ACD") == 0 && value_of(r.at(4), "ADB") == 0 && contained(r, 4);
        }}},
      {"3-simplex-skipped-features", {4, yes, [](const Run& r) {
                                        return all_eight_skipped(r.at(4)) &&
                                               coordinate(corners(r.at(4), "ABCD"), 0) > 0 &&
                                               r.at(4).crossing.verdict == gjk::Crossing::crossed;
                                      }}}};
  return all;
}

const std::string folder = "regions/";

std::vector<const Walkthrough*> regions() { return find_walkthroughs("regions"); }

const Claim& claim_of(const Walkthrough& w) { return claims().at(w.name.substr(folder.size())); }

// -- What can be seen ---------------------------------------------------------------------------------------------------

/// The origin is a move away from BCD, above that triangle, and not farther along it than A. Little room is left there beyond
/// these three edges: an edge that leans over the triangle, of two faces of which one is nearly upright.
bool is_narrow(const Walkthrough& w) {
  return w.name.ends_with("acd-edge-ac") || w.name.ends_with("adb-edge-ab") || w.name.ends_with("adb-edge-ad");
}

int dimension_of(const Walkthrough& w) { return w.name.at(folder.size()) - '0'; }

double diameter(const std::vector<Point>& points) {
  double most = 0;
  for (const Point& p : points)
    for (const Point& q : points) most = std::max(most, (p - q).norm());
  return most;
}

/// Returns: the angle at `p`, in degrees.
double angle(const Point& p, const Point& q, const Point& r) {
  return std::atan2((q - p).cross(r - p).norm(), (q - p).dot(r - p)) * 180 / std::acos(-1.0);
}

/// Returns: the corners of the simplex of that dimension; where the crossing test has ended the run, of the one that it has
/// prevented.
std::vector<Point> simplex_shown(const Run& run, int dimension) {
  const Iteration& at = run.at(dimension + 1);
  const Simplex& simplex = at.simplex ? *at.simplex : run.result.simplex;
  std::vector<Point> points;
  for (int i = 0; i < simplex.size(); ++i) points.push_back(simplex[i].w);
  if (!at.simplex) points.push_back(at.support.vertex.w);
  return points;
}

ExactVecs corners_of(const Object& object) { return exact(vertices_of(object)); }

}  // namespace

TEST_CASE("The table of claims and the catalogue's folder of regions have the same names") {
  CHECK(regions().size() == claims().size());
  for (const Walkthrough* w : regions()) CHECK(claims().contains(w->name.substr(folder.size())));
  for (const auto& [name, claim] : claims()) CHECK(find_walkthrough(folder + name) != nullptr);
}

TEST_CASE("Every walkthrough of a region visits the region that its name claims") {
  for (const Walkthrough* w : regions()) {
    INFO(w->name);
    CHECK(claim_of(*w).visits(run_of(*w)));
  }
}

TEST_CASE("Walkthroughs of regions take the iterations and give the answer of the table") {
  for (const Walkthrough* w : regions()) {
    INFO(w->name);
    const Run run = run_of(*w);
    CHECK(run.result.iterations == claim_of(*w).iterations);
    CHECK(run.size() == claim_of(*w).iterations);
    CHECK(run.result.status == claim_of(*w).status);
  }
}

TEST_CASE("The answer of every walkthrough of a region follows from its objects alone") {
  for (const Walkthrough* w : regions()) {
    INFO(w->name);
    const Run run = run_of(*w);
    if (run.result.status == Status::intersecting) {
      ExactVecs last;
      for (int i = 0; i < run.result.simplex.size(); ++i) last.push_back(exact(run.result.simplex[i].w));
      CHECK(gjk::test::contain_origin(last));
    } else {
      const ExactVec d = exact(run.result.separation.value().direction);
      for (const ExactVec& a : corners_of(run.scene.a))
        for (const ExactVec& b : corners_of(run.scene.b)) CHECK((a - b).dot(d) < 0);
    }
  }
}

TEST_CASE("No simplex of a walkthrough of a region is forged: each vertex is a corner minus a corner") {
  for (const Walkthrough* w : regions()) {
    INFO(w->name);
    const Run run = run_of(*w);
    const std::vector<Point> of_a = vertices_of(run.scene.a), of_b = vertices_of(run.scene.b);
    for (const Iteration& iteration : run.iterations)
      for (int i = 0; iteration.simplex && i < iteration.simplex->size(); ++i) {
        const Vertex& v = (*iteration.simplex)[i];
        CHECK(of_a.at(static_cast<std::size_t>(v.a.index.value())) == v.a.point);
        CHECK(of_b.at(static_cast<std::size_t>(v.b.index.value())) == v.b.point);
        CHECK(v.w == v.a.point - v.b.point);
      }
  }
}

TEST_CASE("In a walkthrough of a region no other point is as far as the one that is found") {
  for (const Walkthrough* w : regions()) {
    INFO(w->name);
    const Run run = run_of(*w);
    for (const Iteration& iteration : run.iterations) {
      const ExactVec d = exact(iteration.support.direction);
      const Rational farthest = exact(iteration.support.vertex.w).dot(d);
      int as_far = 0;
      for (const ExactVec& a : corners_of(run.scene.a))
        for (const ExactVec& b : corners_of(run.scene.b)) {
          CHECK((a - b).dot(d) <= farthest);
          as_far += (a - b).dot(d) == farthest;
        }
      CHECK(as_far == 1);
    }
  }
}

TEST_CASE("Every point of the objects in walkthroughs of regions is a corner") {
  for (const Walkthrough* w : regions())
    for (const Object* object : {&w->scenes[0].a, &w->scenes[0].b}) {
      INFO(w->name << ", " << object->name);
      const ExactVecs points = corners_of(*object);
      CHECK(points.size() >= 3);
      for (const ExactVec& p : points) {
        ExactVecs others;
        for (const ExactVec& q : points)
          if (q != p) others.push_back(q - p);
        CHECK(others.size() + 1 == points.size());
        CHECK_FALSE(gjk::test::contain_origin(others));
      }
    }
}

TEST_CASE("The simplex that a walkthrough of a region is about is easy to see") {
  for (const Walkthrough* w : regions()) {
    INFO(w->name);
    const std::vector<Point> corners = simplex_shown(run_of(*w), dimension_of(*w));
    for (const Point& p : corners)
      for (const Point& q : corners)
        if (&p != &q) CHECK((p - q).norm() >= 0.2 * diameter(corners));
    for (const Point& p : corners)
      for (const Point& q : corners)
        for (const Point& r : corners)
          if (&p != &q && &q != &r && &r != &p) CHECK(angle(p, q, r) >= (is_narrow(*w) ? 15 : 20));
  }
}

TEST_CASE("In walkthroughs of regions the origin is plainly on one side of whatever it is not on") {
  for (const Walkthrough* w : regions()) {
    INFO(w->name);
    const Run run = run_of(*w);
    const int decision = dimension_of(*w) + 1;
    if (!run.at(decision).simplex) continue;
    const double size = diameter(simplex_shown(run, dimension_of(*w)));
    for (const auto& region : run.at(decision).regions)
      if (const double* value = std::get_if<double>(&region.value); value && *value != 0)
        CHECK(std::abs(*value) / region.normal.value().norm() >= (is_narrow(*w) ? 0.014 : 0.08) * size);
  }
}

TEST_CASE("Objects of planar walkthroughs of regions lie in the plane z = 0 and the others do not") {
  for (const Walkthrough* w : regions()) {
    INFO(w->name);
    bool flat = true;
    for (const Object* object : {&w->scenes[0].a, &w->scenes[0].b})
      for (const Point& p : vertices_of(*object)) flat = flat && p.z() == 0;
    CHECK(flat == (w->scenes[0].dimension == Dimension::plane));
  }
}

TEST_CASE("Walkthroughs of regions have small integers and two names and the default options") {
  for (const Walkthrough* w : regions()) {
    INFO(w->name);
    const Scene& scene = w->scenes.at(0);
    CHECK(scene.a.name != scene.b.name);
    for (const Object* object : {&scene.a, &scene.b})
      for (const Point& p : vertices_of(*object))
        for (const double x : {p.x(), p.y(), p.z()}) {
          CHECK(x == std::round(x));
          CHECK(std::abs(x) <= 5);
        }
    CHECK(scene.options.first_direction == Point(1, 0, 0));
    CHECK(scene.options.crossing_test == gjk::CrossingTest::on);
    CHECK(scene.rules == RuleSet::as_intended);
  }
}

TEST_CASE("Each remark in a walkthrough of a region is about something that happens in it") {
  using At = Remark::At;
  for (const Walkthrough* w : regions()) {
    const Run run = run_of(*w);
    CHECK_FALSE(w->remarks.empty());
    for (const Remark& remark : w->remarks) {
      INFO(w->name << ": " << remark.text);
      REQUIRE(remark.iteration <= run.size());
      const Iteration& at = run.at(remark.iteration);
      const auto about = [&](const auto& r) {
        return r.verdict != Verdict::skipped &&
               (r.label.empty() ? (r.face.empty() ? r.feature : r.face + " " + r.feature) : r.label) == remark.only_for;
      };
      switch (remark.at) {
        case At::support_found: break;
        case At::crossing_tested: CHECK(at.crossing.value.has_value()); break;
        case At::region_tested: CHECK(std::ranges::count_if(at.regions, about) == 1); break;
        case At::reduced: CHECK(at.reduction.has_value()); break;
        case At::direction_chosen: CHECK(at.direction.has_value()); break;
        case At::end: CHECK(remark.iteration == run.size()); break;
      }
      CHECK_FALSE(remark.text.empty());
      CHECK_FALSE(remark.text.ends_with('.'));
      CHECK(remark.text.find(';') == std::string::npos);
    }
  }
}

TEST_CASE("Title, source and region of a walkthrough of a region name the same simplex and section") {
  for (const Walkthrough* w : regions()) {
    INFO(w->name);
    const int n = w->name.at(folder.size()) - '0';
    const std::string section = "3.2." + std::to_string(n + 1);
    CHECK(w->title.starts_with(std::to_string(n) + "-simplex: "));
    CHECK(w->source == "ARL-TR-7474, Section " + section);
    REQUIRE(w->region_case);
    CHECK(w->region_case->section == section);
    CHECK_FALSE(w->region_case->text.empty());
    CHECK(w->naming == Naming::roles);
    CHECK(w->layout == Layout::search);
  }
}
