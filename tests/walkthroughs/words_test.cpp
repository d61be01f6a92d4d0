#include "walkthroughs/words.hpp"

#include <limits>

#include "tests/catch.hpp"
#include "tests/walkthroughs/support.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

namespace {

/// A hexagon with A at (3,0), and simplices of its corners.
const LabelledHull hexagon{{{3, 0}, {2, 2}, {-2, 2}, {-3, 0}, {-2, -2}, {2, -2}}};

/// Requires: letters from A to F, oldest first.
Simplex simplex(const std::string& letters) {
  Simplex s;
  for (const char letter : letters) {
    const Vec2& at = hexagon.corners.at(static_cast<std::size_t>(letter - 'A'));
    Vertex vertex;
    vertex.w = {at.x(), at.y(), 0};
    s.add(vertex);
  }
  return s;
}

std::string translate(const std::string& letters, const std::string& text) {
  return Letters(simplex(letters), hexagon).translate(text);
}

}  // namespace

TEST_CASE("A number has at most eight significant digits") {
  CHECK(number(4.375) == "4.375");
  CHECK(number(120) == "120");
  CHECK(number(0.1 + 0.2) == "0.3");
  CHECK(number(123456) == "123456");
  CHECK(number(118.1875) == "118.1875");
  CHECK(number(1.0 / 3) == "0.33333333");
}

TEST_CASE("The minus sign of a number is U+2212, in the exponent too") {
  CHECK(number(-10.1875) == "\u221210.1875");
  CHECK(number(-1) == "−1");
  CHECK(number(-1.5e-7) == "−1.5e−07");
  CHECK(number(-2.5e9).find('-') == std::string::npos);
}

TEST_CASE("Zero is never negative") {
  CHECK(number(0.0) == "0");
  CHECK(number(-0.0) == "0");
  CHECK(vector({-0.0, 1, 0}) == "(0, 1)");
  CHECK(number(-std::numeric_limits<double>::denorm_min()) != "−0");
}

TEST_CASE("A vector has two components in the plane, three in space") {
  CHECK(vector({-3.75, -3.25, -0.0}) == "(−3.75, −3.25)");
  CHECK(vector_in_space({0, -0.0, 9}) == "(0, 0, 9)");
}

TEST_CASE("Roles become the letters of the corners, the newest vertex being A") {
  CHECK(translate("A", "AO") == "AO");
  CHECK(translate("AE", "AO") == "EO");
  CHECK(translate("AE", "AB×AO×AB") == "EA×EO×EA");
  CHECK(translate("AEF", "ABn·AO") == "FE_n·FO");
  CHECK(translate("AEF", "AC×AO×AC") == "FA×FO×FA");
  CHECK(translate("AEF", "−ABCn") == "−FEA_n");
  CHECK(translate("BCDE", "ABCn ADBn BD") == "EDC_n EBD_n DB");
}

TEST_CASE("Translation leaves words that are no roles alone") {
  CHECK(translate("AEF", "the origin lies beyond this edge; A stays the newest") ==
        "the origin lies beyond this edge; F stays the newest");
  CHECK(translate("AEF", "At a Bad place: Cn, n, Eq. 9, R3, ABx, 2·AB") ==
        "At a Bad place: A_n, n, Eq. 9, R3, ABx, 2·FE");
  CHECK(translate("AEF", "d = ≥ ⊥ −") == "d = ≥ ⊥ −");
  CHECK(translate("AEF", "") == "");
}

TEST_CASE("A letter is not translated twice") { CHECK(translate("BCDA", "ABCD") == "ADCB"); }

TEST_CASE("A feature is named in alphabetical order, whatever the order of its vertices") {
  CHECK(Letters(simplex("AEF"), hexagon).feature("AB") == "EF");
  CHECK(Letters(simplex("AFE"), hexagon).feature("AB") == "EF");
  CHECK(Letters(simplex("FAE"), hexagon).feature("ABC") == "AEF");
  CHECK(Letters(simplex("FAE"), hexagon).feature("C") == "F");
}

TEST_CASE("A simplex is listed oldest first") {
  CHECK(list_of_names(simplex("FAE"), hexagon) == "[F, A, E]");
  CHECK(list_of_names(simplex("A"), hexagon) == "[A]");
  CHECK(list_of_names(Simplex{}, hexagon) == "[]");
}

TEST_CASE("Plain text has no markup and keeps every other character") {
  CHECK(plain("R3: GE_n·GO = −71.5 > 0") == "R3: GEn·GO = −71.5 > 0");
  CHECK(plain("x_{12} ≠ 0") == "x12 ≠ 0");
  CHECK(plain("a\\_b") == "a_b");
  CHECK(plain("") == "");
}
