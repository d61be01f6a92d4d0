#include "walkthroughs/text/scene_values.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/certified/fraction.hpp"
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/text/names.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/text/scene_limits.hpp"

namespace walkthroughs::text::reading {

// -- Words ------------------------------------------------------------------------------------------------------------

std::string list_of(std::span<const std::string> words, const std::string& last) {
  std::string list;
  for (std::size_t i = 0; i < words.size(); ++i)
    list += (i == 0 ? "'" : i + 1 == words.size() ? " " + last + " '" : ", '") + words[i] + "'";
  return list;
}

namespace {

std::string suggestion(const std::string& word, std::span<const std::string> known) {
  constexpr std::size_t most = 16;  // a message is read at a glance
  const std::string near = did_you_mean(nearest(word, known));
  if (known.size() > most)
    return near.empty() ? "'gjkstep scene --example' shows them" : near.substr(0, near.size() - 1);
  return near + (near.empty() ? "known" : "Known") + " here are " + list_of(known, "and");
}

}  // namespace

// -- Values -----------------------------------------------------------------------------------------------------------

bool expect(const Value& value, Kind kind, std::string_view expected) {
  if (!value.is(kind)) value.fail("expected " + std::string(expected) + ", found " + std::string(value.description()));
  return value.is(kind);
}

bool expect_object(const Value& value, const Keys& keys, std::string_view expected) {
  if (!expect(value, Kind::object, expected)) return false;
  for (const Value& member : value.children())
    if (!member.key().starts_with('_') && std::ranges::count(keys, member.key()) == 0)
      member.fail("is not a key; " + suggestion(member.key(), keys));
  return value.is_good();
}

namespace {

const Keys notes{"name", "id", "family", "answer", "expect", "notes", "source"};

const Keys& keys_of_scenes_and_pairs() {
  static const Keys keys = [] {
    Keys all{
        "a",         "b",      "title",     "dimension", "first_direction", "iteration_limit", "rules", "crossing_test",
        "zero_test", "scalar", "certified", "mistake", "truth",     "panels",          "letters",         "size",  "text_scale"};
    all.insert(all.end(), notes.begin(), notes.end());
    return all;
  }();
  return keys;
}

}  // namespace

bool is_note(std::string_view key) {
  return key.starts_with('_') || key == "truth" || std::ranges::count(notes, key) > 0;
}

bool expect_scene_or_pair(const Value& root, std::string_view expected) {
  return expect_object(root, keys_of_scenes_and_pairs(), expected);
}

Value required(const Value& object, std::string_view key, std::string_view what_to_do) {
  if (const auto member = object.member(key)) return *member;
  return object.fail_without(key, "is missing; " + std::string(what_to_do));
}

namespace {

double number_of_any_size(const Value& value) {
  expect(value, Kind::number, "a number");
  return value.number();
}

}  // namespace

double number(const Value& value) {
  const double found = number_of_any_size(value);
  if (!(std::abs(found) <= scene_limits::magnitude))
    value.fail(number_text(found) +
               " is beyond 1e150 in magnitude, where squares of lengths overflow; choose a larger unit of length");
  return found;
}

int whole_number(const Value& value, int low, int high) {
  const std::string range = "a whole number from " + std::to_string(low) + " to " + std::to_string(high);
  if (!expect(value, Kind::number, range)) return low;
  const double found = value.number();
  if (found == std::floor(found) && low <= found && found <= high) return static_cast<int>(found);
  value.fail("expected " + range + ", found " + number_text(found));
  return low;
}

bool true_or_false(const Value& value) { return expect(value, Kind::boolean, "true or false") && value.is_true(); }

std::size_t choice(const Value& value, std::span<const std::string_view> words) {
  const std::vector<std::string> known(words.begin(), words.end());
  if (!expect(value, Kind::string, list_of(known, "or"))) return 0;
  const auto found = std::ranges::find(known, value.text());
  if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
  value.fail(in_quotes(value.text()) + " is not known; " + suggestion(value.text(), known));
  return 0;
}

std::string words(const Value& value, std::size_t longest) {
  expect(value, Kind::string, "a string");
  if (const std::string objection = objection_to_words(value.text(), longest); !objection.empty())
    value.fail(objection);
  return value.text();
}

// -- Points -----------------------------------------------------------------------------------------------------------

namespace {

const std::string other_unit_or_double = "choose another unit of length, or compute in double";

void expect_positive_float(const Value& value, double x) {
  if (static_cast<float>(x) == 0)
    value.fail(number_text(x) + " is so small that it is 0 as a float; " + other_unit_or_double);
}

void fail_wrong_count(const Space& space, const Value& value, std::size_t count) {
  const std::string hint = !space.is_plane() && count == 2
                               ? "; if the scene is two-dimensional, add \"dimension\": 2 beside \"a\" and \"b\""
                               : "";
  value.fail("expected " + std::string(space.point_words()) + ", found a list of " + std::to_string(count) +
             " elements" + hint);
}

}  // namespace

Panels panels_in(const Value& list) {
  expect(list, Kind::list, "a list out of 'objects', 'hull', 'algorithm', 'decision' and 'close-up'");
  Panels panels{.objects = false, .hull = false, .algorithm = false, .decision = false};
  for (const Value& each : list.children()) {
    bool& panel = panels.*words_of::panel_members[choice(each, words_of::panels)];
    if (panel) each.fail("'" + each.text() + "' appears twice; name it once");
    panel = true;
  }
  return panels;
}

Dimension dimension_of(const Value& declared) {
  const auto dimension = declared.member("dimension");
  return dimension && whole_number(*dimension, 2, 3) == 2 ? Dimension::plane : Dimension::space;
}

namespace {

/// How many numbers the points and directions in a value have.
struct Counts {
  bool two = false, three = false;

  void look_at(const Value& value) {
    const std::vector<Value> children = value.children();
    if (value.is(Kind::list) && !children.empty() && children[0].is(Kind::number))
      (children.size() == 2 ? two : three) = true;
    else
      for (std::size_t i = 0; i < children.size() && !three; ++i) look_at(children[i]);
  }
};

}  // namespace

bool is_planar(const Value& root) {
  Counts counts;
  for (const char* object : {"a", "b"})
    if (const auto value = root.member(object)) counts.look_at(*value);
  return counts.two && !counts.three;
}

Point Space::point(const Value& value) const {
  if (!expect(value, Kind::list, point_words())) return Point::Zero();
  const std::vector<Value> coordinates = value.children();
  const bool may_have_two = is_plane() || two_numbers == TwoNumbers::lie_in_the_plane;
  if (coordinates.size() != 3 && !(may_have_two && coordinates.size() == 2)) {
    fail_wrong_count(*this, value, coordinates.size());
    return Point::Zero();
  }
  Point found = Point::Zero();
  for (std::size_t i = 0; i < coordinates.size(); ++i) found[static_cast<int>(i)] = coordinate(coordinates[i]);
  if (is_plane() && found.z() != 0)
    coordinates[2].fail("must be 0, because the scene has \"dimension\": 2; found " + number_text(found.z()));
  return found;
}

Point Space::direction(const Value& value) const {
  const Point found = Space{dimension, two_numbers, Numbers::binary64, Magnitudes::all}.point(value);
  if (found.isZero(0)) value.fail("has no length; give a direction other than zero");
  return found;
}

Point Space::first_direction(const Value& value) const {
  const Point found = direction(value);
  point(value);  // each of its numbers is one that the search can have
  if (numbers == Numbers::binary32) expect_positive_float(value, found.cwiseAbs().maxCoeff());
  return found;
}

double Space::length(const Value& value) const {
  const double found = coordinate(value);
  if (found < 0) value.fail("must not be negative, found " + number_text(found) + "; give a length");
  if (numbers == Numbers::binary32 && found != 0) expect_positive_float(value, found);
  return found;
}

Point Space::size(const Value& value) const {
  const Point found = point(value);
  for (const Value& each : value.children()) length(each);
  return found;
}

bool Space::holds(double x) const {
  const double size = std::abs(numbers == Numbers::binary32 ? static_cast<float>(x) : x);
  return magnitudes == Magnitudes::all ? std::isfinite(size) : size <= scene_limits::magnitude;
}

double Space::coordinate(const Value& value) const {
  const double found = magnitudes == Magnitudes::all ? number_of_any_size(value) : number(value);
  if (numbers == Numbers::binary32 && !std::isfinite(static_cast<float>(found)))
    value.fail(number_text(found) + " is beyond the largest float, 3.4e38; " + other_unit_or_double);
  return found;
}

// -- Shapes ----------------------------------------------------------------------------------------------------------

namespace {

/// Returns: the names of the fields of a shape; none where it is a plain list.
template <class Shape>
std::vector<std::string> fields_of() {
  std::vector<std::string> names;
  const auto add = [&](auto kind) {
    if constexpr (requires { kind.name; }) names.emplace_back(kind.name);
    if constexpr (requires { kind.half; }) names.emplace_back(kind.half);
  };
  ShapeRow<Shape>::fields(add);
  return names;
}

std::vector<std::string> shape_keys() {
  std::vector<std::string> keys;
  for_each_kind([&]<class Shape>(std::type_identity<Shape>) { keys.emplace_back(ShapeRow<Shape>::key); });
  return keys;
}

/// Returns: the one member of an object that gives its shape.
Value shape_of(const Value& object) {
  static const std::vector<std::string> keys = shape_keys();
  std::optional<Value> found;
  for (const Value& member : object.children()) {
    if (std::ranges::count(keys, member.key()) == 0) continue;
    if (found)
      member.fail("is a second shape beside '" + found->key() + "'; an object has one: keep " + list_of(keys, "or"));
    found = member;
  }
  if (!found) object.fail("has no shape; give " + list_of(keys, "or"));
  return found.value_or(object);
}

AnyShape read_shape(const Value& object, const Space& space, int sums_around);

/// Reads one field after the other.
struct FieldReader {
  const Value& value;  ///< of the shape
  const Space& space;
  int sums_around;

  void operator()(field::Place place, Point& to) const {
    to = space.point(
        required(value, place.name, space.is_plane() ? "give it as a point [x, y]" : "give it as a point [x, y, z]"));
  }
  void operator()(field::Direction direction, Point& to) const {
    to = space.direction(required(value, direction.name, "give it as a direction [x, y, z]"));
  }
  void operator()(field::Length length, double& to) const {
    to = space.length(required(value, length.name, "give it as a number"));
  }
  void operator()(field::Size size, Point& to) const {
    if (const auto half = value.member(size.half)) {
      if (const auto whole = value.member(size.name))
        half->fail("stands beside '" + whole->key() + "'; give one of them");
      to = 2 * space.size(*half);
      if (!space.holds(to.maxCoeff()))
        half->fail("is too large: the size is twice as much; choose a larger unit of length");
    } else {
      const std::string words = space.is_plane() ? "[x, y]" : "[x, y, z]";
      to = space.size(
          required(value, size.name, "give it as " + words + ", or half of it as '" + std::string(size.half) + "'"));
    }
  }
  void operator()(field::Places, Points& to) const {
    if (!expect(value, Kind::list, "a list of points")) return;
    const std::vector<Value> children = value.children();
    if (children.empty()) return value.fail("has no point; a point set needs at least one");
    static_assert(scene_limits::points == document_limits::elements, "longer lists have been turned away by now");
    to.reserve(children.size());
    for (const Value& child : children) to.push_back(space.point(child));
  }
  void operator()(field::Shapes, std::vector<AnyShape>& to) const {
    if (!expect(value, Kind::list, "a list of two shapes")) return;
    const std::vector<Value> children = value.children();
    if (children.size() != 2)
      return value.fail("expected a list of two shapes, found a list of " + std::to_string(children.size()) +
                        (children.size() > 2 ? "; a sum may be one of the two" : ""));
    if (sums_around == scene_limits::sums)
      return value.fail("is a sum within " + std::to_string(scene_limits::sums) +
                        " others; that many may be in one another");
    for (const Value& child : children) {
      if (expect_object(child, shape_keys(), "an object with a shape"))
        to.push_back(read_shape(child, space, sums_around + 1));
    }
  }
};

template <class Shape>
void read_fields(const Value& value, const Space& space, int sums_around, Shape& shape) {
  static const std::vector<std::string> fields = fields_of<Shape>();
  static const std::string expected = "an object with " + list_of(fields, "and");
  if (space.is_plane() && ShapeRow<Shape>::kind_in_plane.empty())
    value.fail("a scene with \"dimension\": 2 has no " + std::string(ShapeRow<Shape>::kind) +
               "s; use a sphere (a disc) or points, or say \"dimension\": 3");
  if (!fields.empty() && !expect_object(value, fields, expected)) return;
  ShapeRow<Shape>::fields(FieldReader{value, space, sums_around}, shape);
}

AnyShape read_shape(const Value& object, const Space& space, int sums_around) {
  const Value value = shape_of(object);
  AnyShape shape;
  if (!value.is_good()) return shape;
  for_each_kind([&]<class Shape>(std::type_identity<Shape>) {
    if (value.key() != ShapeRow<Shape>::key) return;
    if (space.numbers == Numbers::exact && !CanBeAsked<typename ShapeRow<Shape>::template In<gjk::Fraction>>)
      object.fail("a " + std::string(ShapeRow<Shape>::kind) +
                  " cannot be asked in exact numbers, because its points need square roots; give points, or "
                  "choose another --scalar");
    read_fields(value, space, sums_around, shape.emplace<Shape>());
  });
  return shape;
}

}  // namespace

const std::vector<std::string>& object_keys() {
  static const std::vector<std::string> keys = [] {
    std::vector<std::string> all{"name"};
    for (const std::string& key : shape_keys()) all.push_back(key);
    all.push_back("pose");
    return all;
  }();
  return keys;
}

AnyShape read_shape(const Value& object, const Space& space) { return read_shape(object, space, 0); }

// -- Objects ---------------------------------------------------------------------------------------------------------

namespace {

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

constexpr double most_degrees = 1e6;  // far beyond it doubles do not tell one degree from the next

/// One of the ways to say a rotation.
const std::string rotation_words =
    "{\"axis\": [x, y, z], \"degrees\": d}, a quaternion {\"w\", \"x\", \"y\", \"z\"}, or a matrix of three rows";

double read_degrees(const Value& value) {
  const double degrees = number_of_any_size(value);
  if (!(std::abs(degrees) <= most_degrees))
    value.fail("expected an angle from -1000000 to 1000000 degrees, found " + number_text(degrees));
  return degrees;
}

Eigen::Matrix3d read_turn(const Value& value, const Space& space) {
  expect_object(value, {"axis", "degrees"}, rotation_words);
  const auto axis_given = value.member("axis");
  Point axis(0, 0, 1);
  if (axis_given || !space.is_plane()) {
    const Value axis_value = required(value, "axis", "give it as a direction [x, y, z]");
    axis = Space{Dimension::space}.direction(axis_value);
    if (space.is_plane() && (axis.x() != 0 || axis.y() != 0))
      axis_value.fail("turns the object out of the plane; with \"dimension\": 2 leave the axis out");
  }
  return rotation_about(axis, read_degrees(required(value, "degrees", "give the angle as a number")));
}

gjk::Quaternion read_quaternion(const Value& value, const Space& space) {
  expect_object(value, {"w", "x", "y", "z"}, rotation_words);
  const auto read = [&](std::string_view key) {
    return number_of_any_size(required(value, key, "a quaternion has four numbers"));
  };
  const gjk::Quaternion q{read("w"), read("x"), read("y"), read("z")};
  if (q == gjk::Quaternion{0, 0, 0, 0}) value.fail("w, x, y and z are 0; expected a quaternion other than zero");
  if (space.is_plane() && (q.x != 0 || q.y != 0))
    value.fail("turns the object out of the plane; with \"dimension\": 2 'x' and 'y' are 0");
  return q;
}

/// Returns: the product of two columns that differs most from that of a rotation.
std::string why_no_rotation(const Eigen::Matrix3d& matrix) {
  const Eigen::Matrix3d products = matrix.transpose() * matrix;
  Eigen::Index i, j;
  const double most = (products - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(&i, &j);
  if (most <= rotation_tolerance)
    return "it is a mirror image, its determinant is " + number_text(matrix.determinant());
  const std::string found = number_text(products(i, j));
  return i == j
             ? "column " + std::to_string(i) + " times itself is " + found + ", not 1"
             : "columns " + std::to_string(j) + " and " + std::to_string(i) + " have the product " + found + ", not 0";
}

Eigen::Matrix3d read_matrix(const Value& value, const Space& space) {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  const std::vector<Value> rows = value.children();
  if (rows.size() != 3)
    value.fail("expected three rows of three numbers, found a list of " + std::to_string(rows.size()));
  for (std::size_t i = 0; i < 3 && i < rows.size(); ++i) {
    if (!expect(rows[i], Kind::list, "a row of three numbers")) break;
    const std::vector<Value> numbers = rows[i].children();
    if (numbers.size() != 3)
      rows[i].fail("expected a row of three numbers, found a list of " + std::to_string(numbers.size()));
    for (std::size_t j = 0; j < 3 && j < numbers.size(); ++j)
      matrix(static_cast<int>(i), static_cast<int>(j)) = number_of_any_size(numbers[j]);
  }
  if (!(distance_from_rotation(matrix) <= rotation_tolerance))
    value.fail("is not a rotation: " + why_no_rotation(matrix) +
               "; expected columns that are perpendicular, of length 1 and right-handed, each product to 0.00001");
  if (space.is_plane() && (matrix(2, 0) != 0 || matrix(2, 1) != 0))
    value.fail("turns the object out of the plane; with \"dimension\": 2 the third row is [0, 0, 1]");
  return matrix;
}

void read_rotation(const Value& value, const Space& space, Pose& pose) {
  const auto has = [&](std::string_view key) { return value.member(key).has_value(); };
  if (value.is(Kind::list)) {
    pose.rotation = read_matrix(value, space);
    pose.matrix_as_written = true;
  } else if ((has("axis") || has("degrees")) && (has("w") || has("x") || has("y") || has("z"))) {
    value.fail("is a turn and a quaternion at once; give \"axis\" and \"degrees\", or \"w\", \"x\", \"y\" and \"z\"");
  } else if (has("w") || has("x") || has("y") || has("z")) {
    const gjk::Quaternion quaternion = read_quaternion(value, space);
    if (!value.is_good()) return;
    pose.quaternion = quaternion;
    pose.rotation = matrix_of(quaternion);
  } else {
    pose.rotation = read_turn(value, space);
  }
}

Pose read_pose(const Value& value, const Space& space) {
  for (const char* of_rotation : {"matrix", "quaternion", "axis", "degrees"})
    if (const auto member = value.member(of_rotation))
      member->fail("is not a key of a pose; a rotation is \"rotation\": " + rotation_words);
  expect_object(value, {"translation", "rotation"}, "an object with 'translation' and 'rotation'");
  Pose pose;
  if (const auto rotation = value.member("rotation")) read_rotation(*rotation, space, pose);
  if (const auto translation = value.member("translation")) pose.translation = space.point(*translation);
  return pose;
}

}  // namespace

Object read_object(const Value& value, const Space& space) {
  Object object;
  if (!expect_object(value, object_keys(), "an object with a shape")) return object;
  object.form = read_shape(value, space);
  if (const auto name = value.member("name")) object.name = words(*name, scene_limits::name);
  if (const auto pose = value.member("pose")) object.pose = read_pose(*pose, space);
  return object;
}

// -- Scalars ---------------------------------------------------------------------------------------------------------

bool certified_of(const Value& declared, const Object& a, const Object& b) {
  const auto value = declared.member("certified");
  if (!value) return false;
  if (!true_or_false(*value)) return false;
  for (const auto& [key, object] : {std::pair("a", &a), std::pair("b", &b)}) {
    if (!value->is_good()) break;
    if (!std::holds_alternative<Points>(object->form))
      declared.member(key)
          ->member(key_of(object->form))
          ->fail("a " + kind_of(object->form, Dimension::space) +
                 " cannot be certified in a scene, whose proofs are drawn for sets of points only. Give points, or "
                 "leave out 'certified'");
    else if (moves(object->pose))
      declared.member(key)->member("pose")->fail(
          "an object that its pose moves cannot be certified, because its points are rounded then. Give the points "
          "where they are, or leave out 'certified'");
  }
  return true;
}

Scene in_its_scalar(Scene scene) { return scene.scalar == Scalar::binary32 ? in_float(std::move(scene)) : scene; }

}  // namespace walkthroughs::text::reading
