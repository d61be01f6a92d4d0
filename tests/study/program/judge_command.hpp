/// `gjkstep-study judge -- PROGRAM ARG...`: is a program right? Markdown, or JSON, on the standard output.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tests/study/judge/judged_text.hpp"

namespace study {

struct JudgeCommand {
  std::vector<std::string> program, families;
  std::optional<std::string> pairs, failures, html;
  std::uint64_t count = 100, seed = 1, max_failures = 5;
  static constexpr double usual_time_limit = 2;
  double time_limit = usual_time_limit;
  bool json = false, steps = false;

  void add_to(CLI::App& app);
  /// Errors: std::runtime_error where something is wrong with the program, after everything is written.
  void run() const;

 private:
  bool makes_pairs() const { return !families.empty() || with_count_; }
  std::vector<NamedPair> chosen_pairs() const;
  JudgedHead head() const;
  void save(const ProgramJudged& judged) const;

  bool with_count_ = false;
};

}  // namespace study
