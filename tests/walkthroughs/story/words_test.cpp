#include "walkthroughs/story/words.hpp"

#include <limits>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"

namespace words_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;

namespace {

/// A hexagon with A at (3,0), and simplices of its corners.
const LabelledHull hexagon{{{3, 0}, {2, 2}, {-2, 2}, {-3, 0}, {-2, -2}, {2, -2}}};

/// Requires: a letter from A to F.
Vertex corner(char letter) {
  const Vec2& at = hexagon.corners.at(static_cast<std::size_t>(letter - 'A'));
  Vertex vertex;
  vertex.w = {at.x(), at.y(), 0};
  return vertex;
}

/// Requires: letters from A to F, oldest first.
Simplex simplex(const std::string& letters) {
  Simplex s;
  for (const char letter : letters) s.add(corner(letter));
  return s;
}

/// The moment in which a simplex is being processed, and the names in it.
struct Named {
  Moment now;
  Naming naming;

  Named(Naming how, const std::string& letters) : naming(how) {
    now.simplex = now.processed = simplex(letters);
    now.found = corner(letters.back());
    now.added = true;
  }
  /// The moment after that, when the next vertex was found but not added yet.
  Named(Naming how, const std::string& letters, char found) : Named(how, letters) {
    now.found = corner(found);
    now.added = false;
  }
  Names operator()() const { return {naming, hexagon, now}; }
};

Named corners(const std::string& letters) { return {Naming::corners, letters}; }
Named roles(const std::string& letters) { return {Naming::roles, letters}; }
Named roles(const std::string& letters, char found) { return {Naming::roles, letters, found}; }

std::string translate(const std::string& letters, const std::string& text) {
  return corners(letters)().translate(text);
}

}  // namespace

// -- Numbers ----------------------------------------------------------------------------------------------------------

TEST_CASE("A number has at most eight digits where it is whole and six significant ones where it is not") {
  CHECK(number(4.375) == "4.375");
  CHECK(number(120) == "120");
  CHECK(number(0.1 + 0.2) == "0.3");
  CHECK(number(123456) == "123456");
  CHECK(number(12345678) == "12345678");
  CHECK(number(118.1875) == "118.188");
  CHECK(number(1.0 / 3) == "0.333333");
}

TEST_CASE("A short number has at most four significant digits") {
  CHECK(short_number(4.375) == "4.375");
  CHECK(short_number(118.1875) == "118.2");
  CHECK(short_number(-0.0) == "0");
  CHECK(short_number(-1.0 / 3) == "−0.3333");
  CHECK(short_number(-12225) == "−12225");
  CHECK(short_number(-594432117.0) == "−5.94432e+08");
}

TEST_CASE("The minus sign of a number is U+2212, in the exponent too, and zero has none") {
  CHECK(number(-10.1875) == "\u221210.1875");
  CHECK(number(-1.5e-7) == "−1.5e−07");
  CHECK(number(-2.5e9).find('-') == std::string::npos);
  CHECK(number(-0.0) == "0");
  CHECK(number(-std::numeric_limits<double>::denorm_min()) != "−0");
}

TEST_CASE("A vector has two components in the plane, three in space") {
  CHECK(vector(Point(-3.75, -3.25, -0.0)) == "(−3.75, −3.25)");
  CHECK(vector(Point(0, -0.0, 9), Dimension::space) == "(0, 0, 9)");
}

// -- Names of corners -------------------------------------------------------------------------------------------------

TEST_CASE("Translation leaves words that are no roles alone") {
  CHECK(translate("AEF", "the origin lies beyond this edge; A stays the newest") ==
        "the origin lies beyond this edge; F stays the newest");
  CHECK(translate("AEF", "At a Bad place: Cn, n, Eq. 9, R3, ABx, 2·AB") ==
        "At a Bad place: A_n, n, Eq. 9, R3, ABx, 2·FE");
  CHECK(translate("AEF", "d = ≥ ⊥ −") == "d = ≥ ⊥ −");
  CHECK(translate("AEF", "") == "");
}

// -- Names of roles ---------------------------------------------------------------------------------------------------

TEST_CASE("In roles a place with several vertices has all their letters on its label and the newest in a sentence") {
  CHECK(roles("AEA")().label(corner('A').w) == "A = C");
  CHECK(roles("AA")().label(corner('A').w) == "A = B");
  CHECK(roles("AA")().of(corner('A').w) == "A");
  CHECK(roles("AE", 'E')().label(corner('E').w) == "P = A");
  CHECK(roles("AE", 'E')().of(corner('E').w) == "P");
  CHECK(roles("AE")().label(corner('E').w) == "A");
}

// -- Markup -----------------------------------------------------------------------------------------------------------

TEST_CASE("Plain text has no markup and keeps every other character") {
  CHECK(plain("R3: GE_n·GO = −71.5 > 0") == "R3: GEn·GO = −71.5 > 0");
  CHECK(plain("x_{12} ≠ 0") == "x12 ≠ 0");
  CHECK(plain("a\\_b") == "a_b");
  CHECK(literal("a_b {c}") == "a\\_b {c}");
  CHECK(plain("") == "");
}

TEST_CASE("After Z come A2, B2 and so on") {
  Moment now;
  for (int i = 0; i < 60; ++i) now.known.emplace_back(i, 0, 0);
  const LabelledHull none;
  const Names names(Naming::fixed, none, now);
  CHECK(names.of(Point(25, 0, 0)) == "Z");
  CHECK(names.of(Point(26, 0, 0)) == "A2");
  CHECK(names.of(Point(53, 0, 0)) == "B3");
  CHECK(names.of(Point(60, 0, 0)).empty());
}

}  // namespace words_test
