#include "tests/study/sweep/failure_files.hpp"

#include <set>

#include "tests/kit/catch.hpp"
#include "tests/kit/folder.hpp"
#include "tests/study/methods/certified.hpp"
#include "tests/study/support.hpp"
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

gjk::Status status_of(Kind kind) {
  switch (kind) {
    case Kind::false_positive: return gjk::Status::intersecting;
    case Kind::false_negative: return gjk::Status::separated;
    case Kind::undecided: return gjk::Status::undecided;
    case Kind::false_certificate: break;
  }
  return {};
}

TEST_CASE("A failure that was saved fails in the same way when it is read and run as the scene says", "[failures]") {
  std::set<std::pair<Kind, walkthroughs::Scalar>> seen;
  for (const char* const method : {"as-intended float exact", "as-intended float relative", "as-printed float exact",
                                   "as-intended double exact", "as-printed double exact"})
    for (const char* const family : {"flat-1e-9-turned", "near-parallel-edges", "scale-1e10", "cycles", "triangles",
                                     "touching-face-askew", "spheres-gap-1e-12", "cylinders-gap-1e-12"})
      for (const Failure& failure : failures_of(family, method, 400)) {
        const std::string text = scene_of(failure, 7);
        INFO(text);
        CHECK(text.find(std::string("of family ") + family + ", seed 7. Rules as-") != std::string::npos);
        const walkthroughs::SceneFile file = walkthroughs::parse_scene(text, scene_name(failure));
        const walkthroughs::Scene& scene = file.walkthrough.scenes.front();
        CHECK((scene.scalar == walkthroughs::Scalar::binary32) == (failure.method->scalar.name == "float"));
        CHECK(status_of(scene) == status_of(failure.kind));
        seen.insert({failure.kind, scene.scalar});
      }
  CHECK(seen.size() == 6);
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

TEST_CASE("Pairs with numbers that no scene can hold are not saved, but counted and the reason told", "[failures]") {
  const kit::Folder folder;
  Failure failure{"far", 0, &all_methods().front(), Kind::undecided, 20, Truth::separated, {}};
  failure.pair = {Points{}, Ball{{0, 0, 0}, 1}};
  Failure far = failure;
  far.pair.a = Points{{0, 0, 0}, {0, -1.1e150, 0}};
  failure.pair.a = Points{{1e150, 0, 0}};
  const Saved saved = write_failures(folder.path(), {failure, far, far}, 7);
  CHECK(saved.files == 1);
  CHECK(saved.left_out == 2);
  CHECK(left_out_words(saved) ==
        "2 failures are not saved: a number in them is beyond 1e+150, the largest that a scene file may hold");
  CHECK(left_out_words({1, 0}).empty());
}

}  // namespace
}  // namespace study::test
