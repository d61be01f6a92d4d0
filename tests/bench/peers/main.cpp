/// The plain call, and the certified one, beside libccd, FCL, Bullet and CGAL: how long does a query take, and how often is the answer wrong?
///
///     build/gjkstep-peers                          every family, as Markdown
///     build/gjkstep-peers --everyday               triangles, tetrahedra, boxes, hulls of 32 and 256 points only
///     build/gjkstep-peers --csv peers.csv          the numbers in a file as well
#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "tests/bench/peers/report.hpp"

namespace {

enum ExitCode { ok = 0, unexpected = 1, wrong_usage = 2, cannot_write = 5 };

struct CannotWrite : std::runtime_error {
  using std::runtime_error::runtime_error;
};

std::string joined(int argc, char** argv) {
  std::string command = "build/gjkstep-peers";
  for (int i = 1; i < argc; ++i) command += std::string(" ") + argv[i];
  return command;
}

std::vector<peers::Match> played(const std::vector<study::Family>& families,
                                 const std::vector<peers::Contender>& contenders,
                                 const peers::MatchSettings& settings) {
  std::vector<peers::Match> matches;
  for (const study::Family& family : families) {
    std::cerr << family.name << "…\n";
    matches.push_back(peers::play(family, contenders, settings));
  }
  return matches;
}

int run(int argc, char** argv) {
  peers::Circumstances circumstances{.command = joined(argc, argv),
                                     .compiler = GJKSTEP_COMPILER,
                                     .flags = GJKSTEP_FLAGS,
                                     .processor = peers::processor(),
                                     .settings = {}};
  std::string csv;
  bool everyday_only = false;
  CLI::App app("The plain call of gjkstep beside other libraries: nanoseconds per query and wrong answers.");
  app.footer("Exit codes: 0 ok, 2 wrong usage, 5 cannot write, 1 anything else.");
  app.add_option("--seed", circumstances.settings.seed, "Of the dice")->capture_default_str();
  app.add_option("--pairs", circumstances.settings.pairs, "Of each family")
      ->check(CLI::Range(1, 1'000'000))  // all are kept in memory
      ->capture_default_str();
  app.add_option("--repeats", circumstances.settings.repeats, "Turns of which the median counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  CLI::Option* const wants_csv = app.add_option("--csv", csv, "Write the numbers to this file as well");
  app.add_flag("--everyday", everyday_only, "Triangles, tetrahedra, boxes, hulls of 32 and 256 points only");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? ok : wrong_usage;
  }
  std::ofstream file;
  if (*wants_csv) file.open(csv);  // before the work, not after it
  if (*wants_csv && !file) throw CannotWrite("cannot write '" + csv + "'; name another file with --csv");

  const std::vector<peers::Contender> contenders = peers::contenders();
  peers::write_head(std::cout, circumstances, contenders);
  std::vector<peers::Match> matches = played(peers::everyday_families(), contenders, circumstances.settings);
  peers::write_markdown(std::cout, "Everyday shapes", matches, contenders);
  if (!everyday_only) {
    const std::vector<peers::Match> hard = played(peers::hard_families(), contenders, circumstances.settings);
    peers::write_markdown(std::cout, "The study's families", hard, contenders);
    matches.insert(matches.end(), hard.begin(), hard.end());
  }
  if (*wants_csv) peers::write_csv(file, circumstances, matches, contenders);
  if (*wants_csv && !file.flush()) throw CannotWrite("cannot write '" + csv + "'");
  if (!std::cout.flush()) throw CannotWrite("cannot write to standard output");
  return ok;
}

}  // namespace

int main(int argc, char** argv) try { return run(argc, argv); } catch (const CannotWrite& error) {
  std::cerr << "gjkstep-peers: " << error.what() << '\n';
  return cannot_write;
} catch (const std::exception& error) {
  std::cerr << "gjkstep-peers: " << error.what() << '\n';
  return unexpected;
}
