#include "walkthroughs/scene_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <numbers>
#include <span>

#include "render/rasterizer.hpp"
#include "walkthroughs/document.hpp"
#include "walkthroughs/nearest.hpp"

namespace walkthroughs {
namespace {

using Kind = Document::Kind;
using Keys = std::initializer_list<std::string>;

// -- Words ------------------------------------------------------------------------------------------------------------

/// Returns: the shortest text that reads back as the same number.
std::string written(double number) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, number).ptr;
  return {text, end};
}

/// Returns: "'a', 'b' or 'c'", with `last` in place of "or".
std::string list_of(std::span<const std::string> words, const std::string& last) {
  std::string list;
  for (std::size_t i = 0; i < words.size(); ++i)
    list += (i == 0 ? "'" : i + 1 == words.size() ? " " + last + " '" : ", '") + words[i] + "'";
  return list;
}

std::string suggestion(const std::string& word, std::span<const std::string> known) {
  return "did you mean '" + nearest(std::string_view(word).substr(0, 64), known) + "'? Known here are " +
         list_of(known, "and");
}

// -- Values -----------------------------------------------------------------------------------------------------------

void expect(const Value& value, Kind kind, std::string_view expected) {
  if (!value.is(kind)) value.fail("expected " + std::string(expected) + ", found " + std::string(value.description()));
}

void expect_object(const Value& value, const Keys& keys, std::string_view expected) {
  expect(value, Kind::object, expected);
  for (const Value& member : value.children())
    if (std::ranges::count(keys, member.key()) == 0)
      member.fail("is not a key; " + suggestion(member.key(), std::span(keys.begin(), keys.size())));
}

Value required(const Value& object, std::string_view key, const std::string& what_to_do) {
  if (const auto member = object.member(key)) return *member;
  object.fail_without(key, "is missing; " + what_to_do);
}

double number(const Value& value) {
  expect(value, Kind::number, "a number");
  if (!(std::abs(value.number()) <= scene_limits::magnitude))
    value.fail(written(value.number()) +
               " is beyond 1e150 in magnitude, where squares of lengths overflow; choose a larger unit of length");
  return value.number();
}

double length(const Value& object, std::string_view key) {
  const Value value = required(object, key, "give it as a positive number");
  const double found = number(value);
  if (!(found > 0)) value.fail("must be larger than 0, found " + written(found) + "; give a positive length");
  return found;
}

int whole_number(const Value& value, int low, int high) {
  const std::string range = "a whole number from " + std::to_string(low) + " to " + std::to_string(high);
  expect(value, Kind::number, range);
  const double found = value.number();
  if (found != std::floor(found) || found < low || found > high)
    value.fail("expected " + range + ", found " + written(found));
  return static_cast<int>(found);
}

/// Returns: the position of the word in `words`.
std::size_t choice(const Value& value, const Keys& words) {
  const std::span<const std::string> known(words.begin(), words.size());
  expect(value, Kind::string, list_of(known, "or"));
  const auto found = std::ranges::find(known, value.text());
  if (found == known.end()) value.fail(in_quotes(value.text()) + " is not known; " + suggestion(value.text(), known));
  return static_cast<std::size_t>(found - known.begin());
}

std::string words(const Value& value, std::size_t longest) {
  expect(value, Kind::string, "a string");
  const std::u32string points = code_points(value.text());
  const bool blank = std::ranges::all_of(points, [](char32_t c) { return c == U' '; });
  if (blank) value.fail("is empty; write something, or leave the key out");
  if (!std::ranges::all_of(points, is_printable))
    value.fail("has a control character, such as a line break or a tab; leave it out");
  if (points.size() > longest)
    value.fail("has " + std::to_string(points.size()) + " characters; shorten it to " + std::to_string(longest));
  return value.text();
}

/// Where a scene lies decides what a point looks like.
struct Space {
  Dimension dimension;

  bool is_plane() const { return dimension == Dimension::plane; }
  std::string point_words() const { return is_plane() ? "a point [x, y]" : "a point [x, y, z]"; }

  Point point(const Value& value) const {
    expect(value, Kind::list, point_words());
    const std::vector<Value> numbers = value.children();
    if (numbers.size() != 3 && !(is_plane() && numbers.size() == 2)) wrong_count(value, numbers.size());
    Point found = Point::Zero();
    for (std::size_t i = 0; i < numbers.size(); ++i) found[static_cast<int>(i)] = number(numbers[i]);
    if (is_plane() && found.z() != 0)
      numbers[2].fail("must be 0, because the scene has \"dimension\": 2; found " + written(found.z()));
    return found;
  }

  Point direction(const Value& value) const {
    const Point found = point(value);
    if (found.isZero(0)) value.fail("has no length; give a direction other than zero");
    return found;
  }

 private:
  [[noreturn]] void wrong_count(const Value& value, std::size_t count) const {
    const char* const hint = !is_plane() && count == 2 ? "; for a scene of the plane say \"dimension\": 2" : "";
    value.fail("expected " + point_words() + ", found a list of " + std::to_string(count) + hint);
  }
};

// -- Objects ----------------------------------------------------------------------------------------------------------

Points read_points(const Value& value, const Space& space) {
  expect(value, Kind::list, "a list of points");
  const std::vector<Value> children = value.children();
  if (children.empty()) value.fail("has no point; a point set needs at least one");
  static_assert(scene_limits::points == document_limits::elements, "longer lists have been turned away by now");
  std::vector<Point> points;
  points.reserve(children.size());
  for (const Value& child : children) points.push_back(space.point(child));
  return Points(std::move(points));
}

Ball read_sphere(const Value& value, const Space& space) {
  expect_object(value, {"center", "radius"}, "an object with 'center' and 'radius'");
  const Point center = space.point(required(value, "center", "give it as " + space.point_words()));
  return {center, length(value, "radius")};
}

Cylinder read_cylinder(const Value& value, const Space& space) {
  if (space.is_plane())
    value.fail(
        "a scene with \"dimension\": 2 has no cylinders; use a sphere (a disc) or points, or say \"dimension\": 3");
  expect_object(value, {"center", "axis", "radius", "height"},
                "an object with 'center', 'axis', 'radius' and 'height'");
  const Point center = space.point(required(value, "center", "give it as " + space.point_words()));
  const Point axis = space.direction(required(value, "axis", "give it as a direction [x, y, z]"));
  const double radius = length(value, "radius");
  return {center, axis, radius, length(value, "height")};
}

/// Returns: cosine and sine, exact for quarter turns.
std::pair<double, double> cosine_and_sine(double degrees) {
  const double rest = std::remainder(degrees, 360);
  if (rest == 0) return {1, 0};
  if (std::abs(rest) == 180) return {-1, 0};
  if (std::abs(rest) == 90) return {0, rest > 0 ? 1 : -1};
  const double radians = rest * (std::numbers::pi / 180);
  return {std::cos(radians), std::sin(radians)};
}

/// Rodrigues' formula.
Eigen::Matrix3d rotation_about(const Point& axis, double degrees) {
  const Point n = (axis / axis.cwiseAbs().maxCoeff()).normalized();  // in two steps: |axis|² may under- or overflow
  const auto [cosine, sine] = cosine_and_sine(degrees);
  Eigen::Matrix3d cross;
  cross << 0, -n.z(), n.y(), n.z(), 0, -n.x(), -n.y(), n.x(), 0;
  return cosine * Eigen::Matrix3d::Identity() + (1 - cosine) * n * n.transpose() + sine * cross;
}

Eigen::Matrix3d read_rotation(const Value& value, const Space& space) {
  expect_object(value, {"axis", "degrees"}, "an object with 'axis' and 'degrees'");
  const auto axis_given = value.member("axis");
  Point axis(0, 0, 1);
  if (axis_given || !space.is_plane()) {
    const Value axis_value = required(value, "axis", "give it as a direction [x, y, z]");
    axis = Space{Dimension::space}.direction(axis_value);
    if (space.is_plane() && (axis.x() != 0 || axis.y() != 0))
      axis_value.fail("turns the object out of the plane; with \"dimension\": 2 leave the axis out");
  }
  return rotation_about(axis, number(required(value, "degrees", "give the angle as a number")));
}

Pose read_pose(const Value& value, const Space& space) {
  expect_object(value, {"translation", "rotation"}, "an object with 'translation' and 'rotation'");
  Pose pose;
  if (const auto rotation = value.member("rotation")) pose.rotation = read_rotation(*rotation, space);
  if (const auto translation = value.member("translation")) pose.translation = space.point(*translation);
  return pose;
}

/// Returns: the one member that gives the shape.
Value shape_of(const Value& object) {
  std::optional<Value> found;
  for (const Value& member : object.children()) {
    if (member.key() != "points" && member.key() != "sphere" && member.key() != "cylinder") continue;
    if (found)
      member.fail("is a second shape beside '" + found->key() +
                  "'; an object has one: keep 'points', 'sphere' or 'cylinder'");
    found = member;
  }
  if (!found) object.fail("has no shape; give 'points', 'sphere' or 'cylinder'");
  return *found;
}

decltype(Object::form) read_form(const Value& shape, const Space& space) {
  if (shape.key() == "points") return read_points(shape, space);
  if (shape.key() == "sphere") return read_sphere(shape, space);
  return read_cylinder(shape, space);
}

// What may throw is computed before an aggregate is begun: GCC 12 destroys members of unfinished aggregates twice.
Object read_object(const Value& value, const Space& space) {
  expect_object(value, {"name", "points", "sphere", "cylinder", "pose"}, "an object with a shape");
  const Value shape = shape_of(value);
  auto form = read_form(shape, space);
  Object object{.name = {}, .form = std::move(form)};
  if (const auto name = value.member("name")) object.name = words(*name, scene_limits::name);
  if (const auto pose = value.member("pose")) object.pose = read_pose(*pose, space);
  return object;
}

std::string kind_of(const Object& object, const Space& space) {
  if (std::holds_alternative<Points>(object.form)) return "point set";
  return std::holds_alternative<Cylinder>(object.form) ? "cylinder" : space.is_plane() ? "disc" : "sphere";
}

/// Objects without a name are called what they are; two of a kind are told apart.
void name_the_nameless(Object& a, Object& b, const Space& space) {
  const std::string kind_of_a = kind_of(a, space), kind_of_b = kind_of(b, space);
  const bool alike = kind_of_a == kind_of_b;
  if (a.name.empty()) a.name = kind_of_a + (alike ? " a" : "");
  if (b.name.empty()) b.name = kind_of_b + (alike ? " b" : "");
}

// -- The rest ---------------------------------------------------------------------------------------------------------

Space read_dimension(const Value& root) {
  const auto dimension = root.member("dimension");
  return {dimension && whole_number(*dimension, 2, 3) == 2 ? Dimension::plane : Dimension::space};
}

gjk::Options<double> read_options(const Value& root, const Space& space) {
  gjk::Options<double> options;
  if (const auto first = root.member("first_direction")) options.first_direction = space.direction(*first);
  if (const auto limit = root.member("iteration_limit"))
    options.iteration_limit = whole_number(*limit, 1, scene_limits::iterations);
  if (const auto test = root.member("crossing_test"))
    options.crossing_test = choice(*test, {"on", "off"}) == 0 ? gjk::CrossingTest::on : gjk::CrossingTest::off;
  return options;
}

RuleSet read_rules(const Value& root) {
  const auto rules = root.member("rules");
  return rules && choice(*rules, {"as-intended", "as-printed"}) == 1 ? RuleSet::as_printed : RuleSet::as_intended;
}

Panels read_panels(const Value& root) {
  Panels panels;
  const auto list = root.member("panels");
  if (!list) return panels;
  expect(*list, Kind::list, "a list out of 'objects', 'hull' and 'algorithm'");
  panels = {.objects = false, .hull = false, .algorithm = false};
  for (const Value& each : list->children()) {
    bool* const all[] = {&panels.objects, &panels.hull, &panels.algorithm};
    bool& panel = *all[choice(each, {"objects", "hull", "algorithm"})];
    if (panel) each.fail("'" + each.text() + "' appears twice; name it once");
    panel = true;
  }
  return panels;
}

bool is_size(const render::Size& size) {
  const auto fits = [](int pixels) { return render::min_pixels <= pixels && pixels <= render::max_pixels; };
  return fits(size.width) && fits(size.height);
}

std::optional<render::Size> size_in(const std::string& text) {
  render::Size size;
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width);
  if (width.ec != std::errc() || width.ptr == end || *width.ptr != 'x') return std::nullopt;
  const auto height = std::from_chars(width.ptr + 1, end, size.height);
  if (height.ec != std::errc() || height.ptr != end || !is_size(size)) return std::nullopt;
  return size;
}

std::optional<render::Size> read_size(const Value& root) {
  const auto value = root.member("size");
  if (!value) return std::nullopt;
  const std::string expected = "expected \"1280x720\" or [1280, 720], each from " + std::to_string(render::min_pixels) +
                               " to " + std::to_string(render::max_pixels);
  if (value->is(Kind::string)) {
    const auto size = size_in(value->text());
    if (!size) value->fail(expected + ", found " + in_quotes(value->text()));
    return size;
  }
  if (!value->is(Kind::list)) value->fail(expected + ", found " + std::string(value->description()));
  const std::vector<Value> sides = value->children();
  if (sides.size() != 2) value->fail(expected + ", found a list of " + std::to_string(sides.size()));
  const auto side = [](const Value& v) { return whole_number(v, render::min_pixels, render::max_pixels); };
  return render::Size{side(sides[0]), side(sides[1])};
}

// -- Names from file names --------------------------------------------------------------------------------------------

bool is_plain_letter(char c) {
  return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '.' || c == '_' || c == '-';
}

/// Returns: a name for a folder.
std::string folder_name(const std::string& file_name) {
  std::string name = std::filesystem::path(file_name).stem().string();
  std::ranges::replace_if(
      name, [](char c) { return !is_plain_letter(c); }, '-');
  const bool is_usable = !name.empty() && name != "." && name != "..";
  return is_usable ? name : "scene";
}

/// Returns: the stem as a title, where a title may be like that; else the name of the folder. An underscore would be read
/// as the mark of a subscript.
std::string title_from(const std::string& file_name) {
  std::string stem = std::filesystem::path(file_name).stem().string();
  const bool is_ascii = std::ranges::all_of(stem, [](char c) { return ' ' <= c && c <= '~'; });
  const bool is_blank = stem.find_first_not_of(' ') == std::string::npos;
  if (!is_ascii || is_blank) stem = folder_name(file_name);
  std::ranges::replace(stem, '_', ' ');
  return stem.substr(0, scene_limits::title);
}

SceneFile read_root(const Value& root, const std::string& file_name) {
  expect_object(root,
                {"title", "dimension", "a", "b", "first_direction", "iteration_limit", "crossing_test", "rules",
                 "panels", "size"},
                "an object { ... } that holds the scene");
  const auto title = root.member("title");
  const std::string heading = title ? words(*title, scene_limits::title) : title_from(file_name);
  const Space space = read_dimension(root);
  Object a = read_object(required(root, "a", "give the first object"), space);
  Object b = read_object(required(root, "b", "give the second object"), space);
  name_the_nameless(a, b, space);
  const gjk::Options<double> options = read_options(root, space);
  const RuleSet rules = read_rules(root);
  const Panels panels = read_panels(root);
  const std::optional<render::Size> size = read_size(root);

  SceneFile file;
  file.size = size;
  file.walkthrough.name = folder_name(file_name);
  file.walkthrough.title = file.walkthrough.summary = heading;
  file.walkthrough.source = "scene file";
  file.walkthrough.layout = Layout::search;
  file.walkthrough.panels = panels;
  file.walkthrough.naming = Naming::roles;
  file.walkthrough.scenes.push_back({"scene", std::move(a), std::move(b), options, space.dimension, rules});
  return file;
}

// -- Files ------------------------------------------------------------------------------------------------------------

/// A file that is open for reading.
class Descriptor {
 public:
  /// Does not wait where `file` is a pipe that nobody writes to.
  explicit Descriptor(const std::filesystem::path& file)
      : number_(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

[[noreturn]] void fail_to_read(const std::filesystem::path& file, const std::string& what_to_do) {
  throw SceneError(file.string() + ": cannot be read: " + std::strerror(errno) + "; " + what_to_do);
}

[[noreturn]] void fail_too_large(const std::filesystem::path& file) {
  throw SceneError(file.string() + ": is larger than " + std::to_string(scene_limits::bytes >> 20) +
                   " MiB; a scene file has no need for so much");
}

std::string read_text(const std::filesystem::path& file) {
  const Descriptor descriptor(file);
  struct stat status;
  if (descriptor.number() < 0 || ::fstat(descriptor.number(), &status) != 0)
    fail_to_read(file, "check the name and the permissions");
  if (!S_ISREG(status.st_mode))
    throw SceneError(file.string() + ": is " + (S_ISDIR(status.st_mode) ? "a folder" : "not a regular file") +
                     "; name a scene file");
  if (static_cast<std::uintmax_t>(status.st_size) > scene_limits::bytes) fail_too_large(file);
  std::string text;
  for (;;) {  // it may have grown, and files of /proc do not tell their size
    char part[1 << 16];
    const ssize_t count = ::read(descriptor.number(), part, sizeof part);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail_to_read(file, "check the disk");
    if (count == 0) return text;
    text.append(part, static_cast<std::size_t>(count));
    if (text.size() > scene_limits::bytes) fail_too_large(file);
  }
}

}  // namespace

SceneFile parse_scene(std::string_view text, const std::string& file_name) {
  try {
    const Document document(text);
    return read_root(document.root(), file_name);
  } catch (const DocumentError& error) {
    throw SceneError(file_name + ":" + std::to_string(error.line) + ": " + error.key + (error.key.empty() ? "" : ": ") +
                     error.what());
  }
}

SceneFile read_scene(const std::filesystem::path& file) { return parse_scene(read_text(file), file.string()); }

std::string_view example_scene() {
  return R"(// A scene for gjkstep. Only a and b must be there; everything else shows its default or an alternative.
{
  "title": "A can beside a tilted box",  // without it: the name of the file
  "dimension": 3,                        // 2: the plane; points are [x, y], spheres are discs

  // The two objects. Each has one shape: points, sphere or cylinder.
  "a": {
    "name": "box",  // as captions call it
    "points": [     // their convex hull; the order does not matter
      [-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1],
      [-1, -1,  1], [1, -1,  1], [1, 1,  1], [-1, 1,  1]
    ],
    "pose": {  // first turned about the origin, then moved
      "rotation": {"axis": [1, 1, 0], "degrees": 30},
      "translation": [2.5, 0.5, 0]
    }
  },
  "b": {
    "name": "can",
    "cylinder": {"center": [0, 0, 0], "axis": [0, 0, 1], "radius": 1, "height": 2}
    // or "sphere": {"center": [0, 0, 0], "radius": 1}
  },

  // How the algorithm runs.
  "first_direction": [1, 0, 0],
  "iteration_limit": 20,
  "crossing_test": "on",   // "off": go on until there are no new points
  "rules": "as-intended",  // "as-printed": Algorithm 1 read literally, with its mistake

  // What is shown beside the search. What is left out is not computed.
  "panels": ["objects", "hull", "algorithm"],
  "size": "1280x720"       // or [1280, 720]; pixels
}
)";
}

std::string summary(const SceneFile& file) {
  const Walkthrough& walkthrough = file.walkthrough;
  const Scene& scene = walkthrough.scenes.front();
  const Space space{scene.dimension};
  const auto object = [&](const Object& o) {
    const auto* set = std::get_if<Points>(&o.form);
    return "'" + o.name + "' (" +
           (set ? std::to_string(set->points().size()) + (set->points().size() == 1 ? " point" : " points")
                : kind_of(o, space)) +
           ")";
  };
  std::string panels;
  if (walkthrough.panels.objects) panels += ", objects";
  if (walkthrough.panels.hull) panels += ", hull";
  if (walkthrough.panels.algorithm) panels += ", algorithm";
  return "'" + walkthrough.title + "', " + (space.is_plane() ? "plane" : "space") + ", " + object(scene.a) + " and " +
         object(scene.b) + ", panels: search" + panels;
}

}  // namespace walkthroughs
