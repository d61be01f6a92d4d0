#include "walkthroughs/text/scene_values.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/model/words_of.hpp"
#include "walkthroughs/text/nearest.hpp"
#include "walkthroughs/text/scene_limits.hpp"

namespace walkthroughs::reading {

// -- Words ------------------------------------------------------------------------------------------------------------

std::string list_of(std::span<const std::string> words, const std::string& last) {
  std::string list;
  for (std::size_t i = 0; i < words.size(); ++i)
    list += (i == 0 ? "'" : i + 1 == words.size() ? " " + last + " '" : ", '") + words[i] + "'";
  return list;
}

namespace {

std::string suggestion(const std::string& word, std::span<const std::string> known) {
  return "did you mean '" + nearest(std::string_view(word).substr(0, 64), known) + "'? Known here are " +
         list_of(known, "and");
}

}  // namespace

// -- Values -----------------------------------------------------------------------------------------------------------

void expect(const Value& value, Kind kind, std::string_view expected) {
  if (!value.is(kind)) value.fail("expected " + std::string(expected) + ", found " + std::string(value.description()));
}

void expect_object(const Value& value, const Keys& keys, std::string_view expected) {
  expect(value, Kind::object, expected);
  for (const Value& member : value.children())
    if (std::ranges::count(keys, member.key()) == 0) member.fail("is not a key; " + suggestion(member.key(), keys));
}

Value required(const Value& object, std::string_view key, const std::string& what_to_do) {
  if (const auto member = object.member(key)) return *member;
  object.fail_without(key, "is missing; " + what_to_do);
}

double number(const Value& value) {
  expect(value, Kind::number, "a number");
  if (!(std::abs(value.number()) <= scene_limits::magnitude))
    value.fail(number_text(value.number()) +
               " is beyond 1e150 in magnitude, where squares of lengths overflow; choose a larger unit of length");
  return value.number();
}

double length(const Value& object, std::string_view key) {
  const Value value = required(object, key, "give it as a positive number");
  const double found = number(value);
  if (!(found > 0)) value.fail("must be larger than 0, found " + number_text(found) + "; give a positive length");
  return found;
}

int whole_number(const Value& value, int low, int high) {
  const std::string range = "a whole number from " + std::to_string(low) + " to " + std::to_string(high);
  expect(value, Kind::number, range);
  const double found = value.number();
  if (found != std::floor(found) || found < low || found > high)
    value.fail("expected " + range + ", found " + number_text(found));
  return static_cast<int>(found);
}

std::size_t choice(const Value& value, std::span<const std::string_view> words) {
  const std::vector<std::string> known(words.begin(), words.end());
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

// -- Points -----------------------------------------------------------------------------------------------------------

namespace {

[[noreturn]] void fail_wrong_count(const Space& space, const Value& value, std::size_t count) {
  const std::string hint(!space.is_plane() && count == 2 ? space.if_two_numbers : "");
  value.fail("expected " + space.point_words() + ", found a list of " + std::to_string(count) + hint);
}

}  // namespace

Point Space::point(const Value& value) const {
  expect(value, Kind::list, point_words());
  const std::vector<Value> numbers = value.children();
  if (numbers.size() != 3 && !(is_plane() && numbers.size() == 2)) fail_wrong_count(*this, value, numbers.size());
  Point found = Point::Zero();
  for (std::size_t i = 0; i < numbers.size(); ++i) found[static_cast<int>(i)] = number(numbers[i]);
  if (is_plane() && found.z() != 0)
    numbers[2].fail("must be 0, because the scene has \"dimension\": 2; found " + number_text(found.z()));
  return found;
}

Point Space::direction(const Value& value) const {
  const Point found = point(value);
  if (found.isZero(0)) value.fail("has no length; give a direction other than zero");
  return found;
}

// -- Shapes ----------------------------------------------------------------------------------------------------------

namespace {

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

CylinderAsWritten read_cylinder(const Value& value, const Space& space) {
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

}  // namespace

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

FormAsWritten read_form_as_written(const Value& shape, const Space& space) {
  if (shape.key() == "points") return read_points(shape, space);
  if (shape.key() == "sphere") return read_sphere(shape, space);
  return read_cylinder(shape, space);
}

decltype(Object::form) form_of(FormAsWritten written, Scalar scalar) {
  if (auto* points = std::get_if<Points>(&written)) return std::move(*points);
  if (const auto* ball = std::get_if<Ball>(&written)) return *ball;
  const auto& [center, axis, radius, height] = std::get<CylinderAsWritten>(written);
  if (scalar == Scalar::binary64) return Cylinder(center, axis, radius, height);
  const gjk::Cylinder<float> in_float(gjk::Vec3<float>::Zero(), direction_in_float(axis), 1, 1);
  return Cylinder(center, in_float.axis().cast<double>(), radius, height);
}

decltype(Object::form) read_form(const Value& shape, const Space& space) {
  return form_of(read_form_as_written(shape, space), Scalar::binary64);
}

// -- Scalars ---------------------------------------------------------------------------------------------------------

gjk::Vec3<float> direction_in_float(const Point& direction) {
  const int exponent = std::ilogb(direction.cwiseAbs().maxCoeff());
  const auto scaled = [=](double x) { return static_cast<float>(std::scalbn(x, -exponent)); };
  return {scaled(direction.x()), scaled(direction.y()), scaled(direction.z())};
}

Scalar scalar_of(const Value& declared) {
  const auto scalar = declared.member("scalar");
  return scalar ? static_cast<Scalar>(choice(*scalar, words_of::scalar)) : Scalar::binary64;
}

Scene in_its_scalar(Scene scene, const Value& declared) {
  if (scalar_of(declared) == Scalar::binary64) return scene;
  try {
    return in_float(std::move(scene));
  } catch (const std::range_error& error) {
    declared.member("scalar")->fail(std::string(error.what()) + "; choose another unit of length, or \"double\"");
  }
}

}  // namespace walkthroughs::reading
