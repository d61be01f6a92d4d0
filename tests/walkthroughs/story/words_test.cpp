#include "walkthroughs/story/words.hpp"

#include <limits>
#include <map>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"

using namespace walkthroughs;
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
  CHECK(vector({-3.75, -3.25, -0.0}) == "(−3.75, −3.25)");
  CHECK(vector({0, -0.0, 9}, Dimension::space) == "(0, 0, 9)");
}

// -- Names of corners -------------------------------------------------------------------------------------------------

TEST_CASE("Roles become the letters of the corners, the newest vertex being A") {
  CHECK(translate("A", "AO") == "AO");
  CHECK(translate("AE", "AO") == "EO");
  CHECK(translate("AE", "AB×AO×AB") == "EA×EO×EA");
  CHECK(translate("AEF", "ABn·AO") == "FE_n·FO");
  CHECK(translate("AEF", "AC×AO×AC") == "FA×FO×FA");
  CHECK(translate("AEF", "−ABCn") == "−FEA_n");
  CHECK(translate("BCDE", "ABCn ADBn BD") == "EDC_n EBD_n DB");
  CHECK(translate("BCDA", "ABCD") == "ADCB");  // no letter twice
}

TEST_CASE("Translation leaves words that are no roles alone") {
  CHECK(translate("AEF", "the origin lies beyond this edge; A stays the newest") ==
        "the origin lies beyond this edge; F stays the newest");
  CHECK(translate("AEF", "At a Bad place: Cn, n, Eq. 9, R3, ABx, 2·AB") ==
        "At a Bad place: A_n, n, Eq. 9, R3, ABx, 2·FE");
  CHECK(translate("AEF", "d = ≥ ⊥ −") == "d = ≥ ⊥ −");
  CHECK(translate("AEF", "") == "");
}

TEST_CASE("A feature is named in alphabetical order, whatever the order of its vertices") {
  CHECK(corners("AEF")().sorted("AB") == "EF");
  CHECK(corners("AFE")().sorted("AB") == "EF");
  CHECK(corners("FAE")().sorted("ABC") == "AEF");
  CHECK(corners("FAE")().sorted("C") == "F");
}

TEST_CASE("A simplex is listed oldest first, and named with its kind and its letters in alphabetical order") {
  const Named names = corners("FAE");
  CHECK(names().list(simplex("FAE")) == "[F, A, E]");
  CHECK(names().list(Simplex{}) == "[]");
  CHECK(names().simplex(simplex("FAE")) == "triangle AEF");
  CHECK(names().simplex(simplex("FE")) == "segment EF");
  CHECK(names().simplex(simplex("E")) == "E");
  CHECK(with_kind("ABCD") == "tetrahedron ABCD");
}

TEST_CASE("Corners keep their letters while the search goes on, found or not") {
  const Named names{Naming::corners, "AE", 'F'};
  for (const char letter : std::string("ABCDEF")) {
    CHECK(names().of(corner(letter).w) == std::string(1, letter));
    CHECK(names().label(corner(letter).w) == std::string(1, letter));
  }
  CHECK(names().of(Point(0, 0, 0)).empty());
}

// -- Names of roles ---------------------------------------------------------------------------------------------------

TEST_CASE("In roles the newest vertex is A, the one before it B, and what is not in the simplex has no name") {
  const Named names = roles("CEFB");
  CHECK(names().of(corner('B').w) == "A");
  CHECK(names().of(corner('F').w) == "B");
  CHECK(names().of(corner('E').w) == "C");
  CHECK(names().of(corner('C').w) == "D");
  CHECK(names().of(corner('D').w).empty());
  CHECK(names().label(corner('D').w).empty());
}

TEST_CASE("In roles the point just found is P until it is added, and the others keep their letters until then") {
  const Named before = roles("AE", 'F'), after = roles("AEF");
  CHECK(before().of(corner('F').w) == "P");
  CHECK(before().of(corner('E').w) == "A");
  CHECK(before().of(corner('A').w) == "B");
  CHECK(after().of(corner('F').w) == "A");
  CHECK(after().of(corner('E').w) == "B");
  CHECK(after().of(corner('A').w) == "C");
}

TEST_CASE("In roles the letters stay those of the simplex that was processed when it is reduced") {
  Named names = roles("AEF");
  names.now.simplex = simplex("EF");
  CHECK(names().of(corner('A').w) == "C");
  CHECK(names().list(names.now.simplex) == "[B, A]");
  CHECK(names().simplex(names.now.simplex) == "segment AB");
}

TEST_CASE("In roles a place with several vertices has all their letters on its label and the newest in a sentence") {
  CHECK(roles("AEA")().label(corner('A').w) == "A = C");
  CHECK(roles("AA")().label(corner('A').w) == "A = B");
  CHECK(roles("AA")().of(corner('A').w) == "A");
  CHECK(roles("AE", 'E')().label(corner('E').w) == "P = A");
  CHECK(roles("AE", 'E')().of(corner('E').w) == "P");
  CHECK(roles("AE")().label(corner('E').w) == "A");
}

TEST_CASE("In roles vertices of a simplex that lie at one place are listed under different letters") {
  CHECK(roles("AA")().list(simplex("AA")) == "[B, A]");
  CHECK(roles("AEA")().list(simplex("AEA")) == "[C, B, A]");
  CHECK(roles("AA")().simplex(simplex("AA")) == "segment AB");
}

TEST_CASE("Translation keeps roles, in the order in which the report writes them, and turns n into a subscript") {
  const Named names = roles("BCDE");
  CHECK(names().translate("ABn·AO, ABCn, ADBn, BD") == "AB_n·AO, ABC_n, ADB_n, BD");
  CHECK(names().translate("the search has just moved away from BCD, toward the origin") ==
        "the search has just moved away from BCD, toward the origin");
  CHECK(names().sorted("ADB") == "ADB");
  CHECK(names().sorted("DB") == "DB");
}

// -- Markup -----------------------------------------------------------------------------------------------------------

TEST_CASE("Plain text has no markup and keeps every other character") {
  CHECK(plain("R3: GE_n·GO = −71.5 > 0") == "R3: GEn·GO = −71.5 > 0");
  CHECK(plain("x_{12} ≠ 0") == "x12 ≠ 0");
  CHECK(plain("a\\_b") == "a_b");
  CHECK(literal("a_b {c}") == "a\\_b {c}");
  CHECK(plain("") == "");
}

TEST_CASE("Letters may be fixed: the first point that is found is A, the second B, and so on, in every role") {
  Walkthrough w = walkthrough("regions/3-simplex-face-adb-edge-ad");
  w.naming = Naming::fixed;
  const Story story = tell(w);
  std::map<std::string, Point> places;
  for (std::size_t i = 0; i < story.frames.size(); ++i) {
    const Moment& now = story.frames[i].moments[0];
    const Names names = story.names(i, 0);
    for (std::size_t k = 0; k < now.known.size(); ++k) {
      const std::string letter(1, static_cast<char>('A' + k));
      CHECK(names.of(now.known[k]) == letter);
      CHECK(names.label(now.known[k]) == letter);
      CHECK(names.before(now.known[k]).empty());
      CHECK(places.emplace(letter, now.known[k]).first->second == now.known[k]);  // for the whole search
    }
    for (int role = 0; role < now.processed.size(); ++role) {
      const Point& w_of_role = now.processed.point(static_cast<gjk::Role>(role));
      CHECK(names.of(static_cast<gjk::Role>(role)) == names.of(w_of_role));
    }
  }
  CHECK(places.size() == 5);
  const std::string expected = "D joins the simplex as its newest vertex.";
  CHECK(std::ranges::count(story.frames, expected, &Frame::caption) == 1);
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

TEST_CASE("Where roles move on, what a vertex was called before is told, but for the newest") {
  const Story story = tell(walkthrough("regions/3-simplex-face-adb-edge-ad"));
  int moves = 0;
  for (std::size_t i = 0; i < story.frames.size(); ++i) {
    if (story.frames[i].focus != Focus::added) continue;
    const Simplex& simplex = story.frames[i].moments[0].simplex;
    std::string before;
    for (int role = simplex.size(); role-- > 0;)
      before += story.names(i, 0).before(simplex.point(static_cast<gjk::Role>(role)));
    CHECK(before == std::string("CBA").substr(static_cast<std::size_t>(4 - simplex.size())));
    ++moves;
  }
  CHECK(moves == 3);
}
