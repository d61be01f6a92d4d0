/// Asks a program about many pairs, so that each has its own answer or its own reason for none.
///
/// A run of the program is asked several at once: its start may take longer than a thousand answers, and it may keep its output
/// back until its input ends. Where answers are missing, smaller and smaller runs find the pair that is to blame, which is
/// then asked alone. The program is given up after 5 pairs in a row that are too late, 50 that end or 3 that bring more than a line,
/// and after 20 runs that answered a few and then had to be ended, none between that answered more.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "walkthroughs/judge/run_program.hpp"

namespace walkthroughs::judge {

struct Reply {
  enum Kind { line, ended, late, flooding, not_asked } kind = not_asked;
  std::string text;  ///< the line; or why there is none: "exit code 1", "no answer within 2 s"
};

struct Replies {
  std::vector<Reply> all;  ///< one a question
  /// Runs that crashed, by a signal or with an exit code before their last answer, although each of their pairs, asked in other
  /// company, was answered; and how the first did.
  std::uint64_t crashes_in_company = 0;
  std::string first_crash;
  std::size_t answers_before_first_crash = 0;  ///< in its run
  /// Runs that were too late after some answers, although each of their pairs, asked in other company, was answered in time.
  std::uint64_t late_in_company = 0;
  std::size_t answers_before_first_late = 0;  ///< in its run
  std::uint64_t early_ends = 0;               ///< runs with exit code 0 that left questions unanswered behind answers
  std::uint64_t floods = 0;                   ///< runs that wrote more lines than they read
  std::uint64_t long_lines = 0;               ///< runs that wrote a line longer than may be
  bool closes_its_input = false;              ///< before it had answered all that was asked in a run
  bool outlives_its_input = false;            ///< it did not end when its input did
  bool was_given_up = false;                  ///< several in a row as above; the rest were not asked
  std::string said;          ///< what it wrote to standard error in the first run that was not answered
  std::uint64_t others = 0;  ///< lines that are no answers
  std::string first_other;   ///< of these
};

struct AskedProgram {
  std::vector<std::string> words;         ///< the program and its arguments
  std::chrono::milliseconds limit{2000};  ///< until its next answer, from its start on
  std::function<bool(std::string_view)> is_answer = [](std::string_view) { return true; };  ///< of a line
};

/// Errors: those of run_program().
Replies ask_all(const AskedProgram& program, const std::vector<std::string>& questions);

}  // namespace walkthroughs::judge
