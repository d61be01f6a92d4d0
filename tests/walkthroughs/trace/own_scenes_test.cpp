// What `gjkstep trace` writes `gjkstep render --from-trace` takes, whatever the scene and whatever its file is called.
#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/trace/random_scene_files.hpp"
#include "tests/walkthroughs/trace/traces.hpp"
#include "walkthroughs/query/query.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/text/scene_file.hpp"

namespace own_scenes_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;

namespace {

constexpr unsigned seed = 13;

/// Writing it again takes the search again, so the same text means the same scene, to the last bit.
void check_takes_what_it_writes(const RandomSceneFile& file) {
  INFO("seed " << seed << ", " << printable(file.name) << ": " << file.text);
  const Walkthrough written = parse_scene(file.text, file.name).walkthrough;
  const std::string text = trace_text(written);
  REQUIRE(complaint_about_trace(text) == "read");
  const TraceFile read = parse_trace(text, "trace.jsonl");
  CHECK(read.walkthrough.name == written.name);
  CHECK(read.walkthrough.title == written.title);
  CHECK(trace_text(read.walkthrough) == text);
}

/// Returns: what decided, in one text, of the answer to a query or of the last event of a trace.
std::string answer_in(const OrderedJson& line) {
  return line.value("status", "none") + " " + line.value("reason", "none") + " " +
         std::to_string(line.value("iterations", 0));
}

/// Requires: that it begins and tests as queries do.
void check_query_agrees(const RandomSceneFile& file, const OrderedJson& written) {
  INFO("seed " << seed << ", " << file.text);
  const Walkthrough walkthrough = parse_scene(file.text, file.name).walkthrough;
  const Scene& scene = walkthrough.scenes.front();
  const QueryOptions options{.scalar = scene.scalar == Scalar::binary32 ? QueryScalar::binary32 : QueryScalar::binary64,
                             .rules = scene.rules,
                             .zero_test = scene.zero_test,
                             .iteration_limit = scene.options.iteration_limit};
  const OrderedJson pair{{"a", written["a"]}, {"b", written["b"]}, {"dimension", written.value("dimension", 3)}};
  std::string answer;
  REQUIRE(answer_line(pair.dump(), 1, options, answer));
  const OrderedJson said = OrderedJson::parse(answer);
  const std::vector<OrderedJson> lines = json_lines(trace_text(walkthrough));
  const auto is_end = [](const OrderedJson& line) { return line.value("event", "") == "finished"; };
  const OrderedJson told = *std::ranges::find_if(lines, is_end);  // proofs may follow
  if (told.value("reason", "") == "cycle")  // which is noticed later, if at all within the limit, where nobody listens
    CHECK(said.value("status", "") == "undecided");
  else
    CHECK(answer_in(said) == answer_in(told));
}

/// Returns: a scene file of a cylinder and a sum with it, all lengths multiplied.
RandomSceneFile scaled(double scale) {
  const nlohmann::ordered_json at = {scale, 2 * scale, -scale}, axis = {0.3, -1.7, 0.9};
  const nlohmann::ordered_json can{
      {"cylinder", {{"center", at}, {"axis", axis}, {"radius", scale}, {"height", 3 * scale}}}};
  const nlohmann::ordered_json segment{{"points", {at, {scale, 0, 0}}}};
  const nlohmann::ordered_json scene{{"a", {{"sum", {can, segment}}}}, {"b", can}, {"first_direction", {1, 2, 3}}};
  return {"can.json", scene.dump()};
}

}  // namespace

TEST_CASE("The trace of any own scene is taken, and says the same scene and the same search", "[trace-file][full]") {
  RandomSceneFiles files(seed);
  for (int i = 0; i < 1000; ++i) check_takes_what_it_writes(files.next());
}

TEST_CASE("A scene and a query of the same pair give the same answer", "[scene-file]") {
  RandomSceneFiles files(seed);
  int asked = 0;
  for (int i = 0; i < 600; ++i) {
    const RandomSceneFile file = files.next();
    const OrderedJson written = OrderedJson::parse(file.text);
    if (written.contains("first_direction") || written.value("crossing_test", "on") == "off") continue;
    check_query_agrees(file, written);
    ++asked;
  }
  CHECK(asked > 150);
}

TEST_CASE("The trace of objects that a pose moves beyond all floats is taken", "[trace-file]") {
  for (const char* object : {R"("points":[[3e38,0,0]])", R"("sphere":{"center":[3e38,0,0],"radius":1e38})",
                             R"("cylinder":{"center":[3e38,0,0],"axis":[0,0,1],"radius":1,"height":2})"})
    check_takes_what_it_writes({"far.json", std::string(R"({"scalar":"float","a":{)") + object +
                                                R"(,"pose":{"translation":[3e38,0,0]}},"b":{"points":[[0,0,0]]}})"});
}

TEST_CASE("The trace of cylinders and their sums is taken at every scale", "[trace-file]") {
  for (int power = -323; power < 150; ++power) check_takes_what_it_writes(scaled(std::pow(10, power)));
}

}  // namespace own_scenes_test
