#include "walkthroughs/page/page.hpp"

#include <algorithm>
#include <set>

#include "render/html.hpp"
#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/story/stories.hpp"
#include "walkthroughs/page/questions.hpp"
#include "walkthroughs/story/alternative_text.hpp"
#include "walkthroughs/story/progress.hpp"
#include "walkthroughs/story/storyboard.hpp"
#include "walkthroughs/story/words.hpp"
#include "walkthroughs/trace/trace_json.hpp"
#include "walkthroughs/wrong_on_purpose/mistakes.hpp"

namespace page_test {

using namespace walkthroughs;
using namespace walkthroughs::program;
using namespace walkthroughs::test;

namespace {

const PagePictures pictures{.url = [](std::size_t frame, int) { return std::to_string(frame) + ".png"; },
                            .page = {1280, 720},
                            .part = {{40, 72}, {1240, 520}}};

PageJson data_of(const Story& story) { return page_data(story, pictures, {}); }

std::string page_of(const Story& story, const PageSurroundings& around = {}) {
  return page_files(story, pictures, around).back().content;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++found;
  return found;
}

/// What a script sets that variable to.
PageJson set_in(const std::string& script, const std::string& variable) {
  const std::size_t begin = script.find(variable + " = ") + variable.size() + 3;
  return PageJson::parse(script.substr(begin, script.find(";\n", begin) - begin));
}

}  // namespace

/// The first test of this file: what a page keeps for the next one would be searched for here.
TEST_CASE("A page runs no search, neither its own nor another's") {
  const auto calls = [] {
    std::size_t sum = 0;
    for (const Walkthrough& each : whole_catalogue())
      for (const Scene& scene : each.scenes) sum += scene.a.support_calls + scene.b.support_calls;
    return sum;
  };
  const Story story = tell(walkthrough("regions/2-simplex-r3"));
  const std::size_t before = calls();
  CHECK(data_of(story)["questions"].size() > 3);
  CHECK(calls() == before);
}

TEST_CASE("A page has each frame of every walkthrough, with its picture, caption, facts and what is seen",
          "[unsanitized]") {
  for (const Walkthrough& w : whole_catalogue()) {
    INFO(w.name);
    const Story story = tell(w);
    const PageJson data = data_of(story), frames = data["frames"];
    REQUIRE(frames.size() == story.frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
      CHECK(frames[i]["caption"] == story.frames[i].caption);
      CHECK(frames[i]["pictures"] == PageJson{std::to_string(i) + ".png"});
      std::vector<std::string> facts, expected_facts, words;
      for (const PageJson& fact : frames[i]["facts"]) facts.push_back(data["texts"].at(fact[1].get<std::size_t>()));
      for (const Fact& fact : story.frames[i].facts)
        if (!fact.is_in_caption) expected_facts.push_back(fact.text);
      CHECK(facts == expected_facts);
      for (const PageJson& place : frames[i]["words"]) words.push_back(data["texts"].at(place.get<std::size_t>()));
      CHECK(words == picture_in_words(story, i));
    }
  }
}

TEST_CASE("A page has each event as the trace has it, and each step its range of them") {
  const Story story = tell(walkthrough("figure-4"));
  const std::vector<PageFile> files = page_files(story, pictures, {.has_files_beside = true});
  const PageJson held = set_in(std::ranges::find(files, events_file, &PageFile::name)->content, "gjkstepEvents");
  REQUIRE(held.size() == 2);
  for (std::size_t s = 0; s < 2; ++s) {
    const auto& events = story.tellings[s].trace.events;
    REQUIRE(held[s]["events"].size() == events.size());
    for (std::size_t i = 0; i < events.size(); ++i) CHECK(held[s]["events"][i] == event_json(events[i]));
    CHECK(data_of(story)["frames"].back()["events"][s][1] == events.size() - 1);
  }
}

TEST_CASE("Each step of a search tells how near the iterations known by then have come, in words and with a graph") {
  render::Font font(render::Font::default_directory());
  PagePictures drawn = pictures;
  drawn.font = &font;
  for (const char* name : {"figure-4-left", "figure-4", "certified/touching"}) {
    INFO(name);
    const Story story = tell(walkthrough(name));
    const PageJson data = page_data(story, drawn, {}), words_alone = data_of(story);
    std::set<std::size_t> graphs;
    for (std::size_t i = 0; i < story.frames.size(); ++i) {
      const auto place = data["frames"][i]["progress"].get<std::vector<std::size_t>>();
      const std::string told = data["texts"].at(place.at(0));
      for (std::size_t s = 0; s < story.tellings.size(); ++s) {
        const std::vector<Progress> progress = progress_of(story.tellings[s]);
        const std::size_t known = known_at(progress, story.frames[i].events[s].last);
        CHECK_THAT(told, kit::contains(progress_told(progress, known, story.tellings[s].scene.dimension)));
      }
      CHECK(place.at(1) > 0);
      const std::string graph = data["graphs"][0].get<std::string>() + data["graphs"].at(place[1]).get<std::string>();
      CHECK((graph.starts_with("<svg") && graph.ends_with("</svg>")));
      graphs.insert(place[1]);
      CHECK(words_alone["frames"][i]["progress"].size() == 1);
    }
    CHECK(graphs.size() + 1 == data["graphs"].size());
    CHECK(page_data(story, drawn, {}, 1)["graphs"].empty());
    CHECK_FALSE(page_data(story, drawn, {}, 1)["frames"][1].contains("progress"));
  }
  CHECK(page_data(tell(walkthrough("figure-1")), drawn, {})["frames"][0]["progress"].is_null());  // no search
}

TEST_CASE("A page has each question of its story, before the step that answers it") {
  const Story story = tell(walkthrough("figure-4-right"));
  const std::vector<Question> questions = questions_of(story);
  const PageJson data = data_of(story);
  REQUIRE(data["questions"].size() == questions.size());
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const auto& asked = data["questions"][i];
    CHECK(data["texts"][asked["text"].get<std::size_t>()] == questions[i].text);
    CHECK(asked["choices"].size() == questions[i].choices.size());
    CHECK(asked["right"] == questions[i].right);
    const auto& answered_by = data["frames"][asked["before"].get<std::size_t>()]["events"][0];
    CHECK((answered_by[0] <= questions[i].event && questions[i].event <= answered_by[1]));
  }
}

TEST_CASE("The page of each mistake asks for its line, before the step where the searches part") {
  for (const wrong_on_purpose::Description& mistake : wrong_on_purpose::all()) {
    INFO(mistake.word);
    const Story story = tell(walkthrough("mistakes/" + std::string(mistake.word)));
    const PageJson questions = data_of(story)["questions"];
    REQUIRE(questions.size() == 1);
    const auto before = questions[0]["before"].get<std::size_t>();
    REQUIRE(before >= 1);
    CHECK(story.frames[before].focus == Focus::parting);
  }
}

TEST_CASE(
    "Beside each step stand the lines that run: of two searches one algorithm until they part, then one for each") {
  const auto titles_of = [](const std::string& name) {
    std::vector<std::string> titles;
    const PageJson data = data_of(tell(walkthrough(name)));
    for (const PageJson& frame : data["frames"]) {
      titles.push_back("");
      for (const PageJson& code : frame["code"])
        titles.back() += data["texts"].at(code["title"].get<std::size_t>()).get<std::string>() + ". ";
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
  for (const Walkthrough& w : whole_catalogue()) {
    if (w.scenes.size() < 2 || w.layout == Layout::close_ups) continue;
    INFO(w.name);
    const PageJson data = data_of(tell(w));
    for (const PageJson& code : data["frames"].back()["code"]) {
      const PageJson& lines = data["listings"].at(code["listing"].get<std::size_t>());
      ++listings;
      const std::string line = lines.at(code.at("current").get<std::size_t>())[1];
      INFO(line);
      // The last where no new vertex is found.
      CHECK((line == "intersecting" || line == "separated" || line == "undecided" || line.starts_with("P ← ")));
    }
  }
  CHECK(listings >= 8);
}

TEST_CASE("Beside a mistake the report's lines stand as far as to where they part, also where that frame is left out") {
  const Walkthrough& w = walkthrough("mistakes/m14-order-below-triangle");
  for (const Detail detail : {Detail::decision, Detail::iteration}) {
    const Story story = tell(w, detail);
    const PageJson frames = data_of(story)["frames"];
    std::size_t shown = 0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const bool is_shown = !frames[i]["code"].empty();
      CHECK(is_shown == (story.frames[i].events[1].last <= *story.parts_at));
      shown += is_shown;
    }
    CHECK((0 < shown && shown < frames.size()));
  }
}

TEST_CASE("Each step has its usual view and the further ones, in order") {
  PagePictures turning = pictures;
  turning.turns = 2;
  turning.url = [](std::size_t frame, int turn) { return std::to_string(frame) + "-" + std::to_string(turn); };
  const PageJson frames = page_data(tell(walkthrough("figure-4")), turning, {})["frames"];
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const std::string number = std::to_string(i);
    CHECK(frames[i]["pictures"] == PageJson{number + "-0", number + "-1", number + "-2"});
  }
}

TEST_CASE("The same story makes the same page, byte by byte") {
  CHECK(page_of(tell(walkthrough("vehicle-and-threat/vehicle-hit"))) ==
        page_of(tell(walkthrough("vehicle-and-threat/vehicle-hit"))));
}

TEST_CASE("Titles and names of others are text in a page, whatever they hold") {
  const std::string hostile = "</script></title></style><img src=x onerror=alert(1)> {{steps}} & \"'";
  Walkthrough w = walkthrough("figure-4-left");
  w.title = w.summary = w.source = w.name = w.scenes[0].name = w.scenes[0].a.name = hostile;
  const std::string plain_page = page_of(tell(walkthrough("figure-4-left"))), page = page_of(tell(w));
  CHECK(count(page, "<img") == count(plain_page, "<img"));
  CHECK(count(page, "</script") == count(plain_page, "</script"));
  CHECK(count(page, "</style") == count(plain_page, "</style"));
  CHECK(count(page, "</title") == 1);
  CHECK(count(page, "{{steps}}") >= 2);
  CHECK(set_in(page, "gjkstepEvents")[0]["name"] == hostile);
}

TEST_CASE("What to practise with is a link by its title where it has a page, and else its name") {
  const Story story = tell(walkthrough("figure-4-left"));
  PageSurroundings around;
  const PageJson names = page_data(story, pictures, around)["practices"];
  around.page_of = [](const std::string& name) { return "../" + name; };
  const PageJson links = page_data(story, pictures, around)["practices"];
  REQUIRE(names.size() == links.size());
  REQUIRE_FALSE(names.empty());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string name = names[i][0];
    CHECK(names[i][1] == "");
    CHECK(links[i][0] == (name.empty() ? "" : find_walkthrough(name)->title));
    CHECK(links[i][1] == (name.empty() ? "" : "../" + name));
  }
}

TEST_CASE("A page has its files beside it and asks for them, or holds what is in them") {
  const Story story = tell(walkthrough("figure-4"));
  const std::vector<PageFile> files = page_files(story, pictures, {.has_files_beside = true});
  std::vector<std::string> names, all = page_file_names();
  for (const PageFile& file : files) names.push_back(file.name);
  CHECK(names.back() == page_file);
  std::ranges::sort(names);
  std::ranges::sort(all);
  CHECK(names == all);
  const std::string whole = page_of(story), page = files.back().content;
  for (const auto& [name, content] : files) {
    INFO(name);
    if (name == page_file) continue;
    const bool is_asked_for_later = name == events_file || name == "quiz.js" || name == "lesson.js";
    CHECK(count(page, "=\"" + name + "\"") == (is_asked_for_later ? 0 : 1));
    CHECK(count(page, content) == 0);
    CHECK(count(whole, "=\"" + name + "\"") == 0);
    if (name != story_file) CHECK(count(whole, content) == 1);
  }
  CHECK(page_files(story, pictures, {}).size() == 1);
}

TEST_CASE("Without scripts each step has its picture and its caption") {
  const Story story = tell(walkthrough("figure-4-left"));
  const std::string page = page_of(story, {.has_files_beside = true});
  CHECK(count(page, "<section class=\"step\">") == story.frames.size());
  for (std::size_t i = 0; i < story.frames.size(); ++i) {
    CHECK(count(page, "<img src=\"" + std::to_string(i) + ".png\"") == 1);
    CHECK(count(page, "<h2>" + render::escaped(plain(story.frames[i].caption)) + "</h2>") >= 1);
  }
}

TEST_CASE("All that a page loads but its pictures is below 116 kB, and 1.9 more for each step beyond the 50th",
          "[unsanitized][full]") {
  render::Font font(render::Font::default_directory());
  PagePictures drawn = pictures;
  drawn.font = &font;
  for (const Walkthrough& w : whole_catalogue()) {
    INFO(w.name);
    const Story story = tell(w);
    const std::vector<PageFile> files =
        page_files(story, drawn, {.command = "gjkstep render", .has_files_beside = true});
    const std::string& page = files.back().content;
    std::size_t size = page.size();
    for (const PageFile& file : files)
      if (count(page, "=\"" + file.name + "\"") > 0) size += file.content.size();
    CHECK(size > page.size() + 20'000);
    CHECK(size < 116'000 + 1'900 * (std::max<std::size_t>(story.frames.size(), 50) - 50));
  }
}

TEST_CASE("Questions whose steps are left out are counted, so that the page can say why they are not asked") {
  Story story = tell(walkthrough("regions/2-simplex-r3"));
  const std::size_t known = questions_of(story).size();
  CHECK(data_of(story)["unasked"] == 0);
  keep_only(story, places_of(frames_in("regions,end").value(), story.frames));
  const PageJson data = data_of(story);
  CHECK(data["questions"].empty());
  CHECK(data["unasked"] == known);
}

TEST_CASE("Of every search that is told step by step each question is asked") {
  for (const Walkthrough& w : whole_catalogue()) {
    if (w.layout != Layout::search || w.scenes[0].certified) continue;
    INFO(w.name);
    CHECK(data_of(tell(w))["unasked"] == 0);
  }
}

}  // namespace page_test
