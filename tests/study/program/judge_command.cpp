#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>

#include "render/file.hpp"
#include "tests/study/judge/judge_program.hpp"
#include "tests/study/judge/judged_page.hpp"
#include "tests/study/judge/judged_scenes.hpp"
#include "tests/study/judge/judged_text.hpp"
#include "tests/study/judge/pairs_file.hpp"
#include "tests/study/pairs/families.hpp"
#include "tests/study/program/commands.hpp"
#include "tests/study/program/options.hpp"
#include "tests/study/program/progress.hpp"
#include "tests/study/steps/judged_steps.hpp"
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/program/places.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/text/text_file.hpp"

namespace study {
namespace {

constexpr std::size_t most_steps = 10;       // failures that are followed
constexpr std::size_t most_drawn_steps = 3;  // of these

constexpr std::size_t largest_file = std::size_t{64} << 20;

constexpr const char* footer =
    R"(The program reads a pair a line, {"a": {"points": [[x, y, z], ...]}, "b": ...}, as 'gjkstep query' does, and writes an
answer a line: true (they intersect), false or "undecided"; or {"status": "intersecting", "separated" or "undecided"} with
more in it, if it likes: a "direction", "point" or "simplex" is evidence, and is multiplied out. It may answer as it goes or
when its input ends. So 'gjkstep-study judge -- gjkstep query' judges gjkstep. Programs that have none of this: see
tests/study/judge/README.md.
With --steps some failures are asked again with JUDGE_STEPS=1 in the environment: the program then writes a line for each
iteration before its answer, {"direction": [x, y, z], "simplex": [[x, y, z], ...]}, as 'gjkstep-study check-steps' reads them.
Without --families, --count and --pairs the pairs are those of tests/study/corpus.jsonl that are made of points. Spheres
and cylinders are asked where their families are named, or --pairs has them.
Exit codes: 0 nothing is wrong, 1 something is, 2 wrong usage or a program that cannot be started, 3 pairs that cannot be
read or judged, 4 --html finds no OpenGL to draw with, 5 cannot write.)";

bool is_of_points(const NamedPair& named) {
  return std::holds_alternative<Points>(named.pair.a) && std::holds_alternative<Points>(named.pair.b);
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

constexpr double usual_time_limit = 2;

struct JudgeCommand {
  std::vector<std::string> program, families;
  std::optional<std::string> pairs, failures, html;
  std::uint64_t count = 100, seed = 1, max_failures = 5;
  double time_limit = usual_time_limit;
  bool json = false, steps = false, makes_pairs = false;

  void run() const;

 private:
  std::vector<NamedPair> chosen_pairs() const;
  JudgedHead head() const;
  void save(const ProgramJudged& judged) const;
};

std::vector<NamedPair> JudgeCommand::chosen_pairs() const {
  if (pairs) return read_pairs(walkthroughs::text::read_text(*pairs, largest_file), *pairs);
  std::vector<NamedPair> all;
  if (!makes_pairs) all = kept_pairs();
  for (const Family* const family : makes_pairs ? families_called(families) : std::vector<const Family*>())
    for (std::uint64_t i = 0; i < std::min(count, family->size.value_or(count)); ++i)
      all.push_back({family->name + "-" + std::to_string(i), family->name, family->make(seed, i)});
  if (families.empty()) std::erase_if(all, [](const NamedPair& named) { return !is_of_points(named); });
  return all;
}

JudgedHead JudgeCommand::head() const {
  const std::string name = joined(program, " ");
  std::string command = "gjkstep-study judge", asked;
  for (const std::string& word : program) asked += " " + walkthroughs::text::shell_quoted(word);
  if (!families.empty()) command += " --families " + joined(families, ",");
  if (makes_pairs) command += " --count " + std::to_string(count) + " --seed " + std::to_string(seed);
  if (pairs) command += " --pairs " + walkthroughs::text::shell_word(*pairs);
  if (time_limit != usual_time_limit) command += " --time-limit " + walkthroughs::model::number_text(time_limit);
  if (steps) command += " --steps";
  return {name, command + " --" + asked, makes_pairs};
}

void JudgeCommand::run() const {
  if (failures) expect_named("--save-failures", *failures);
  if (pairs && pairs->empty()) throw UsageError("--pairs '': name a file that 'gjkstep-study pairs' wrote");
  if (html && html->empty()) throw UsageError("--html '': name a file to write, for example --html judged.html");
  walkthroughs::program::Places places;
  if (html) places.write(*html, "what --html gets");
  if (pairs) places.read(*pairs, "the pairs " + *pairs);
  if (failures) places.write_into(*failures, {"*.json"}, "the scenes of --save-failures");
  places.write_standard_output();
  places.expect_apart();
  const std::vector<NamedPair> chosen = chosen_pairs();
  if (failures) render::make_folder(*failures, "choose another with --save-failures");  // before the work, not after it
  if (html) render::expect_writable(*html);
  ::unsetenv("JUDGE_STEPS");  // answers only, until steps are asked for
  ProgressLine line;
  const AskedProgram asked{
      .words = program, .limit = std::chrono::milliseconds(std::lround(1000 * time_limit)), .progress = std::ref(line)};
  ProgramJudged judged = judge_program(asked, chosen);
  if (steps) judged.steps = steps_of_failures(asked, judged, most_steps, html ? most_drawn_steps : 0);
  std::cout << (json ? judged_json(judged, head()) : judged_markdown(judged, head()));
  if (failures) save(judged);
  if (html) render::write_file(*html, judged_page(judged, head()));
  std::cout.flush();
  if (!judged.is_good()) throw std::runtime_error(joined(program, " ") + ": " + verdict_line(judged));
}

void JudgeCommand::save(const ProgramJudged& judged) const {
  const std::vector<JudgedScene> scenes = judged_scenes(judged, joined(program, " "), max_failures);
  for (const JudgedScene& scene : scenes) render::write_file(std::filesystem::path(*failures) / scene.name, scene.text);
  std::cerr << "gjkstep-study: " << *failures << ": " << scenes.size()
            << (scenes.size() == 1 ? " scene file" : " scene files") << "; gjkstep render draws them\n";
}

}  // namespace

void add_judge(CLI::App& program) {
  CLI::App& app =
      *program.add_subcommand("judge", "is a program right? Asks it about pairs, and tells which mistake it may have");
  const auto asked = std::make_shared<JudgeCommand>();
  add_list(app, "--families", asked->families, "pairs of these, such as triangles,boxes");
  add_pair_count(app, "--count", asked->count, "so many of each family");
  add_seed(app, asked->seed);
  CLI::Option* const file =
      app.add_option("--pairs", asked->pairs, "the pairs of this file, as 'gjkstep-study pairs' writes them");
  for (const char* const option : {"--families", "--count", "--seed"}) file->excludes(app.get_option(option));
  walkthroughs::program::expect_number(
      app.add_option("--time-limit", asked->time_limit, "seconds until the next answer")->capture_default_str(), 0.01,
      3600.0);
  CLI::Option* const saves =
      app.add_option("--save-failures", asked->failures, "folder for scene files of what went wrong");
  walkthroughs::program::expect_number(app.add_option("--max-failures", asked->max_failures, "of each family and kind")
                                           ->capture_default_str()
                                           ->needs(saves),
                                       std::uint64_t{0}, most_pairs);
  app.add_option("--html", asked->html, "one page, too: the verdict, families, the first failures drawn");
  app.add_flag("--json", asked->json, "JSON in place of Markdown, with every pair that is not right");
  app.add_flag("--steps", asked->steps, "name the first wrong step of failures, too, if the program writes its steps");
  app.add_option("PROGRAM", asked->program, "what to judge, and its arguments, after --")->required();
  app.footer(footer);
  app.callback([asked, &app] {
    asked->makes_pairs = app.count("--families") + app.count("--count") + app.count("--seed") > 0;
    asked->run();
  });
}

}  // namespace study
