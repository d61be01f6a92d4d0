/// One query at a time: JSON Lines in, JSON Lines out. `gjkstep query --help` says what a line holds.
///
///     {"a":{"points":[[0,0,0],[1,0,0],[0,1,0]]},"b":{"sphere":{"center":[3,0,0],"radius":1}}}
///     {"status":"separated","iterations":2,"reason":"origin-not-crossed","evidence":{"direction":[…],…}}
///
/// Evidence is what collision() returns: where separated the direction, how far the difference reaches along it (w·d < 0)
/// and the two points that reach so far, with their indices in "points"; else the simplex, oldest vertex first, newest
/// (A) last: the one that contains the origin where intersecting, the last one where undecided.
///
/// Asked for certificates, each answer is proven, and "certificate" takes the place of "reason" and "evidence": of points always, of
/// balls there is none, and about shapes whose points are computed an answer may be undecided, with a bound on the gap.
///
/// Numbers are the shortest that read back the same in the scalar; -0.0 keeps its sign. In exact numbers they are strings,
/// "p/q" in lowest terms or "p". What is not finite is "inf", "-inf" or "nan", and a long double beyond all doubles a string.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "walkthroughs/query/query_lines.hpp"
#include "walkthroughs/query/query_options.hpp"
#include "walkthroughs/text/scene_limits.hpp"

namespace walkthroughs::query {

namespace query_limits {
inline constexpr std::size_t line = scene_limits::bytes;       ///< as long as a scene file may be
inline constexpr std::size_t measured = std::size_t{1} << 30;  ///< bytes of a file whose pairs are measured
}  // namespace query_limits

/// Appends the answer to one pair, or an error that names that line, and a line feed. Returns: whether it is an answer.
bool answer_line(std::string_view line, std::size_t line_number, const QueryOptions& options, std::string& out);

using Write = std::function<void(std::string_view)>;

struct QueryTally {
  std::size_t lines = 0, bad = 0;
  std::size_t first_bad = 0;  ///< counted from 1; 0 where all are good
};

/// One line out for each line in, also for blank ones (an error). Before more is read, all answers so far are written: who
/// asks one pair and waits gets the answer. Errors: those of reading and writing.
QueryTally answer_lines(const QueryOptions& options, const ReadSome& read, const Write& write);

}  // namespace walkthroughs::query
