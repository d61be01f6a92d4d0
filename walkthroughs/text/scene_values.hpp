/// The values that scene files and traces have in common, read from a document within scene_limits.
///
/// Where a value is not what is expected they complain (document.hpp) and return something in its place.
#pragma once

#include <cmath>
#include <concepts>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "walkthroughs/model/scene.hpp"
#include "walkthroughs/model/walkthrough.hpp"
#include "walkthroughs/model/words_of.hpp"
#include "walkthroughs/text/document.hpp"

namespace walkthroughs::text::reading {

using Kind = Document::Kind;
using Keys = std::vector<std::string>;

/// Returns: "'a', 'b' or 'c'", with `last` in place of "or".
std::string list_of(std::span<const std::string> words, const std::string& last);

/// Returns: whether it is of that kind.
bool expect(const Value& value, Kind kind, std::string_view expected);
/// Expects an object that has no keys but these, and such as "_mine", which are their writer's.
bool expect_object(const Value& value, const Keys& keys, std::string_view expected);
Value required(const Value& object, std::string_view key, std::string_view what_to_do);

double number(const Value& value);
int whole_number(const Value& value, int low, int high);
bool true_or_false(const Value& value);
/// Returns: the position of the word in `words`.
std::size_t choice(const Value& value, std::span<const std::string_view> words);
/// Returns: what `declared` says with that key; `otherwise` where there is none.
template <class E>
E chosen(const Value& declared, std::string_view key, E otherwise) {
  const auto value = declared.member(key);
  return value ? static_cast<E>(choice(*value, words_of::all(otherwise))) : otherwise;
}
/// Returns: a printable text that is not blank.
std::string words(const Value& value, std::size_t longest);

/// Returns: what `declared` says with its key "dimension"; space where there is none.
Dimension dimension_of(const Value& declared);

/// Whether nobody looks at it, and answers repeat it: "name", "id" and the like, and what begins with _.
bool is_note(std::string_view key);
/// Expects the text of a scene or of a pair. Each may stand for the other: neither looks at what is the other's, or nobody's.
bool expect_scene_or_pair(const Value& root, std::string_view expected);

/// What points of two numbers mean in space.
enum class TwoNumbers { refused, lie_in_the_plane };

/// The numbers that are asked: all of the text must be some, and exact fractions know no square roots.
enum class Numbers { binary32, binary64, long_double, exact };

inline Numbers numbers_of(Scalar scalar) { return scalar == Scalar::binary32 ? Numbers::binary32 : Numbers::binary64; }

/// How large coordinates may be. `all`: as large as the numbers that are asked.
enum class Magnitudes { with_finite_squares, all };

/// Where a scene lies decides what a point looks like, and what it is asked in, what its coordinates may be.
struct Space {
  Dimension dimension;
  TwoNumbers two_numbers = TwoNumbers::refused;
  Numbers numbers = Numbers::binary64;
  Magnitudes magnitudes = Magnitudes::with_finite_squares;

  bool is_plane() const { return dimension == Dimension::plane; }
  std::string_view point_words() const { return is_plane() ? "a point [x, y]" : "a point [x, y, z]"; }
  Point point(const Value& value) const;
  /// Only the ratios of its numbers count: these may be any.
  Point direction(const Value& value) const;
  Point first_direction(const Value& value) const;
  /// Returns: a number that is not negative.
  double length(const Value& value) const;
  /// Returns: three lengths; in the plane two, and 0.
  Point size(const Value& value) const;
  /// Returns: whether a number is one that the search can have.
  bool holds(double x) const;

 private:
  double coordinate(const Value& value) const;
};

/// Whether all points and directions of a scene's objects have two numbers.
bool is_planar(const Value& root);

/// Returns: an object as scene files and queries write it: a shape, its numbers those of the text, and perhaps a name (else
/// empty) and a pose. scene_text.hpp says what each may hold.
Object read_object(const Value& value, const Space& space);

/// Returns: the keys of an object that may have a name and a pose.
const std::vector<std::string>& object_keys();

/// Returns: the shape that one member of an object gives, its numbers those of the text.
AnyShape read_shape(const Value& object, const Space& space);

/// Returns: the panels named in a list of words.
Panels panels_in(const Value& list);

/// Turns what was read into a scalar, number by number. Of directions only the ratios matter: where floats have no such powers
/// of two, another is taken. Requires: that it was read for that scalar (Numbers).
template <class S>
struct InScalar : Cast<S> {
  gjk::Vec3<S> direction(const Point& d) const {
    const double largest = d.cwiseAbs().maxCoeff();
    const int exponent = std::same_as<S, float> && largest > 0 ? std::ilogb(largest) : 0;
    return this->point(d.unaryExpr([=](double x) { return std::scalbn(x, -exponent); }));
  }
};

/// Returns: what `declared` says with its key "certified": whether the answer about its "a" and "b" is proven. Refused where
/// it cannot be.
bool certified_of(const Value& declared, const Object& a, const Object& b);
/// Returns: the scene with its numbers rounded to its scalar, which can hold all of them.
Scene in_its_scalar(Scene scene);

}  // namespace walkthroughs::text::reading
