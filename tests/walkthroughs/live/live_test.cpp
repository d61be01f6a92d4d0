#include "walkthroughs/live/live.hpp"

#include <nlohmann/json.hpp>

#include "tests/kit/catch.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/story/storyboard.hpp"
#include "walkthroughs/text/scene_text.hpp"
#include "walkthroughs/trace/trace_json.hpp"

namespace live_test {

using namespace walkthroughs::live;
using Json = nlohmann::ordered_json;

namespace {

/// A page's program, asked with JSON.
struct Page {
  render::Font font{render::Font::default_directory()};
  Live live{font};

  Json operator()(const Json& request) { return Json::parse(live.answer(request.dump())); }
  Json tell(const Json& what) { return (*this)({{"tell", what}}); }
  Json draw(const Json& how) { return (*this)({{"draw", how}}); }
};

Json triangles(double to_the_right) {
  const auto x = [=](double at) { return at + to_the_right; };
  return {{"dimension", 2},
          {"a", {{"points", {{-3, -1}, {1, -2}, {-0.5, 2}}}}},
          {"b", {{"points", {{x(-0.5), 0.5}, {x(3), -1}, {x(2.5), 2}}}}}};
}

Json scene_of(const Json& scene) { return {{"scene", scene.dump()}}; }

/// Returns: what is at that path of the scene; null where there is nothing.
Json at(const Json& scene, const Json& path) {
  Json value = scene;
  for (const Json& key : path) {
    if (key.is_number() ? key >= value.size() : !value.contains(key.get<std::string>())) return nullptr;
    value = key.is_number() ? Json(value[key.get<std::size_t>()]) : Json(value[key.get<std::string>()]);
  }
  return value;
}

}  // namespace

TEST_CASE("What is wrong with a scene is a value, and the story told before stays") {
  Page ask;
  const Json told = ask.tell(scene_of(triangles(0)));
  CHECK(told["answers"]["search"] == "together");
  const Json wrong = ask.tell({{"scene", "{\"dimension\": 2,\n\"a\": {\"points\": [[0, 0], [1, \"x\"]]}}"}});
  CHECK(wrong["error"]["line"] == 2);
  CHECK(wrong["error"]["key"] == "a.points[1][1]");
  CHECK(wrong["error"]["text"] == "a.points[1][1]: expected a number, found a string");
  CHECK(ask.tell({{"name", "no-such"}})["error"]["key"] == "name");
  CHECK(ask.draw({{"frame", 3}})["picture"].get<std::string>().starts_with("<svg "));
}

TEST_CASE("A search of the catalogue is the same when it is read from the scene that a page has of it") {
  for (const Walkthrough& w : whole_catalogue()) {
    if (w.layout != Layout::search) continue;
    INFO(w.name);
    const Reading<SceneFile> read = scene_in(scene_json(w, w.scenes.front()).dump(), "scene.json");
    REQUIRE_FALSE(read.complaint);
    const Scene &one = w.scenes.front(), &other = read.value.walkthrough.scenes.front();
    // Of an axis only the direction is kept.
    CHECK((is_same(one.a, other.a) || std::holds_alternative<Cylinder>(one.a.form)));
    CHECK((is_same(one.b, other.b) || std::holds_alternative<Cylinder>(one.b.form)));
    CHECK(one.options.first_direction == other.options.first_direction);
    CHECK(one.rules == other.rules);
    CHECK(one.scalar == other.scalar);
    CHECK(one.certified == other.certified);
  }
}

TEST_CASE("While one drags the same kind of step is shown, else the last before it") {
  Page ask;
  const Json before = ask.tell(scene_of(triangles(0)));
  for (std::size_t frame = 0; frame < before["story"]["frames"].size(); ++frame) {
    ask.tell(scene_of(triangles(0)));
    CHECK(ask.tell({{"scene", triangles(0).dump()}, {"like", frame}})["frame"] == frame);
  }
  ask.tell(scene_of(triangles(0)));
  const Json apart = ask.tell({{"scene", triangles(9).dump()}, {"like", before["story"]["frames"].size() - 1}});
  CHECK(apart["answers"]["search"] == "apart");
  CHECK(apart["frame"] == apart["story"]["frames"].size() - 1);  // from one end to the other
}

TEST_CASE("Briefly told there is one frame, and no more than a page needs while one drags") {
  Page ask;
  const Json whole = ask.tell(scene_of(triangles(0)));
  const Json brief = ask.tell({{"scene", triangles(0).dump()}, {"like", 4}, {"brief", true}});
  CHECK(brief["frame"] == 4);
  CHECK(brief["story"]["frames"].size() == whole["story"]["frames"].size());
  CHECK(brief["story"]["frames"][4]["caption"] == whole["story"]["frames"][4]["caption"]);
  CHECK(brief["story"]["frames"][3].is_null());
  CHECK(brief["story"]["questions"].empty());
  CHECK(brief["scene"].is_null());
}

TEST_CASE("A held picture keeps its size, whatever is moved") {
  Page ask;
  ask.tell(scene_of(triangles(0)));
  const auto corner = [&] {
    const Json drawn = ask.draw(Json::object());
    for (const Json& grip : drawn["grips"])
      if (grip["name"] == "a.points[0]") return grip["at"];
    return Json();
  };
  const Json place = corner();
  ask({{"hold", true}});
  ask.tell(scene_of(triangles(4)));
  CHECK(corner() == place);
  ask({{"hold", false}});
  CHECK(corner() != place);
}

TEST_CASE("Every grip moves something that the scene has, or may have") {
  Page ask;
  Json scene = triangles(0);
  scene["dimension"] = 3;
  scene["a"] = {{"sum", {{{"sphere", {{"center", {0, 0, 0}}, {"radius", 1}}}}, {{"points", {{0, 0, 0}, {1, 0, 0}}}}}}};
  for (const Json& b :
       {Json{{"sphere", {{"center", {5, 0, 0}}, {"radius", 1}}}},
        Json{{"capsule", {{"from", {5, 0, 0}}, {"to", {5, 1, 0}}, {"radius", 1}}}},
        Json{{"box", {{"center", {5, 0, 0}}, {"size", {1, 1, 1}}}}, {"pose", {{"translation", {1, 0, 0}}}}}}) {
    scene["b"] = b;
    const Json told = ask.tell(scene_of(scene));
    REQUIRE_FALSE(told.contains("error"));
    const Json drawn = ask.draw(Json::object());
    CHECK(drawn["grips"].size() >= 2);
    for (const Json& grip : drawn["grips"]) {
      INFO(grip.dump());
      CHECK(grip["paths"].size() >= 1);
      for (const Json& path : grip["paths"]) {
        const Json value = at(told["scene"], path);
        CHECK((value.is_null() || value.size() == 3));
        CHECK((!value.is_null() || path.back() == "translation"));
      }
    }
  }
}

TEST_CASE("A switch says what the scene says, and each of its choices is one that can be read") {
  Page ask;
  const Json told = ask.tell(scene_of(triangles(0)));
  CHECK(told["switches"].size() == 7);
  for (const Json& each : told["switches"])
    for (const Json& choice : each["choices"]) {
      INFO(each["key"].dump() << choice.dump());
      Json scene = told["scene"];
      scene[each["key"].get<std::string>()] = choice["value"];
      if (choice["value"].is_null()) scene.erase(each["key"].get<std::string>());
      const Json other = ask.tell(scene_of(scene));
      REQUIRE_FALSE(other.contains("error"));
      for (const Json& again : other["switches"])
        if (again["key"] == each["key"]) CHECK(again["choices"][again["chosen"].get<std::size_t>()] == choice);
    }
}

TEST_CASE("A trace that is dropped is told, and one that contradicts itself is not") {
  Page ask;
  const Walkthrough& w = *find_walkthrough("figure-4-right");
  std::string trace = traces_json(w, {run(w.scenes[0])}, {truth_of(w.scenes[0], gjk::Status::separated)});
  CHECK(ask.tell({{"trace", trace}})["answers"]["search"] == "apart");
  trace.replace(trace.find("not-crossed"), 11, "crossed");
  CHECK(ask.tell({{"trace", trace}}).contains("error"));
}

TEST_CASE("Each choice of a question about regions, vertices and directions can be pointed at, apart from the others") {
  Page ask;
  int pressed = 0, drawn = 0;
  for (const Walkthrough& w : whole_catalogue()) {
    if (w.layout != Layout::search || w.scenes[0].certified) continue;
    INFO(w.name);
    const Json questions = ask.tell({{"name", w.name}})["story"]["questions"];
    for (std::size_t k = 0; k < questions.size(); ++k) {
      const Json& question = questions[k];
      const Json picture = ask.draw({{"frame", question["before"].get<int>() - 1}, {"asks", k}});
      const Json& aims = picture["aims"];
      const std::size_t count = question["choices"].size();
      const bool is_of_two = question["kind"] == "crossing" || count == 2;
      if (aims.empty() && is_of_two) continue;
      INFO(question.dump());
      REQUIRE(aims.size() == count);
      for (std::size_t i = 0; i < count; ++i) {
        CHECK(aims[i]["choice"] == i);
        const Json& at = aims[i].contains("at") ? aims[i]["at"] : aims[i]["from"];
        CHECK((at[0] > 0 && at[0] < picture["width"] && at[1] > 0 && at[1] < picture["height"]));
        for (std::size_t j = 0; j < i && aims[i].contains("at"); ++j)
          CHECK(std::hypot(at[0].get<double>() - aims[j]["at"][0].get<double>(),
                           at[1].get<double>() - aims[j]["at"][1].get<double>()) > 25);
      }
      (aims[0].contains("at") ? pressed : drawn) += 1;
    }
  }
  CHECK(pressed > 100);
  CHECK(drawn > 50);
}

TEST_CASE("The direction that comes next leads from the newest vertex to the origin, where it is the only one") {
  Page ask;
  const Json told = ask.tell({{"name", "regions/0-simplex-elsewhere"}, {"screen", 3}});
  CHECK(told["is_done"] == false);
  const Json picture = ask.draw({{"frame", told["frame"]}, {"asks", "direction"}});
  REQUIRE(picture["aims"].size() == 1);
  const Json &from = picture["aims"][0]["from"], &by = picture["aims"][0]["by"];
  // AO = (-1, -2): to the left, and on a page downwards.
  CHECK(by[0].get<double>() < 0);
  CHECK(by[1].get<double>() / by[0].get<double>() == Approx(-2));
  CHECK(from[0].get<double>() > 0);
}

}  // namespace live_test
