#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>

#include "render/file.hpp"
#include "tests/study/methods/mistakes.hpp"
#include "tests/study/program/commands.hpp"
#include "tests/study/program/options.hpp"
#include "tests/study/steps/parting.hpp"
#include "walkthroughs/output/frames.hpp"
#include "walkthroughs/program/places.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/text/text_file.hpp"

namespace study {
namespace {

constexpr const char* footer =
    R"(The file has a pair, as 'gjkstep query' reads it, then a line for each iteration, and perhaps the answer:
  {"a": {"points": [[x, y, z], ...]}, "b": {"points": [[x, y, z], ...]}}
  {"direction": [x, y, z], "simplex": [[x, y, z], ...]}
  true
the direction in which the iteration searched, and the simplex of points a - b after it was reduced, the newest last (or
first, if in every step); the last one need not be reduced, and the iteration that ends with "no" need not be told.
Further searches may follow, each with its pair.
Each step is made again from the simplex before it, as the file has it. Another face that sees the origin, directions of
other length and vertices in other order are right, too, and told where the report chooses otherwise.
What --draw shows is the mistake that would make the same step, on this pair and begun in the same direction; where there is none, the
steps of the file.
Exit codes: 0 every step is right, 1 one is not, 2 wrong usage, 3 the file cannot be read, 4 --draw finds no OpenGL to draw
with, 5 cannot write.)";

constexpr const char* standard_input = "-";

/// Pictures of both runs, side by side, until they part. `file`: which they must not lie over, unless it is standard input.
void draw_parting(const ToldRun& run, const StepsChecked& checked, const std::string& file, const std::string& folder) {
  const std::optional<Parting> parting = parting_of(run, checked);
  walkthroughs::program::Places places;
  if (file == standard_input)
    places.read_standard_input();
  else
    places.read(file, "the steps " + file);
  places.write_into(std::filesystem::path(folder) / parting->walkthrough.name, {"*.png"}, "the pictures of --draw");
  places.write_standard_output();
  places.expect_apart();
  walkthroughs::output::Studio studio;
  walkthroughs::output::Renderer renderer(
      studio, [](const std::filesystem::path& file, const walkthroughs::story::Story&, std::optional<std::size_t>) {
        std::cout << walkthroughs::text::printable(file.string()) << '\n';
      });
  walkthroughs::output::Frames().add(std::make_shared<const walkthroughs::picture::StagedStory>(parting->story()),
                                     {.folder = folder, .size = walkthroughs::picture::frame_page}, renderer);
  renderer.finish();
}

constexpr std::size_t largest_file = std::size_t{64} << 20;

std::string read_standard_input() {
  std::string text(largest_file + 1, '\0');
  std::cin.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(std::cin.gcount()));
  if (text.size() > largest_file)
    throw walkthroughs::text::InputError("standard input: is larger than 64 MiB; tell fewer searches at once");
  return text;
}

void write(const ToldRun& run, const StepsChecked& checked) {
  std::cout << walkthroughs::text::printable(run.named.name) << ": ";
  if (run.steps.empty())
    std::cout << "no step is told\n";
  else if (checked.iteration == 0)
    std::cout << "every step is one that the report's algorithm may make\n";
  else
    std::cout << "iteration " << checked.iteration << ": " << walkthroughs::text::printable(checked.words) << '\n';
  for (const std::size_t mistake : checked.mistakes)
    std::cout << "  that is what follows from M" << mistake + 1 << ": " << mistakes()[mistake].name << '\n';
  for (const std::string& choice : checked.other_choices) std::cout << "  as right: " << choice << '\n';
}

struct CheckStepsCommand {
  std::string file;
  std::optional<std::string> draw;  ///< folder
};

void run(const CheckStepsCommand& asked) {
  const auto& [file, draw] = asked;
  if (file.empty()) throw UsageError("check-steps '': name a file that tells searches step by step");
  if (draw) {
    expect_named("--draw", *draw);
    render::make_folder(*draw, "choose another with --draw");
  }
  const bool reads_file = file != standard_input;
  const std::string name = reads_file ? file : "standard input";
  const std::string text = reads_file ? walkthroughs::text::read_text(file, largest_file) : read_standard_input();
  const std::vector<ToldRun> runs = read_told_runs(text, name);
  if (std::ranges::all_of(runs, [](const ToldRun& run) { return run.steps.empty(); }))
    throw walkthroughs::text::InputError(name + ": no search tells a step; write one a line before the answer: " +
                                         R"({"direction": [x, y, z], "simplex": [[x, y, z], ...]})");
  std::size_t all = 0, wrong = 0, rounded = 0;
  for (const ToldRun& run : runs) {
    const StepsChecked checked = check_steps(run);
    write(run, checked);
    ++all;
    wrong += checked.iteration > 0;
    rounded += checked.may_be_rounding;
    if (draw && checked.iteration > 0 && wrong == 1) draw_parting(run, checked, file, *draw);
  }
  std::cout.flush();
  if (wrong > 0)
    throw std::runtime_error(name + ": " + std::to_string(wrong) + " of " + std::to_string(all) +
                             (all == 1 ? " search has a wrong step" : " searches have a wrong step") +
                             (rounded == 0 ? "" : "; of " + std::to_string(rounded) + " rounding may be the reason"));
}

}  // namespace

void add_check_steps(CLI::App& program) {
  CLI::App& app = *program.add_subcommand(
      "check-steps", "which is the first step of a program's search that the report's algorithm would not make?");
  const auto asked = std::make_shared<CheckStepsCommand>();
  app.add_option("FILE", asked->file, "searches, told step by step; - reads standard input")->required();
  app.add_option("--draw", asked->draw,
                 "folder for pictures of the first wrong search beside the report's, until they part");
  app.footer(footer);
  app.callback([asked] { run(*asked); });
}

}  // namespace study
