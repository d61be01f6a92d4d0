// The region catalogue: every walkthrough regions/… really visits the region that its name claims (Section 3.2). Whatever a
// walkthrough says of itself is ignored; the traces are asked, and the geometry is worked out anew, by linear equations. All
// coordinates are small whole numbers: what is not zero is far larger than rounding.

#include <map>
#include <optional>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/catalogue/nearest_feature.hpp"
#include "tests/walkthroughs/support.hpp"

namespace regions_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;
using gjk::Relation;
using gjk::Role;
using gjk::Status;
using gjk::Verdict;

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
  for (const auto& event : walkthroughs::model::run(run.scene).events) {
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

/// Returns: what was tested and decided, what is kept of the simplex, and the next direction:
/// "ABC no, ACD > 0, ACD AD > 0: keep DA, d = AD×AO×AD".
std::string decided(const Iteration& at) {
  std::string text = at.simplex ? "" : "not crossed";
  for (const auto& r : at.regions) {
    if (r.verdict == Verdict::skipped) continue;
    const std::map<Relation, std::string> relations{{Relation::positive, " > 0"},
                                                    {Relation::negative, " < 0"},
                                                    {Relation::zero, " = 0"},
                                                    {Relation::not_zero, " ≠ 0"}};
    text += (text.empty() ? "" : ", ") + (r.face.empty() ? "" : to_string(r.face) + " ") + to_string(r.feature) +
            (r.verdict == Verdict::rejected ? " no" : relations.at(r.relation));
  }
  if (at.reduction) text += ": keep " + to_string(at.reduction->kept);
  if (at.direction) text += (at.reduction ? ", d = " : ": d = ") + to_string(at.direction->expression);
  return text;
}

// -- Where the origin lies --------------------------------------------------------------------------------------------

/// Returns: the corners of the simplex in the order of roles, A first; where the crossing test has ended the run, of the one
/// that it has prevented.
std::vector<Point> corners_at(const Run& run, int iteration) {
  const Iteration& at = run.at(iteration);
  std::vector<Point> points;
  if (!at.simplex) points.push_back(at.support.vertex.w);
  const Simplex& simplex = at.simplex ? *at.simplex : run.result.simplex;
  for (int i = 0; i < simplex.size(); ++i) points.push_back(simplex.point(static_cast<Role>(i)));
  return points;
}

bool is_zero(double x) { return std::abs(x) < 1e-9; }

/// Returns: a sign for each corner, of its weight in the place nearest to the origin. "++-": the origin lies beyond AB.
std::string signs(const std::vector<Point>& corners) {
  std::string text;
  for (const double weight : footpoint(corners, Point::Zero()).weights)
    text += is_zero(weight) ? '0' : weight < 0 ? '-' : '+';
  return text;
}

/// Returns: the signs, and on which side of segment (seen from B to A) or triangle (from where its normal points) it lies;
/// "level" where it lies at the point, on the line or in the plane.
std::string place_of_origin(const std::vector<Point>& corners) {
  const Point O = Point::Zero(), A = corners[0];
  if (corners.size() == 4) return signs(corners);
  if (is_zero(footpoint(corners, O).at.norm())) return signs(corners) + " level";
  if (corners.size() == 2) return signs(corners) + ((A - corners[1]).cross(O - A).z() > 0 ? " left" : " right");
  if (corners.size() == 1) return signs(corners);
  return signs(corners) + ((corners[1] - A).cross(corners[2] - A).dot(O - A) > 0 ? " above" : " below");
}

/// Returns: the signs in the face that was chosen at a tetrahedron; nothing where none was.
std::string signs_in_face(const Run& run, int iteration) {
  const std::vector<Point> corners = corners_at(run, iteration);
  for (const auto& r : run.at(iteration).regions)
    if (r.simplex_size == 4 && r.face.empty() && r.verdict == Verdict::chosen && r.feature.size() == 3) {
      std::vector<Point> face;
      for (const gjk::Role role : r.feature) face.push_back(corners.at(static_cast<std::size_t>(role)));
      return to_string(r.feature) + " " + signs(face);
    }
  return "";
}

// -- The claims -------------------------------------------------------------------------------------------------------

/// What the name of a walkthrough promises of the iteration with its simplex: a test that says so, and where the origin lies.
struct Claim {
  std::string name, decided, place, in_face = "";
};

const std::vector<Claim> claims = {
    {"0-simplex-elsewhere", "A ≠ 0: d = AO", "+"},
    {"0-simplex-a-is-origin", "A = 0", "+ level"},
    {"1-simplex-r3", "AB ≠ 0: d = AB×AO×AB", "++ left"},
    {"1-simplex-r4", "AB ≠ 0: d = AB×AO×AB", "++ right"},
    {"1-simplex-on-segment", "AB = 0", "++ level"},
    {"1-simplex-a-is-origin", "AB = 0", "+0 level"},
    {"1-simplex-r1-cannot-happen", "AB ≠ 0: d = AB×AO×AB", "++ right"},
    {"1-simplex-r2-cannot-happen", "not crossed", "+- left"},
    {"2-simplex-r3", "AB > 0: keep BA, d = AB×AO×AB", "++- level"},
    {"2-simplex-r7", "AB no, AC > 0: keep CA, d = AC×AO×AC", "+-+ level"},
    {"2-simplex-r1-above", "AB no, AC no, ABC > 0: d = ABCn", "+++ above"},
    {"2-simplex-r1-below", "AB no, AC no, ABC < 0: keep CAB, d = −ABCn", "+++ below"},
    {"2-simplex-r1-in-plane", "AB no, AC no, ABC = 0", "+++ level"},
    {"2-simplex-on-edge", "AB no, AC no, ABC = 0", "++0 level"},
    {"2-simplex-on-vertex", "AB no, AC no, ABC = 0", "+00 level"},
    {"2-simplex-r2-cannot-happen", "not crossed", "+-- level"},
    {"2-simplex-r4-cannot-happen", "AB > 0: keep BA, d = AB×AO×AB", "++- level"},
    {"2-simplex-r5-cannot-happen", "AB no, AC no, ABC = 0", "+++ level"},
    {"2-simplex-r6-cannot-happen", "AB no, AC > 0: keep CA, d = AC×AO×AC", "+-+ level"},
    {"3-simplex-face-abc", "ABC > 0, ABC AC no, ABC AB no: keep CBA, d = ABCn", "+++-", "ABC +++"},
    {"3-simplex-face-abc-edge-ac", "ABC > 0, ABC AC > 0: keep CA, d = AC×AO×AC", "+-+-", "ABC +-+"},
    {"3-simplex-face-abc-edge-ab", "ABC > 0, ABC AC no, ABC AB > 0: keep BA, d = AB×AO×AB", "++--", "ABC ++-"},
    {"3-simplex-face-acd", "ABC no, ACD > 0, ACD AD no, ACD AC no: keep DCA, d = ACDn", "+-++", "ACD +++"},
    {"3-simplex-face-acd-edge-ad", "ABC no, ACD > 0, ACD AD > 0: keep DA, d = AD×AO×AD", "+--+", "ACD +-+"},
    {"3-simplex-face-acd-edge-ac", "ABC no, ACD > 0, ACD AD no, ACD AC > 0: keep CA, d = AC×AO×AC", "+-++", "ACD ++-"},
    {"3-simplex-face-adb", "ABC no, ACD no, ADB > 0, ADB AB no, ADB AD no: keep BDA, d = ADBn", "++-+", "ADB +++"},
    {"3-simplex-face-adb-edge-ab", "ABC no, ACD no, ADB > 0, ADB AB > 0: keep BA, d = AB×AO×AB", "++-+", "ADB +-+"},
    {"3-simplex-face-adb-edge-ad", "ABC no, ACD no, ADB > 0, ADB AB no, ADB AD > 0: keep DA, d = AD×AO×AD", "++-+",
     "ADB ++-"},
    {"3-simplex-inside", "ABC no, ACD no, ADB no, ABCD > 0", "++++"},
    {"3-simplex-on-face", "ABC no, ACD no, ADB no, ABCD > 0", "+0++"},
    {"3-simplex-in-plane-of-face", "ABC no, ACD > 0, ACD AD no, ACD AC no: keep DCA, d = ACDn", "+-+0", "ACD +++"},
    {"3-simplex-a-is-origin", "ABC no, ACD no, ADB no, ABCD > 0", "+000"},
    {"3-simplex-skipped-features", "ABC no, ACD no, ADB no, ABCD > 0", "++++"}};

const std::string folder = "regions/";

std::vector<const Walkthrough*> regions() { return find_walkthroughs("regions"); }

int dimension_of(const Walkthrough& w) { return w.name.at(folder.size()) - '0'; }

}  // namespace

TEST_CASE("Every walkthrough of a region visits the region that its name claims") {
  REQUIRE(regions().size() == claims.size());
  for (std::size_t i = 0; i < claims.size(); ++i) {
    const Walkthrough& w = *regions()[i];
    INFO(w.name);
    const Run run = run_of(w);
    const int n = dimension_of(w) + 1;
    CHECK(w.name == folder + claims[i].name);
    CHECK(decided(run.at(n)) == claims[i].decided);
    CHECK(place_of_origin(corners_at(run, n)) == claims[i].place);
    CHECK(signs_in_face(run, n) == claims[i].in_face);
  }
}

}  // namespace regions_test
