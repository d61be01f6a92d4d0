/// The commands of gjkstep-study, as its command line spells them.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tests/study/program/check_steps_command.hpp"
#include "tests/study/program/claims_command.hpp"
#include "tests/study/program/judge_command.hpp"
#include "tests/study/program/pairs_command.hpp"
#include "tests/study/sweep/plan.hpp"

namespace study {

/// `gjkstep-study run`: sweeps, and writes what was counted and timed.
struct RunCommand {
  Request request;
  bool quick = false, full = false;
  std::optional<std::string> shard, failures;
  std::string out = "study";
  unsigned threads = 0;  ///< 0: as many as the processor has
  std::uint64_t max_failures = 5;

  void add_to(CLI::App& app);
  void run() const;

 private:
  void expect_apart(const Plan& plan) const;
  void save(const std::vector<Failure>& found) const;
};

/// All of them. A further command is one more entry in Commands::add_to().
class Commands {
 public:
  /// `app` keeps references to this object, which must outlive it.
  void add_to(CLI::App& app);

  /// Runs the command that was parsed. Errors: UsageError where there was none, and those of the command.
  void run() const;

 private:
  template <class Command>
  void add(CLI::App& app, Command& command, const char* name, const char* what);

  RunCommand run_;
  ClaimsCommand claims_;
  PairsCommand pairs_;
  JudgeCommand judge_;
  CheckStepsCommand check_steps_;
  std::vector<std::pair<const CLI::App*, std::function<void()>>> all_;
};

}  // namespace study
