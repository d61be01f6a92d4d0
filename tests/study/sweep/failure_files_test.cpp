#include "tests/study/sweep/failure_files.hpp"

#include <set>

#include "tests/kit/catch.hpp"
#include "tests/study/methods/certified.hpp"
#include "tests/study/support.hpp"
#include "tests/walkthroughs/program/program.hpp"
#include "walkthroughs/model/run.hpp"
#include "walkthroughs/text/scene_file.hpp"

namespace study::test {
namespace {

std::vector<Failure> failures_of(const std::string& family, const std::string& method, std::uint64_t pairs) {
  Plan plan = plan_for({&family_named(family)}, {&method_named(method)}, pairs);
  plan.failures_kept = 3;
  return sweep(plan).failures;
}

gjk::Status status_of(const walkthroughs::Scene& scene) {
  return std::get<gjk::Finished<double>>(walkthroughs::run(scene).events.back()).result.status;
}

TEST_CASE("A saved failure is a scene that goes wrong in the same way", "[failures]") {
  const std::vector<Failure> wrong = failures_of("triangles", "as-printed double exact", 500);
  REQUIRE(wrong.size() == 3);
  for (const Failure& failure : wrong) {
    const std::string text = scene_of(failure, 7);
    INFO(text);
    CHECK(text.starts_with("// Truth: they are apart. Answer: intersecting.\n"));
    CHECK(text.find("of family triangles, seed 7. Rules as-printed, scalar double, zero test exact") !=
          std::string::npos);
    const walkthroughs::SceneFile file = walkthroughs::parse_scene(text, scene_name(failure));
    CHECK(status_of(file.walkthrough.scenes.front()) == gjk::Status::intersecting);
  }
}

TEST_CASE("A saved cycle is a scene that stays undecided", "[failures]") {
  const std::vector<Failure> undecided = failures_of("cycles", "as-intended double exact", 10);
  REQUIRE(undecided.size() == 3);
  const walkthroughs::SceneFile file = walkthroughs::parse_scene(scene_of(undecided[0], 7), "cycle.json");
  CHECK(status_of(file.walkthrough.scenes.front()) == gjk::Status::undecided);
}

gjk::Status status_of(Kind kind) {
  switch (kind) {
    case Kind::false_positive: return gjk::Status::intersecting;
    case Kind::false_negative: return gjk::Status::separated;
    case Kind::undecided: return gjk::Status::undecided;
    case Kind::false_certificate: break;
  }
  return {};
}

TEST_CASE("A failure in float that was saved fails in the same way when it is read and run as the scene says",
          "[failures]") {
  std::set<Kind> kinds;
  for (const char* const method : {"as-intended float exact", "as-intended float relative", "as-printed float exact"})
    for (const char* const family : {"flat-1e-9-turned", "near-parallel-edges", "scale-1e10"})
      for (const Failure& failure : failures_of(family, method, 400)) {
        const std::string text = scene_of(failure, 7);
        INFO(text);
        const walkthroughs::SceneFile file = walkthroughs::parse_scene(text, scene_name(failure));
        const walkthroughs::Scene& scene = file.walkthrough.scenes.front();
        CHECK(scene.scalar == walkthroughs::Scalar::binary32);
        CHECK(status_of(scene) == status_of(failure.kind));
        kinds.insert(failure.kind);
      }
  CHECK(kinds.size() == 3);
}

TEST_CASE("A certified answer that is wrong is saved as a scene of its first search, which says so", "[failures]") {
  Failure failure{"triangles",
                  3,
                  nullptr,
                  Kind::false_positive,
                  no_limit,
                  Truth::separated,
                  {Points{{0, 0, 0}, {0, 1, 0}}, Points{{-9, 0, 0}, {-9, 0, 1}}}};
  for (const Method& method : all_methods()) {
    if (!is_certified(method.rules)) continue;
    failure.method = &method;
    const std::string text = scene_of(failure, 7);
    INFO(text);
    const std::string first = method.rules == "certified" ? "as-intended" : "eager";
    CHECK(text.find("of family triangles, seed 7. Asked by gjk::certified_collision(), scalar " + method.scalar.name +
                    ", rules of the first search " + first + ".\n// A scene cannot run the second search") !=
          std::string::npos);
    CHECK(text.find("iteration_limit") == std::string::npos);
    const walkthroughs::SceneFile file = walkthroughs::parse_scene(text, scene_name(failure));
    const walkthroughs::Scene& scene = file.walkthrough.scenes.front();
    CHECK(to_string(scene.rules) == first);
    CHECK((scene.scalar == walkthroughs::Scalar::binary32) == (method.scalar.name == "float"));
    CHECK(status_of(scene) == gjk::Status::separated);
  }
  CHECK(scene_name(failure) == "triangles-certified-eager-double-exact-false-positive-3.json");
  failure.kind = Kind::false_certificate;
  CHECK(scene_of(failure, 7)
            .starts_with("// Truth: they are apart. Answer: right, with a certificate that does not hold.\n"));
  CHECK(scene_name(failure) == "triangles-certified-eager-double-exact-false-certificate-3.json");
}

TEST_CASE("Balls and cylinders that went wrong are scenes as well", "[failures]") {
  for (const char* const family : {"spheres-gap-1e-12", "cylinders-gap-1e-12"}) {
    const std::vector<Failure> wrong = failures_of(family, "as-intended double exact", 300);
    INFO(family);
    REQUIRE(!wrong.empty());
    const walkthroughs::SceneFile file = walkthroughs::parse_scene(scene_of(wrong[0], 7), scene_name(wrong[0]));
    const gjk::Status status = status_of(file.walkthrough.scenes.front());
    CHECK((status == gjk::Status::undecided) == (wrong[0].kind == Kind::undecided));
  }
}

TEST_CASE("Pairs with numbers that no scene can hold are not saved", "[failures]") {
  Failure failure{"far", 0, &all_methods().front(), Kind::undecided, 20, Truth::separated, {}};
  failure.pair = {Points{{1e150, 0, 0}}, Ball{{0, 0, 0}, 1}};
  CHECK(fits_scene(failure));
  failure.pair.a = Points{{0, 0, 0}, {0, -1.1e150, 0}};
  CHECK(!fits_scene(failure));
}

TEST_CASE("Failures that are not saved are counted and the reason is told", "[failures]") {
  const walkthroughs::test::Folder folder;
  Failure failure{"far", 0, &all_methods().front(), Kind::undecided, 20, Truth::separated, {}};
  failure.pair = {Points{{1, 0, 0}}, Points{{0, 0, 0}}};
  Failure far = failure;
  far.pair.a = Points{{1e151, 0, 0}};
  const Saved saved = write_failures(folder.path(), {failure, far, far}, 7);
  CHECK(saved.files == 1);
  CHECK(saved.left_out == 2);
  CHECK(left_out_words(saved) ==
        "2 failures are not saved: a number in them is beyond 1e+150, the largest that a scene file may hold");
  CHECK(left_out_words({1, 0}).empty());
}

}  // namespace
}  // namespace study::test
