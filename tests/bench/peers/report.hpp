/// What the benchmark found, as Markdown for readers and as CSV for programs.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "tests/bench/peers/match.hpp"

namespace peers {

/// Where and how it was measured.
struct Circumstances {
  std::string command, compiler, flags, processor;
  MatchSettings settings;
};

void write_head(std::ostream& out, const Circumstances& circumstances, const std::vector<Contender>& contenders);
void write_markdown(std::ostream& out, const std::string& title, const std::vector<Match>& matches,
                    const std::vector<Contender>& contenders);
void write_csv(std::ostream& out, const Circumstances& circumstances, const std::vector<Match>& matches,
               const std::vector<Contender>& contenders);

/// Returns: the model name in /proc/cpuinfo, or "unknown".
std::string processor();

}  // namespace peers
