/// The plain call, and the certified one, beside libccd, FCL, Bullet and CGAL: how long does a query take, and how often is the answer wrong?
///
///     build/gjkstep-peers > peers.csv              every family; report.py makes tables of it
///     build/gjkstep-peers --everyday               triangles, tetrahedra, boxes, hulls of 32 and 256 points only
#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>

#include "tests/bench/peers/match.hpp"

namespace {

enum ExitCode { ok = 0, unexpected = 1, wrong_usage = 2, cannot_write = 5 };

/// Returns: the model name in /proc/cpuinfo, or "unknown".
std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(": ") + 2);
  return "unknown";
}

void write_head(int argc, char** argv, const peers::MatchSettings& settings,
                const std::vector<peers::Contender>& contenders) {
  std::cout << "# made by: `build/gjkstep-peers";
  for (int i = 1; i < argc; ++i) std::cout << ' ' << argv[i];
  std::cout << "`\n# seed " << settings.seed << ", turns: " << settings.repeats << "\n# processor: " << processor()
            << "\n# compiler: " << GJKSTEP_COMPILER << ", flags `" << GJKSTEP_FLAGS
            << "` (the peers' own code as Debian compiled it)\n# corners of the pairs that were timed: "
            << peers::corners_raced << " at most\n";
  for (const peers::Contender& contender : contenders)
    std::cout << "# " << contender.name << ": " << contender.how << '\n';
  std::cout << "part,family,pairs,timed,meet,lost,contender,is_peer,borrows,proves,ns,false_positives,false_negatives,"
               "undecided,failed,not_asked,first_failure\n";
}

void write_rows(const std::string& part, const std::vector<study::Family>& families,
                const std::vector<peers::Contender>& contenders, const peers::MatchSettings& settings) {
  for (const study::Family& family : families) {
    std::cerr << family.name << "…\n";
    const peers::Match match = peers::play(family, contenders, settings);
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      const peers::Score& score = match.scores[i];
      std::cout << part << ',' << match.family << ',' << match.pairs << ',' << match.raced << ',' << match.meet << ','
                << match.lost << ",\"" << contenders[i].name << "\"," << contenders[i].is_peer << ','
                << contenders[i].borrows << ',' << contenders[i].proves << ',' << score.nanoseconds << ','
                << score.false_positives << ',' << score.false_negatives << ',' << score.undecided << ','
                << score.failed << ',' << score.not_asked << ',' << score.first_failure << '\n';
    }
  }
}

int run(int argc, char** argv) {
  peers::MatchSettings settings;
  bool everyday_only = false;
  CLI::App app("The plain call of gjkstep beside other libraries: nanoseconds per query and wrong answers, as CSV.");
  app.footer("Exit codes: 0 ok, 2 wrong usage, 5 cannot write, 1 anything else.");
  app.add_option("--seed", settings.seed, "Of the dice")->capture_default_str();
  app.add_option("--pairs", settings.pairs, "Of each family")
      ->check(CLI::Range(1, 1'000'000))  // all are kept in memory
      ->capture_default_str();
  app.add_option("--repeats", settings.repeats, "Turns of which the median counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_flag("--everyday", everyday_only, "Triangles, tetrahedra, boxes, hulls of 32 and 256 points only");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? ok : wrong_usage;
  }
  const std::vector<peers::Contender> contenders = peers::contenders();
  write_head(argc, argv, settings, contenders);
  write_rows("Everyday shapes", peers::everyday_families(), contenders, settings);
  if (!everyday_only) write_rows("The study's families", peers::hard_families(), contenders, settings);
  if (std::cout.flush()) return ok;
  std::cerr << "gjkstep-peers: cannot write to standard output\n";
  return cannot_write;
}

}  // namespace

int main(int argc, char** argv) try { return run(argc, argv); } catch (const std::exception& error) {
  std::cerr << "gjkstep-peers: " << error.what() << '\n';
  return unexpected;
}
