// Traces read back: they redraw their frames, and what contradicts itself is refused with the line and the reason.
#include "walkthroughs/trace/trace_file.hpp"

#include <cmath>
#include <map>
#include <set>

#include "render/triangles.hpp"
#include "tests/kit/catch.hpp"
#include "tests/kit/dice.hpp"
#include "tests/kit/places.hpp"
#include "tests/kit/text.hpp"
#include "tests/walkthroughs/trace/traces.hpp"
#include "walkthroughs/picture/draw.hpp"
#include "walkthroughs/story/alternative_text.hpp"
#include "walkthroughs/story/storyboard.hpp"

namespace trace_file_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;
namespace fs = std::filesystem;

namespace {

// -- Frames -----------------------------------------------------------------------------------------------------------

render::Triangles laid_out(const StagedStory& story, std::size_t frame, render::Font& font) {
  const Look look;
  render::Canvas canvas(frame_page, frame_page, look.style.theme.paper, font);
  draw_frame(canvas, story, frame, look);
  return triangles_of(canvas);
}

bool is_same(const render::CanvasVertex& v, const render::CanvasVertex& u) {
  return v.x == u.x && v.y == u.y && v.u == u.u && v.v == u.v && v.half_length == u.half_length &&
         v.radius == u.radius && v.color == u.color && v.kind == u.kind;
}

bool is_same(const render::Triangles::Run& r, const render::Triangles::Run& s) {
  return r.first == s.first && r.left == s.left && r.top == s.top && r.right == s.right && r.bottom == s.bottom;
}

/// The same triangles in the same order make the same pixels.
void check_same_frames(const StagedStory& told, const StagedStory& retold) {
  static render::Font font(render::Font::default_directory());
  REQUIRE(retold.frames.size() == told.frames.size());
  for (std::size_t i = 0; i < told.frames.size(); ++i) {
    const render::Triangles first = laid_out(told, i, font), second = laid_out(retold, i, font);
    const auto same = [](const auto& x, const auto& y) { return is_same(x, y); };
    CHECK(std::ranges::equal(first.vertices, second.vertices, same));
    CHECK(std::ranges::equal(first.runs, second.runs, same));
    CHECK(alternative_text(told, i) == alternative_text(retold, i));
  }
}

void check_redraws(const Walkthrough& w) {
  INFO(w.name);
  const TraceFile file = parse_trace(trace_text(w), "trace.jsonl");
  CHECK(file.walkthrough.name == w.name);
  check_same_frames(StagedStory(tell(w)), StagedStory(tell(file.walkthrough, file.traces)));
}

// -- Scenes that need all bits ------------------------------------------------------------------------------------------

/// Random objects of every kind, turned and moved, of the size of a power of ten.
class RandomScenes {
 public:
  explicit RandomScenes(unsigned seed) : dice_(seed) {}

  Walkthrough next(int power) {
    size_ = std::pow(10, power);
    Walkthrough w = walkthrough_of({{0, 0, 0}});
    w.naming = Naming::roles;
    Scene& scene = w.scenes[0];
    scene.dimension = Dimension::space;
    scene.a = object("first");
    scene.b = object("second");
    scene.options.first_direction = point();
    scene.options.crossing_test = pick(4) == 0 ? gjk::CrossingTest::off : gjk::CrossingTest::on;
    const int other_rules = pick(4);
    scene.rules = other_rules == 0 ? RuleSet::as_printed : other_rules == 1 ? RuleSet::eager : RuleSet::as_intended;
    return w;
  }

 private:
  int pick(int count) { return dice_.between(0, count - 1); }
  double number() { return dice_.between(-1.0, 1.0) * size_; }
  Point point() { return {number(), number(), pick(5) == 0 ? -0.0 : number()}; }

  AnyShape form(int sums = 2) {
    const int kind = pick(sums > 0 ? 5 : 4);
    if (kind == 4) return Sum{{form(sums - 1), form(sums - 1)}};
    if (kind < 2) {
      std::vector<Point> list;
      for (int i = pick(8); i >= 0; --i) list.push_back(point());
      return points(std::move(list));
    } else if (kind == 2) {
      return Ball{point(), std::abs(number())};
    }
    return Cylinder{point(), point(), std::abs(number()), std::abs(number())};
  }

  Object object(const std::string& name) {
    Object o{name, form()};
    if (pick(2) == 0) return o;
    const double angle = dice_.between(-4.0, 4.0);
    o.pose.rotation = Eigen::AngleAxisd(angle, Point(point() / size_).normalized()).toRotationMatrix();
    o.pose.translation = point();
    return o;
  }

  kit::Dice dice_;
  double size_ = 1;
};

std::vector<std::string> event_texts(const Trace& trace) {
  std::vector<std::string> texts;
  for (const auto& event : trace.events) texts.push_back(event_json(event).dump());
  return texts;
}

/// The header too: its scenes run to the identical events.
void check_reads_back(const Walkthrough& w) {
  const std::string text = trace_text(w);
  INFO(text.substr(0, 1500));
  const std::string complaint = complaint_about_trace(text);
  INFO(complaint);
  REQUIRE(complaint == "read");
  const TraceFile file = parse_trace(text, "trace.jsonl");
  for (std::size_t s = 0; s < w.scenes.size(); ++s) CHECK(event_texts(file.traces[s]) == event_texts(run(w.scenes[s])));
  CHECK(trace_text(file.walkthrough) == text);
}

/// A file in a folder of its own.
struct Written {
  Written(const std::string& text, const std::string& name) : path(folder.path() / name) {
    std::ofstream(path, std::ios::binary) << text;
  }
  Folder folder;
  fs::path path;
};

// -- Changing values --------------------------------------------------------------------------------------------------

/// A capsule, turned, beside a box drawn out along a cylinder's directions.
Walkthrough search_on_sums() {
  Walkthrough w = walkthrough_of({{0, 0, 0}});
  w.naming = Naming::roles;
  Scene& scene = w.scenes[0];
  scene.dimension = Dimension::space;
  scene.a = {"capsule",
             Sum{{Points{{-1, 0, 0}, {1, 0.5, 0}}, Ball{{0.1, 0.2, 0.3}, 0.5}}},
             {Eigen::AngleAxisd(0.7, Point(1, -2, 3).normalized()).toRotationMatrix(), Point(2, 1, 0.5)}};
  scene.b = {"rounded box", Sum{{Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                 Cylinder{{-2, 0.25, 0}, {0.25, -0.5, 1}, 0.5, 1}}}};
  scene.options.first_direction = {1, 2, 3};
  return w;
}

/// Without the crossing test: a vertex that was dropped is found again, and the search goes on.
Walkthrough search_that_meets_a_vertex_again() {
  Walkthrough w = walkthrough_of({{0, 0, 0}});
  w.naming = Naming::roles;
  Scene& scene = w.scenes[0];
  scene.dimension = Dimension::space;
  scene.a = {"triangle", Points{{0, 2, 1}, {2, 1, 0}, {-2, -1, -2}}};
  scene.b = {"segment", Points{{-2, 4, 1}, {-1, 0, -1}}};
  scene.options.crossing_test = gjk::CrossingTest::off;
  return w;
}

/// The traces that together have every event, every kind of object, and each way to end.
std::vector<std::string> texts_to_change() {
  std::vector<std::string> texts;
  for (const char* name :
       {"figure-4-right", "figure-4-right-no-crossing-test", "as-printed-spheres", "eager-between-centers",
        "regions/2-simplex-r1-below", "regions/3-simplex-inside", "regions/3-simplex-face-acd",
        "regions/3-simplex-face-adb-edge-ad", "regions/0-simplex-a-is-origin", "vehicle-and-threat/vehicle-near-miss"})
    texts.push_back(trace_text(walkthrough(name)));
  Walkthrough short_of_breath = walkthrough("regions/3-simplex-inside");
  short_of_breath.scenes[0].options.iteration_limit = 2;
  texts.push_back(trace_text(short_of_breath));
  texts.push_back(trace_text(search_on_sums()));
  texts.push_back(trace_text(search_that_meets_a_vertex_again()));
  return texts;
}

/// What nothing in the search follows from. Points of objects count only where the search found them, and no point that it
/// did not find may reach farther.
bool is_free(const std::string& path, const OrderedJson& line) {
  const auto has = [&](const char* part) { return path.find(part) != std::string::npos; };
  return line.contains("schema") &&
         (path == "/walkthrough" || path == "/version" || has("/presentation/") || path.ends_with("/name") ||
          has("/points/") || has("/iteration_limit") || has("/dimension") || has("/rules") ||
          has("/cylinder/axis/0"));  // along x: its multiples are the same axis
}

/// Each word that a trace has at that key.
using Vocabulary = std::map<std::string, std::set<std::string>>;

Vocabulary vocabulary() {
  Vocabulary words;
  for (const Walkthrough* w : searches())
    for (const OrderedJson& line : json_lines(trace_text(*w))) {
      const OrderedJson flat = line.flatten();
      for (const auto& [path, value] : flat.items())
        if (value.is_string()) words[path.substr(path.rfind('/'))].insert(value.get<std::string>());
    }
  return words;
}

std::vector<OrderedJson> other_values(const OrderedJson& value, const std::set<std::string>& words) {
  if (value.is_boolean()) return {!value.get<bool>()};
  if (value.is_number_integer()) return {value.get<int>() + 1, value.get<int>() - 1};
  if (value.is_number()) {
    const double x = value.get<double>();
    std::vector<OrderedJson> others{x + 1, "nan", nullptr};
    if (x != 0) others.insert(others.end(), {x * (1 + 1e-9), -x});
    return others;
  }
  std::vector<OrderedJson> others{"-", 0, nullptr};
  for (const std::string& word : words)
    if (word != value.get<std::string>()) others.emplace_back(word);
  return others;
}

}  // namespace

// -- What is read -----------------------------------------------------------------------------------------------------

TEST_CASE("A trace read back redraws the identical frames, for every walkthrough that has a search",
          "[trace-file][unsanitized][full]") {
  for (const Walkthrough* w : searches()) check_redraws(*w);
}

TEST_CASE("A trace of an own scene redraws the identical frames, whatever its numbers",
          "[trace-file][unsanitized][full]") {
  RandomScenes scenes(7474);
  for (const int power : {-155, -100, -3, 0, 0, 0, 3, 76, 110, 149}) check_redraws(scenes.next(power));
}

TEST_CASE("Reading a trace and telling it asks no support function", "[trace-file]") {
  for (const Walkthrough* w : searches()) {
    TraceFile file = parse_trace(trace_text(*w), "trace.jsonl");
    file.walkthrough.panels.hull = false;
    tell(file.walkthrough, file.traces);
    for (const Scene& scene : file.walkthrough.scenes) CHECK(scene.a.support_calls + scene.b.support_calls == 0);
  }
}

TEST_CASE("Scenes and events of random objects read back as the identical numbers", "[trace-file][unsanitized][full]") {
  RandomScenes scenes(1);
  for (int i = 0; i < 1000; ++i) check_reads_back(scenes.next(i % 3 == 0 ? i % 305 - 155 : i % 9 - 4));
}

// -- What is refused --------------------------------------------------------------------------------------------------

TEST_CASE("A trace that ends anywhere but at its end is refused", "[trace-file]") {
  const std::string text = trace_text(walkthrough("figure-4-right"));
  for (std::size_t length = 0; length + 1 < text.size(); ++length) {
    const std::string said = complaint_about_trace(text.substr(0, length));
    INFO(length << " of " << text.size() << " bytes: " << said);
    const auto line = 1 + std::ranges::count(text.substr(0, length), '\n');
    const std::string place = "bad.jsonl:" + std::to_string(line) + ": ";
    const std::string next_place = "bad.jsonl:" + std::to_string(line + 1) + ": ";
    CHECK((said.starts_with(place) || (text[length] == '\n' && said.starts_with(next_place))));
    CHECK(said.find("cut off") != std::string::npos);
  }
}

TEST_CASE("No value of a trace can be changed without contradicting the others", "[trace-file][unsanitized][full]") {
  const Vocabulary words = vocabulary();
  int refused = 0;
  for (const std::string& text : texts_to_change()) {
    REQUIRE(complaint_about_trace(text) == "read");
    const std::vector<OrderedJson> lines = json_lines(text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const OrderedJson flat = lines[i].flatten();
      for (const auto& [path, value] : flat.items()) {
        if (is_free(path, lines[i]) || value.is_array()) continue;
        const auto known = words.find(path.substr(path.rfind('/')));
        for (const OrderedJson& other :
             other_values(value, known == words.end() ? std::set<std::string>{} : known->second)) {
          std::vector<OrderedJson> changed = lines;
          changed[i][OrderedJson::json_pointer(path)] = other;
          const std::string said = complaint_about_trace(text_of(changed));
          if (said != "read") {
            ++refused;
            continue;
          }
          INFO("line " << i + 1 << " of " << lines[0].at("walkthrough") << ": " << path << " changed from " << value
                       << " to " << other);
          CHECK(said != "read");
        }
      }
    }
  }
  CHECK(refused > 10000);
}

TEST_CASE("No key of a trace can be left out, but for remarks and the pose of an object", "[trace-file]") {
  for (const std::string& text : texts_to_change()) {
    const std::vector<OrderedJson> lines = json_lines(text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (const auto& [key, value] : lines[i].items()) {
        std::vector<OrderedJson> changed = lines;
        changed[i].erase(key);
        INFO("line " << i + 1 << " of " << lines[0].at("walkthrough") << " without " << key);
        CHECK(complaint_about_trace(text_of(changed)).starts_with("bad.jsonl:" + std::to_string(i + 1) + ": "));
        changed = lines;
        changed[i]["more-" + key] = value;
        CHECK(complaint_about_trace(text_of(changed)).starts_with("bad.jsonl:" + std::to_string(i + 1) + ": "));
      }
    }
  }
}

TEST_CASE("No line of a trace can be left out, doubled, or change places with the next", "[trace-file]") {
  for (const std::string& text : texts_to_change()) {
    const std::vector<OrderedJson> lines = json_lines(text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      INFO("line " << i + 1 << " of " << lines[0].at("walkthrough"));
      const auto at = [&](std::vector<OrderedJson>& list) { return list.begin() + static_cast<std::ptrdiff_t>(i); };
      std::vector<OrderedJson> without = lines, doubled = lines, swapped = lines;
      without.erase(at(without));
      doubled.insert(at(doubled), lines[i]);
      CHECK(complaint_about_trace(text_of(without)) != "read");
      CHECK(complaint_about_trace(text_of(doubled)) != "read");
      if (i + 1 == lines.size()) continue;
      std::swap(swapped[i], swapped[i + 1]);
      CHECK(complaint_about_trace(text_of(swapped)) != "read");
    }
  }
}

TEST_CASE("A normal is made as its region says, not by another formula of the same value", "[trace-file]") {
  std::vector<OrderedJson> lines = json_lines(trace_text(walkthrough("regions/3-simplex-face-acd")));
  int changed = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].value("formula", "") != "AB×AC") continue;
    std::vector<OrderedJson> otherwise = lines;
    otherwise[i]["formula"] = "ABCn";
    INFO("line " << i + 1);
    CHECK(complaint_about_trace(text_of(otherwise)).find("'formula' is \"ABCn\", but the search says \"AB×AC\"") !=
          std::string::npos);
    ++changed;
  }
  CHECK(changed >= 2);  // of a triangle and of a tetrahedron
}

TEST_CASE("A point of an object that the search found cannot be changed", "[trace-file]") {
  std::vector<OrderedJson> lines = json_lines(trace_text(walkthrough("figure-4-right")));
  const std::size_t found = lines[2].at("a").at("index");
  lines[0]["scenes"][0]["a"]["points"][found][0] = 4.0;
  CHECK(complaint_about_trace(text_of(lines)).starts_with("bad.jsonl:3: 'a' is not where the point of index"));
}

TEST_CASE("What a trace says of the truth cannot be changed, left out or added", "[trace-file]") {
  const std::vector<OrderedJson> lines = json_lines(trace_text(walkthrough("failures/coplanar-askew")));
  REQUIRE(lines.back().at("event") == "truth");
  const auto complaint_about_last = [&](const auto& change) {
    std::vector<OrderedJson> changed = lines;
    change(changed);
    return complaint_about_trace(text_of(changed));
  };
  using Lines = std::vector<OrderedJson>;
  CHECK(kit::has(complaint_about_last([](Lines& all) { all.back()["status"] = "separated"; }), "but the truth is {"));
  CHECK(kit::has(complaint_about_last([](Lines& all) { all.back()["nearest"][0][1] = 2; }), "but the truth is {"));
  CHECK(kit::has(complaint_about_last([](Lines& all) { all.back().erase("exchanged"); }), "but the truth is {"));
  CHECK(kit::has(complaint_about_last([](Lines& all) { all.back() = 3; }), "an object that says the truth"));
  CHECK(kit::has(complaint_about_last([](Lines& all) { all.pop_back(); }),
                 "'truth' of the scene 'coplanar-askew' is missing"));
  CHECK(kit::has(complaint_about_last([](Lines& all) { all.push_back(all.back()); }), "nothing may follow"));
  CHECK(kit::has(complaint_about_last([](Lines& all) { all[0]["scenes"][0]["truth"] = "left-out"; }),
                 "nothing may follow"));
  CHECK(complaint_about_last([](Lines& all) {
          all[0]["scenes"][0]["truth"] = "left-out";
          all.pop_back();
        }) == "read");
  CHECK(complaint_about_last([](Lines& all) {  // which knew nothing of it
          all[0]["version"] = 2;
          all.pop_back();
        }) == "read");
}

TEST_CASE("Objects as read are those that were rounded to the scene's", "[trace-file]") {
  const std::vector<OrderedJson> lines = json_lines(trace_text(walkthrough("failures/vanished-product")));
  const auto complaint = [&](const char* key, const OrderedJson& value) {
    std::vector<OrderedJson> changed = lines;
    changed[0]["scenes"][0][key] = value;
    return complaint_about_trace(text_of(changed));
  };
  const OrderedJson& scene = lines[0].at("scenes").at(0);
  OrderedJson other = scene.at("a_as_read");
  other["points"][0][0] = 1e-13;
  CHECK(kit::has(complaint("a_as_read", other), "is not what was rounded to the scene's object"));
  CHECK(kit::has(complaint("b_as_read", scene.at("b")), "is not what was rounded to the scene's object"));
  CHECK(kit::has(complaint("scalar", "double"), "belongs to a scene whose 'scalar' is 'float'"));
}

TEST_CASE("A file that is larger than a trace may be is refused", "[trace-file]") {
  const Written long_trace(std::string(trace_limits::bytes + 1, ' '), "long.jsonl");
  try {
    read_trace(long_trace.path);
    FAIL("was read");
  } catch (const InputError& error) {
    CHECK(std::string(error.what()).ends_with("it is larger than 64 MiB; give a smaller one"));
  }
}

// -- The corpus -------------------------------------------------------------------------------------------------------

namespace {

struct Damage {
  const char* file;
  int line;
  const char* reason;  ///< a part of what is said
};

const Damage damages[] = {
    {"cut-in-line", 5, "the line ends in the middle"},
    {"cut-at-line", 6, "the trace is cut off"},
    {"cut-in-header", 1, "the line ends in the middle"},
    {"cut-after-first-scene", 36, "of the scene 'right' is missing"},
    {"empty", 1, "its first line is missing"},
    {"blank-line", 3, "is empty"},
    {"not-json", 1, "is not JSON"},
    {"comment", 2, "is not JSON"},
    {"scene-file", 1, "is not the first line of a trace"},
    {"version-1", 1, "version 1 is not known"},
    {"version-4", 1, "version 4 is not known"},
    {"mistake-unknown", 1, "'m22' is not known"},
    {"mistake-unnamed", 6, "but the search says \"A is the origin\""},
    {"name-elsewhere", 1, "cannot name a folder"},
    {"name-absolute", 1, "cannot name a folder"},
    {"unknown-key", 3, "is not a key"},
    {"infinite-scene", 1, "expected a number"},
    {"first-direction", 2, "'direction' is [1.0,0.0,0.0], but the search says [0.0,1.0,0.0]"},
    {"not-a-rotation", 1, "is not a rotation"},
    {"two-scenes-one-name", 1, "two scenes of the name"},
    {"one-scene-in-step", 1, "shows 2 scenes"},
    {"close-up-too-late", 1, "no crossing test in iteration 19"},
    {"corners-of-a-sphere", 1, "'corners' needs point sets"},
    {"other-scene", 3, "has not finished"},
    {"event-missing", 4, "'vertex-added' stands here, but the search says 'crossing-tested'"},
    {"event-twice", 6, "'vertex-added' stands here, but the search says 'region-tested'"},
    {"goes-on", 18, "nothing may follow"},
    {"iteration", 8, "'iteration' is 3, but the search says 2"},
    {"iterations", 17, "'iterations' is 9"},
    {"not-a-minus-b", 3, "'w' is [1.5,-4.0,0.0], but the search says [1.0,-4.0,0.0]"},
    {"not-the-vertex-of-its-index", 3, "has index 99"},
    {"other-direction", 8, "'direction' is [-0.5,4.0,-0.0], but the search says [-1.0,4.0,-0.0]"},
    {"new", 3, "'new' is false"},
    {"not-the-farthest", 3, "reaches farther"},
    {"crossing-value", 9, "'value' is 4.0, but the search says 3.0"},
    {"crossing-verdict", 9, "'verdict' is \"crossed\", but the search says \"not-crossed\""},
    {"order-of-simplex", 10, "'simplex[0].w' is [-3.0,0.0,0.0], but the search says [1.0,-4.0,0.0]"},
    {"vertex-of-simplex", 10, "'simplex[0].w' is [4.0,2.0,0.0], but the search says [4.0,1.0,0.0]"},
    {"region-verdict", 22, "'verdict' is \"rejected\", but the search says \"chosen\""},
    {"region-value", 22, "'value' is 128.0, but the search says 64.0"},
    {"region-normal", 22, "'normal' is [64.0,64.0,0.0], but the search says [-64.0,-64.0,-0.0]"},
    {"region-relation", 22, "'relation' is \"< 0\", but the search says \"> 0\""},
    {"region-feature", 22, "region: is 'R3', but the other fields say 'R7'"},
    {"region-left-out", 18, "'feature' is \"BC\", but the search says \"B\""},
    {"region-size", 22, "region: is 'R3', but the other fields say ''"},
    {"kept", 23, "dropped: is 'C', but the other fields say 'B'"},
    {"dropped", 23, "dropped: is '', but the other fields say 'C'"},
    {"after", 23, "'after[0].w' is [3.0,-2.0,0.0], but the search says [-1.0,2.0,0.0]"},
    {"direction-value", 14, "'direction' is [-8.5,-45.0,-0.0], but the search says [-9.0,-45.0,-0.0]"},
    {"direction-expression", 14, "'expression' is \"AO\", but the search says \"AB×AO×AB\""},
    {"status", 10, "'status' is \"intersecting\", but the search says \"separated\""},
    {"reason", 10, "'reason' is \"no-new-vertex\", but the search says \"origin-not-crossed\""},
    {"no-separation", 10, "'separation' is missing"},
    {"support-value", 10, "'separation.support_value' is -1e-09, but the search says -10.1875"},
    {"support-value-positive", 10, "'separation.support_value' is 1.0, but the search says -10.1875"},
    {"short-of-the-sum", 3, "does not reach as far as the sum"},
    {"beside-the-sum", 3, "is not a farthest point of the sum"},
    {"index-in-a-sum", 3, "has an index"},
    {"sum-of-one", 1, "expected a list of two shapes, found a list of 1"},
};

}  // namespace

TEST_CASE("Each damaged trace of the corpus is refused with its line and its reason", "[trace-file]") {
  for (const Damage& damage : damages) {
    const std::string said = complaint_about_trace(
        bytes_of(kit::source("tests/fuzz/traces") / ("bad-" + std::string(damage.file) + ".jsonl")));
    INFO(damage.file << ": " << said);
    CHECK(said.starts_with("bad.jsonl:" + std::to_string(damage.line) + ": "));
    CHECK(said.find(damage.reason) != std::string::npos);
    CHECK(said.size() < 600);
  }
}

TEST_CASE("What to do about a refused trace fits who got it from gjkstep and who wrote it", "[trace-file]") {
  for (const char* file : {"cut-in-line", "cut-at-line", "empty", "blank-line", "scene-file", "version-1", "new"}) {
    const std::string said =
        complaint_about_trace(bytes_of(kit::source("tests/fuzz/traces") / ("bad-" + std::string(file) + ".jsonl")));
    INFO(said);
    CHECK(said.ends_with(
        ". Write it anew with 'gjkstep trace NAME'. 'gjkstep trace --schema' lists what a line may hold"));
  }
}

TEST_CASE("Each trace of the corpus is read or has a place in the table of damages", "[trace-file]") {
  std::size_t read = 0, refused = 0;
  for (const auto& entry : fs::directory_iterator(kit::source("tests/fuzz/traces"))) {
    const std::string file = entry.path().filename().string();
    INFO(file);
    CHECK(entry.file_size() <= 20480);
    const bool is_sound = complaint_about_trace(bytes_of(entry.path())) == "read";
    CHECK(is_sound == file.starts_with("ok-"));
    ++(is_sound ? read : refused);
  }
  CHECK(read >= 13);
  CHECK(refused == std::size(damages));
}

}  // namespace trace_file_test
