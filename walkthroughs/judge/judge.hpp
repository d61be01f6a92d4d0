/// Is a program right? It is asked about cases, one block after the other, in constant memory: kept are counts, the worst, and some
/// to look for the cause with.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "walkthroughs/judge/answer.hpp"
#include "walkthroughs/judge/asking.hpp"
#include "walkthroughs/judge/how_far.hpp"

namespace walkthroughs::judge {

/// What sets are to be called that programs see in different ways.
enum class Called { intersecting, separated, either };

/// What is wrong, and how wrong it may be.
struct Standard {
  Expected expected = {};
  Called touching = Called::intersecting;  ///< sets that only touch
  Called inside = Called::intersecting;    ///< sets of which one lies wholly inside the other, not touching its surface
  double tolerance =
      0;  ///< what is no farther from the other answer, relative to the size of the pair, is counted apart
};

enum class Verdict {
  right,
  within_tolerance,
  wrong_yes,
  wrong_no,
  wrong_distance,
  undecided,
  not_a_number,
  no_answer,
  ended,
  late,
  not_asked
};
inline constexpr std::array<std::string_view, 11> verdict_words{
    "right",     "within the tolerance", "wrong yes", "wrong no", "wrong distance",
    "undecided", "not a number",         "no answer", "ended",    "too late",
    "not asked"};

/// Returns: whether it is a fault of the program. To leave a pair open is one.
constexpr bool is_fault(Verdict verdict) {
  return verdict != Verdict::right && verdict != Verdict::within_tolerance && verdict != Verdict::not_asked;
}
/// Returns: whether it is the wrong answer, and not none.
constexpr bool is_wrong(Verdict verdict) {
  return verdict == Verdict::wrong_yes || verdict == Verdict::wrong_no || verdict == Verdict::wrong_distance;
}

/// Returns: by how much a distance may be off, relative to the size of the pair, which is the diagonal of the box around both.
/// That is far above what rounding does to a good search, in doubles or in floats.
constexpr double good_distance(Numbers numbers) { return numbers == Numbers::floats ? 1e-4 : 1e-6; }

/// What came of one case.
struct Judged {
  Case asked;
  Said said = Said::nothing;
  Verdict verdict = Verdict::not_asked;
  HowFar how_far = {};                  ///< of a wrong answer; where there is a distance, the true one
  std::optional<double> distance = {};  ///< that is told of sets apart
  std::string detail = {};              ///< of no answer, or of an early end
  bool false_evidence = false;          ///< whether what it gives as evidence of a right answer proves nothing
};

/// Returns: how far the sets would have to be moved to make a wrong answer right, relative to their size.
double how_wrong(const Judged& judged);

struct Tally {
  std::string family;
  std::uint64_t pairs = 0, false_evidence = 0;
  std::array<std::uint64_t, verdict_words.size()> counts{};
  double worst = 0;  ///< of wrong answers, relative

  std::uint64_t of(Verdict verdict) const { return counts[static_cast<std::size_t>(verdict)]; }
  std::uint64_t wrong() const { return of(Verdict::wrong_yes) + of(Verdict::wrong_no) + of(Verdict::wrong_distance); }
  std::uint64_t faults() const;
  void add(const Judged& judged);
};

inline constexpr std::size_t most_failed = 10;  ///< pairs without an answer that are kept, and so many undecided ones

struct Judgement {
  Tally all;
  std::vector<Tally> families;  ///< in the order in which they come
  std::vector<Judged>
      worst;  ///< wrong answers, those of the worst power of a hundred first, the smallest of them before larger ones, and all
              ///< before numbers beyond 1e±8; at most so many as were wanted
  std::vector<Judged> failed;       ///< the first without an answer
  std::vector<Judged> open;         ///< the first undecided ones
  std::vector<std::string> faults;  ///< all of them, each in a line: "wrong yes boxes-2"
  std::vector<Judged> samples;      ///< in which causes are looked for: answered, rightly and wrongly
  Replies replies;                  ///< how it behaved; without the lines
  std::uint64_t passed_over = 0;    ///< pairs that floats have no room for

  bool behaves()
      const;  ///< no run of the program crashed, was late, or brought more than was asked for, and all was asked
  bool is_good() const;  ///< and nothing is wrong
};

/// `progress`: is told how many of how many are done, of 0 where that is not known yet. Errors: those of run_program() and of Cases.
Judgement judge(const AskedProgram& program, Cases cases, const Standard& standard, std::size_t worst,
                const std::function<void(std::uint64_t done, std::uint64_t most)>& progress);

/// Returns: what the sets are to be called.
Called right_answer(const Case& asked, const Standard& standard);

/// Returns: whether `gjkstep render` takes the pair.
bool can_be_drawn(const PointPair& pair);

/// Returns: what came of that reply.
Judged judged(const Case& asked, const Reply& reply, const Standard& standard);

}  // namespace walkthroughs::judge
