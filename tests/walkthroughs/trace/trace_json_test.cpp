#include "walkthroughs/trace/trace_json.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"

namespace trace_json_test {

using namespace walkthroughs;
using namespace walkthroughs::program;
using namespace walkthroughs::test;
using Json = nlohmann::json;

namespace {

/// The walkthroughs of the catalogue, one through tetrahedra, and one in numbers that need all their digits.
std::vector<Walkthrough> walkthroughs_to_trace() {
  std::vector<Walkthrough> list = whole_catalogue();
  std::erase_if(list, [](const Walkthrough& w) { return w.scenes.empty(); });  // diagrams have no trace
  list.push_back(walkthrough_of({{5, 1, 2}, {-4, 3, 1}, {-1, -5, 2}, {0, 1, -6}, {1, 2, 5}}));
  list.push_back(walkthrough_of({{0.1, 1.0 / 3, 1e-17}, {-0.7, 2e-5, 0.3}, {-1e-3, -2.0 / 7, 123.456}},
                                {.first_direction = {0.1, -1e-9, 1.0 / 3}},
                                {{1e-300, 0.2, 0.1 + 0.2}, {-0.0, -1.1, 1e-5}}));
  return list;
}

std::vector<Json> lines_of(const Walkthrough& w) {
  std::ostringstream out;
  write_traces(out, w);
  std::istringstream in(out.str());
  std::vector<Json> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(Json::parse(line));  // throws where it is not JSON
  return lines;
}

/// The events of all scenes, in the order of the lines.
std::vector<gjk::Event<double>> events_of(const Walkthrough& w) {
  std::vector<gjk::Event<double>> events;
  for (const Scene& scene : w.scenes) std::ranges::copy(run(scene).events, std::back_inserter(events));
  return events;
}

/// The identical double: the sign of zero counts.
void check_same(const Json& json, double value) {
  if (std::isinf(value)) {
    CHECK(json == (value > 0 ? "inf" : "-inf"));
    return;
  }
  REQUIRE(json.is_number_float());
  CHECK(std::bit_cast<std::uint64_t>(json.get<double>()) == std::bit_cast<std::uint64_t>(value));
}

void check_same(const Json& json, const Point& p) {
  REQUIRE(json.size() == 3);
  for (int i = 0; i < 3; ++i) check_same(json[static_cast<std::size_t>(i)], p[i]);
}

void check_same(const Json& json, const Vertex& v) {
  check_same(json.at("w"), v.w);
  check_same(json.at("a").at("point"), v.a.point);
  check_same(json.at("b").at("point"), v.b.point);
  const auto check_index = [](const Json& j, const std::optional<int>& index) {
    CHECK(j.contains("index") == index.has_value());  // round objects have no vertices to count
    if (index) CHECK(j.at("index") == *index);
  };
  check_index(json.at("a"), v.a.index);
  check_index(json.at("b"), v.b.index);
}

void check_same(const Json& json, const Simplex& simplex) {
  REQUIRE(json.size() == static_cast<std::size_t>(simplex.size()));
  for (int i = 0; i < simplex.size(); ++i) check_same(json[static_cast<std::size_t>(i)], simplex[i]);
}

/// What is empty in an event is left out of its line.
void check_text(const Json& json, const char* key, const std::string& text) { CHECK(json.value(key, "") == text); }

struct CheckLine {
  const Json& json;

  void operator()(const gjk::SearchStarted<double>& e) const {
    CHECK(json.at("event") == "search-started");
    check_same(json.at("direction"), e.direction);
    check_text(json, "why", std::string(gjk::to_string(e.why)));
  }
  void operator()(const gjk::SupportFound<double>& e) const {
    CHECK(json.at("event") == "support-found");
    check_same(json.at("direction"), e.direction);
    check_same(json, e.vertex);
    CHECK(json.at("new") == e.is_new);
  }
  void operator()(const gjk::CrossingTested<double>& e) const {
    const char* const verdicts[] = {"crossed", "not-crossed", "not-applied-first-point", "not-applied-switched-off"};
    CHECK(json.at("event") == "crossing-tested");
    CHECK(json.contains("value") == e.value.has_value());
    if (e.value) check_same(json.at("value"), *e.value);
    CHECK(json.at("verdict") == verdicts[static_cast<int>(e.verdict)]);
  }
  void operator()(const gjk::VertexAdded<double>& e) const {
    CHECK(json.at("event") == "vertex-added");
    check_same(json.at("simplex"), e.simplex);
  }
  void operator()(const gjk::RegionTested<double>& e) const {
    const char* const relations[] = {"> 0", "< 0", "= 0", "!= 0", ">= 0"};
    const char* const verdicts[] = {"chosen", "rejected", "skipped", "possible"};
    const bool computed = !std::holds_alternative<std::monostate>(e.value);
    CHECK(json.at("event") == "region-tested");
    CHECK(json.at("simplex_size") == e.simplex_size);
    check_text(json, "feature", to_string(e.feature));
    check_text(json, "region", std::string(to_string(label_of(e))));
    check_text(json, "face", to_string(e.face));
    check_text(json, "expression", to_string(e.expression));
    check_text(json, "formula", to_string(e.formula));
    CHECK(json.contains("normal") == e.normal.has_value());
    if (e.normal) check_same(json.at("normal"), *e.normal);
    CHECK(json.contains("value") == computed);
    if (const double* value = std::get_if<double>(&e.value)) check_same(json.at("value"), *value);
    if (const Point* value = std::get_if<Point>(&e.value)) check_same(json.at("value"), *value);
    check_text(json, "relation", computed ? relations[static_cast<int>(e.relation)] : "");
    CHECK(json.at("verdict") == verdicts[static_cast<int>(e.verdict)]);
    check_text(json, "reason", reason_in_words(e));
  }
  void operator()(const gjk::SimplexReduced<double>& e) const {
    CHECK(json.at("event") == "simplex-reduced");
    check_same(json.at("before"), e.before);
    check_same(json.at("after"), e.after);
    check_text(json, "kept", to_string(e.kept));
    check_text(json, "dropped", to_string(e.dropped()));
    check_text(json, "why", std::string(gjk::to_string(e.why)));
  }
  void operator()(const gjk::DirectionChosen<double>& e) const {
    CHECK(json.at("event") == "direction-chosen");
    check_text(json, "expression", to_string(e.expression));
    check_same(json.at("direction"), e.direction);
  }
  void operator()(const gjk::Finished<double>& e) const {
    CHECK(json.at("event") == "finished");
    CHECK(json.at("status") == std::string(gjk::to_string(e.result.status)));
    CHECK(json.at("reason") == std::string(gjk::to_string(e.result.reason)));
    CHECK(json.at("iterations") == e.result.iterations);
    check_same(json.at("simplex"), e.result.simplex);
    CHECK(json.contains("separation") == e.result.separation.has_value());
    if (!e.result.separation) return;
    check_same(json.at("separation").at("direction"), e.result.separation->direction);
    check_same(json.at("separation").at("support_value"), e.result.separation->support_value);
  }
  void operator()(const gjk::FilterTried<double>& e) const {
    CHECK(json.at("event") == "proof-tried");
    CHECK(json.at("proof") == std::string(gjk::to_string(e.proof)));
    REQUIRE(json.at("numbers").size() == e.numbers.size());
    for (std::size_t i = 0; i < e.numbers.size(); ++i) {
      check_text(json.at("numbers")[i], "expression", to_string(e.numbers[i].expression));
      check_same(json.at("numbers")[i].at("value"), e.numbers[i].value);
    }
    check_same(json.at("bound"), e.bound);
    CHECK(json.at("holds") == e.holds);
  }
  void operator()(const gjk::SignTaken<double>& e) const {
    CHECK(json.at("event") == "sign-taken");
    check_text(json, "expression", to_string(e.expression));
    check_text(json, "formula", formula_of(e));
    CHECK(json.contains("vertex") == e.vertex.has_value());
    if (e.vertex) check_same(json.at("vertex"), *e.vertex);
    check_same(json.at("value"), e.value);
    check_same(json.at("error"), e.error);
    CHECK(json.contains("power") == e.power.has_value());
    if (e.power) CHECK(json.at("power") == *e.power);
    check_text(json, "exact", e.exact);
    CHECK(json.at("sign") == e.sign);
  }
  void operator()(const gjk::FeatureKept<double>& e) const {
    CHECK(json.at("event") == "feature-kept");
    check_same(json.at("before"), e.before);
    check_same(json.at("after"), e.after);
    check_text(json, "kept", to_string(e.kept));
    check_text(json, "dropped", to_string(e.dropped()));
    CHECK(json.at("contains_origin") == e.contains_origin);
  }
  void operator()(const gjk::Certified<double>& e) const {
    CHECK(json.at("event") == "certified");
    CHECK(json.at("status") == std::string(gjk::to_string(e.result.status)));
    CHECK(json.at("proof") == std::string(gjk::to_string(e.result.proof)));
    CHECK(json.at("iterations") == e.result.iterations);
    CHECK(json.at("second_iterations") == e.result.fallback_iterations);
    const Json& certificate = json.at("certificate");
    CHECK(certificate.size() == 1);
    const auto check_pairs = [](const Json& list, const gjk::IndexPairs& pairs) {
      REQUIRE(list.size() == static_cast<std::size_t>(pairs.size()));
      for (int i = 0; i < pairs.size(); ++i)
        CHECK(list[static_cast<std::size_t>(i)] == Json::array({pairs[i].a, pairs[i].b}));
    };
    if (const auto* d = std::get_if<gjk::SeparatingDirection>(&e.result.certificate))
      check_same(certificate.at("direction"), d->d);
    else if (const auto* feature = std::get_if<gjk::SeparatingFeature>(&e.result.certificate))
      check_pairs(certificate.at("nearest"), feature->of);
    else
      check_pairs(certificate.at("simplex"), std::get<gjk::CommonSimplex>(e.result.certificate).of);
  }
};

Point point(const Json& json) {
  const auto number = [](const Json& j) { return j == "inf" ? HUGE_VAL : j == "-inf" ? -HUGE_VAL : j.get<double>(); };
  return Point(number(json.at(0)), number(json.at(1)), number(json.at(2)));
}

AnyShape form(const Json& json) {
  if (json.contains("sphere"))
    return Ball{point(json["sphere"].at("center")), json["sphere"].at("radius").get<double>()};
  if (json.contains("cylinder")) {
    const Json& c = json["cylinder"];
    return Cylinder{point(c.at("center")), point(c.at("axis")), c.at("radius").get<double>(),
                    c.at("height").get<double>()};
  }
  if (json.contains("sum")) return Sum{{form(json["sum"].at(0)), form(json["sum"].at(1))}};
  std::vector<Point> vertices;
  for (const Json& p : json.at("points")) vertices.push_back(point(p));
  return points(std::move(vertices));
}

Object object(const Json& json) {
  Object o{json.at("name"), form(json)};
  if (!json.contains("pose")) return o;
  for (int row = 0; row < 3; ++row)
    o.pose.rotation.row(row) = point(json["pose"].at("rotation").at(static_cast<std::size_t>(row)));
  o.pose.translation = point(json["pose"].at("translation"));
  return o;
}

std::optional<Object> object_if_any(const Json& json, const char* key) {
  return json.contains(key) ? std::optional(object(json.at(key))) : std::nullopt;
}

RuleSet rules(const std::string& name) {
  if (name == "eager") return RuleSet::eager;
  if (name == "complete") return RuleSet::complete;
  return name == "as-printed" ? RuleSet::as_printed : RuleSet::as_intended;
}

std::optional<Mistake> mistake(const std::string& word) {
  const wrong_on_purpose::Description* known = wrong_on_purpose::named(word);
  return known ? std::optional(known->value) : std::nullopt;
}

Scene scene(const Json& json) {
  return {
      .name = json.at("name"),
      .a = object(json.at("a")),
      .b = object(json.at("b")),
      .options = {.first_direction = point(json.at("first_direction")),
                  .iteration_limit = json.at("iteration_limit"),
                  .crossing_test = json.at("crossing_test") == "on" ? gjk::CrossingTest::on : gjk::CrossingTest::off},
      .dimension = json.at("dimension") == 2 ? Dimension::plane : Dimension::space,
      .rules = rules(json.at("rules")),
      .zero_test = json.value("zero_test", "exact") == "exact" ? ZeroTest::exact : ZeroTest::relative,
      .scalar = json.value("scalar", "double") == "double" ? Scalar::binary64 : Scalar::binary32,
      .certified = json.value("certified", false),
      .mistake = mistake(json.value("mistake", "none")),
      .a_as_read = object_if_any(json, "a_as_read"),
      .b_as_read = object_if_any(json, "b_as_read")};
}

}  // namespace

TEST_CASE("The first line of a trace says schema, version, walkthrough and scalar") {
  for (const Walkthrough& w : walkthroughs_to_trace()) {
    const Json first = lines_of(w).at(0);
    CHECK(first.at("schema") == "gjkstep-trace");
    CHECK(first.at("version") == 3);
    CHECK(first.at("walkthrough") == w.name);
    CHECK(first.at("scalar") == "double");
    CHECK(first.at("scenes").size() == w.scenes.size());
  }
}

TEST_CASE("The scenes in the first line are enough to repeat the run") {
  for (const Walkthrough& w : walkthroughs_to_trace()) {
    const std::vector<Json> lines = lines_of(w);
    Walkthrough again = w;
    again.scenes.clear();
    for (const Json& s : lines[0].at("scenes")) again.scenes.push_back(scene(s));
    CHECK(lines_of(again) == lines);
  }
}

TEST_CASE("Each further line is one event, with the identical numbers") {
  for (const Walkthrough& w : walkthroughs_to_trace()) {
    std::vector<Json> lines = lines_of(w);
    std::erase_if(lines, [](const Json& line) { return line.value("event", "") == "truth"; });
    const auto events = events_of(w);
    REQUIRE(lines.size() == 1 + events.size());
    for (std::size_t i = 0; i < events.size(); ++i) {
      INFO(lines[i + 1].dump());
      CHECK(lines[i + 1].at("iteration") == iteration_of(events[i]));
      std::visit(CheckLine{lines[i + 1]}, events[i]);
    }
  }
}

TEST_CASE("The lines of a scene carry its name, and scenes follow each other") {
  std::vector<std::string> names;
  const std::vector<Json> lines = lines_of(walkthrough("figure-5"));
  for (std::size_t i = 1; i < lines.size(); ++i) names.push_back(lines[i].at("scene"));
  names.erase(std::unique(names.begin(), names.end()), names.end());
  CHECK(names == std::vector<std::string>{"left", "right"});
}

TEST_CASE("On each line of a vertex w = a − b") {
  std::size_t vertices = 0;
  for (const Walkthrough& w : walkthroughs_to_trace())
    for (const Json& line : lines_of(w))
      if (line.value("event", "") == "support-found") {
        const Point w_exactly = point(line.at("a").at("point")) - point(line.at("b").at("point"));
        const bool is_float = w.scenes[0].scalar == Scalar::binary32;
        CHECK(point(line.at("w")) == (is_float ? Point(w_exactly.cast<float>().cast<double>()) : w_exactly));
        ++vertices;
      }
  CHECK(vertices > 0);
}

TEST_CASE("The verdict on a region follows from value and relation") {
  int chosen = 0, rejected = 0;
  for (const Walkthrough& w : walkthroughs_to_trace()) {
    for (const Json& line : lines_of(w)) {
      if (line.value("event", "") != "region-tested" || line.at("verdict") == "skipped") continue;
      if (line.at("feature") == "ABCD") continue;  // what is left when every other region was rejected
      const Json& value = line.at("value");
      const std::string relation = line.at("relation");
      const bool zero = value.is_array() ? point(value) == Point(0, 0, 0) : value == 0.0;
      const bool holds = relation == "= 0"    ? zero
                         : relation == "!= 0" ? !zero
                         : relation == "> 0"  ? value > 0.0
                         : relation == ">= 0" ? value >= 0.0
                                              : relation == "< 0" && value < 0.0;
      CHECK((line.at("verdict") == "rejected") == !holds);
      ++(holds ? chosen : rejected);
    }
  }
  CHECK(chosen > 0);
  CHECK(rejected > 0);
}

TEST_CASE("The walkthroughs use the whole vocabulary of events") {
  std::set<std::string> seen;
  for (const Walkthrough& w : walkthroughs_to_trace())
    for (const Json& line : lines_of(w)) seen.insert(line.value("event", "header"));
  CHECK(seen == std::set<std::string>{"header", "search-started", "support-found", "crossing-tested", "vertex-added",
                                      "region-tested", "simplex-reduced", "direction-chosen", "finished", "truth",
                                      "proof-tried", "sign-taken", "feature-kept", "certified"});
}

}  // namespace trace_json_test
