/// What was found about a program, in words and for programs.
#pragma once

#include <string>
#include <vector>

#include "tests/study/judge/judged.hpp"

namespace study {

/// What readers need beside what was found.
struct JudgedHead {
  std::string program;     ///< the command that was judged
  std::string command;     ///< the command that judged it
  bool is_sample = false;  ///< whether pairs are thrown, not chosen: then rates have intervals
};

/// Returns: the verdict in one line: "wrong: 31 of 458 pairs".
std::string verdict_line(const ProgramJudged& judged);
/// Returns: what there is to say to it, a sentence each: the mistake that answers most alike, how it crashed, what it wrote.
std::vector<std::string> remarks(const ProgramJudged& judged);

struct Table {
  std::string heading;
  std::vector<std::string> titles;
  std::size_t words;  ///< the first so many columns are words, the others numbers
  std::vector<std::vector<std::string>> rows = {};
  std::vector<std::string> sentences = {};  ///< to read below it
};

/// Returns: what is there to tell of these, in the order in which to read them: families, mistakes that answer alike, answers that
/// changed, first wrong steps. Families of which all is right have no row; the last row is of all pairs.
std::vector<Table> tables_of(const ProgramJudged& judged, bool is_sample);

std::string judged_markdown(const ProgramJudged& judged, const JudgedHead& head);
/// Returns: one object, one line.
std::string judged_json(const ProgramJudged& judged, const JudgedHead& head);

}  // namespace study
