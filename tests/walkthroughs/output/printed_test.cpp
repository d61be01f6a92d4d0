// Slides with notes, handouts and questions on paper: what stands on which page, and when there is none.
#include "render/image.hpp"
#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/program/program.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/output/handout.hpp"
#include "walkthroughs/page/questions.hpp"
#include "walkthroughs/text/scene_file.hpp"

namespace printed_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;
namespace fs = std::filesystem;

namespace {

Handout handout_for(const Walkthrough& walkthrough, const Look& look = {}) {
  static render::Font font{render::Font::default_directory()};
  return handout_of(StagedStory(tell(walkthrough)), look, font);
}

std::string texts_of(const render::Canvas& canvas) {
  std::string all;
  for (const render::Shape& shape : canvas.shapes())
    if (const auto* text = std::get_if<render::shape::Text>(&shape)) all += text->text + "\n";
  return all;
}

/// Runs `gjkstep render NAME OPTIONS`. Returns: what it has said on standard error.
std::string render_into(const Folder& folder, const std::string& what) {
  const Outcome outcome = run("render " + what + " --size 64x36 --out " + quoted(folder.path().string()));
  CHECK(outcome.exit_code == 0);
  return outcome.err;
}

bool has_poppler() { return has(shell("pdfinfo -v").err, "pdfinfo version"); }

std::string info_of(const fs::path& file) { return shell("pdfinfo " + quoted(file.string())).out; }

std::string words_of(const fs::path& file, int page) {
  const std::string number = std::to_string(page);
  return shell("pdftotext -layout -f " + number + " -l " + number + " " + quoted(file.string()) + " -").out;
}

}  // namespace

TEST_CASE("A deck has a slide for each step, 16 to 9, and notes to each", "[printed][full]") {
  if (!has_poppler()) return kit::skip("there is no pdfinfo");
  const Folder folder;
  CHECK(render_into(folder, "figure-4-right --deck").empty());
  const fs::path deck = folder.path() / "figure-4-right" / "deck.pdf", notes = deck.parent_path() / "notes.pdf";
  const Story story = tell(walkthrough("figure-4-right"));
  CHECK(has(info_of(deck), "Pages:           " + std::to_string(story.frames.size()) + "\n"));
  CHECK(has(info_of(deck), "960 x 540 pts"));
  CHECK(has(words_of(deck, 2), "step 2 of " + std::to_string(story.frames.size()) + " · iteration 1"));
  CHECK(has(info_of(notes), "(A4)"));
  CHECK(has(words_of(notes, 1), "Notes: " + walkthrough("figure-4-right").title));
  CHECK(has(words_of(notes, 1), "The difference has the corners"));
}

TEST_CASE("Letters of a handout have 7 points or more, and all of it stands on one page, whatever the walkthrough",
          "[printed][unsanitized][full]") {
  for (const Walkthrough& walkthrough : whole_catalogue()) {
    INFO(walkthrough.name);
    if (walkthrough.name == "lesson") continue;  // whose twelve pictures are to be taken hold of, and illegible on one page
    const Handout handout = handout_for(walkthrough);
    REQUIRE(handout.pages.size() == 1);
    const double least = walkthrough.name == "mistakes/survival" ? 6 : least_points;  // a table that is wider than A4
    CHECK(handout.free_from <= handout.paper.height - margin);
    for (const render::OnPaper& part : handout.pages[0]) {
      CHECK(part.corner.x() + part.scale * part.part.width() <= handout.paper.width + 1e-9);
      CHECK(part.corner.y() + part.scale * part.part.height() <= handout.paper.height + 1e-9);
      for (const render::Shape& shape : part.canvas->shapes())
        if (const auto* text = std::get_if<render::shape::Text>(&shape))
          CHECK(part.scale * text->style.size >= least - 1e-9);
    }
  }
}

TEST_CASE("A handout has a row for each iteration and says the answer and its reason", "[printed]") {
  const Handout handout = handout_for(walkthrough("figure-4-right"));
  const std::string texts = texts_of(handout.canvases.front());
  INFO(texts);
  CHECK(handout.left_out == 0);
  CHECK(handout.pictures == 3);  // of the objects, and of both iterations
  for (const char* text : {"1\n", "2\n", "E·d = ", "separated\n"}) CHECK(has(texts, text));
}

TEST_CASE("Of a search that is too long for one page a handout keeps both ends, and says how many are left out",
          "[printed]") {
  const SceneFile longest = parse_scene(R"({"iteration_limit": 100, "panels": [], "truth": false,
    "a": {"sphere": {"center": [0.1, 0.2, 0.3], "radius": 1}},
    "b": {"sum": [{"cylinder": {"center": [0, 0, 0], "axis": [1, 2, 3], "radius": 1, "height": 2}},
                  {"sphere": {"center": [2.4389675565875675, 1.1, -0.3], "radius": 0.5}}]}})",
                                        "touching.json");
  const Handout handout = handout_for(longest.walkthrough);
  CHECK(handout.free_from <= handout.paper.height - margin);
  REQUIRE(handout.left_out > 0);
  const std::string texts = texts_of(handout.canvases.front());
  CHECK(has(texts, std::to_string(handout.left_out) + " iterations are left out here."));
  CHECK(has(texts, "\n1\n"));
  CHECK(has(texts, "\n51\n"));
}

TEST_CASE("A quiz asks what a page asks, and answers on a page of its own behind", "[printed][full]") {
  if (!has_poppler()) return kit::skip("there is no pdfinfo");
  const Folder folder;
  CHECK(render_into(folder, "figure-4-right --quiz").empty());
  const fs::path quiz = folder.path() / "figure-4-right" / "quiz.pdf";
  const Story story = tell(walkthrough("figure-4-right"));
  const std::vector<Question> questions = questions_of(story);
  int page = 1;
  std::string asked;
  while (!has(words_of(quiz, page), "Answers\n")) asked += words_of(quiz, page++);
  for (std::size_t i = 0; i < questions.size(); ++i)
    CHECK(has(asked, std::to_string(i + 1) + ". " + questions[i].text.substr(0, 8)));
  CHECK_FALSE(has(asked, questions[0].choices[questions[0].right].reason));  // which the picture does not tell, either
  CHECK_FALSE(has(words_of(quiz, page), "1. " + questions[0].text.substr(0, 8)));
  CHECK_FALSE(has(info_of(quiz), story.walkthrough.title));  // which tells how it ends
}

TEST_CASE("Where nothing is asked there is no quiz, also none of an earlier run", "[printed][full]") {
  const Folder folder;
  const fs::path quiz = folder.path() / "figure-4-right" / "quiz.pdf";
  CHECK(has(render_into(folder, "figure-1 --quiz"), "figure-1: it asks nothing, so there is no quiz.pdf"));
  CHECK(render_into(folder, "figure-4-right --quiz").empty());
  CHECK(fs::exists(quiz));
  CHECK(has(render_into(folder, "figure-4-right --quiz --frames 1"), "so there is no quiz.pdf"));
  CHECK_FALSE(fs::exists(quiz));
}

TEST_CASE("What is printed is the same each time", "[printed][full]") {
  const Folder folder, again;
  for (const Folder* each : {&folder, &again})
    render_into(*each, "regions/3-simplex-face-adb-edge-ad --deck --handout --quiz");
  for (const char* file : {"deck.pdf", "notes.pdf", "handout.pdf", "quiz.pdf"})
    CHECK(bytes_of(folder.path() / "regions/3-simplex-face-adb-edge-ad" / file) ==
          bytes_of(again.path() / "regions/3-simplex-face-adb-edge-ad" / file));
}

}  // namespace printed_test
