// Walkthroughs of wrong and undecided answers: that they are, in which operation, and that their remarks are true.
#include <bit>
#include <cstdint>

#include "tests/core/oracle.hpp"
#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/story/stories.hpp"
#include "tests/walkthroughs/trace/traces.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/story/exact.hpp"
#include "walkthroughs/story/storyboard.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
using gjk::test::exact;
using gjk::test::ExactVecs;

namespace {

/// By linear equations in fractions, which share nothing with the search.
gjk::Status truth_about(const Scene& scene) {
  ExactVecs differences;
  for (const Point& a : vertices_of(scene.a))
    for (const Point& b : vertices_of(scene.b)) differences.push_back(exact(a) - exact(b));
  return gjk::test::contain_origin(differences) ? gjk::Status::intersecting : gjk::Status::separated;
}

gjk::Status answer_of(const Scene& scene) { return all<gjk::Finished>(run(scene)).at(0).result.status; }

/// Returns: the frame with that mark, which is the only one but for the last.
const Frame& wrong_turn_in(const Story& story) {
  std::vector<const Frame*> found;
  for (const Frame& frame : story.frames)
    for (const Fact& fact : frame.facts)
      if (fact.mark == Fact::Mark::truth) found.push_back(&frame);
  REQUIRE(found.size() == 2);
  CHECK(found[1] == &story.frames.back());
  return *found[0];
}

std::string truth_in(const Frame& frame) {
  const auto found = std::ranges::find(frame.facts, Fact::Mark::truth, &Fact::mark);
  REQUIRE(found != frame.facts.end());
  return plain(found->text);
}

}  // namespace

TEST_CASE("There are five failures, and each answer is wrong or undecided") {
  CHECK(find_walkthroughs("failures").size() == 5);
  for (const Walkthrough* w : find_walkthroughs("failures")) {
    INFO(w->name);
    CHECK(answer_of(w->scenes[0]) != truth_about(w->scenes[0]));
  }
}

TEST_CASE("False positives, false negatives and undecided answers are all among the failures") {
  const auto answer = [](const char* name) { return answer_of(walkthrough(name).scenes[0]); };
  CHECK(answer("failures/vanished-product") == gjk::Status::intersecting);
  CHECK(answer("failures/overflowed-product") == gjk::Status::undecided);
  CHECK(answer("failures/beyond-an-edge") == gjk::Status::undecided);
  CHECK(answer("failures/coplanar-askew") == gjk::Status::separated);
  CHECK(answer("failures/far-from-the-origin") == gjk::Status::separated);
}

TEST_CASE("Exact arithmetic answers rightly where floating point fails") {
  for (const Walkthrough* w : find_walkthroughs("failures"))
    CHECK(exact_answer(w->scenes[0]) == truth_about(w->scenes[0]));
}

TEST_CASE("Each failure comes from another operation, and a frame says what exact arithmetic finds there") {
  const std::vector<std::pair<std::string, std::string>> operations = {
      {"vanished-product", "in exact arithmetic: P·d = −"},
      {"overflowed-product", "in exact arithmetic: AB×AO×AB = ("},
      {"beyond-an-edge", "in exact arithmetic: ABn·AO = 0"},
      {"coplanar-askew", "in exact arithmetic: ABCn·AO = 0"},
      {"far-from-the-origin", "in exact arithmetic: P·d = −15, but (4, −8)·d = 128"}};
  for (const auto& [name, said] : operations) {
    INFO(name);
    const Story story = tell(walkthrough("failures/" + name));
    CHECK(truth_in(wrong_turn_in(story)).starts_with(said));
  }
}

TEST_CASE("Until the frame with the remark exact arithmetic decides the same") {
  const std::vector<std::pair<std::string, Focus>> places = {{"vanished-product", Focus::crossing},
                                                             {"overflowed-product", Focus::direction},
                                                             {"beyond-an-edge", Focus::region},
                                                             {"coplanar-askew", Focus::region},
                                                             {"far-from-the-origin", Focus::support}};
  for (const auto& [name, focus] : places) {
    INFO(name);
    const Story story = tell(walkthrough("failures/" + name));
    CHECK(wrong_turn_in(story).focus == focus);
  }
}

TEST_CASE("The last frame says what is true") {
  for (const Walkthrough* w : find_walkthroughs("failures")) {
    INFO(w->name);
    const Story story = tell(*w);
    const bool meet = truth_about(w->scenes[0]) == gjk::Status::intersecting;
    CHECK(truth_in(story.frames.back()).starts_with(meet ? "in truth both objects hold" : "in truth the objects are"));
  }
}

TEST_CASE("A search that exact arithmetic decides alike has no wrong turn") {
  const Scene& scene = walkthrough("figure-4-left").scenes[0];
  CHECK_THROWS_AS(remarks_on({"cause", "truth"}, scene, run(scene)), std::logic_error);
}

TEST_CASE("Exact numbers that no double holds are written as the others") {
  const Scene scene = walkthrough_of({{1e-170, 0, 0}}).scenes[0];
  CHECK(remarks_on({"cause", "truth"}, scene, run(scene)).at(0).fact == "in exact arithmetic: P·d = −1e−340");
}

TEST_CASE("The relative zero test mends the failures that come from rounding, not those of range") {
  const auto answer = [](const char* name) {
    Scene scene = walkthrough(name).scenes[0];
    scene.zero_test = ZeroTest::relative;
    return answer_of(scene);
  };
  CHECK(answer("failures/coplanar-askew") == gjk::Status::intersecting);
  CHECK(answer("failures/beyond-an-edge") == gjk::Status::intersecting);
  CHECK(answer("failures/overflowed-product") == gjk::Status::undecided);
}

TEST_CASE("Doubles decide rightly where floats fail") {
  for (const Walkthrough* w : find_walkthroughs("failures")) {
    INFO(w->name);
    Scene scene = w->scenes[0];
    scene.scalar = Scalar::binary64;
    CHECK(answer_of(scene) == truth_about(scene));
  }
}

// -- Scalars and zero tests -------------------------------------------------------------------------------------------

TEST_CASE("A scene in float consists of floats, and so does every number of its search") {
  const auto is_float = [](double x) {
    return std::bit_cast<std::uint64_t>(x) % (1 << 29) == 0;
  };  // of 52 digits 23 count
  for (const char* name : {"figure-4-left", "vehicle-and-threat/counter-munition-hit"}) {
    const Scene scene = in_float(walkthrough(name).scenes[0]);
    CHECK(scene.scalar == Scalar::binary32);
    for (const auto& found : all<gjk::SupportFound>(run(scene))) {
      for (const Point& p : {found.direction, found.vertex.w, found.vertex.a.point, found.vertex.b.point})
        CHECK((is_float(p.x()) && is_float(p.y()) && is_float(p.z())));
    }
  }
}

TEST_CASE("A number that no float holds, or a length that vanishes, is named") {
  Scene scene = walkthrough("as-printed-spheres").scenes[0];
  scene.b.form = Ball{{1e39, 0, 0}, 1};
  CHECK_THROWS_WITH(in_float(scene), "1e+39 is beyond all floats");
  scene.b.form = Ball{{1, 0, 0}, 1e-50};
  CHECK_THROWS_WITH(in_float(scene), "1e-50 is too small for a float and becomes 0");
}

TEST_CASE("Traces in float and with the relative zero test are read back whole") {
  for (const Walkthrough* w : searches())
    for (const ZeroTest zero_test : {ZeroTest::exact, ZeroTest::relative})
      for (const Scalar scalar : {Scalar::binary64, Scalar::binary32}) {
        Walkthrough changed = *w;
        changed.findings = {};
        for (Scene& scene : changed.scenes) {
          if (scalar == Scalar::binary32) scene = in_float(scene);
          scene.zero_test = zero_test;
        }
        if (changed.close_up || changed.layout == Layout::until_they_part) continue;
        INFO(w->name << (scalar == Scalar::binary32 ? " in float" : " in double")
                     << (zero_test == ZeroTest::relative ? ", relative" : ", exact"));
        CHECK(complaint_about_trace(trace_text(changed)) == "read");
      }
}

TEST_CASE("A trace says its scalar and zero test, where they are not the usual ones, and is retold with them") {
  Walkthrough w = walkthrough("failures/coplanar-askew");
  w.scenes[0].zero_test = ZeroTest::relative;
  w.findings = {};
  const std::string text = trace_text(w);
  const auto header = json_lines(text).at(0);
  CHECK(header.at("version") == 2);
  CHECK(header.at("scenes").at(0).at("scalar") == "float");
  CHECK(header.at("scenes").at(0).at("zero_test") == "relative");
  const TraceFile read = parse_trace(text, "trace.jsonl");
  CHECK(read.walkthrough.scenes[0].scalar == Scalar::binary32);
  CHECK(read.walkthrough.scenes[0].zero_test == ZeroTest::relative);
  const auto usual = json_lines(trace_text(walkthrough("figure-4-left"))).at(0);
  CHECK_FALSE(usual.at("scenes").at(0).contains("scalar"));
  CHECK_FALSE(usual.at("scenes").at(0).contains("zero_test"));
}

TEST_CASE("A search in float that is passed off as one in double is refused, and the other way round") {
  auto lines = json_lines(trace_text(walkthrough("failures/coplanar-askew")));
  lines[0].at("scenes").at(0)["scalar"] = "double";
  CHECK(complaint_about_trace(text_of(lines)) != "read");
}

TEST_CASE("A verdict that only the relative zero test gives is refused where the test is exact") {
  Walkthrough w = walkthrough("failures/coplanar-askew");
  w.scenes[0].zero_test = ZeroTest::relative;
  w.findings = {};
  auto lines = json_lines(trace_text(w));
  CHECK(complaint_about_trace(text_of(lines)) == "read");
  lines[0].at("scenes").at(0).erase("zero_test");
  CHECK(complaint_about_trace(text_of(lines)) != "read");
}

TEST_CASE("A product that only counts as zero is told as what it is") {
  Walkthrough w = walkthrough("failures/coplanar-askew");
  w.scenes[0].zero_test = ZeroTest::relative;
  w.findings = {};
  const Story story = tell(w);
  const auto says = [](const Fact& fact) { return plain(fact.text) == "R1: ABCn·AO = −4, which counts as 0"; };
  CHECK(std::ranges::any_of(story.frames.back().facts, says));
}
