/// Algorithms 1-5 of the report in our own notation, each line knowing which event is its own.
///
/// `[C, B, A]` is a simplex, oldest first; `d` the search direction; N the iteration limit.
#pragma once

#include <string>
#include <vector>

#include "walkthroughs/story/story.hpp"

namespace walkthroughs {

/// What a line does. A test stands for the region test with its face, feature and relation; an action for what
/// follows the test before it.
enum class LineKind { plain, support, crossing, add, process, intersecting, separated, undecided, test, action };

struct CodeLine {
  int indent;
  std::string text;  ///< in roles: "if ABn·AO > 0"
  LineKind kind = LineKind::plain;
  /// Of a test. In those of the complete rules X and Y stand for B, C or D, and "any" for each face and none.
  std::string face = {}, feature = {};
  std::optional<gjk::Relation> relation = {};  ///< of a test that has one line for each outcome
  int size = 0;                                ///< of the simplex, where the line is about one size
};

/// Returns: Algorithm 1 to 5, as these rules have it; the complete rules have one text for 3 to 5. Requires: 1 <= number <= 5.
const std::vector<CodeLine>& algorithm(int number, RuleSet rules);

/// "Algorithm 4"; of the complete rules, which are not the report's, what they do.
std::string name_of_algorithm(int number, RuleSet rules);

/// Returns: the number of the algorithm that was running when this was the last event, as `focus` tells it.
int running_algorithm(const Moment& now, Focus focus);

/// Returns: the line where it was, or nothing where no line stands for it.
std::optional<std::size_t> current_line(const std::vector<CodeLine>& code, const Moment& now, Focus focus);

/// Returns: the test that a line has made in this iteration so far, or null.
const gjk::RegionTested<double>* test_of(const CodeLine& line, const Moment& now);

}  // namespace walkthroughs
