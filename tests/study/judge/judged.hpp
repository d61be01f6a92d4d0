/// What is found about a program.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/image.hpp"
#include "tests/study/corpus/answered_pair.hpp"
#include "tests/study/judge/asking.hpp"
#include "tests/study/judge/rate.hpp"

namespace study {

enum class Verdict { right, wrong_yes, wrong_no, undecided, unreadable, ended, late, not_asked };
inline constexpr std::array<std::string_view, 8> verdict_words{"right",     "wrong yes", "wrong no", "undecided",
                                                               "no answer", "ended",     "too late", "not asked"};

/// What came of one pair.
struct Judged {
  NamedPair named;
  Truth truth = Truth::separated;
  Verdict verdict = Verdict::not_asked;
  bool false_evidence = false;  ///< whether evidence is given for a right answer that it does not prove
  std::string detail = {};      ///< of no answer, or of an early end

  bool is_wrong() const;    ///< undecided and not asked are not, nor a right answer with false evidence
  bool has_search() const;  ///< whose steps may say why it is not answered rightly: of sets of points, with an answer
};

struct FamilyTally {
  std::string family;
  std::uint64_t pairs = 0, evidence = 0, false_evidence = 0;
  std::array<std::uint64_t, verdict_words.size()> counts{};

  std::uint64_t of(Verdict verdict) const { return counts[static_cast<std::size_t>(verdict)]; }
  /// Of the pairs that were asked, those with is_wrong().
  Rate wrong = {};
};

/// By chance alone a mistake may be wrong on a pair or two of those that a program is wrong on.
inline constexpr std::uint64_t enough_in_common = 3;

enum class Numbers { doubles, floats };
inline constexpr std::array<std::string_view, 2> numbers_words{"doubles", "floats"};

/// How alike a program and one whose mistake is known are: how many pairs both answer wrongly, of those that one of them does.
struct Resemblance {
  /// The position in mistakes(). Then only pairs count that the report's algorithm answers rightly. Empty where all count: for
  /// that algorithm itself, which rounding and cycles mislead, and for who always says the same.
  std::optional<std::size_t> mistake = {};
  std::string name = {};  ///< "M18 (…)", "the report's algorithm in floats (without a mistake)"
  std::optional<Numbers> sound_in = {};  ///< of what has no mistake, so that only rounding and cycles make it wrong
  std::uint64_t both = 0, either = 0;
  std::string first_direction = {};  ///< with which it comes nearest: "+x", "from A to B"

  bool has_evidence() const { return both >= enough_in_common; }
  double share() const { return either == 0 ? 0 : static_cast<double>(both) / static_cast<double>(either); }
};

/// How many of the wrong answers about sets of points may be laid to rounding alone, in these numbers.
struct LaidToRounding {
  std::uint64_t wrong = 0, in_doubles = 0, in_floats = 0;
};

/// What came of asking again after a change that must not matter.
struct Change {
  std::string_view what;
  std::uint64_t asked = 0, other_answers = 0;
  std::uint64_t wrong_no = 0;  ///< of these, where the answer is known to be yes
  std::string first = {};  ///< the name of the first pair with another answer
  std::optional<Pair> first_pair = {};  ///< that pair after the change
};

/// What the steps of one failure say, where the program tells them.
struct JudgedSteps {
  std::string pair;        ///< its name
  int iteration = 0;       ///< of the first step that the report's algorithm would not make, from 1; 0: none
  std::string words = {};  ///< what is wrong with it, or why nothing is
  std::vector<std::size_t> mistakes = {};   ///< positions in mistakes() of those that would make it
  bool may_be_rounding = false;             ///< no line need be wrong
  std::optional<render::Image> drawn = {};  ///< beside what the report's algorithm makes, where they part
};

struct ProgramJudged {
  std::vector<Judged> pairs;
  std::vector<FamilyTally> families;  ///< in the order in which they come
  FamilyTally all;
  std::vector<Resemblance> resemblances;  ///< the best first; none where the program is wrong on no pair that counts
  LaidToRounding rounding;
  std::vector<Change> changes;
  std::optional<std::vector<JudgedSteps>> steps = {};  ///< of some failures, where they were asked for
  Replies replies;                                     ///< the lines are in `pairs`
  bool crashes = false;                                ///< also in company, or after its last answer

  bool is_good() const;  ///< nothing is wrong, and all was asked
};

}  // namespace study
