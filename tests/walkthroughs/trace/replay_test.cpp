// Traces are held to their search, run again: also of one with a mistake, which it must name.
#include "walkthroughs/trace/replay.hpp"

#include "tests/kit/catch.hpp"
#include "tests/kit/dice.hpp"
#include "tests/walkthroughs/trace/traces.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/model/scene.hpp"

namespace replay_test {

using namespace walkthroughs;
using namespace walkthroughs::program;
using namespace walkthroughs::test;

namespace {

std::vector<const Walkthrough*> about_mistakes() {
  std::vector<const Walkthrough*> all = find_walkthroughs("mistakes");
  std::erase_if(all, [](const Walkthrough* w) { return w->layout == Layout::diagrams; });
  return all;
}

/// Returns: the trace with another mistake in its first scene, or with none.
std::string renamed(const Walkthrough& w, std::optional<Mistake> other) {
  std::vector<OrderedJson> lines = json_lines(trace_text(w));
  OrderedJson& scene = lines[0]["scenes"][0];
  const auto& known = wrong_on_purpose::all();
  scene.erase("mistake");
  scene["rules"] = other ? to_string(known[static_cast<std::size_t>(*other)].rules) : "as-intended";
  if (other) scene["mistake"] = known[static_cast<std::size_t>(*other)].word;
  return text_of(lines);
}

/// Triangles of whole numbers from -n to n: many touch.
Scene random_scene(kit::Dice& dice) {
  const int n = dice.between(1, 4);
  const bool is_plane = dice.between(0, 2) == 0;
  const auto number = [&] { return static_cast<double>(dice.between(-n, n)); };
  const auto triangle = [&] {
    std::vector<Point> vertices;
    for (int i = 0; i < 3; ++i) {
      const double x = number(), y = number();
      vertices.emplace_back(x, y, is_plane ? 0 : number());
    }
    return points(vertices);
  };
  return {.name = "right",
          .a = {"a", triangle()},
          .b = {"b", triangle()},
          .dimension = is_plane ? Dimension::plane : Dimension::space};
}

}  // namespace

TEST_CASE("Traces of mistakes are taken, and say the same again", "[trace-file]") {
  for (const Walkthrough* w : about_mistakes()) {
    INFO(w->name);
    const std::string text = trace_text(*w);
    REQUIRE(complaint_about_trace(text) == "read");
    const TraceFile read = parse_trace(text, "trace.jsonl");
    CHECK(read.walkthrough.scenes.at(0).mistake == w->scenes[0].mistake);
    CHECK(trace_text(read.walkthrough) == text);
  }
}

TEST_CASE("A trace with a mistake is not taken for the report's algorithm, nor for one with another mistake",
          "[trace-file]") {
  for (const Walkthrough* w : about_mistakes()) {
    INFO(w->name);
    CHECK(complaint_about_trace(renamed(*w, {})) != "read");
    for (const auto& known : wrong_on_purpose::all()) {
      if (known.value == w->scenes[0].mistake) continue;
      INFO(known.word);
      CHECK(complaint_about_trace(renamed(*w, known.value)) != "read");
    }
  }
}

TEST_CASE("What any search with a mistake tells is taken, and where it differs from the report's not without its name",
          "[trace-file][full]") {
  kit::Dice dice(17);
  for (const auto& known : wrong_on_purpose::all()) {
    int parted = 0, refused = 0;
    for (int i = 0; i < 3000 && parted < 12; ++i) {
      const Walkthrough w = beside_the_report(known.value, random_scene(dice));
      if (run(w.scenes[0]).events == run(w.scenes[1]).events) continue;
      ++parted;
      INFO(w.name << ", pair " << i << ": " << json_lines(trace_text(w))[0]["scenes"][0].dump());
      REQUIRE(complaint_about_trace(trace_text(w)) == "read");
      refused += complaint_about_trace(renamed(w, {})) != "read";
    }
    INFO(known.word);
    CHECK(parted >= 6);
    CHECK(refused == parted);
  }
}

TEST_CASE("A mistake is known with the report's rules, the crossing test on, in double, and shown beside the report",
          "[trace-file]") {
  const Walkthrough& w = walkthrough("mistakes/m14-order-below-triangle");
  const auto complaint = [&](const auto& change) {
    std::vector<OrderedJson> lines = json_lines(trace_text(w));
    change(lines[0]);
    return complaint_about_trace(text_of(lines));
  };
  const std::string otherwise = "this scene says otherwise";
  for (const auto& [key, value] : std::vector<std::pair<std::string, std::string>>{
           {"rules", "eager"}, {"crossing_test", "off"}, {"zero_test", "relative"}, {"scalar", "float"}})
    CHECK(complaint([&](OrderedJson& header) { header["scenes"][0][key] = value; }).find(otherwise) !=
          std::string::npos);
  CHECK(complaint([](OrderedJson& header) { header["scenes"][0]["mistake"] = "m22"; }).find("'m22' is not known") !=
        std::string::npos);
  CHECK(complaint([](OrderedJson& header) { header["scenes"][0]["mistake"] = 14; }) != "read");
  CHECK(complaint([](OrderedJson& header) {
          header["presentation"]["layout"] = "in-step";
        }).find("shows no mistake; 'until-they-part' does") != std::string::npos);
  CHECK(complaint([](OrderedJson& header) {
          header["scenes"][1]["mistake"] = "m14-order-below-triangle";
        }).find("shows no mistake; 'until-they-part' does") != std::string::npos);
}

TEST_CASE("A trace of a mistake beside a search of another pair is told all the same, without a line", "[trace-file]") {
  for (const Walkthrough* mistaken : about_mistakes()) {
    Walkthrough w = *mistaken;
    for (const Walkthrough* other : about_mistakes()) {
      w.scenes[1] = other->scenes[1];
      INFO(w.name << " beside " << other->name);
      const TraceFile read = parse_trace(trace_text(w), "trace.jsonl");
      CHECK_FALSE(tell(read.walkthrough, read.traces).frames.empty());
    }
  }
}

}  // namespace replay_test
