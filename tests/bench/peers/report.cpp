#include "tests/bench/peers/report.hpp"

#include <cmath>
#include <fstream>
#include <iomanip>
#include <ostream>
#include <sstream>

namespace peers {
namespace {

std::string fixed(double value, int digits) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << value;
  return text.str();
}

/// "0", or what went wrong: false positives, false negatives, undecided, failed.
std::string mistakes(const Score& score) {
  std::string text;
  const auto add = [&](int count, const char* sign) {
    if (count > 0) text += (text.empty() ? "" : " ") + std::to_string(count) + sign;
  };
  add(score.false_positives, "+");
  add(score.false_negatives, "−");
  add(score.undecided, "?");
  add(score.failed, "!");
  return text.empty() ? "0" : text;
}

/// The fastest peer beside the plain call; "–" where there is none. `counts` says which peers are looked at.
template <class Counts>
std::string speed_up(const Match& match, const std::vector<Contender>& contenders, Counts&& counts) {
  double fastest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < match.scores.size(); ++i)
    if (contenders[i].is_peer && match.scores[i].nanoseconds > 0 && counts(match.scores[i]))
      fastest = std::min(fastest, match.scores[i].nanoseconds);
  return std::isinf(fastest) ? "–" : fixed(fastest / match.scores[0].nanoseconds, 2);
}

void write_row(std::ostream& out, const std::vector<std::string>& cells) {
  for (const std::string& cell : cells) out << "| " << cell << ' ';
  out << "|\n";
}

void write_table_head(std::ostream& out, std::vector<std::string> columns, const std::vector<Contender>& contenders,
                      const std::vector<std::string>& last) {
  const std::size_t left = columns.size();
  for (const Contender& contender : contenders) columns.push_back(contender.name);
  columns.insert(columns.end(), last.begin(), last.end());
  write_row(out, columns);
  for (std::size_t i = 0; i < columns.size(); ++i) out << (i == 0 || i + 1 < left ? "|---" : "|---:");
  out << "|\n";
}

void write_times(std::ostream& out, const std::vector<Match>& matches, const std::vector<Contender>& contenders) {
  write_table_head(out, {"ns per query", "pairs", "meet"}, contenders,
                   {"fastest peer ÷ gjkstep", "fastest no worse ÷ gjkstep"});
  for (const Match& match : matches) {
    std::vector<std::string> cells{match.family, std::to_string(match.pairs), std::to_string(match.meet)};
    for (const Score& score : match.scores) cells.push_back(score.nanoseconds > 0 ? fixed(score.nanoseconds, 0) : "–");
    cells.push_back(speed_up(match, contenders, [](const Score&) { return true; }));
    cells.push_back(speed_up(match, contenders,
                             [&](const Score& peer) { return peer.not_right() <= match.scores[0].not_right(); }));
    write_row(out, cells);
  }
}

void write_mistakes(std::ostream& out, const std::vector<Match>& matches, const std::vector<Contender>& contenders) {
  write_table_head(out, {"wrong answers"}, contenders, {"a peer right, gjkstep not"});
  for (const Match& match : matches) {
    std::vector<std::string> cells{match.family};
    for (const Score& score : match.scores) cells.push_back(mistakes(score));
    cells.push_back(std::to_string(match.lost));
    write_row(out, cells);
  }
}

void write_failures(std::ostream& out, const std::vector<Match>& matches, const std::vector<Contender>& contenders) {
  for (const Match& match : matches)
    for (std::size_t i = 0; i < contenders.size(); ++i)
      if (!match.scores[i].first_failure.empty())
        out << "* " << contenders[i].name << ", " << match.family << ", " << match.scores[i].first_failure << "\n";
}

}  // namespace

void write_head(std::ostream& out, const Circumstances& c, const std::vector<Contender>& contenders) {
  out << "# The plain call beside what people use\n\n"
      << "The same pairs, one process, one thread, processor time; the contenders take turns, and of "
      << c.settings.repeats
      << " turns the median counts.\nShapes are made beforehand. Truth is exact: `tests/study/oracle.hpp`.\n\n"
      << "* made by: `" << c.command << "`\n* seed " << c.settings.seed << "\n* processor: " << c.processor
      << "\n* compiler: " << c.compiler << ", flags `" << c.flags << "` (the peers' own code as Debian compiled it)\n";
  for (const Contender& contender : contenders) out << "* " << contender.name << ": " << contender.how << "\n";
  out << "\nWrong answers: `+` false positives, `−` false negatives, `?` undecided or an exception, `!` crashed, out "
         "of time "
         "or not\nasked after such. Sets are closed: touching is intersecting. \"No worse\": not right on no more "
         "pairs than gjkstep.\n";
}

void write_markdown(std::ostream& out, const std::string& title, const std::vector<Match>& matches,
                    const std::vector<Contender>& contenders) {
  out << "\n## " << title << "\n\n";
  write_times(out, matches, contenders);
  out << '\n';
  write_mistakes(out, matches, contenders);
  out << '\n';
  write_failures(out, matches, contenders);
}

void write_csv(std::ostream& out, const Circumstances& c, const std::vector<Match>& matches,
               const std::vector<Contender>& contenders) {
  out << "# " << c.command << "; seed " << c.settings.seed << "; " << c.processor << "; " << c.compiler << "; "
      << c.flags << "\nfamily,contender,pairs,meet,ns_per_query,false_positives,false_negatives,undecided,failed\n";
  for (const Match& match : matches)
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      const Score& score = match.scores[i];
      out << match.family << ',' << contenders[i].name << ',' << match.pairs << ',' << match.meet << ','
          << fixed(score.nanoseconds, 1) << ',' << score.false_positives << ',' << score.false_negatives << ','
          << score.undecided << ',' << score.failed << '\n';
    }
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(": ") + 2);
  return "unknown";
}

}  // namespace peers
