// gjkstep judge: is somebody else's GJK right, how wrong is it, and why?

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#include "render/file.hpp"
#include "walkthroughs/judge/adapters.hpp"
#include "walkthroughs/judge/judged_text.hpp"
#include "walkthroughs/judge/run_program.hpp"
#include "walkthroughs/output/manifest.hpp"
#include "walkthroughs/pairs/families.hpp"
#include "walkthroughs/pairs/graded.hpp"
#include "walkthroughs/pairs/pair_file.hpp"
#include "walkthroughs/program/command_line.hpp"
#include "walkthroughs/program/judge_report.hpp"
#include "walkthroughs/program/number_option.hpp"
#include "walkthroughs/program/places.hpp"
#include "walkthroughs/story/words.hpp"
#include "walkthroughs/text/names.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/text/text_file.hpp"

namespace walkthroughs::program {
namespace {

constexpr std::size_t largest_file = std::size_t{64} << 20;
constexpr std::uint64_t most_of_each = 1'000'000;

/// Returns: all that a program can be asked about.
std::vector<std::string> names_of_families();

std::string footer() {
  return R"(The program reads a pair a line, {"a":{"points":[[x,y,z],...]},"b":{"points":[...]}}, and writes an answer a line: yes (their
hulls have a point in common; touching counts), no, undecided, or 'distance 0.25'. true, false and the JSON of 'gjkstep query' are
understood, too. Whatever else it prints is no answer, and is shown. It may answer as it goes or when its input ends.
'gjkstep judge --adapter c' prints a main function around your own code; there are c, cpp, py and mjs.
Without --families, --count and --pairs it is asked about the kept pairs (published failures, the smallest pairs on which mistakes
show, needles, contact, 1e+-100) and about 100 of each family. The truth of each is the certified answer, its certificate
multiplied out in fractions. The same seed makes the same pairs.
With JUDGE_STEPS in its environment it may tell its steps, a line at the end of each iteration, before its answer:
  {"direction": [x,y,z], "simplex": [[x,y,z],...]}
the direction that it searched along, and the simplex after it was reduced, points a - b, the newest last. What the adapters
call judge_step does that. Each step is made again from the simplex before it; wrong ones are told from those that are as right.
How wrong an answer is: how far the sets would have to be moved to make it right, relative to the diagonal of the box around both.
A distance of sets that are apart is wrong where it is off by more than 1e-6 of that (1e-4 with --numbers float), and --tolerance.
Exit codes: 0 all is right (or, with --accept, nothing is newly wrong), 1 something is not, 2 wrong usage or a program that cannot be started, 3 pairs that cannot be read, or a program
that does not answer, 5 cannot write.
Families: )" +
         joined(names_of_families(), ", ", [](const std::string& each) { return each; }) + ".";
}

/// How far it has come, in place, on a terminal. Where an error ends it, that takes the place.
void show_progress(std::uint64_t done, std::uint64_t most) {
  if (::isatty(STDERR_FILENO) != 1) return;
  const std::string of_all = most > 0 ? " of " + std::to_string(most) : "";
  std::fprintf(stderr, "%llu%s pairs\r%s", static_cast<unsigned long long>(done), of_all.c_str(),
               done == most ? "\n" : "");
}

struct JudgeCommand {
  std::vector<std::string> program, families, without;
  std::optional<std::string> pairs, save, accept, adapter, shown;
  render::Backend backend = render::default_backend();  ///< of what is shown
  std::uint64_t count = 100, seed = 1;
  double time_limit = 2, tolerance = 0;
  std::string numbers = "double", touching = "yes", solid = "yes";
  bool in_plane = false, as_json = false, as_table = false, as_steps = false, makes_pairs = false, force = false;
  std::string options;  ///< as they were given

  int run() const;

 private:
  judge::Expected expected() const {
    return {numbers == "float" ? judge::Numbers::floats : judge::Numbers::doubles, in_plane};
  }
  judge::Standard standard() const;
  ReportFolder report_folder() const { return {shown.value(), backend, force}; }
  judge::Cases cases() const;
  Places places() const;
  judge::Report report() const;
  void expect_possible() const;
  judge::Accepted accepted(const judge::Judgement& judgement, const std::optional<std::set<std::string>>& known) const;
};

bool is_of_points(const NamedPair& named) { return pairs::points_of(named.pair).has_value(); }
bool is_of_points(const Family& family) { return pairs::points_of(family.make(1, 0)).has_value(); }

/// Those that are made of points, and graded ones.
std::vector<const Family*> families_of_points() {
  std::vector<const Family*> all;
  for (const std::vector<Family>* const list : {&pairs::families(), &pairs::graded_families()})
    for (const Family& each : *list)
      if (is_of_points(each)) all.push_back(&each);
  return all;
}

std::vector<std::string> names_of_families() {
  std::vector<std::string> names;
  for (const Family* const each : families_of_points()) names.push_back(each->name);
  return names;
}

/// `otherwise`: where none is named. Errors: UsageError.
std::vector<const Family*> families_called(const std::vector<std::string>& names,
                                           std::vector<const Family*> otherwise) {
  if (names.empty()) return otherwise;
  const std::vector<const Family*> all = families_of_points();
  std::vector<const Family*> chosen;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(all, name, &Family::name);
    if (found == all.end())
      throw UsageError("there is no family " + in_quotes(name) + " of points; " +
                       did_you_mean(nearest(name, names_of_families())) + "'gjkstep judge --help' names all");
    if (std::ranges::find(chosen, *found) == chosen.end()) chosen.push_back(*found);
  }
  return chosen;
}

judge::Cases JudgeCommand::cases() const {
  if (pairs) {
    const auto next = [file = std::make_shared<pairs::PairFile>(*pairs), from = called(*pairs)] {
      std::optional<NamedPair> pair = file->next();
      if (pair && !is_of_points(*pair))
        throw InputError(from + ": " + printable(pair->name) +
                         " has a round shape; a program is asked about points only");
      return pair;
    };
    return {next, 0, expected()};
  }
  std::vector<NamedPair> kept = makes_pairs ? std::vector<NamedPair>() : pairs::kept_pairs();
  std::erase_if(kept, [](const NamedPair& each) { return !is_of_points(each); });
  std::vector<const Family*> chosen = families_called(families, families_of_points());
  for (const Family* const left_out : families_called(without, {})) {
    std::erase(chosen, left_out);
    std::erase_if(kept, [&](const NamedPair& each) { return each.family == left_out->name; });
  }
  return judge::cases_of(kept, chosen, count, seed, expected());
}

void JudgeCommand::expect_possible() const {
  if (program.empty())
    throw UsageError(
        "what is to be judged? Write it after --, for example gjkstep judge -- ./mine; 'gjkstep judge --help' says how "
        "it is asked");
  if (as_json + as_table + as_steps > 1)
    throw UsageError("--json, --table and --steps are each what is printed; leave all but one out");
}

constexpr const char* head_of_accepted = "# What gjkstep judge has accepted as wrong. Remove this file to accept anew.";

bool is_there(const std::string& file) {
  std::error_code unknown;  // then it cannot be written, and that is told
  return std::filesystem::exists(file, unknown);
}

/// Returns: what the file says. Errors: InputError.
std::set<std::string> accepted_in(const std::string& file) {
  std::istringstream lines(read_text(file, largest_file));
  std::set<std::string> faults;
  std::string line;
  if (!std::getline(lines, line) || !line.starts_with(head_of_accepted))
    throw InputError(file + ":1: is no list of accepted faults; name a file that is not there, and it is written");
  while (std::getline(lines, line)) {
    line.erase(line.find_last_not_of(" \t\r") + 1);
    if (!line.empty() && !line.starts_with('#')) faults.insert(line);
  }
  return faults;
}

/// Where the file is not there it is written, with what is wrong now. `known`: what it said before the program was asked.
judge::Accepted JudgeCommand::accepted(const judge::Judgement& judgement,
                                       const std::optional<std::set<std::string>>& known) const {
  if (known) return {*accept, *known, false};
  std::string text = std::string(head_of_accepted) + "\n";
  for (const std::string& fault : judgement.faults) text += fault + "\n";
  write_output(*accept, text);
  return {*accept, {judgement.faults.begin(), judgement.faults.end()}, true};
}

judge::Called called_by(const std::string& word) {
  using judge::Called;
  return word == "no" ? Called::separated : word == "either" ? Called::either : Called::intersecting;
}

judge::Standard JudgeCommand::standard() const {
  return {expected(), called_by(touching), called_by(solid), tolerance};
}

/// Returns: what is read and written. Errors: UsageError where two of these are at one place, or a file of others would be lost.
Places JudgeCommand::places() const {
  Places places;
  if (pairs && pairs->empty()) throw UsageError("--pairs '': name a file, or - for standard input");
  if (pairs) places.read(*pairs, "the pairs " + *pairs);
  if (save) {
    expect_named("--save", *save, "a folder to write to, for example --save wrong");
    places.write_into(*save, {"*.json"}, "the scenes of --save");
  }
  if (accept) {
    expect_named("--accept", *accept, "a file, for example --accept known.txt");
    if (is_there(*accept))
      places.read(*accept, "the accepted faults " + *accept);
    else
      places.write(*accept, "what --accept writes");
  }
  if (shown) report_folder().add_written(places);
  places.write_standard_output();
  places.expect_apart();
  const std::string elsewhere = !shown ? "--save" : save ? "--save and --report" : "--report";
  if (save || shown) places.expect_no_loss(force ? Others::overwritten : Others::kept, elsewhere);
  return places;
}

/// Asks the program. Errors: UsageError where it cannot be started; InputError where nothing can be said of it.
judge::Report JudgeCommand::report() const {
  const judge::AskedProgram asked{.words = program,
                                  .limit = std::chrono::milliseconds(std::lround(1000 * time_limit)),
                                  .is_answer = judge::is_meant_as_answer};
  judge::Report report{.program = joined(program, " ", shell_quoted),
                       .options = options,
                       .saved = save.value_or(shown.value_or("")),
                       .shown = shown.value_or("")};
  ::unsetenv("JUDGE_STEPS");  // it is asked for steps when its answers are known
  try {
    report.judgement = judge::judge(asked, cases(), standard(), kept_worst, show_progress);
    if (save) write_scenes(*save, report.judgement);
    if (report.judgement.all.pairs == 0)
      throw UsageError("no pair is left to ask: floats have no room for any of them");
    if (const auto why = judge::why_not_judged(report.judgement))
      throw InputError(report.program + " " + *why + "; 'gjkstep judge --help' says how it is asked");
    report.causes = judge::probable_causes(asked, report.judgement, standard());
    report.steps = judge::look_at_steps(asked, report.judgement);
    judge::add_cause(report.steps, report.causes);
  } catch (const judge::CannotStart& error) {
    throw UsageError(error.what());
  } catch (const std::system_error& error) {
    throw UsageError(std::string(error.what()) + "; allow more open files (ulimit -n) or processes (ulimit -u)");
  }
  return report;
}

int JudgeCommand::run() const {
  if (adapter) {
    std::cout << judge::adapter(*adapter) << std::flush;
    return ok;
  }
  expect_possible();
  const Places used = places();
  std::optional<std::set<std::string>> known;
  if (accept && is_there(*accept))
    known = accepted_in(*accept);
  else if (accept)
    render::expect_writable(*accept);
  if (save) render::make_folder(*save, "choose another with --save");  // before the work, not after it
  if (shown) report_folder().expect_possible();
  judge::Report found = report();
  if (accept) found.accepted = accepted(found.judgement, known);
  std::cout << (as_json    ? judge::json(found)
                : as_table ? judge::table(found)
                : as_steps ? judge::steps_text(found)
                           : judge::first_screen(found))
            << std::flush;
  if (shown) {
    const std::filesystem::path page = report_folder().write(found);
    if (!as_json && !as_table && !as_steps) std::cout << "open " << printable(page.string()) << '\n';
  }
  used.tidy_manifests();
  const bool is_known = found.accepted && found.judgement.behaves() && found.accepted->news(found.judgement).empty();
  return is_known || found.judgement.is_good() ? 0 : 1;
}

/// "a,b", and again.
CLI::Option* add_families(CLI::App& command, const std::string& option, std::vector<std::string>& families,
                          const std::string& what) {
  return command.add_option(option, families, what)
      ->delimiter(',')
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name("NAME,...");
}

/// Returns: the options as they were given, in order, with a blank behind them where there are some.
std::string given_options(const CLI::App& command) {
  std::string text;
  for (const CLI::Option* const option : command.parse_order()) {
    const bool is_of_places =
        std::set<std::string>{"--save", "--report", "--force", "--gl"}.contains(option->get_name());
    if (!option->get_name().starts_with("--") || is_of_places) continue;
    text += option->get_name() + " ";
    if (option->get_expected_max() > 0)
      text +=
          joined(option->results(), ",", [](const auto& each) { return each == "-" ? each : shell_word(each); }) + " ";
  }
  return text;
}

}  // namespace

Command add_judge_command(CLI::App& app, std::optional<std::string>& gl) {
  const auto asked = std::make_shared<JudgeCommand>();
  CLI::App* const command = app.add_subcommand("judge", "is another program's GJK right, how wrong is it, and why?");
  add_families(*command, "--families", asked->families, "only pairs of these, such as triangles,boxes");
  add_families(*command, "--without", asked->without, "no pairs of these, such as scale-1e100");
  CLI::Option* const count =
      command->add_option("--count", asked->count, "so many of each family")->capture_default_str();
  expect_number(count, std::uint64_t{1}, most_of_each);
  CLI::Option* const seed = command->add_option("--seed", asked->seed, "which pairs are made")->capture_default_str();
  expect_number(seed, std::uint64_t{0}, ~std::uint64_t{0});
  CLI::Option* const file =
      command->add_option("--pairs", asked->pairs, "the pairs of this file, a line each; - is standard input");
  for (const char* const option : {"--families", "--without", "--count", "--seed"})
    file->excludes(command->get_option(option));
  expect_number(command
                    ->add_option("--tolerance", asked->tolerance,
                                 "answers this near to right are counted apart, relative to the size of the pair")
                    ->capture_default_str(),
                0.0, 1.0);
  command->add_option("--numbers", asked->numbers, "double, or float: pairs are rounded to floats first")
      ->check(CLI::IsMember({"double", "float"}))
      ->capture_default_str();
  command->add_option("--touching", asked->touching, "what sets that only touch are to be called: yes, no or either")
      ->check(CLI::IsMember({"yes", "no", "either"}))
      ->capture_default_str();
  command
      ->add_option(
          "--solid", asked->solid,
          "what sets are to be called of which one lies wholly inside the other, not touching its surface: yes, no "
          "(as of hollow meshes) or either")
      ->check(CLI::IsMember({"yes", "no", "either"}))
      ->capture_default_str();
  command->add_flag("--plane", asked->in_plane, "for programs of the plane: every z is 0");
  expect_number(
      command->add_option("--time-limit", asked->time_limit, "seconds until the next answer")->capture_default_str(),
      0.01, 3600.0);
  command->add_option("--save", asked->save, "folder for the worst pairs, as scenes that 'gjkstep render' draws");
  command->add_option("--report", asked->shown, "folder for report.html: what was found, and pages of the worst pairs");
  add_backend_option(*command, gl);
  command->add_option("--accept", asked->accept,
                      "file of faults that are known, which are no failure; it is written where it is not there");
  add_force_flag(*command, asked->force);
  command->add_flag("--table", asked->as_table, "print a table of all families");
  command->add_flag("--steps", asked->as_steps, "print what is to be said of the steps that it tells");
  command->add_flag("--json", asked->as_json, "print all as JSON");
  command->add_option("--adapter", asked->adapter, "print a main function for your code: c, cpp, py or mjs")
      ->check(CLI::IsMember({"c", "cpp", "py", "mjs"}));
  command->add_option("PROGRAM", asked->program, "what to judge, and its arguments, after --");
  command->footer(footer());
  return {command, [asked, command, &gl] {
            asked->makes_pairs =
                command->count("--families") + command->count("--count") + command->count("--seed") > 0;
            asked->options = given_options(*command);
            if (gl && !asked->shown) throw UsageError("--gl: without --report 'judge' draws nothing; leave --gl out");
            if (asked->shown) asked->backend = chosen_backend(gl);
            return asked->run();
          }};
}

}  // namespace walkthroughs::program
