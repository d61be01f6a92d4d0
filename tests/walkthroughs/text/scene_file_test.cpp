// Scenes that users write: what is read, from which files, and what it means.
#include "walkthroughs/text/scene_file.hpp"

#include <sstream>

#include "tests/kit/catch.hpp"
#include "tests/kit/places.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/trace/trace_json.hpp"

namespace scene_file_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;
namespace fs = std::filesystem;

namespace {

const std::string ball = R"({"sphere": {"center": [0, 0, 0], "radius": 1}})";
const std::string corner = R"({"points": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]})";

/// Each on its own line: a on 2, b on 3, the rest from 4 on.
std::string scene_text(const std::string& a, const std::string& b, const std::string& rest = "") {
  return "{\n  \"a\": " + a + ",\n  \"b\": " + b + (rest.empty() ? "" : ",\n  " + rest) + "\n}\n";
}
std::string plane_text(const std::string& a, const std::string& b) { return scene_text(a, b, R"("dimension": 2)"); }

SceneFile parsed(const std::string& text) { return parse_scene(text, "my scene.json"); }
Scene scene_of(const std::string& text) { return parsed(text).walkthrough.scenes.at(0); }

const std::vector<Point>& points_of(const Object& object) { return std::get<Points>(object.form); }

}  // namespace

// -- What is read -----------------------------------------------------------------------------------------------------

TEST_CASE("The example reads without complaint, runs, and shows every key", "[scene-file]") {
  const SceneFile file = parsed(std::string(example_scene()));
  CHECK(file.walkthrough.scenes.size() == 1);
  CHECK(file.size == render::Size{1280, 720});
  CHECK(file.text_scale == 1);
  CHECK(all<gjk::Finished>(run(file.walkthrough.scenes[0])).size() == 1);
  for (const char* key : {"title",           "dimension",     "a",           "b",         "name",    "points",
                          "sphere",          "cylinder",      "sum",         "center",    "axis",    "radius",
                          "height",          "pose",          "translation", "rotation",  "degrees", "first_direction",
                          "iteration_limit", "crossing_test", "rules",       "zero_test", "scalar",  "certified", "mistake",
                          "panels",          "size",          "text_scale"})
    CHECK(example_scene().find("\"" + std::string(key) + "\"") != std::string_view::npos);
}

TEST_CASE("The smallest scene is two objects and everything else has a default", "[scene-file]") {
  const SceneFile file = parsed(scene_text(corner, ball));
  const Walkthrough& walkthrough = file.walkthrough;
  CHECK(walkthrough.name == "my-scene");
  CHECK(walkthrough.title == "my scene");
  CHECK(walkthrough.layout == Layout::search);
  CHECK(walkthrough.naming == Naming::roles);
  CHECK(walkthrough.panels.objects);
  CHECK(walkthrough.panels.hull);
  CHECK(walkthrough.panels.algorithm);
  CHECK_FALSE(file.size.has_value());
  CHECK_FALSE(file.text_scale.has_value());
  const Scene& scene = walkthrough.scenes.at(0);
  CHECK(scene.name == "scene");
  CHECK(scene.dimension == Dimension::space);
  CHECK(scene.rules == RuleSet::as_intended);
  CHECK(scene.scalar == Scalar::binary64);
  CHECK(scene.zero_test == ZeroTest::exact);
  CHECK_FALSE(scene.certified);
  CHECK(scene.options.first_direction == Point(1, 0, 0));
  CHECK(scene.options.iteration_limit == 20);
  CHECK(scene.options.crossing_test == gjk::CrossingTest::on);
  CHECK(scene.a.name == "point set");
  CHECK(scene.b.name == "sphere");
  CHECK(scene.a.pose.rotation.isIdentity(0));
  CHECK(scene.a.pose.translation.isZero(0));
}

TEST_CASE("What a scene says replaces the defaults", "[scene-file]") {
  const SceneFile file = parsed(scene_text(corner, ball,
                                           R"("title": "Zürich → π", "first_direction": [0, -2, 1e-3],
    "iteration_limit": 1000, "crossing_test": "off", "rules": "as-printed", "panels": ["hull"], "size": [16, 8192])"));
  const Scene& scene = file.walkthrough.scenes.at(0);
  CHECK(file.walkthrough.title == "Zürich → π");
  CHECK(scene.options.first_direction == Point(0, -2, 1e-3));
  CHECK(scene.options.iteration_limit == 1000);
  CHECK(scene.options.crossing_test == gjk::CrossingTest::off);
  CHECK(scene.rules == RuleSet::as_printed);
  CHECK(file.walkthrough.panels.hull);
  CHECK_FALSE(file.walkthrough.panels.objects);
  CHECK_FALSE(file.walkthrough.panels.algorithm);
  CHECK(file.size == render::Size{16, 8192});
  CHECK(parsed(scene_text(corner, ball, R"("size": "640x480")")).size == render::Size{640, 480});
  for (const double scale : {0.75, 1.25, 1.5})
    CHECK(parsed(scene_text(corner, ball, "\"text_scale\": " + number_text(scale))).text_scale == scale);
  const Panels none = parsed(scene_text(corner, ball, R"("panels": [])")).walkthrough.panels;
  CHECK_FALSE((none.objects || none.hull || none.algorithm));
}

TEST_CASE("Points are read as they are written, to the last digit", "[scene-file]") {
  const Scene scene = scene_of(scene_text(
      R"({"name": "p", "points": [[0.1, -2e-3, 3], [1e150, 0, 5e-324], [-0, 7, 8]]})", R"({"points": [[1, 2, 3]]})"));
  CHECK(scene.a.name == "p");
  CHECK(points_of(scene.a) == std::vector<Point>{{0.1, -2e-3, 3}, {1e150, 0, 5e-324}, {0, 7, 8}});
  CHECK(points_of(scene.b) == std::vector<Point>{{1, 2, 3}});
}

TEST_CASE("A sum is read as its two shapes are, in the plane and in space, also within a sum", "[scene-file]") {
  const std::string segment = R"({"points": [[0, 0, -1], [0, 0, 1]]})";
  const Scene scene = scene_of(
      scene_text(R"({"sum": [)" + segment + R"(, {"sum": [{"sphere": {"center": [1, 0, 0], "radius": 0.5}}, {"cylinder":
          {"center": [0, 2, 0], "axis": [0, 4, 0], "radius": 1, "height": 3}}]}], "pose": {"translation": [9, 0, 0]}})",
                 ball));
  const Sum& sum = std::get<Sum>(scene.a.form);
  REQUIRE(sum.summands.size() == 2);
  CHECK(std::get<Points>(sum.summands[0]) == Points{{0, 0, -1}, {0, 0, 1}});
  const Sum& inner = std::get<Sum>(sum.summands[1]);
  CHECK(std::get<Ball>(inner.summands[0]).radius == 0.5);
  CHECK(std::get<Cylinder>(inner.summands[1]).axis == Point(0, 1, 0));
  CHECK(scene.a.pose.translation == Point(9, 0, 0));
  CHECK(scene.a.name == "sum of a point set and a sum");
  const Scene flat = scene_of(plane_text(R"({"sum": [{"points": [[0, 0], [2, 0]]},
                                             {"sphere": {"center": [1, 1], "radius": 0.5}}]})",
                                         R"({"points": [[9, 9]]})"));
  CHECK(std::get<Points>(std::get<Sum>(flat.a.form).summands[0])[1] == Point(2, 0, 0));
  CHECK(flat.a.name == "sum of a point set and a disc");
}

TEST_CASE("A pose first turns, counter-clockwise about its axis, and then moves", "[scene-file]") {
  const auto posed = [](const std::string& pose) {
    return vertices_of(scene_of(scene_text(R"({"points": [[1, 2, 3]], "pose": )" + pose + "}", ball)).a).at(0);
  };
  CHECK(posed(R"({"translation": [10, 20, 30]})") == Point(11, 22, 33));
  CHECK(posed(R"({"rotation": {"axis": [0, 0, 9], "degrees": 90}})") == Point(-2, 1, 3));
  CHECK(posed(R"({"rotation": {"axis": [0, 0, 1], "degrees": -90}})") == Point(2, -1, 3));
  CHECK(posed(R"({"rotation": {"axis": [1e-320, 0, 0], "degrees": 180}})") == Point(1, -2, -3));
  CHECK(posed(R"({"rotation": {"axis": [0, 0, 1], "degrees": 90}, "translation": [10, 0, 0]})") == Point(8, 1, 3));
  CHECK(posed(R"({"rotation": {"axis": [1, 1, 1], "degrees": 720}})") == Point(1, 2, 3));
  CHECK((posed(R"({"rotation": {"axis": [1, 1, 1], "degrees": 120}})") - Point(3, 1, 2)).norm() <= 1e-15);
  CHECK(posed("{}") == Point(1, 2, 3));
}

TEST_CASE("The rotation of a pose is rigid, however long its axis", "[scene-file]") {
  for (const char* axis : {"[1, -2, 3]", "[1e-320, 2e-320, 0]", "[1e150, 1e150, -1e150]"}) {
    const std::string pose = R"(, "pose": {"rotation": {"axis": )" + std::string(axis) + R"(, "degrees": 33.3}}})";
    const Eigen::Matrix3d turn = scene_of(scene_text(R"({"points": [[1, 2, 3]])" + pose, ball)).a.pose.rotation;
    INFO(axis);
    CHECK((turn * turn.transpose() - Eigen::Matrix3d::Identity()).norm() <= 1e-15);
    CHECK(turn.determinant() == Approx(1));
    CHECK(turn.trace() == Approx(1 + 2 * std::cos(33.3 * 3.14159265358979 / 180)));
  }
}

TEST_CASE("In the plane points have two numbers, spheres are discs, and a rotation needs no axis", "[scene-file]") {
  const Scene scene = scene_of(plane_text(
      R"({"points": [[1, 2], [3, 4, 0]], "pose": {"rotation": {"degrees": 90}, "translation": [10, 0]}})",
      R"({"sphere": {"center": [5, 6], "radius": 2}, "pose": {"rotation": {"axis": [0, 0, -1], "degrees": 90}}})"));
  CHECK(scene.dimension == Dimension::plane);
  CHECK(vertices_of(scene.a) == std::vector<Point>{{8, 1, 0}, {6, 3, 0}});
  CHECK(std::get<Ball>(scene.b.form).center == Point(5, 6, 0));
  CHECK(scene.b.pose(Point(5, 6, 0)) == Point(6, -5, 0));
  CHECK(scene.b.name == "disc");
}

TEST_CASE("Comments, a byte order mark and lines that end in CR LF are read", "[scene-file]") {
  CHECK_NOTHROW(parsed("// one\n/* two\n * lines **/" + scene_text(corner, ball) + "// the end"));
  CHECK_NOTHROW(parsed("\xEF\xBB\xBF" + scene_text(corner, ball)));
  std::string text = scene_text(corner, ball, "\"radius\": 1");
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.replace(at, 1, "\r\n");
  CHECK_THROWS_WITH(parsed(text), kit::starts_with("my scene.json:4: radius: is not a key"));
}

TEST_CASE("Eager rules begin from center to center where the scene does not say otherwise", "[scene-file]") {
  const auto first = [](const std::string& a, const std::string& b, const std::string& rest) {
    return scene_of(scene_text(a, b, rest)).options.first_direction;
  };
  const std::string eager = R"("rules": "eager")";
  const std::string triangle = R"({"points": [[0, 0, 0], [3, 0, 0], [0, 6, 0]]})";  // around (1, 2, 0)
  const std::string can =
      R"({"cylinder": {"center": [1, 0, 0], "axis": [0, 0, 1], "radius": 1, "height": 2},
          "pose": {"rotation": {"axis": [0, 0, 1], "degrees": 90}, "translation": [0, 8, 1]}})";  // around (0, 9, 1)
  CHECK(first(triangle, can, eager).isApprox(Point(-1, 7, 1)));
  CHECK(first(triangle, can, eager + R"(, "scalar": "float")").isApprox(Point(-1, 7, 1), 1e-6));
  CHECK(first(triangle, can, eager + R"(, "first_direction": [0, 0, 2])") == Point(0, 0, 2));
  CHECK(first(triangle, triangle, eager) == Point(1, 0, 0));
  for (const char* const others : {"as-intended", "as-printed"})
    CHECK(first(triangle, can, R"("rules": ")" + std::string(others) + "\"") == Point(1, 0, 0));
  const std::string end = R"({"points": [[1e150, 0, 0]]})", other_end = R"({"points": [[-1e150, 0, 0]]})";
  CHECK(first(end, other_end, eager) == Point(-2e150, 0, 0));
}

TEST_CASE("In floats a cylinder has the axis that its numbers have as floats, of whatever length", "[scene-file]") {
  const auto axis = [](const std::string& written) {
    const std::string cylinder =
        R"({"cylinder": {"center": [0, 0, 0], "radius": 1, "height": 1, "axis": )" + written + "}}";
    return std::get<Cylinder>(scene_of(scene_text(corner, cylinder, R"("scalar": "float")")).b.form).axis;
  };
  CHECK(axis("[0, 0, 1e-100]") == Point(0, 0, 1));
  CHECK(axis("[0, -1e100, 0]") == Point(0, -1, 0));
  const gjk::Cylinder<float> in_float(gjk::Vec3<float>::Zero(), {0.1f, 0.3f, 0.7f}, 1, 1);
  CHECK(axis("[0.1, 0.3, 0.7]") == in_float.axis().cast<double>());
  const gjk::Cylinder<double> in_double(Point::Zero(), {0.1, 0.3, 0.7}, 1, 1);
  CHECK(axis("[0.1, 0.3, 0.7]") != in_double.axis().cast<float>().cast<double>());
}

TEST_CASE("In floats eager rules begin between the centers, or along +x where no float tells how", "[scene-file]") {
  const auto first = [](const std::string& x) {
    return scene_of(scene_text("{\"points\": [[-" + x + ", 0, 0]]}", "{\"points\": [[" + x + ", 0, 0]]}",
                               R"("rules": "eager", "scalar": "float")"))
        .options.first_direction;
  };
  CHECK(first("0.1") == Point(0.2f, 0, 0));
  CHECK(first("3e38") == Point(1, 0, 0));
  CHECK(first("1e-46") == Point(1, 0, 0));
}

// -- Files ------------------------------------------------------------------------------------------------------------

TEST_CASE("A scene is read from its file, which errors name", "[scene-file]") {
  const Folder folder;
  CHECK(read_scene(kit::write(folder / "two balls.json", scene_text(corner, ball))).walkthrough.name == "two-balls");
  const fs::path bad = kit::write(folder / "bad.json", scene_text(corner, "{}"));
  CHECK_THROWS_WITH(read_scene(bad), kit::starts_with(bad.string() + ":3: b: has no shape"));
}

// -- The corpus of the fuzzer -----------------------------------------------------------------------------------------

TEST_CASE("A mistake stands beside the report's search, and only where that is the usual one") {
  const auto with = [](const std::string& more) {
    return R"({"dimension": 2, "a": {"points": [[0, 0], [1, 0]]}, "b": {"points": [[2, 0]]}, "mistake": "m9-abn-inward")" + more + "}";
  };
  const SceneFile file = parsed(with(""));
  REQUIRE(file.walkthrough.scenes.size() == 2);
  CHECK(file.walkthrough.layout == Layout::until_they_part);
  CHECK(file.walkthrough.scenes[0].mistake == Mistake::triangle_abn_inward);
  CHECK(file.walkthrough.scenes[0].name == "M9");
  CHECK_FALSE(file.walkthrough.scenes[1].mistake);
  CHECK_THAT(summary(file), kit::contains(", mistake M9, panels"));
  for (const char* unusual : {R"("rules": "complete")", R"("scalar": "float")", R"("zero_test": "relative")",
                              R"("crossing_test": "off")", R"("certified": true)"})
    CHECK_THROWS_WITH(parsed(with(std::string(", ") + unusual)),
                      kit::starts_with("my scene.json:1: mistake: is made in the report's rules"));
}

TEST_CASE("Each file of the fuzzer's corpus reads and can be told, or is turned away as a InputError", "[scene-file]") {
  int read = 0, turned_away = 0;
  for (const auto& entry : fs::directory_iterator(kit::source("tests/fuzz/scenes"))) {
    const std::string file = entry.path().filename().string();
    INFO(file);
    const std::string text = bytes_of(entry.path());
    CHECK((file.starts_with("bad-") || file.starts_with("ok-") || file == "example.json"));
    try {
      const SceneFile scene = parse_scene(text, file);
      std::ostringstream told;
      write_traces(told, scene.walkthrough);
      CHECK(told.str().find("\"finished\"") != std::string::npos);
      CHECK_FALSE(file.starts_with("bad-"));
      ++read;
    } catch (const InputError& error) {
      CHECK(std::string(error.what()).starts_with(file + ":"));
      CHECK(file.starts_with("bad-"));
      ++turned_away;
    }
  }
  CHECK(read >= 10);
  CHECK(turned_away >= 40);
  CHECK(bytes_of(kit::source("tests/fuzz/scenes") / "example.json") == example_scene());
}

}  // namespace scene_file_test
