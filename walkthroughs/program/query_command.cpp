// gjkstep query: pairs of objects on standard input, answers on standard output.

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <iostream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/gjk.hpp"
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/model/words_of.hpp"
#include "walkthroughs/program/command_line.hpp"
#include "walkthroughs/program/number_option.hpp"
#include "walkthroughs/program/places.hpp"
#include "walkthroughs/program/standard_output.hpp"
#include "walkthroughs/query/measure.hpp"
#include "walkthroughs/query/query.hpp"
#include "walkthroughs/story/words.hpp"
#include "walkthroughs/text/names.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/text/scene_limits.hpp"
#include "walkthroughs/text/text_file.hpp"

namespace walkthroughs::program {
namespace {

std::string footer() {
  return R"(INPUT
Standard input holds JSON Lines, each {"a": OBJECT, "b": OBJECT}. An OBJECT is one of
)" + shapes_in_lines("  {", "}") +
         R"(It may have a "pose" and a "name", as in scene files ('gjkstep scene --example').
A point [x, y] means [x, y, 0]. A pair may say "dimension": 2. --scalar exact takes points, boxes and their sums only.
A number is read as the nearest double, and then converted. A line may have 16 MiB, and end in CR LF.
"name", "id", "family", "answer", "expect", "truth", "notes", "source" and keys that begin with _ are repeated in the answer.
A scene in one line is a pair, too. What it says beside its objects is not looked at.
The first direction is +x. With --start between, and with eager rules, it leads from the center of a to that of b.
The center of points is their mean. With --start inside the first vertex is the difference of these centers; it has no indices.

OUTPUT
One line for each, in the same order:
  {"status": "intersecting", "separated" or "undecided", "iterations": n, "reason": "...", "evidence": {...}}
The evidence of separated is a direction d, the points a and b farthest along d and -d, and (a - b)·d < 0.
Else it is the simplex, its newest vertex last, each w = a - b. An index is the position in "points", from 0.
Numbers are the shortest that read back the same in the scalar. Some are strings: the fractions of exact ("1/3"), long
doubles beyond all doubles, "inf", "-inf" and "nan".
Differences of points beyond about 1e±75 (double) or 1e±8 (float) overflow or vanish in products. The answer is then
arbitrary. long-double and exact have room for all numbers that a line may hold.
A bad line, also a blank one, gives {"error": "...", "line": n}. The others are answered.
Answers are written before more is read, so a program may ask one pair and wait.

--certified
Every answer is true, whatever rounds or overflows, in --scalar float or double, for any finite numbers.
About points, spheres, boxes, capsules and sums of these, in any pose, none is "undecided", unless sums have more than 2^30
points, or half of a size is no double. Nor about cylinders, spheres and capsules along one coordinate axis. Other cylinders
are undecided only where rounding leaves it open, nearer than ten roundings of the coordinates. Of points that no pose moves:
  {"status": "...", "iterations": n, "second_iterations": m, "proof": "...", "certificate": {...}}
The proof is "direction" or "tetrahedron" where what the first search found is proof enough. Else it is "second-search":
an exact fallback of m iterations. Rules, zero test, start and iterations steer the first search only.
A certificate is about the numbers as read and converted, multiplied without rounding:
  {"direction": [x, y, z]}     separated: this d has a·d < b·d for all points a and b
  {"nearest": [[i, j], ...]}   separated: so has d = -v, v being the point nearest to 0 of the hull of these a[i] - b[j]
  {"simplex": [[i, j], ...]}   intersecting: 0 is in the hull of these a[i] - b[j]; index -1 is the mean of all points
With --fractions each number is "p/q", and there is what a check needs. "direction" stands beside "nearest".
Beside "simplex" stand "weights" w[k] >= 0, whose sum is 1, and "point". This is the sum of all w[k] a[i], and also of
all w[k] b[j]: a point of both objects.
Of all others of these without cylinders, where squared distances were compared exactly:
  {"status": "...", "iterations": n, "proof": "distance", "certificate": {"nearest": [[i, j], ...]}}
Let the core be an object without its radii, turned by its matrix or quaternion without rounding. Of the hull of these
a[i] - b[j] of the cores, let v be the point nearest to 0. Of all a - b none is nearer. They intersect where |v| is at most the
sum of the radii. A sphere has one point. A capsule has "from" and "to". A box has the corners ---, +--, ++-, -+-, -++, +++, +-+
and --+ by the sides of x, y and z; where it is flat, those with a + there are left out. The points of a sum are numbered in
pairs, those of the second shape first. --fractions adds "weights", and "point": v.
Of cylinders along one coordinate axis, also with a sphere or a capsule along it: {"status": "...", "proof": "discs"}.
Points of other cylinders are computed, and known to some roundings:
  {"status": "separated", "iterations": n, "proof": "direction", "certificate": {"direction": [x, y, z]}}
  {"status": "intersecting", "iterations": n, "proof": "surface"}, one of points found that goes around 0
  {"status": "undecided", "iterations": n, "gap": g}: no farther apart than g, and no deeper in each other

Exit codes: 0 all lines are answered, 2 wrong usage, 3 a line was bad or the input cannot be read, 5 cannot write.)";
}

std::size_t read_some(std::span<char> bytes) {
  for (;;) {
    const ssize_t count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
    if (count >= 0) return static_cast<std::size_t>(count);
    if (wait_for(STDIN_FILENO, POLLIN)) continue;
    if (errno != EINTR)
      throw InputError(std::string("standard input cannot be read: ") + std::strerror(errno) +
                       "; give it pairs, one a line");
  }
}

/// Returns: the enumerator at the position of the word. Errors: UsageError.
template <class Enumerator, std::size_t count>
Enumerator choice(const std::string& option, const std::string& word,
                  const std::array<std::string_view, count>& words) {
  const auto found = std::ranges::find(words, word);
  if (found != words.end()) return static_cast<Enumerator>(found - words.begin());
  const std::vector<std::string> known(words.begin(), words.end());
  throw UsageError(option + " " + in_quotes(word) + " is not known; " + did_you_mean(nearest(word, known)) +
                   "'gjkstep query --help' shows all");
}

/// Returns: "as-intended: the report's rules; as-printed: ...".
template <class E, std::size_t count>
std::string words_and_meanings(const std::array<gjk::Named<E>, count>& table) {
  return joined(table, "; ", [](const auto& each) { return std::string(each.name).append(": ").append(each.meaning); });
}

/// Errors: UsageError.
void expect_scalar_with_proofs(QueryScalar scalar) {
  if (scalar == QueryScalar::exact)
    throw UsageError(
        "--certified is for --scalar float and double; exact does not round, so what it decides is true anyway: leave "
        "out --certified");
  if (scalar == QueryScalar::long_double)
    throw UsageError("--certified is for --scalar float and double, whose rounding it bounds; leave out --scalar");
}

/// Returns: the direction x,y,z, written in decimal; nothing where a number is not finite, or all are 0.
std::optional<Point> direction_in(std::string_view text) {
  Point direction;
  for (int i = 0; i < 3; ++i) {
    const std::size_t end = i < 2 ? text.find(',') : text.size();
    const auto number = decimal<double>(text.substr(0, end));
    if (!number || end == std::string_view::npos) return std::nullopt;
    direction[i] = *number;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return gjk::is_usable_direction(direction) ? std::optional(direction) : std::nullopt;
}

/// Errors: UsageError.
Point first_direction_in(const std::string& text, QueryScalar scalar) {
  const Point direction = *direction_in(text);
  if (scalar == QueryScalar::binary32 && !gjk::is_usable_direction(Cast<float>{}.point(direction)))
    throw UsageError("--first-direction " + in_quotes(text) +
                     " is infinite or 0 in floats; only the ratios of its numbers count: bring them nearer to 1");
  return direction;
}

struct QueryCommand {
  std::string scalar = "double", rules = "as-intended", zero_test = "exact";
  int max_iterations = 20;
  std::optional<std::string> start, first_direction;
  bool certified = false, fractions = false;
  std::optional<std::string> measured;  ///< a file
  bool csv = false;

  /// Returns: the exit code: 0, or 3 where a line was bad (told on standard error; the others are answered).
  /// Errors: UsageError; InputError where standard input cannot be read; render::FileError where standard output cannot be
  /// written.
  int run() const {
    const QueryOptions options = checked_options();
    if (measured) {
      expect_output_apart_from(*measured, "the file of pairs");
      const Measurement found = measure(read_text(*measured, query_limits::measured), called(*measured), options);
      std::cout << (csv ? csv_of(found) : table_of(found));
      return ok;
    }
    Places places;
    places.read_standard_input();
    places.write_standard_output();
    places.expect_apart();
    const QueryTally tally = answer_lines(options, read_some, write_to_standard_output);
    if (tally.bad == 0) return ok;
    std::cerr << "gjkstep: " << tally.bad << " of " << tally.lines << (tally.lines == 1 ? " line is" : " lines are")
              << " not answered; the first is line " << tally.first_bad << ", and its \"error\" says why\n";
    return bad_input;
  }

 private:
  /// Errors: UsageError.
  QueryOptions checked_options() const {
    QueryOptions options{.scalar = choice<QueryScalar>("--scalar", scalar, query_scalars),
                         .rules = choice<RuleSet>("--rules", rules, words_of::rules),
                         .zero_test = choice<ZeroTest>("--zero-test", zero_test, words_of::zero_test),
                         .iteration_limit = max_iterations};
    if (start) options.start = choice<QueryStart>("--start", *start, query_starts);
    if (first_direction) options.first_direction = first_direction_in(*first_direction, options.scalar);
    if (certified) {
      expect_scalar_with_proofs(options.scalar);
      options.evidence = fractions ? QueryEvidence::fractions : QueryEvidence::certificate;
    }
    return options;
  }
};

}  // namespace

Command add_query_command(CLI::App& app) {
  const auto query = std::make_shared<QueryCommand>();
  CLI::App* const command =
      app.add_subcommand("query", "answer pairs of objects: one pair a line in, one answer a line out");
  command->option_defaults()->always_capture_default();  // which help shows
  command->add_option("--scalar", query->scalar, "compute in float, double, long-double or exact fractions");
  command->add_option("--rules", query->rules, words_and_meanings(gjk::rule_sets));
  command->add_option("--zero-test", query->zero_test,
                      words_and_meanings(gjk::zero_tests) +
                          "; relative makes together of what is barely apart (of 175 pairs from public projects 9)");
  expect_number(
      command->add_option("--max-iterations", query->max_iterations, "so many at most; then the answer is undecided"),
      1, scene_limits::iterations);
  CLI::Option* const start = command->add_option(
      "--start", query->start,
      "between: search first from the center of a to that of b; inside: begin with the difference of the centers");
  CLI::Option* const first_direction =
      command->add_option("--first-direction", query->first_direction, "search first along x,y,z")->excludes(start);
  first_direction->check(CLI::Validator(
      [](const std::string& text) -> std::string {
        return direction_in(text) ? "" : "expected three finite numbers x,y,z, not all 0, found " + in_quotes(text);
      },
      "x,y,z"));
  CLI::Option* const certified = command->add_flag("--certified", query->certified,
                                                   "prove each answer, with a certificate where it is about points");
  command
      ->add_flag("--fractions", query->fractions,
                 "write certificates in exact fractions, with what it takes to check them")
      ->needs(certified);
  CLI::Option* const measured =
      command->add_option("--measure", query->measured,
                          "ask the pairs of this file in each scalar by each set of rules, "
                          "and certified: what a pair costs, how many answers are "
                          "wrong, and which setting to choose. Exact numbers, which take a thousand "
                          "times as long, are asked about 1000 pairs or 4096 points at most");
  measured->type_name("FILE")->excludes(certified)->excludes("--scalar")->excludes("--rules");
  command->add_flag("--csv", query->csv, "write that table as CSV")->needs(measured);
  command->footer(footer());
  return {command, [query] { return query->run(); }};
}

}  // namespace walkthroughs::program
