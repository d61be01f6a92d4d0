/// Algorithms 1-5 of the report in our own notation, each line knowing which event is its own.
///
/// `[C, B, A]` is a simplex, oldest first; `d` the search direction; N the iteration limit.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "walkthroughs/story/story.hpp"

namespace walkthroughs::story {

/// What a line does. A test stands for the region test with its face, feature and relation; an action for what
/// follows the test before it.
enum class LineKind {
  plain,
  otherwise,  ///< an "else" that says which region is left
  support,
  crossing,
  add,
  process,
  intersecting,
  separated,
  undecided,
  test,
  action,
  // Of proofs, and of the second search:
  direction_proof,
  direction_holds,
  tetrahedron_proof,
  tetrahedron_holds,
  second_start,
  toward
};

/// What a line of Algorithms 4 and 5 keeps, oldest first, and where it searches on.
struct Way {
  gjk::Roles kept;
  gjk::Expression direction;
};

/// The tests that a line stands for.
struct TestsOf {
  gjk::Roles feature = {}, face = {};
  std::optional<gjk::Relation> relation = {};  ///< of a test that has one line for each outcome
  int any_of_size = 0;       ///< of the complete rules: in place of a feature each edge AX (2) or face AXY (3)
  bool in_any_face = false;  ///< and in none
  int simplex_size = 0;      ///< where the line is about one size
};

struct CodeLine {
  int indent;
  std::string text;  ///< in roles: "if ABn·AO > 0"
  LineKind kind = LineKind::plain;
  TestsOf tests = {};           ///< of a test
  std::optional<Way> way = {};  ///< of an action that leads on and does not keep everything as it is
};

/// The number of what is not the report's: proofs, and the second search.
inline constexpr int certifying = 6;

/// Returns: Algorithm 1 to 5, as these rules have it, or what certifies; the complete rules have one text for 3 to 5.
/// Requires: 1 <= number <= 6.
const std::vector<CodeLine>& algorithm(int number, RuleSet rules);

/// Returns: the number of the algorithm that was running when this was the last event, as `focus` tells it.
int running_algorithm(const Moment& now, Focus focus);

/// Returns: the line where it was, or nothing where no line stands for it.
std::optional<std::size_t> current_line(const std::vector<CodeLine>& code, const Moment& now, Focus focus);

/// Returns: the test that a line has made in this iteration so far, or null.
const gjk::RegionTested<double>* test_of(const CodeLine& line, const Moment& now);

/// Returns: what came of a test, and its value where that is to be shown: "= −0.42 ✗".
std::string outcome(const gjk::RegionTested<double>& test, bool with_value);

/// Returns: "Algorithm 4", and where the picture has its own letters, who is who in the simplex that is being processed:
/// "Algorithm 4: A = G, B = E, C = A". That of the complete rules, which are not the report's, is "Nearest feature", that
/// of the proofs "Certified".
std::string title_of(int number, RuleSet rules, const Names& names, const Simplex& simplex);

/// Returns: the text of a line of that algorithm in the letters of the picture, with the markup of render/font.hpp.
std::string line_in_letters(int number, const CodeLine& line, const Names& names);

}  // namespace walkthroughs::story
