// Scenes that are turned away: each with the line, the key and what to do.
#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/text/scene_texts.hpp"
#include "walkthroughs/text/document.hpp"
#include "walkthroughs/text/scene_limits.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

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
  check_complaint("{\n\"title\": \"\xFF\"}", "2",
                  {"is not UTF-8 at column 11: the byte \\xff", "save the text as UTF-8"});
  check_complaint("{\n\"title\": \"\xED\xA0\x80\"}", "2", {"is not UTF-8 at column 11: the byte \\xed"});
  check_complaint(
      "{\n // Gr\xF6\xDF"
      "e\n}",
      "2", {"is not UTF-8 at column 7: the byte \\xf6"});
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
  check_object("{\"sphere\": {\"radius\": 1e999\n}}", "2: a.sphere.radius", {"'1e999' is too large", "1.8e308"});
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
  check_rest(R"("a\u001b[31mb": 3)", "4: a\\x1b[31mb", {"is not a key"});
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
  check_rest(R"("rules": true)", "4: rules",
             {"expected 'as-intended', 'as-printed', 'eager' or 'complete', found true or false"});
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
  check_rest(R"("certified": "yes")", "4: certified", {"expected true or false"});
  check_rest(R"("panels": ["hull", "camera"])", "4: panels[1]", {"'camera' is not known"});
  check_rest(R"("panels": ["hull", "hull"])", "4: panels[1]", {"'hull' appears twice"});
}

TEST_CASE("What is not made of points at rest cannot be certified", "[scene-file]") {
  check_complaint("{\"a\": " + corner + ",\n\"b\": " + ball + ",\n\"certified\": true}", "2: b.sphere",
                  {"a sphere cannot be certified", "give points, or leave out 'certified'"});
  const std::string moved = R"({"points": [[0, 0, 0]], "pose": {"translation": [1, 0, 0]}})";
  check_complaint("{\"a\": " + moved + ",\n\"b\": " + corner + ",\n\"certified\": true}", "1: a.pose",
                  {"an object that its pose moves cannot be certified", "leave out 'certified'"});
  CHECK(parsed("{\"a\": " + moved + ",\n\"b\": " + ball + ",\n\"certified\": false}").walkthrough.scenes.size() == 1);
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

TEST_CASE("The scale of text is a number from 0.75 to 1.5", "[scene-file]") {
  for (const char* scale : {"0.74", "1.51", "0", "-1", "1e10"})
    check_rest(R"("text_scale": )" + std::string(scale), "4: text_scale",
               {"expected a number from 0.75 to 1.5, found"});
  check_rest(R"("text_scale": "1.5")", "4: text_scale", {"expected a number"});
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
    check_rest(R"("title": "a)" + std::string(code) + "b\"", "4: title", {"cannot be shown"});
  check_object(R"({"points": [[0, 0, 0]], "name": ")" + std::string(41, 'x') + "\"}", "2: a.name", {"41 characters"});
  check_object(R"({"points": [[0, 0, 0]], "name": "a\rb"})", "2: a.name", {"cannot be shown"});
}
