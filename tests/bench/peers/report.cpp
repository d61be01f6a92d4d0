#include "tests/bench/peers/report.hpp"

#include <fstream>
#include <iomanip>
#include <limits>
#include <optional>
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
  add(score.not_asked, " not asked");
  return text.empty() ? "0" : text;
}

/// Returns: nanoseconds of the fastest of the peers that have at most so many pairs not right; empty where none was timed.
std::optional<double> fastest_peer(const Match& match, const std::vector<Contender>& contenders,
                                   int not_right = std::numeric_limits<int>::max()) {
  std::optional<double> fastest;
  for (std::size_t i = 0; i < match.scores.size(); ++i) {
    const Score& score = match.scores[i];
    if (!contenders[i].is_peer || score.nanoseconds == 0 || score.not_right() > not_right) continue;
    if (!fastest || score.nanoseconds < *fastest) fastest = score.nanoseconds;
  }
  return fastest;
}

/// "1.27": how many times as long the peer takes; "–" where there is none.
std::string speed_up(const std::optional<double>& peer, const Score& ours) {
  return peer ? fixed(*peer / ours.nanoseconds, 2) : "–";
}

/// The columns that compare: for the plain call and the eager one, which stand first.
constexpr std::size_t compared = 2;

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

constexpr double aim = 1.5;

// -- What proofs cost ---------------------------------------------------------------------------------------------------

/// Returns: the position of that contender; empty where there is none of that name.
std::optional<std::size_t> find(const std::vector<Contender>& contenders, const std::string& name) {
  for (std::size_t i = 0; i < contenders.size(); ++i)
    if (contenders[i].name == name) return i;
  return std::nullopt;
}

/// Returns: nanoseconds; empty where it was not timed, or is not there.
std::optional<double> time_of(const Match& match, std::optional<std::size_t> contender) {
  if (!contender || match.scores[*contender].nanoseconds == 0) return std::nullopt;
  return match.scores[*contender].nanoseconds;
}

/// Returns: how many times as long the first takes.
std::optional<double> quotient(const std::optional<double>& one, const std::optional<double>& other) {
  return one && other ? std::optional(*one / *other) : std::nullopt;
}

/// A contender that proves what another one guesses.
struct Proving {
  std::size_t prover, guesser;
  std::optional<double> cost(const Match& match) const {
    return quotient(time_of(match, prover), time_of(match, guesser));
  }
};

std::vector<Proving> provings(const std::vector<Contender>& contenders) {
  std::vector<Proving> all;
  for (std::size_t i = 0; i < contenders.size(); ++i)
    if (const auto guesser = find(contenders, contenders[i].proves)) all.push_back({i, *guesser});
  return all;
}

/// Each with its guesser, with the exact peer and with the fastest one.
void write_proofs(std::ostream& out, const std::vector<Match>& matches, const std::vector<Contender>& contenders) {
  const std::vector<Proving> all = provings(contenders);
  if (all.empty()) return;
  const std::optional<std::size_t> exact = find(contenders, exact_peer);
  std::vector<std::string> headings;
  for (const Proving& each : all) {
    const std::string& prover = contenders[each.prover].name;
    for (const std::string& other : {prover + " ÷ " + contenders[each.guesser].name,
                                     std::string(exact_peer) + " ÷ " + prover, "fastest peer ÷ " + prover})
      headings.push_back(other);
  }
  write_table_head(out, {"what a proof costs"}, {}, headings);
  for (const Match& match : matches) {
    std::vector<std::string> cells{match.family};
    for (const Proving& each : all) {
      const std::optional<double> ours = time_of(match, each.prover);
      for (const auto& ratio :
           {each.cost(match), quotient(time_of(match, exact), ours), quotient(fastest_peer(match, contenders), ours)})
        cells.push_back(ratio ? fixed(*ratio, 2) : "–");
    }
    write_row(out, cells);
  }
  out << '\n';
}

/// Returns: how many times as long as its guess a proven answer may take; empty where nothing is aimed at.
std::optional<double> proof_aim(const std::string& family) {
  if (family == "triangles" || family == "tetrahedra" || family == "boxes") return 1.06;
  if (family.starts_with("hulls-")) return 1.03;
  return std::nullopt;
}

/// On which families does a proof cost as little as is aimed at?
void write_proof_aim(std::ostream& out, const std::vector<Match>& matches, const std::vector<Contender>& contenders) {
  for (const Proving& each : provings(contenders)) {
    std::string met, missed;
    for (const Match& match : matches) {
      const std::optional<double> most = proof_aim(match.family), cost = each.cost(match);
      if (!most || !cost) continue;
      std::string& list = *cost <= *most ? met : missed;
      list += (list.empty() ? "" : ", ") + match.family + " (" + fixed(*cost, 3) + ", aim " + fixed(*most, 2) + ")";
    }
    if (!met.empty() || !missed.empty())
      out << "* " << contenders[each.prover].name << " takes no longer beside " << contenders[each.guesser].name
          << " than is aimed at on: " << (met.empty() ? "none" : met)
          << (missed.empty() ? "" : "; longer on: " + missed) << "\n";
  }
}

/// How many times as fast as the exact peer proven answers are aimed to be about random tetrahedra. On hard families they are to
/// be no slower, but on those whose flat faces stand square to an axis, where its predicates need no exact number.
constexpr double exact_aim = 5;

/// Where are proven answers as fast as those of the exact peer?
void write_exact_aim(std::ostream& out, const std::vector<Match>& matches, const std::vector<Contender>& contenders) {
  const std::optional<std::size_t> exact = find(contenders, exact_peer);
  for (const Proving& each : provings(contenders)) {
    std::string faster, slower;
    for (const Match& match : matches) {
      const auto ratio = quotient(time_of(match, exact), time_of(match, each.prover));
      if (!ratio) continue;
      std::string& list = *ratio >= 1 ? faster : slower;
      list += (list.empty() ? "" : ", ") + match.family + " (" + fixed(*ratio, 2) +
              (match.family == "tetrahedra" ? ", aim " + fixed(exact_aim, 1) : "") + ")";
    }
    if (!faster.empty() || !slower.empty())
      out << "* " << contenders[each.prover].name << " is at least as fast as " << exact_peer
          << " on: " << (faster.empty() ? "none" : faster) << (slower.empty() ? "" : "; slower on: " + slower) << "\n";
  }
}

// -- Aims -----------------------------------------------------------------------------------------------------------------

/// On which families is the fastest peer slower by the factor that is aimed at? Of those that the aim is about, also by which it
/// is on the others.
void write_aim(std::ostream& out, const std::vector<Match>& matches, const std::vector<Contender>& contenders) {
  for (std::size_t i = 0; i < contenders.size(); ++i) {
    if (contenders[i].is_peer || contenders[i].name == exact_peer) continue;
    std::string met, missed;
    for (const Match& match : matches) {
      const auto ratio = quotient(fastest_peer(match, contenders), time_of(match, i));
      if (!ratio || (*ratio < aim && !proof_aim(match.family))) continue;
      std::string& list = *ratio >= aim ? met : missed;
      list += (list.empty() ? "" : ", ") + match.family + " (" + fixed(*ratio, 2) + ")";
    }
    out << "* " << contenders[i].name << " is at least " << fixed(aim, 1)
        << " times as fast as the fastest peer on: " << (met.empty() ? "none" : met)
        << (missed.empty() ? "" : "; less on: " + missed) << "\n";
  }
}

/// Where is the plain call not right about pairs that some peer is right about?
void write_lost(std::ostream& out, const std::vector<Match>& matches, const std::vector<Contender>& contenders) {
  std::string families;
  for (const Match& match : matches)
    if (match.lost > 0)
      families += (families.empty() ? "" : ", ") + match.family + " (" + std::to_string(match.lost) + ")";
  out << "* " << contenders[0].name << " is right wherever a peer is"
      << (families.empty() ? "" : ", except about pairs of: " + families) << "\n";
}

void write_times(std::ostream& out, const std::vector<Match>& matches, const std::vector<Contender>& contenders) {
  std::vector<std::string> ratios;
  for (const char* peer : {"fastest peer ÷ ", "fastest no worse ÷ "})
    for (std::size_t i = 0; i < compared; ++i) ratios.push_back(peer + contenders[i].name);
  write_table_head(out, {"ns per query", "pairs", "timed"}, contenders, ratios);
  for (const Match& match : matches) {
    std::vector<std::string> cells{match.family, std::to_string(match.pairs), std::to_string(match.raced)};
    for (const Score& score : match.scores) cells.push_back(score.nanoseconds > 0 ? fixed(score.nanoseconds, 0) : "–");
    for (std::size_t i = 0; i < compared; ++i)
      cells.push_back(speed_up(fastest_peer(match, contenders), match.scores[i]));
    for (std::size_t i = 0; i < compared; ++i)
      cells.push_back(speed_up(fastest_peer(match, contenders, match.scores[i].not_right()), match.scores[i]));
    write_row(out, cells);
  }
}

void write_mistakes(std::ostream& out, const std::vector<Match>& matches, const std::vector<Contender>& contenders) {
  write_table_head(out, {"wrong answers", "meet"}, contenders, {"a peer right, gjkstep not"});
  for (const Match& match : matches) {
    std::vector<std::string> cells{match.family, std::to_string(match.meet)};
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
      << " turns the median counts.\nShapes are made beforehand. Truth is exact: `tests/study/truth/oracle.hpp`.\n\n"
      << "* made by: `" << c.command << "`\n* seed " << c.settings.seed << "\n* processor: " << c.processor
      << "\n* compiler: " << c.compiler << ", flags `" << c.flags << "` (the peers' own code as Debian compiled it)\n";
  for (const Contender& contender : contenders) out << "* " << contender.name << ": " << contender.how << "\n";
  out << R"(
Wrong answers: `+` false positives, `−` false negatives, `?` undecided or an exception, `!` crashed or out of time; after
three of these the rest is not asked, nor is what a contender has no call for. Sets are closed: touching is intersecting. "No worse": not right on no more pairs.

Timed are the first pairs, as many as have )"
      << corners_raced << R"( corners together, so that they stay in the cache; who has no answer to some
pair is not timed. "–": not timed, or no such peer. The fastest peer may be one that is wrong about most pairs, as the
table of wrong answers shows.
)";
}

void write_markdown(std::ostream& out, const std::string& title, const std::vector<Match>& matches,
                    const std::vector<Contender>& contenders) {
  out << "\n## " << title << "\n\n";
  write_times(out, matches, contenders);
  out << '\n';
  write_mistakes(out, matches, contenders);
  out << '\n';
  write_proofs(out, matches, contenders);
  write_aim(out, matches, contenders);
  write_proof_aim(out, matches, contenders);
  write_exact_aim(out, matches, contenders);
  write_lost(out, matches, contenders);
  write_failures(out, matches, contenders);
}

void write_csv(std::ostream& out, const Circumstances& c, const std::vector<Match>& matches,
               const std::vector<Contender>& contenders) {
  out << "# " << c.command << "; seed " << c.settings.seed << "; " << c.processor << "; " << c.compiler << "; "
      << c.flags
      << "\nfamily,contender,pairs,meet,ns_per_query,false_positives,false_negatives,undecided,failed,not_asked\n";
  for (const Match& match : matches)
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      const Score& score = match.scores[i];
      out << match.family << ',' << contenders[i].name << ',' << match.pairs << ',' << match.meet << ','
          << fixed(score.nanoseconds, 1) << ',' << score.false_positives << ',' << score.false_negatives << ','
          << score.undecided << ',' << score.failed << ',' << score.not_asked << '\n';
    }
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(": ") + 2);
  return "unknown";
}

}  // namespace peers
