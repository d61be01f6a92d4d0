/// A search as somebody else's program tells it: a pair, a line for each iteration, and perhaps the answer.
///
///     {"a":{"points":[…]},"b":{"points":[…]}}
///     {"direction":[1,0,0],"simplex":[[3,1,0]]}
///     {"direction":[-3,-1,0],"simplex":[[3,1,0],[-2,0,1]]}
///     true
///
/// A step says along which direction it searched, and the simplex after it was reduced, points a - b, the newest last; whoever
/// has it first in every step is understood, too. The last simplex need not be reduced, and the step that ends a search with
/// "no" need not be told: its vertex never becomes part of a simplex. A file holds as many such searches as it likes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/study/corpus/answered_pair.hpp"
#include "walkthroughs/judge/answer.hpp"

namespace study {

using walkthroughs::judge::Said;

struct ToldStep {
  Vec direction;
  std::vector<Vec> simplex;  ///< one to four, oldest first, however they were told
};

struct ToldRun {
  NamedPair named;
  std::vector<ToldStep> steps;
  std::optional<Said> said = {};
};

/// Errors: walkthroughs::text::InputError, which names the line of `file`.
std::vector<ToldRun> read_told_runs(std::string_view text, const std::string& file);

}  // namespace study
