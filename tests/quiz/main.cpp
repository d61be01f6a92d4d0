// gjkstep-quiz: pictures of the moment before a decision, without words and numbers, and a key of what is decided then.
#include <CLI/CLI.hpp>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "render/file.hpp"
#include "tests/quiz/quiz.hpp"
#include "walkthroughs/picture/draw.hpp"
#include "walkthroughs/picture/studio.hpp"
#include "walkthroughs/program/exit_code.hpp"
#include "walkthroughs/program/number_option.hpp"
#include "walkthroughs/story/storyboard.hpp"

namespace {

using namespace walkthroughs;

std::string number_of(std::size_t index) {
  std::ostringstream name;
  name << std::setw(3) << std::setfill('0') << index;
  return name.str();
}

render::Image picture_of(const quiz::Question& question, Studio& studio, const Look& look) {
  const StagedStory story(tell(question.walkthrough));
  const render::Size page = page_of_frame(look.text);
  render::Canvas canvas(page, page, look.style.theme.paper, studio.font);
  draw_frame(canvas, story, question.frame, look);
  return studio.rasterizer.draw(canvas);
}

int run(int argc, char** argv) {
  CLI::App app("Draws questions: the moment before a decision, without words and numbers; and a key.");
  std::size_t count = 60;
  std::uint64_t seed = 1;
  std::string out = "quiz";
  expect_number(app.add_option("--count", count, "at least so many, as many of each kind")->capture_default_str(),
                std::size_t{1}, std::size_t{999});
  expect_number(app.add_option("--seed", seed, "which scenes are made")->capture_default_str(), std::uint64_t{0},
                ~std::uint64_t{0});
  app.add_option("--out", out, "folder: 000.png, 001.png, …, legend.txt, questions.txt; key.txt is not for readers")
      ->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    app.exit(help);
    return ok;
  } catch (const CLI::ParseError& error) {
    throw UsageError(std::string(error.what()) + "; 'gjkstep-quiz --help' shows the options");
  }
  render::make_folder(out, "choose another with --out");
  Studio studio;
  const Look look{.text = Text::none, .values = false};
  std::string texts, key;
  const std::vector<quiz::Question> all = quiz::questions(count, seed);
  const std::filesystem::path folder = out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    render::write_png(folder / (number_of(i) + ".png"), picture_of(all[i], studio, look), {});
    texts += number_of(i) + ": " + all[i].text + "\n";
    key += number_of(i) + ": " + all[i].answer + " (" + all[i].kind + ")\n";
  }
  render::write_file(folder / "legend.txt", quiz::legend());
  render::write_file(folder / "questions.txt", texts);
  render::write_file(folder / "key.txt", key);
  std::cout << out << ": " << all.size() << " questions, seed " << seed << '\n';
  return ok;
}

}  // namespace

int main(int argc, char** argv) {
  return exit_code_of("gjkstep-quiz", "ask for fewer questions", [&] { return run(argc, argv); });
}
