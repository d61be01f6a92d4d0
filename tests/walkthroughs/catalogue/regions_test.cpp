// The region catalogue: every walkthrough regions/… really visits the region that its name claims (Section 3.2). Whatever a
// walkthrough says of itself is ignored; the traces are asked, and the geometry is worked out anew, by linear equations. All
// coordinates are small whole numbers: what is not zero is far larger than rounding.

#include <map>
#include <optional>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/catalogue/nearest_feature.hpp"
#include "tests/walkthroughs/support.hpp"

using namespace walkthroughs;
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
    text += (text.empty() ? "" : ", ") + (r.face.empty() ? "" : r.face + " ") + r.feature +
            (r.verdict == Verdict::rejected ? " no" : relations.at(r.relation));
  }
  if (at.reduction) text += ": keep " + at.reduction->kept;
  if (at.direction) text += (at.reduction ? ", d = " : ": d = ") + at.direction->expression;
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
      for (const char role : r.feature) face.push_back(corners.at(static_cast<std::size_t>(role - 'A')));
      return r.feature + " " + signs(face);
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

/// Returns: whether the origin is in the hull: then it is in that of four of the points, or of fewer.
bool hold_origin(const std::vector<Point>& points) {
  for (unsigned chosen = 1; chosen < 1u << points.size(); ++chosen) {
    std::vector<Point> some;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (chosen >> i & 1) some.push_back(points[i]);
    if (some.size() > 4) continue;
    const Footpoint foot = footpoint(some, Point::Zero());
    if (is_zero(foot.at.norm()) && std::ranges::all_of(foot.weights, [](double w) { return w > -1e-9; })) return true;
  }
  return false;
}

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

TEST_CASE("What cannot happen is skipped in the walkthroughs of regions, and the origin is never there") {
  for (const Walkthrough* w : regions()) {
    INFO(w->name);
    const Run run = run_of(*w);
    for (const Iteration& at : run.iterations) {
      if (!at.simplex) continue;
      const std::string nearest = nearest_feature(*at.simplex, Point::Zero());
      for (const auto& region : at.regions) {
        std::string feature = region.feature;
        std::ranges::sort(feature);
        CHECK((region.verdict != Verdict::skipped || feature != nearest));
        CHECK((region.verdict == Verdict::skipped || region.label != "R2"));  // what the crossing test rules out
      }
    }
    const auto& of_simplex = run.at(dimension_of(*w) + 1).regions;
    const auto skipped = std::ranges::count(of_simplex, Verdict::skipped, &gjk::RegionTested<double>::verdict);
    if (w->name.ends_with("skipped-features")) CHECK(skipped == 8);
    if (!w->name.ends_with("-cannot-happen") || of_simplex.empty()) continue;
    const std::string label = "R" + w->name.substr(std::string("regions/n-simplex-r").size(), 1);
    const auto named = std::ranges::find(of_simplex, label, &gjk::RegionTested<double>::label);
    REQUIRE(named != of_simplex.end());
    CHECK(named->verdict == Verdict::skipped);
  }
}

TEST_CASE("The answer of every walkthrough of a region follows from its objects alone") {
  for (const Walkthrough* w : regions()) {
    INFO(w->name);
    const Run run = run_of(*w);
    if (run.result.status == Status::intersecting) {
      CHECK(hold_origin(corners_at(run, run.size())));
      continue;
    }
    const Point d = run.result.separation.value().direction;
    for (const Point& a : vertices_of(run.scene.a))
      for (const Point& b : vertices_of(run.scene.b)) CHECK((a - b).dot(d) < 0);
  }
}

TEST_CASE("In a walkthrough of a region no other point is as far as the one that is found") {
  for (const Walkthrough* w : regions()) {
    INFO(w->name);
    const Run run = run_of(*w);
    for (const Iteration& iteration : run.iterations) {
      const Point d = iteration.support.direction, found = iteration.support.vertex.w;
      for (const Point& a : vertices_of(run.scene.a))
        for (const Point& b : vertices_of(run.scene.b)) CHECK((a - b == found || (a - b).dot(d) < found.dot(d)));
    }
  }
}

TEST_CASE(
    "Objects of walkthroughs of regions have small whole corners, no other points, two names and default options") {
  for (const Walkthrough* w : regions()) {
    const Scene& scene = w->scenes.at(0);
    bool is_flat = true;
    for (const Object* object : {&scene.a, &scene.b}) {
      INFO(w->name << ", " << object->name);
      const std::vector<Point> points = vertices_of(*object);
      CHECK(points.size() >= 3);
      for (const Point& p : points) {
        for (const double x : p) CHECK((x == std::round(x) && std::abs(x) <= 5));
        is_flat = is_flat && p.z() == 0;
        std::vector<Point> others;
        for (const Point& q : points)
          if (q != p) others.push_back(q - p);
        CHECK(others.size() + 1 == points.size());
        CHECK_FALSE(hold_origin(others));
      }
    }
    INFO(w->name);
    CHECK(is_flat == (scene.dimension == Dimension::plane));
    CHECK(scene.a.name != scene.b.name);
    CHECK(scene.options.first_direction == Point(1, 0, 0));
    CHECK(scene.options.crossing_test == gjk::CrossingTest::on);
    CHECK(scene.rules == RuleSet::as_intended);
  }
}

TEST_CASE(
    "The simplex that a walkthrough of a region is about is easy to see, the origin plainly on one side or on it") {
  for (const Walkthrough* w : regions()) {
    INFO(w->name);
    const Run run = run_of(*w);
    const int decision = dimension_of(*w) + 1;
    const std::vector<Point> corners = corners_at(run, decision);
    const double size = diameter(corners);
    for (const Point& p : corners)
      for (const Point& q : corners) {
        if (&p == &q) continue;
        CHECK((p - q).norm() >= 0.2 * size);
        for (const Point& r : corners)
          if (&q != &r && &r != &p) CHECK(angle(p, q, r) >= (is_narrow(*w) ? 15 : 20));
      }
    for (const auto& region : run.at(decision).regions)
      if (const double* value = std::get_if<double>(&region.value); value && *value != 0)
        CHECK(std::abs(*value) / region.normal.value().norm() >= (is_narrow(*w) ? 0.014 : 0.08) * size);
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
