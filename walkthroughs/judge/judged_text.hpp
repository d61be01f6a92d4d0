/// What was found about a program, in words: a first screen of five lines, a table, JSON, a page; and scenes to draw.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "walkthroughs/judge/causes.hpp"
#include "walkthroughs/judge/judge.hpp"
#include "walkthroughs/judge/told_steps.hpp"

namespace walkthroughs::judge {

/// What was known to be wrong: faults that are no news.
struct Accepted {
  std::string file;
  std::set<std::string> faults;  ///< as Judgement has them
  bool is_written = false;       ///< just now: what is wrong is what is accepted

  /// Returns: the faults that are news.
  std::vector<std::string> news(const Judgement& judgement) const;
};

struct Report {
  std::string program;  ///< with its arguments, as a shell reads them
  std::string options;  ///< of the command line, before "--"; with a blank behind them where there are some
  Judgement judgement = {};
  std::vector<Cause> causes = {};
  std::optional<Accepted> accepted = {};
  std::string saved = {};  ///< the folder of its scenes; else empty
  std::string shown = {};  ///< the folder of --report; else empty
  StepsLooked steps = {};
};

/// Returns: why nothing can be said of the program, if that is so: it answered nothing, or was given up, or wrote more than was asked.
std::optional<std::string> why_not_judged(const Judgement& judgement);

/// Returns: verdict and counts; the worst pair; it as a scene; the most probable cause with its evidence; what to do next. And a line
/// each for what is odd about how it behaves.
std::string first_screen(const Report& report);

/// Returns: a table in Markdown, a row a family.
std::string table(const Report& report);

/// Returns: each search of which something was found, step by step.
std::string steps_text(const Report& report);

/// Returns: all of it as JSON.
std::string json(const Report& report);

struct SavedScene {
  std::string name, text;
};

/// Returns: the pairs without an answer, then the worst, each as a file of one line that `gjkstep render` takes, and --pairs, and the
/// program itself; those beyond its limits are left out.
std::vector<SavedScene> scenes_of_worst(const Judgement& judgement);

// -- The same for a page ------------------------------------------------------------------------------------------------

struct ToldPair {
  std::string name, what;
  std::string file = {}, scene = {};  ///< what it is saved as, and what stands there; empty where it cannot be drawn
};
inline constexpr const char *not_drawn = "beyond what is drawn: its numbers are too large", *no_cause = "none found";

struct ToldCause {
  std::string name, evidence;
  long agreement;    ///< in percent
  std::string next;  ///< a command; empty where nothing follows from it
};

using Row = std::vector<std::string>;

struct Told {
  std::string verdict, accepted;
  std::vector<ToldCause> causes = {};
  std::string first_wrong_step = {};                       ///< empty where there is none
  std::vector<ToldPair> pairs = {};                        ///< those without an answer, then the worst
  Row columns = {}, all = {};                              ///< of the table
  std::vector<Row> with_faults = {}, without_faults = {};  ///< a family each
  std::vector<std::string> notes = {};                     ///< on how it behaves
  std::string command = {};                                ///< that makes the report
};

/// Returns: what first_screen(), table() and scenes_of_worst() say, in pieces. Requires: report.shown.
Told told(const Report& report);

}  // namespace walkthroughs::judge
