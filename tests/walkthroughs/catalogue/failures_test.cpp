// Walkthroughs of wrong and undecided answers: that they are, in which operation, and that their remarks are true.
#include <bit>
#include <cstdint>
#include <sstream>

#include "tests/kit/catch.hpp"
#include "tests/kit/text.hpp"
#include "tests/walkthroughs/truth_about.hpp"
#include "walkthroughs/model/truth.hpp"
#include "walkthroughs/story/rounding.hpp"
#include "walkthroughs/trace/trace_file.hpp"
#include "walkthroughs/trace/trace_json.hpp"

namespace failures_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;
using gjk::Status;

namespace {

Status answer_of(const Scene& scene) { return all<gjk::Finished>(run(scene)).at(0).result.status; }

/// Returns: what exact arithmetic says in that frame; nothing where it does not speak up.
std::string truth_in(const Frame& frame) {
  const auto found = std::ranges::find(frame.facts, Fact::Mark::truth, &Fact::mark);
  return found == frame.facts.end() ? "" : plain(found->text);
}

/// A search of floats that the exact zero test leads astray, by the relative one.
Walkthrough with_relative_test() {
  Walkthrough w = walkthrough("failures/coplanar-askew");
  w.scenes[0].zero_test = ZeroTest::relative;
  w.remarks = {};
  return w;
}

std::string trace_text(const Walkthrough& w) {
  std::ostringstream out;
  write_traces(out, w);
  return out.str();
}

/// The text with `from`, which is in it, replaced.
std::string changed(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

/// What one of the five failures answers, where it goes wrong, and what exact arithmetic finds there.
struct Failure {
  std::string name;
  Status answer;
  Focus place;
  std::string said;
};

}  // namespace

TEST_CASE("Each failure comes from another operation, which a frame tells, and the last frame says what is true") {
  const Failure failures[] = {
      {"vanished-product", Status::intersecting, Focus::crossing, "P·d = −"},
      {"overflowed-product", Status::undecided, Focus::direction, "(AB×AO)×AB = ("},
      {"beyond-an-edge", Status::undecided, Focus::region, "ABn·AO = 0"},
      {"coplanar-askew", Status::separated, Focus::region, "ABCn·AO = 0"},
      {"far-from-the-origin", Status::separated, Focus::support, "P·d = −15, but (4, −8)·d = 128"}};
  CHECK(find_walkthroughs("failures").size() == std::size(failures));
  for (const auto& [name, answer, place, said] : failures) {
    INFO(name);
    const Scene& scene = walkthrough("failures/" + name).scenes[0];
    const Status truth = truth_about(scene);
    CHECK(answer_of(scene) == answer);
    CHECK(answer != truth);
    CHECK(exact_answer(scene.a, scene.b).status == truth);
    std::vector<Frame> frames = tell(walkthrough("failures/" + name)).frames;
    std::erase_if(frames, [](const Frame& frame) { return truth_in(frame).empty(); });
    REQUIRE(frames.size() >= 2);
    CHECK(frames[0].focus == place);
    CHECK(truth_in(frames[0]).starts_with("in exact arithmetic: " + said));
    const Remark& cause = walkthrough("failures/" + name).remarks.at(0);
    CHECK(cause.contradicts);
    CHECK(kit::has(plain(frames[0].caption), as_sentence(cause.text)));
    CHECK(frames.back().focus == Focus::end);
    const bool meet = truth == Status::intersecting;
    CHECK(truth_in(frames.back()).starts_with(meet ? "in truth both objects hold" : "in truth a − b is nearest to"));
  }
}

TEST_CASE("A search that exact arithmetic decides alike tells nothing of it") {
  const Story story = tell(walkthrough("figure-4-left"));
  CHECK(std::ranges::all_of(story.frames, [](const Frame& frame) { return truth_in(frame).empty(); }));
}

TEST_CASE("Exact numbers that no double holds are written as the others") {
  Walkthrough w = walkthrough_of({{1e-170, 0, 0}});
  w.naming = Naming::roles;
  const Story story = tell(w);
  CHECK(std::ranges::any_of(
      story.frames, [](const Frame& frame) { return truth_in(frame) == "in exact arithmetic: P·d = −1e−340"; }));
}

TEST_CASE("The relative zero test mends the failures that come from rounding, not those of range; doubles mend all") {
  const auto relative = [](const std::string& name) {
    Scene scene = walkthrough("failures/" + name).scenes[0];
    scene.zero_test = ZeroTest::relative;
    return answer_of(scene);
  };
  CHECK(relative("coplanar-askew") == Status::intersecting);
  CHECK(relative("beyond-an-edge") == Status::intersecting);
  CHECK(relative("overflowed-product") == Status::undecided);
  for (const Walkthrough* w : find_walkthroughs("failures")) {
    INFO(w->name);
    Scene scene = w->scenes[0];
    scene.scalar = Scalar::binary64;
    CHECK(answer_of(scene) == truth_about(scene));
  }
}

TEST_CASE("A product that only counts as zero is told as what it is") {
  const Walkthrough w = with_relative_test();
  const Story story = tell(w);
  const auto says = [](const Fact& fact) { return plain(fact.text) == "R1: ABCn·AO = −4, which counts as 0"; };
  CHECK(std::ranges::any_of(story.frames.back().facts, says));
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
  for (const Walkthrough& w : whole_catalogue()) {
    if (w.layout != Layout::search && w.layout != Layout::in_step) continue;
    for (const ZeroTest zero_test : {ZeroTest::exact, ZeroTest::relative})
      for (const Scalar scalar : {Scalar::binary64, Scalar::binary32}) {
        Walkthrough other = w;
        other.remarks = {};
        for (Scene& scene : other.scenes) {
          if (scalar == Scalar::binary32) scene = in_float(scene);
          scene.zero_test = zero_test;
        }
        INFO(w.name << (scalar == Scalar::binary32 ? " in float" : " in double")
                    << (zero_test == ZeroTest::relative ? ", relative" : ", exact"));
        CHECK_NOTHROW(parse_trace(trace_text(other), "trace.jsonl"));
      }
  }
}

TEST_CASE("A trace says its scalar and zero test, where they are not the usual ones, and no other is believed") {
  const std::string scalar = R"("scalar":"float")", zero_test = R"("zero_test":"relative")";
  const std::string text = trace_text(with_relative_test()), usual = trace_text(walkthrough("figure-4-left"));
  REQUIRE((kit::has(text, scalar) && kit::has(text, zero_test)));
  CHECK_FALSE((kit::has(usual, scalar) || kit::has(usual, "\"zero_test\"")));
  const Walkthrough read = parse_trace(text, "trace.jsonl").walkthrough;
  CHECK(read.scenes[0].scalar == Scalar::binary32);
  CHECK(read.scenes[0].zero_test == ZeroTest::relative);
  CHECK_THROWS_AS(parse_trace(changed(text, zero_test, R"("zero_test":"exact")"), "trace.jsonl"), InputError);
  const std::string in_float = trace_text(walkthrough("failures/coplanar-askew"));
  CHECK_THROWS_AS(parse_trace(changed(in_float, scalar, R"("scalar":"double")"), "trace.jsonl"), InputError);
}

}  // namespace failures_test
