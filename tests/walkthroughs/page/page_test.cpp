#include "walkthroughs/page/page.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "render/html.hpp"
#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/story/stories.hpp"
#include "walkthroughs/page/questions.hpp"
#include "walkthroughs/page/templates.hpp"
#include "walkthroughs/story/alternative_text.hpp"
#include "walkthroughs/story/frame_choice.hpp"
#include "walkthroughs/story/words.hpp"
#include "walkthroughs/trace/trace_json.hpp"
#include "walkthroughs/wrong_on_purpose/mistakes.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

namespace {

const PagePictures pictures{.url = [](std::size_t frame, int) { return std::to_string(frame) + ".png"; },
                            .page = {1280, 720},
                            .part = {{40, 72}, {1240, 520}}};

std::string page_of(const Story& story) {
  return page_html(story, pictures, {.command = "gjkstep", .trace_command = {}, .sources = {}, .ways = {}});
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++found;
  return found;
}

nlohmann::json data_of(const std::string& page, const std::string& id = "data") {
  const std::string begin = "id=\"" + id + "\">";
  const std::size_t at = page.find(begin) + begin.size();
  return nlohmann::json::parse(page.substr(at, page.find("</script>", at) - at));
}

std::vector<std::string> all_between(const std::string& text, const std::string& begin, const std::string& end) {
  std::vector<std::string> all;
  for (std::size_t at = 0; (at = text.find(begin, at)) != std::string::npos;) {
    at += begin.size();
    all.push_back(text.substr(at, text.find(end, at) - at));
  }
  return all;
}

std::string step_of(const std::string& page, std::size_t index) {
  return all_between(page, "<section class=\"step\" id=\"" + std::to_string(index + 1) + "\"", "</section>").at(0);
}

/// What the picture in a step is called.
std::string name_of_picture(const std::string& page, const std::string& step) {
  std::istringstream ids(all_between(step, "aria-labelledby=\"", "\"").at(0));
  std::string name;
  for (std::string id; ids >> id;) {
    const std::vector<std::string> sentences = all_between(page, "<p hidden id=\"" + id + "\">", "</p>");
    REQUIRE(sentences.size() == 1);
    name += (name.empty() ? "" : "\n") + sentences[0];
  }
  return name;
}

}  // namespace

TEST_CASE("A page has a section for each frame of every walkthrough, with its picture, caption and facts",
          "[unsanitized]") {
  for (const Walkthrough& w : catalogue()) {
    INFO(w.name);
    const Story story = tell(w);
    const std::string page = page_of(story);
    CHECK(count(page, "<section class=\"step\"") == story.frames.size());
    for (std::size_t i = 0; i < story.frames.size(); ++i) {
      CHECK(count(page, "id=\"" + std::to_string(i + 1) + "\"") == 1);
      CHECK(count(page, "src=\"" + std::to_string(i) + ".png\"") == 1);
      CHECK(count(page, "<h2>" + html_of(story.frames[i].caption) + "</h2>") >= 1);
      for (const Fact& fact : story.frames[i].facts) CHECK(count(page, html_of(fact.text) + "</li>") >= 1);
    }
  }
}

TEST_CASE("The data of a page hold each event as the trace has it, and each step its range of them") {
  const Story story = tell(walkthrough("figure-4"));
  const std::string page = page_of(story);
  const nlohmann::json data = data_of(page), held = data_of(page, "events"), scenes = held["scenes"];
  REQUIRE(scenes.size() == 2);
  REQUIRE(data["steps"].size() == story.frames.size());
  for (std::size_t s = 0; s < 2; ++s) {
    const auto& events = story.tellings[s].trace.events;
    REQUIRE(scenes[s]["events"].size() == events.size());
    for (std::size_t i = 0; i < events.size(); ++i)
      CHECK(scenes[s]["events"][i] == nlohmann::json::parse(event_json(events[i])));
    CHECK(held["steps"].back()[s][1] == events.size() - 1);
  }
}

TEST_CASE("The data of a page hold each question of its story, before the step that answers it") {
  const Story story = tell(walkthrough("figure-4-right"));
  const std::vector<Question> questions = questions_of(story);
  const std::string page = page_of(story);
  const nlohmann::json data = data_of(page, "questions"), steps = data_of(page, "events")["steps"];
  REQUIRE(data["questions"].size() == questions.size());
  CHECK(data_of(page)["questions"] == questions.size());
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const auto& asked = data["questions"][i];
    CHECK(data["texts"][asked["text"].get<std::size_t>()] == html_of(questions[i].text));
    CHECK(asked["choices"].size() == questions[i].choices.size());
    CHECK(asked["right"] == questions[i].right);
    const auto& answered_by = steps[asked["before"].get<std::size_t>()][0];
    CHECK((answered_by[0] <= questions[i].event && questions[i].event <= answered_by[1]));
  }
}

TEST_CASE("The page of each mistake asks for its line, before the step where the searches part") {
  for (const wrong_on_purpose::Description& mistake : wrong_on_purpose::all()) {
    INFO(mistake.word);
    const Story story = tell(walkthrough("mistakes/" + std::string(mistake.word)));
    const nlohmann::json data = data_of(page_of(story), "questions");
    REQUIRE(data["questions"].size() == 1);
    const auto before = data["questions"][0]["before"].get<std::size_t>();
    REQUIRE(before >= 1);
    CHECK(story.frames[before].focus == Focus::parting);
  }
}

TEST_CASE(
    "Beside each step stand the lines that run: of two searches one algorithm until they part, then one for each") {
  const auto titles_of = [](const std::string& name) {
    const Story story = tell(walkthrough(name));
    const std::string page = page_of(story);
    const nlohmann::json data = data_of(page);
    std::vector<std::string> titles;
    for (std::size_t i = 0; i < story.frames.size(); ++i) {
      titles.push_back("");
      const std::vector<std::string> said = all_between(step_of(page, i), "<h3>", "</h3>");
      CHECK(said.size() == data["steps"][i].value("code", nlohmann::json::array()).size());
      for (const std::string& title : said) titles.back() += title + ". ";
    }
    return titles;
  };
  const std::vector<std::string> figure_4 = titles_of("figure-4"), spheres = titles_of("as-printed-spheres");
  for (const std::string& both : figure_4) CHECK((count(both, "left: Alg") == 1 && count(both, "right: Alg") == 1));
  const Story story = tell(walkthrough("as-printed-spheres"));
  REQUIRE(story.parting() > 1U);
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    INFO(i << ": " << spheres[i]);
    CHECK(count(spheres[i], ": Algorithm") == (i < story.parting() ? 1U : 2U));
    CHECK(count(spheres[i], "both: ") == (i < story.parting() ? 1U : 0U));
  }
  for (const std::string& one : titles_of("figure-4-left")) CHECK(one.starts_with("Algorithm "));
  CHECK(titles_of("figure-1") == std::vector<std::string>(titles_of("figure-1").size()));
}

TEST_CASE("Of two searches each has its own line marked, and at the end the one that answers") {
  int listings = 0;
  for (const Walkthrough& w : catalogue()) {
    if (w.scenes.size() < 2 || w.layout == Layout::close_ups) continue;
    INFO(w.name);
    const Story story = tell(w);
    const nlohmann::json data = data_of(page_of(story));
    for (const auto& code : data["steps"].back().value("code", nlohmann::json::array())) {
      const auto& lines = data["listings"][code[0].get<std::size_t>()];
      ++listings;
      REQUIRE(code[1].is_number());
      const std::string line = lines[code[1].get<std::size_t>()][1];
      INFO(line);
      // The last where no new vertex is found.
      CHECK((line == "intersecting" || line == "separated" || line == "undecided" || line.starts_with("P ← ")));
    }
  }
  CHECK(listings >= 8);
}

TEST_CASE("Beside a mistake the report's lines stand as far as to where they part, also where that frame is left out") {
  const Walkthrough& w = walkthrough("mistakes/m14-order-below-triangle");
  for (const Detail detail : {Detail::decision, Detail::step}) {
    const Story story = tell(w, detail);
    const nlohmann::json data = data_of(page_of(story));
    int shown = 0;
    for (std::size_t i = 0; i < story.frames.size(); ++i) {
      const bool is_shown = data["steps"][i].contains("code");
      CHECK(is_shown == (story.frames[i].events[1].last <= *story.parts_at));
      shown += is_shown;
    }
    CHECK((0 < shown && shown < static_cast<int>(story.frames.size())));
  }
}

TEST_CASE("The data of a page name the further views of each step, in order, and not the usual one") {
  const Story story = tell(walkthrough("figure-4"));
  PagePictures turning = pictures;
  turning.turns = 2;
  turning.url = [](std::size_t frame, int turn) { return std::to_string(frame) + "-" + std::to_string(turn); };
  const nlohmann::json turned = data_of(page_html(story, turning, {}))["turned"];
  REQUIRE(turned.size() == story.frames.size());
  for (std::size_t i = 0; i < turned.size(); ++i)
    CHECK(turned[i] == nlohmann::json{std::to_string(i) + "-1", std::to_string(i) + "-2"});
  CHECK(data_of(page_of(story))["turned"].empty());
}

TEST_CASE("The same story makes the same page, byte by byte") {
  CHECK(page_of(tell(walkthrough("vehicle-and-threat/vehicle-hit"))) ==
        page_of(tell(walkthrough("vehicle-and-threat/vehicle-hit"))));
}

TEST_CASE("Titles and names of others are text in a page, whatever they hold") {
  const std::string hostile = "</script></title></style><img src=x onerror=alert(1)> {{script}} & \"'";
  Walkthrough w = walkthrough("figure-4-left");
  w.title = w.summary = w.source = w.name = w.scenes[0].name = w.scenes[0].a.name = hostile;
  const std::string plain_page = page_of(tell(walkthrough("figure-4-left"))), page = page_of(tell(w));
  CHECK(count(page, "<img") == count(plain_page, "<img"));
  CHECK(count(page, "</script") == count(plain_page, "</script"));
  CHECK(count(page, "</style") == count(plain_page, "</style"));
  CHECK(count(page, "</title") == 1);
  CHECK(count(page, "{{script}}") >= 2);
  CHECK(data_of(page, "events")["scenes"][0]["name"] == hostile);
}

TEST_CASE("A page whose pictures have larger text has larger text itself") {
  const Story story = tell(walkthrough("figure-4-left"));
  PagePictures larger = pictures;
  larger.text_scale = 1.25;
  CHECK(page_html(story, larger, {}).find("}html{font-size:125.000%}") != std::string::npos);
  CHECK(page_html(story, pictures, {}).find("html{font-size") == std::string::npos);
}

TEST_CASE("What to practise with is a link by its title where it has a page, and else its name") {
  const Story story = tell(walkthrough("figure-4-left"));
  PageSurroundings around;
  const auto practices = [&] {
    std::vector<nlohmann::json> all;
    const nlohmann::json data = data_of(page_html(story, pictures, around), "questions");
    for (const nlohmann::json& question : data["questions"]) all.push_back(question["practice"]);
    return all;
  };
  const std::vector<nlohmann::json> names = practices();
  around.page_of = [](const std::string& name) { return "../" + name; };
  const std::vector<nlohmann::json> links = practices();
  REQUIRE(names.size() == links.size());
  REQUIRE_FALSE(names.empty());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string name = names[i][0];
    CHECK(names[i][1] == "");
    CHECK(links[i][0] == (name.empty() ? "" : find_walkthrough(name)->title));
    CHECK(links[i][1] == (name.empty() ? "" : "../" + name));
  }
}

TEST_CASE("A page with files beside it holds none of them, and says where they are") {
  const Story story = tell(walkthrough("figure-4"));
  const std::string page = page_html(
      story, pictures,
      {.command = "c", .trace_command = "gjkstep trace figure-4", .sources = {}, .ways = {}, .has_files = true});
  CHECK(count(page, "<link rel=\"stylesheet\" href=\"page.css\">") == 1);
  CHECK(count(page, "<script src=\"page.js\"></script>") == 1);
  CHECK(count(page, "href=\"trace.jsonl\"") == 1);
  CHECK(count(page, "<script src=\"steps.js\"></script>") == 1);
  CHECK(count(page, "id=\"data\"") == 0);
  CHECK(count(page, "id=\"events\"") == 0);
  CHECK(count(page, "id=\"questions\"") == 0);
  const std::string whole = page_of(story);
  const std::vector<PageFile> files = page_files(story, pictures, {});
  CHECK(std::ranges::equal(files, files_asked_for, {}, &PageFile::name));
  for (const PageFile& file : files) {
    INFO(file.name);
    const std::string held = file.name == events_file      ? "\"event\":\"support-found\""
                             : file.name == steps_file     ? "\"listings\":"
                             : file.name == questions_file ? "\"texts\":"
                                                           : file.content;
    CHECK(count(file.content, held) >= 1);
    CHECK(count(whole, held) >= 1);
    CHECK(count(page, held) == 0);
  }
}

TEST_CASE("A picture is named by all sentences about it, each of which stands in the page once") {
  for (const char* const name : {"figure-1", "figure-4", "cycle-separated", "complete/beside-the-report"}) {
    INFO(name);
    const Story story = tell(walkthrough(name));
    const std::string page = page_of(story);
    std::set<std::string> sentences;
    for (std::size_t i = 0; i < story.frames.size(); ++i) {
      std::string expected;
      for (const std::string& sentence : picture_in_words(story, i)) {
        expected += (expected.empty() ? "" : "\n") + render::escaped(sentence);
        sentences.insert(sentence);
      }
      CHECK(name_of_picture(page, step_of(page, i)) == expected);
    }
    CHECK(count(page, "<p hidden id=\"s") == sentences.size());
  }
}

TEST_CASE("All that a page loads but its pictures is below 60 kB, and 1.6 more for each step beyond the 50th",
          "[unsanitized][full]") {
  const PageSurroundings around{
      .command = "gjkstep render", .trace_command = {}, .sources = {}, .ways = {}, .has_files = true};
  for (const Walkthrough& w : catalogue()) {
    INFO(w.name);
    const Story story = tell(w);
    const std::string page = page_html(story, pictures, around);
    std::size_t size = page.size();
    for (const PageFile& file : page_files(story, pictures, around))
      if (count(page, "=\"" + file.name + "\"") > 0) size += file.content.size();
    CHECK(size > page.size() + 20'000);
    CHECK(size < 60'000 + 1'600 * (std::max<std::size_t>(story.frames.size(), 50) - 50));
  }
}

TEST_CASE("Questions whose steps are left out are counted, so that the page can say why they are not asked") {
  Story story = tell(walkthrough("regions/2-simplex-r3"));
  const std::size_t known = questions_of(story).size();
  CHECK(data_of(page_of(story))["unasked"] == 0);
  keep_only(story, places_of(frames_in("regions,end").value(), story.frames));
  const nlohmann::json data = data_of(page_of(story));
  CHECK(data["questions"] == 0);
  CHECK(data["unasked"] == known);
}

TEST_CASE("Of every search that is told step by step each question is asked") {
  for (const Walkthrough& w : catalogue()) {
    if (w.layout != Layout::search || w.scenes[0].certified) continue;
    INFO(w.name);
    CHECK(data_of(page_of(tell(w)))["unasked"] == 0);
  }
}
