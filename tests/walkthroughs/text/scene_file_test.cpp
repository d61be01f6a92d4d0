// Scenes that users write: what is read, and what is said about everything else.
#include "walkthroughs/text/scene_file.hpp"

#include <sys/stat.h>
#include <sys/wait.h>

#include <cstdlib>
#include <sstream>

#include "tests/catch.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/text/document.hpp"
#include "walkthroughs/text/scene_limits.hpp"
#include "walkthroughs/trace/trace_json.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;
namespace fs = std::filesystem;

namespace {

// -- Scenes -----------------------------------------------------------------------------------------------------------

const std::string ball = R"({"sphere": {"center": [0, 0, 0], "radius": 1}})";
const std::string corner = R"({"points": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]})";

/// Each on its own line: a on 2, b on 3, the rest from 4 on.
std::string scene_text(const std::string& a, const std::string& b, const std::string& rest = "") {
  return "{\n  \"a\": " + a + ",\n  \"b\": " + b + (rest.empty() ? "" : ",\n  " + rest) + "\n}\n";
}
std::string plane_text(const std::string& a, const std::string& b) { return scene_text(a, b, R"("dimension": 2)"); }

SceneFile parsed(const std::string& text, const std::string& file = "my scene.json") { return parse_scene(text, file); }
Scene scene_of(const std::string& text) { return parsed(text).walkthrough.scenes.at(0); }

const std::vector<Point>& points_of(const Object& object) { return std::get<Points>(object.form); }

// -- Complaints -------------------------------------------------------------------------------------------------------

std::string complaint(const std::string& text) {
  try {
    parsed(text, "bad.json");
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no complaint";
}

/// `place`: "LINE: KEY", or "LINE" for the text as a whole.
void check_complaint(const std::string& text, const std::string& place, const std::vector<std::string>& parts) {
  INFO(text.substr(0, 300));
  const std::string said = complaint(text);
  INFO(said.substr(0, 600));
  CHECK(said.starts_with("bad.json:" + place + ": "));
  for (const std::string& part : parts) CHECK(said.find(part) != std::string::npos);
  CHECK(said.size() < 400);
}

void check_object(const std::string& object, const std::string& place, const std::vector<std::string>& parts) {
  check_complaint(scene_text(object, ball), place, parts);
}
void check_rest(const std::string& rest, const std::string& place, const std::vector<std::string>& parts) {
  check_complaint(scene_text(corner, ball, rest), place, parts);
}

/// A file in a folder of its own.
struct Written {
  explicit Written(const std::string& text, const std::string& name = "scene.json") : path(folder.path() / name) {
    std::ofstream(path, std::ios::binary) << text;
  }
  Folder folder;
  fs::path path;
};

std::string complaint_about_file(const fs::path& file) {
  try {
    read_scene(file);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no complaint";
}

}  // namespace

// -- What is read -----------------------------------------------------------------------------------------------------

TEST_CASE("The example reads without complaint, runs, and shows every key", "[scene-file]") {
  const SceneFile file = parsed(std::string(example_scene()));
  CHECK(file.walkthrough.scenes.size() == 1);
  CHECK(file.size == render::Size{1280, 720});
  CHECK(all<gjk::Finished>(run(file.walkthrough.scenes[0])).size() == 1);
  for (const char* key : {"title",
                          "dimension",
                          "a",
                          "b",
                          "name",
                          "points",
                          "sphere",
                          "cylinder",
                          "sum",
                          "center",
                          "axis",
                          "radius",
                          "height",
                          "pose",
                          "translation",
                          "rotation",
                          "degrees",
                          "first_direction",
                          "iteration_limit",
                          "crossing_test",
                          "rules",
                          "zero_test",
                          "scalar",
                          "panels",
                          "size"})
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
  const Scene& scene = walkthrough.scenes.at(0);
  CHECK(scene.name == "scene");
  CHECK(scene.dimension == Dimension::space);
  CHECK(scene.rules == RuleSet::as_intended);
  CHECK(scene.scalar == Scalar::binary64);
  CHECK(scene.zero_test == ZeroTest::exact);
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

TEST_CASE("A sphere is read as it is written", "[scene-file]") {
  const Scene scene = scene_of(scene_text(corner, R"({"sphere": {"radius": 0.75, "center": [1, -2, 3]}})"));
  const Ball& sphere = std::get<Ball>(scene.b.form);
  CHECK(sphere.center == Point(1, -2, 3));
  CHECK(sphere.radius == 0.75);
}

TEST_CASE("A cylinder is read as it is written", "[scene-file]") {
  const Scene scene = scene_of(
      scene_text(R"({"cylinder": {"center": [1, 2, 3], "axis": [0, 0, -5], "radius": 2, "height": 3}})", ball));
  const Cylinder& cylinder = std::get<Cylinder>(scene.a.form);
  CHECK(cylinder.center == Point(1, 2, 3));
  CHECK(cylinder.axis == Point(0, 0, -1));
  CHECK(cylinder.height == 3);
  CHECK(cylinder.radius == 2);
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

TEST_CASE("In floats the numbers of a sum are floats, too", "[scene-file]") {
  const std::string sum = R"({"sum": [{"points": [[0.1, 0, 0]]}, {"cylinder": {"center": [0, 0, 0.1],
                              "axis": [0.1, 0.3, 0.7], "radius": 0.3, "height": 1}}]})";
  const Scene scene = scene_of(scene_text(sum, ball, R"("scalar": "float")"));
  const Sum& read = std::get<Sum>(scene.a.form);
  CHECK(std::get<Points>(read.summands[0])[0].x() == double{0.1f});
  CHECK(std::get<Cylinder>(read.summands[1]).radius == double{0.3f});
  const gjk::Cylinder<float> in_float(gjk::Vec3<float>::Zero(), {0.1f, 0.3f, 0.7f}, 1, 1);
  CHECK(std::get<Cylinder>(read.summands[1]).axis == in_float.axis().cast<double>());
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

TEST_CASE("Two objects of a kind are told apart by name", "[scene-file]") {
  const Scene scene = scene_of(scene_text(ball, ball));
  CHECK(scene.a.name == "sphere a");
  CHECK(scene.b.name == "sphere b");
  const Scene half_named = scene_of(scene_text(R"({"name": "sun", "points": [[0, 0, 0]]})", ball));
  CHECK(half_named.a.name == "sun");
  CHECK(half_named.b.name == "sphere");
}

TEST_CASE("Comments, a byte order mark and lines that end in CR LF are read", "[scene-file]") {
  CHECK_NOTHROW(parsed("// one\n/* two\n * lines **/" + scene_text(corner, ball) + "// the end"));
  CHECK_NOTHROW(parsed("\xEF\xBB\xBF" + scene_text(corner, ball)));
  std::string text = scene_text(corner, ball, "\"radius\": 1");
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.replace(at, 1, "\r\n");
  check_complaint(text, "4: radius", {"is not a key"});
}

TEST_CASE("The name of a scene can name a folder, whatever its file is called", "[scene-file]") {
  const auto name = [](const std::string& file) { return parsed(scene_text(corner, ball), file).walkthrough.name; };
  CHECK(name("a/b/Tank_2-x.1.json") == "Tank_2-x.1");
  CHECK(name("two words;rm -rf ~.json") == "two-words-rm--rf--");
  CHECK(name("Zürich.json") == "Z--rich");
  CHECK(name("line\nbreak.json") == "line-break");
  CHECK(name("..") == "scene");
  CHECK(name(".") == "scene");
  CHECK(name("") == "scene");
  CHECK(name("/") == "scene");
  CHECK(name("...json") == "scene");
}

TEST_CASE("A title made from the file's name can be drawn, whatever the file is called", "[scene-file]") {
  const auto title = [](const std::string& file) { return parsed(scene_text(corner, ball), file).walkthrough.title; };
  CHECK(title("a/two words.json") == "two words");
  CHECK(title("snake_case.json") == "snake case");
  CHECK(title("line\nbreak.json") == "line-break");
  CHECK(title("\xFF.json") == "-");
  CHECK(title(std::string(200, 'x') + ".json").size() == scene_limits::title);
}

TEST_CASE("Reading a scene computes nothing, and running it asks each object once an iteration", "[scene-file]") {
  for (const char* rules : {"\"rules\": \"as-intended\"", "\"rules\": \"as-printed\"", "\"rules\": \"eager\""}) {
    const Scene scene = scene_of(scene_text(corner, ball, rules));
    CHECK(scene.a.support_calls == 0);
    CHECK(scene.b.support_calls == 0);
    const Trace trace = run(scene);
    const auto iterations = static_cast<std::size_t>(all<gjk::Finished>(trace).at(0).result.iterations);
    CHECK(iterations > 0);
    CHECK(scene.a.support_calls == iterations);
    CHECK(scene.b.support_calls == iterations);
  }
}

TEST_CASE("A scene file says which rules run", "[scene-file]") {
  const std::string away = R"({"sphere": {"center": [10, 0, 0], "radius": 1}})";
  const auto status = [&](const std::string& rest) {
    return all<gjk::Finished>(run(scene_of(scene_text(ball, away, rest)))).at(0).result.status;
  };
  CHECK(status(R"("rules": "as-intended")") == gjk::Status::separated);
  CHECK(status(R"("rules": "as-printed")") == gjk::Status::intersecting);
  CHECK(status(R"("rules": "eager")") == gjk::Status::separated);
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

TEST_CASE("A scene file says in which numbers the search computes, and rounds its own to them", "[scene-file]") {
  const Scene scene = scene_of(scene_text(R"({"points": [[0.1, 0, 0]]})", ball, R"("scalar": "float")"));
  CHECK(scene.scalar == Scalar::binary32);
  CHECK(vertices_of(scene.a).at(0).x() == double{0.1f});
  CHECK(scene_of(scene_text(corner, ball, R"("scalar": "double")")).scalar == Scalar::binary64);
}

TEST_CASE("A scene file says what counts as zero", "[scene-file]") {
  CHECK(scene_of(scene_text(corner, ball, R"("zero_test": "relative")")).zero_test == ZeroTest::relative);
  CHECK(scene_of(scene_text(corner, ball, R"("zero_test": "exact")")).zero_test == ZeroTest::exact);
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

TEST_CASE("Numbers that do not fit into floats are named, and what to do", "[scene-file]") {
  const std::string far_away = R"({"sphere": {"center": [1e40, 0, 0], "radius": 1}})";
  check_complaint(scene_text(corner, far_away, R"("scalar": "float")"), "4: scalar",
                  {"1e+40 is beyond all floats; choose another unit of length, or \"double\""});
}

TEST_CASE("The summary says in one line what a scene declares", "[scene-file]") {
  CHECK(summary(parsed(std::string(example_scene()))) ==
        "'A can beside a tilted box', space, 'box' (8 points) and 'can' (cylinder), panels: search, objects, hull, "
        "algorithm");
  CHECK(summary(parsed(scene_text(R"({"points": [[0, 0]]})", ball, R"("dimension": 2, "panels": [])"))) ==
        "'my scene', plane, 'point set' (1 point) and 'disc' (disc), panels: search");
  const std::string capsule = R"({"name": "capsule", "sum": [{"points": [[0, 0, 0], [1, 0, 0]]}, )" + ball + "]}";
  CHECK(summary(parsed(scene_text(capsule, ball, R"("panels": [])"))) ==
        "'my scene', space, 'capsule' (sum of 2 points and a sphere) and 'sphere' (sphere), panels: search");
}

// -- What is not JSON -------------------------------------------------------------------------------------------------

TEST_CASE("A text that is not JSON is turned away with line and column", "[scene-file]") {
  check_complaint("{\n  \"a\": {},\n}\n", "3", {"not JSON at column 1", "unexpected '}'"});
  check_complaint("{\n  \"a\" {}\n}", "2", {"column 7", "expected ':'"});
  check_complaint("scene: yes\n", "1", {"column 1", "'scene' is not a value"});
  check_complaint("{\n\"a\": {\"points\": [[1,2,\n3", "3: a.points[0][3]", {"unexpected end of input"});
  check_complaint("{}\n{}", "2", {"column 1", "expected end of input"});
  check_complaint("{\n  \"title\": \"one\n two\"}", "2: title", {"control character", "column 16"});
  check_complaint("{ /* never closed\n\n", "2", {"missing closing '*/'"});
  check_complaint("{\"title\": 'x'}", "1: title", {"column 11"});
}

TEST_CASE("An empty file is called empty, and how to begin is said", "[scene-file]") {
  check_complaint("", "1", {"empty", "gjkstep scene --example"});
  check_complaint(" \r\n\t\n", "1", {"empty"});
}

TEST_CASE("A text in another encoding is turned away", "[scene-file]") {
  check_complaint("{\n\"title\": \"\xFF\"}", "2: title", {"ill-formed UTF-8"});
  check_complaint("{\n\"title\": \"\xED\xA0\x80\"}", "2: title", {"ill-formed UTF-8"});
  check_complaint(std::string("\xFF\xFE{\0}\0", 6), "1", {"UTF-16", "save it as UTF-8"});
  check_complaint(scene_text(corner, ball) + std::string("\n\0{", 3), "6", {"byte 0"});
  check_complaint("{\n// \x07\n}", "2", {"byte 7"});
}

TEST_CASE("Blank lines are counted, however many, and strings keep their blanks", "[scene-file]") {
  const std::string many(1000, '\n');
  check_complaint("{" + many + "\"a\": 1" + many + ",\n\n \n\"b\"\n\n:\n\n 2}", "1001: a", {"expected an object"});
  check_complaint("{\"a\": " + corner + ", \"b\": " + ball + ",\n\t \n\r\n\"rules\"\n\n:\n\n 2\n\n}", "8: rules",
                  {"found a number"});
  check_complaint("{\n\n // one\n\n\n// two\n\n \t x", "8", {"column 4"});
  CHECK(parsed(scene_text(corner, ball, "\n\t  \"title\":\n \t  \"  a   b  \"")).walkthrough.title == "  a   b  ");
}

TEST_CASE("Numbers that are not finite are turned away by name", "[scene-file]") {
  check_object(R"({"points": [[0, NaN, 0]]})", "2: a.points[0][1]", {"'NaN' is not a number"});
  check_object(R"({"points": [[0, nan, 0]]})", "2: a.points[0][1]", {"'nan' is not a number"});
  check_object(R"({"points": [[Infinity, 0, 0]]})", "2: a.points[0][0]", {"'Infinity' is not a number"});
  check_object(R"({"points": [[0, 0, -Infinity]]})", "2: a.points[0][2]", {"'-Infinity' is not a number"});
  check_object("{\"sphere\": {\"radius\": 1e999\n}}", "2: a.sphere.radius", {"'1e999' is too large", "1e150"});
  check_complaint("1e999", "1", {"'1e999' is too large"});
}

TEST_CASE("A key that appears twice is turned away where it appears again", "[scene-file]") {
  check_rest("\"title\": \"x\",\n\"title\": \"x\"", "5: title", {"twice"});
  check_object("{\"sphere\": {\"radius\": 1,\n\n\"radius\": 1}}", "4: a.sphere.radius", {"twice"});
}

TEST_CASE("Brackets in one another, keys, elements and values beyond the limits are turned away", "[scene-file]") {
  std::string sixteen_levels;
  for (int i = 0; i < 16; ++i) sixteen_levels += "[0]";
  check_complaint(std::string(17, '['), "1: " + sixteen_levels, {"16 levels"});
  check_complaint(std::string(1 << 20, '['), "1: " + sixteen_levels, {"16 levels"});
  std::string keys = "{";
  for (std::size_t i = 0; i <= document_limits::members; ++i) keys += "\"k" + std::to_string(i) + "\": 0,\n";
  check_complaint(keys, "101: k100", {"an object may have 100"});
  std::string lists = "[";
  for (int i = 0; i < 11; ++i) {
    lists += "[0";
    for (int k = 1; k < 99999; ++k) lists += ",0";
    lists += "],\n";
  }
  check_complaint(lists, "10: [9][99998]", {"a file may have 1000000"});
}

// -- What is not a scene ----------------------------------------------------------------------------------------------

TEST_CASE("A scene is an object", "[scene-file]") { check_complaint("\n[1, 2]\n", "2", {"found a list"}); }

TEST_CASE("An unknown key is turned away with the nearest one that is known", "[scene-file]") {
  check_rest(R"("iteration_limt": 3)", "4: iteration_limt", {"is not a key", "did you mean 'iteration_limit'?"});
  check_object(R"({"point": [[0, 0, 0]]})", "2: a.point", {"did you mean 'points'?"});
  check_object(R"({"sphere": {"centre": [0, 0, 0], "radius": 1}})", "2: a.sphere.centre", {"did you mean 'center'?"});
  check_object(R"({"cylinder": {"hight": 1}})", "2: a.cylinder.hight", {"did you mean 'height'?"});
  check_object("{\"points\": [[0, 0, 0]],\n\"pose\": {\"rotate\": {}}}", "3: a.pose.rotate",
               {"did you mean 'rotation'?"});
  check_object(R"({"points": [[0, 0, 0]], "pose": {"rotation": {"angle": 1}}})", "2: a.pose.rotation.angle",
               {"is not a key"});
  check_rest("\"" + std::string(100000, 'x') + "\": 3", "4: " + std::string(40, 'x') + "…", {"is not a key"});
  check_rest(R"("a\u001b[31mb": 3)", "4: a�[31mb", {"is not a key"});
}

TEST_CASE("A missing key is named", "[scene-file]") {
  check_complaint("{\"a\": " + ball + "}", "1: b", {"is missing", "second object"});
  check_complaint("{\"b\": " + ball + "}", "1: a", {"is missing", "first object"});
  check_object(R"({"sphere": {"radius": 1}})", "2: a.sphere.center", {"is missing", "[x, y, z]"});
  check_object(R"({"sphere": {"center": [0, 0, 0]}})", "2: a.sphere.radius", {"is missing"});
  check_object(R"({"cylinder": {"center": [0, 0, 0], "axis": [0, 0, 1], "radius": 1}})", "2: a.cylinder.height",
               {"is missing"});
  check_object(R"({"points": [[0, 0, 0]], "pose": {"rotation": {"degrees": 1}}})", "2: a.pose.rotation.axis",
               {"is missing"});
  check_object(R"({"points": [[0, 0, 0]], "pose": {"rotation": {"axis": [0, 0, 1]}}})", "2: a.pose.rotation.degrees",
               {"is missing"});
}

TEST_CASE("An object has one shape", "[scene-file]") {
  check_object(R"({"name": "ghost"})", "2: a", {"has no shape", "'points', 'sphere', 'cylinder' or 'sum'"});
  check_object("{\"points\": [[0, 0, 0]],\n\"sphere\": {\"center\": [0, 0, 0], \"radius\": 1}}", "3: a.sphere",
               {"second shape beside 'points'"});
}

TEST_CASE("A sum has two shapes, and what is wrong with one is told by its place", "[scene-file]") {
  const std::string dot = R"({"points": [[0, 0, 0]]})";
  const auto of = [](const std::string& list) { return "{\"sum\": " + list + "}"; };
  check_object(of("{}"), "2: a.sum", {"expected a list of two shapes, found an object"});
  check_object(of("[]"), "2: a.sum", {"expected a list of two shapes, found a list of 0"});
  check_object(of("[" + dot + "]"), "2: a.sum", {"found a list of 1"});
  check_object(of("[" + dot + "," + dot + "," + dot + "]"), "2: a.sum", {"a list of 3", "a sum may be one of the two"});
  check_object(of("[" + dot + ", 1]"), "2: a.sum[1]", {"expected an object with a shape, found a number"});
  check_object(of("[{}, " + dot + "]"), "2: a.sum[0]", {"has no shape; give 'points', 'sphere', 'cylinder' or 'sum'"});
  check_object(of("[" + dot + R"(,
                  {"sphere": {"center": [0, 0, 0], "radius": 0}}])"),
               "3: a.sum[1].sphere.radius", {"larger than 0, found 0"});
  check_object(of("[" + dot + "," + of("[" + dot + R"(, {"points": [[0, 0]]}])") + "]"), "2: a.sum[1].sum[1].points[0]",
               {"a list of 2"});
  check_object(of("[" + dot + R"(, {"points": [[0, 0, 0]], "name": "x"}])"), "2: a.sum[1].name", {"is not a key"});
  check_object(of("[" + dot + R"(, {"points": [[0, 0, 0]], "pose": {}}])"), "2: a.sum[1].pose", {"is not a key"});
  check_object("{\"sum\": [" + dot + "," + dot + "], \"points\": [[0, 0, 0]]}", "2: a.points",
               {"second shape beside 'sum'"});
  check_complaint(plane_text(of(R"([{"points": [[0, 0]]}, {"cylinder": {}}])"), R"({"points": [[0, 0]]})"),
                  "2: a.sum[1].cylinder", {"no cylinders"});
}

TEST_CASE("Four sums may be in one another and not one more", "[scene-file]") {
  const std::string dot = R"({"points": [[0, 0, 0]]})";
  std::string nested = dot;
  for (int i = 0; i < scene_limits::sums; ++i) nested = "{\"sum\": [" + nested + ", " + dot + "]}";
  CHECK_NOTHROW(parsed(scene_text(nested, ball)));
  check_object("{\"sum\": [" + nested + ", " + dot + "]}", "2: a.sum[0].sum[0].sum[0].sum[0].sum",
               {"is a sum within 4 others"});
}

TEST_CASE("A point set has points, and each has three numbers", "[scene-file]") {
  check_object(R"({"points": []})", "2: a.points", {"at least one"});
  check_object("{\"points\": [[0, 0, 0],\n[1]]}", "3: a.points[1]", {"[x, y, z]", "a list of 1"});
  check_object(R"({"points": [[0, 0, 0, 0]]})", "2: a.points[0]", {"a list of 4"});
  check_object(R"({"points": [[]]})", "2: a.points[0]", {"a list of 0"});
  check_object(R"({"points": [[0, 0]]})", "2: a.points[0]", {"a list of 2", "\"dimension\": 2"});
  check_object(R"({"points": [0, 0, 0]})", "2: a.points[0]", {"expected a point [x, y, z], found a number"});
}

TEST_CASE("More than 100,000 points are turned away, and that many are read", "[scene-file]") {
  std::string list;
  for (std::size_t i = 0; i < scene_limits::points; ++i) list += std::string(i ? ",\n" : "") + "[0,0,0]";
  CHECK(points_of(scene_of(scene_text("{\"points\": [" + list + "]}", ball)).a).size() == scene_limits::points);
  check_object("{\"points\": [" + list + ",\n[0,0,0]]}", "100002: a.points", {"a list may have 100000"});
}

TEST_CASE("A value of the wrong type is turned away: what was expected and what was found", "[scene-file]") {
  check_object("null", "2: a", {"expected an object", "found null"});
  check_object("[]", "2: a", {"found a list"});
  check_object(R"({"points": "cube"})", "2: a.points", {"expected a list of points, found a string"});
  check_object(R"({"points": [["1", 0, 0]]})", "2: a.points[0][0]", {"expected a number, found a string"});
  check_object(R"({"points": [[0, true, 0]]})", "2: a.points[0][1]", {"expected a number, found true or false"});
  check_object(R"({"sphere": 1})", "2: a.sphere", {"expected an object with 'center' and 'radius', found a number"});
  check_object(R"({"points": [[0, 0, 0]], "name": 7})", "2: a.name", {"expected a string, found a number"});
  check_object(R"({"points": [[0, 0, 0]], "pose": []})", "2: a.pose", {"found a list"});
  check_rest(R"("title": ["x"])", "4: title", {"expected a string, found a list"});
  check_rest(R"("dimension": "2")", "4: dimension", {"expected a whole number from 2 to 3, found a string"});
  check_rest(R"("first_direction": {})", "4: first_direction", {"expected a point [x, y, z], found an object"});
  check_rest(R"("rules": true)", "4: rules", {"expected 'as-intended', 'as-printed' or 'eager', found true or false"});
  check_rest(R"("panels": "hull")", "4: panels", {"expected a list", "found a string"});
  check_rest(R"("size": 1280)", "4: size", {"expected \"1280x720\" or [1280, 720]", "found a number"});
}

TEST_CASE("Numbers beyond 1e150 are turned away, and 1e150 is read", "[scene-file]") {
  check_object(R"({"points": [[0, 1.1e150, 0]]})", "2: a.points[0][1]", {"1.1e+150 is beyond 1e150"});
  check_object(R"({"points": [[0, 0, -1e300]]})", "2: a.points[0][2]", {"-1e+300 is beyond 1e150"});
  check_object(R"({"sphere": {"center": [0, 0, 0], "radius": 2e150}})", "2: a.sphere.radius", {"beyond 1e150"});
  check_rest(R"("first_direction": [0, 2e150, 0])", "4: first_direction[1]", {"beyond 1e150"});
  CHECK_NOTHROW(parsed(scene_text(R"({"points": [[0, 1e150, -1e150]]})", ball)));
}

TEST_CASE("Radius and height are positive", "[scene-file]") {
  check_object(R"({"sphere": {"center": [0, 0, 0], "radius": 0}})", "2: a.sphere.radius", {"larger than 0, found 0"});
  check_object(R"({"sphere": {"center": [0, 0, 0], "radius": -1.5}})", "2: a.sphere.radius", {"found -1.5"});
  const auto can = [](const std::string& radius, const std::string& height) {
    return R"({"cylinder": {"center": [0, 0, 0], "axis": [0, 0, 1], "radius": )" + radius + R"(, "height": )" + height +
           "}}";
  };
  check_object(can("0", "1"), "2: a.cylinder.radius", {"larger than 0"});
  check_object(can("1", "0"), "2: a.cylinder.height", {"larger than 0"});
  check_object(can("1", "-2"), "2: a.cylinder.height", {"found -2"});
}

TEST_CASE("Directions and axes have a length", "[scene-file]") {
  check_rest(R"("first_direction": [0, -0.0, 0])", "4: first_direction", {"has no length"});
  check_object(R"({"cylinder": {"center": [0, 0, 0], "axis": [0, 0, 0], "radius": 1, "height": 1}})",
               "2: a.cylinder.axis", {"has no length"});
  check_object(R"({"points": [[0, 0, 0]], "pose": {"rotation": {"axis": [0, 0, 0], "degrees": 1}}})",
               "2: a.pose.rotation.axis", {"has no length"});
}

TEST_CASE("A scene of the plane stays in the plane", "[scene-file]") {
  const std::string dot = R"({"points": [[0, 0]]})";
  check_complaint(plane_text(R"({"points": [[0, 0], [0, 0, 1]]})", dot), "2: a.points[1][2]",
                  {"must be 0", "\"dimension\": 2", "found 1"});
  check_complaint(plane_text(R"({"points": [[0]]})", dot), "2: a.points[0]", {"expected a point [x, y]"});
  check_complaint(plane_text(R"({"cylinder": {}})", dot), "2: a.cylinder", {"no cylinders"});
  check_complaint(plane_text(dot, R"({"sphere": {"center": [0, 0, 1], "radius": 1}})"), "3: b.sphere.center[2]",
                  {"must be 0"});
  check_complaint(plane_text(dot, R"({"points": [[0, 0]], "pose": {"translation": [0, 0, 2]}})"),
                  "3: b.pose.translation[2]", {"must be 0"});
  check_complaint(plane_text(dot, R"({"points": [[0, 0]], "pose": {"rotation": {"axis": [1, 0, 1], "degrees": 0}}})"),
                  "3: b.pose.rotation.axis", {"out of the plane"});
  check_complaint(scene_text(dot, dot, "\"first_direction\": [0, 0, 1], \"dimension\": 2"), "4: first_direction[2]",
                  {"must be 0"});
}

TEST_CASE("Whole numbers and words are among those that there are", "[scene-file]") {
  check_rest(R"("dimension": 4)", "4: dimension", {"from 2 to 3, found 4"});
  check_rest(R"("iteration_limit": 0)", "4: iteration_limit", {"from 1 to 1000, found 0"});
  check_rest(R"("iteration_limit": 1001)", "4: iteration_limit", {"found 1001"});
  check_rest(R"("iteration_limit": 2.5)", "4: iteration_limit", {"found 2.5"});
  check_rest(R"("iteration_limit": 18446744073709551616)", "4: iteration_limit", {"found 18446744073709551616"});
  check_rest(R"("crossing_test": "yes")", "4: crossing_test", {"'yes' is not known", "'on' and 'off'"});
  check_rest(R"("rules": "as-print")", "4: rules", {"did you mean 'as-printed'?"});
  check_rest(R"("rules": "eagre")", "4: rules", {"did you mean 'eager'?"});
  check_rest(R"("scalar": "single")", "4: scalar", {"'single' is not known", "'double' and 'float'"});
  check_rest(R"("zero_test": "absolute")", "4: zero_test", {"did you mean", "'exact' and 'relative'"});
  check_rest(R"("panels": ["hull", "camera"])", "4: panels[1]", {"'camera' is not known"});
  check_rest(R"("panels": ["hull", "hull"])", "4: panels[1]", {"'hull' appears twice"});
}

TEST_CASE("A size has two sides, each from 16 to 8192 pixels", "[scene-file]") {
  for (const char* size : {"1280", "x720", "1280x", "1280x720x3", "1280 x 720", "15x720", "1280x8193", "-1280x720",
                           "99999999999x720", "1280×720", ""})
    check_rest(R"("size": ")" + std::string(size) + "\"", "4: size", {"each from 16 to 8192", "found '"});
  check_rest(R"("size": [1280])", "4: size", {"a list of 1"});
  check_rest(R"("size": [1280, 720, 3])", "4: size", {"a list of 3"});
  check_rest(R"("size": [15, 720])", "4: size[0]", {"from 16 to 8192, found 15"});
  check_rest(R"("size": [1280, "720"])", "4: size[1]", {"found a string"});
}

TEST_CASE("Titles and names are short, not empty, and can be shown", "[scene-file]") {
  const auto times = [](int count, const std::string& text) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
  };
  CHECK_NOTHROW(parsed(scene_text(corner, ball, R"("title": ")" + times(120, "ü") + "\"")));
  check_rest(R"("title": ")" + times(121, "ü") + "\"", "4: title", {"has 121 characters", "120"});
  check_rest(R"("title": "")", "4: title", {"is empty"});
  check_rest(R"("title": "  ")", "4: title", {"is empty"});
  for (const char* code : {"\\n", "\\t", "\\u0000", "\\u001b", "\\u007f", "\\u0085", "\\u2028", "\\u202e"})
    check_rest(R"("title": "a)" + std::string(code) + "b\"", "4: title", {"control character"});
  check_object(R"({"points": [[0, 0, 0]], "name": ")" + std::string(41, 'x') + "\"}", "2: a.name", {"41 characters"});
  check_object(R"({"points": [[0, 0, 0]], "name": "a\rb"})", "2: a.name", {"control character"});
}

// -- Files ------------------------------------------------------------------------------------------------------------

TEST_CASE("A scene is read from its file, which errors name", "[scene-file]") {
  const Written good(scene_text(corner, ball), "two balls.json");
  CHECK(read_scene(good.path).walkthrough.name == "two-balls");
  const Written bad(scene_text(corner, "{}"));
  CHECK(complaint_about_file(bad.path).starts_with(bad.path.string() + ":3: b: has no shape"));
}

TEST_CASE("What is not a readable regular file is turned away without waiting for it", "[scene-file]") {
  const Folder folder;
  CHECK(complaint_about_file(folder.path()).starts_with(folder.path().string() + ": is a folder; "));
  CHECK(complaint_about_file("/dev/zero") == "/dev/zero: is not a regular file; name a scene file");
  const fs::path pipe = folder.path() / "pipe";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  CHECK(complaint_about_file(pipe).find(": is not a regular file; ") != std::string::npos);
  const fs::path none = folder.path() / "none.json";
  CHECK(complaint_about_file(none).starts_with(none.string() + ": cannot be read: No such file or directory; "));
  CHECK(complaint_about_file("").find("cannot be read") != std::string::npos);
}

TEST_CASE("A file that is too large is turned away unread", "[scene-file]") {
  const Written file("");
  fs::resize_file(file.path, std::uintmax_t{1} << 40);  // takes no room on the disk
  CHECK(complaint_about_file(file.path).find(": is larger than 16 MiB; ") != std::string::npos);
  fs::resize_file(file.path, scene_limits::bytes + 1);
  CHECK(complaint_about_file(file.path).find("larger than 16 MiB") != std::string::npos);
  fs::resize_file(file.path, scene_limits::bytes);
  CHECK(complaint_about_file(file.path).find("byte 0") != std::string::npos);
}

// -- The program ------------------------------------------------------------------------------------------------------

namespace {

struct Outcome {
  int exit_code;
  std::string out, err;
};

/// Runs `gjkstep scene`.
Outcome run_program(const std::string& arguments) {
  const Folder folder;
  const std::string out = (folder.path() / "out").string(), err = (folder.path() / "err").string();
  const std::string command =
      "'" + std::string(GJKSTEP_PROGRAM) + "' scene " + arguments + " >'" + out + "' 2>'" + err + "'";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, bytes_of(out), bytes_of(err)};
}

}  // namespace

TEST_CASE("gjkstep scene --example prints a scene that gjkstep scene --check accepts", "[scene-file]") {
  const Outcome example = run_program("--example");
  CHECK(example.exit_code == 0);
  CHECK(example.out == example_scene());
  const Written file(example.out);
  const Outcome checked = run_program("--check '" + file.path.string() + "'");
  CHECK(checked.exit_code == 0);
  CHECK(checked.out == file.path.string() + ": ok: " + summary(read_scene(file.path)) + "\n");
  CHECK(checked.err.empty());
}

TEST_CASE("gjkstep scene --check answers a bad scene with exit code 3 and the complaint alone", "[scene-file]") {
  const Written file(scene_text(corner, "{}"));
  const Outcome checked = run_program("--check '" + file.path.string() + "'");
  CHECK(checked.exit_code == 3);
  CHECK(checked.out.empty());
  CHECK(checked.err == "gjkstep: " + complaint_about_file(file.path) + "\n");
}

TEST_CASE("gjkstep scene says what it can do", "[scene-file]") {
  for (const char* arguments : {"", "--example --check x", "--check"}) {
    const Outcome outcome = run_program(arguments);
    INFO(arguments << ": " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.find("--check") != std::string::npos);
  }
}

// -- The corpus of the fuzzer -----------------------------------------------------------------------------------------

TEST_CASE("Each file of the fuzzer's corpus reads and can be told, or is turned away as a SceneError", "[scene-file]") {
  int read = 0, turned_away = 0;
  for (const auto& entry : fs::directory_iterator(GJKSTEP_SCENES)) {
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
    } catch (const SceneError& error) {
      CHECK(std::string(error.what()).starts_with(file + ":"));
      CHECK(file.starts_with("bad-"));
      ++turned_away;
    }
  }
  CHECK(read >= 10);
  CHECK(turned_away >= 40);
  CHECK(bytes_of(fs::path(GJKSTEP_SCENES) / "example.json") == example_scene());
}
