#include "walkthroughs/page/page.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "render/html.hpp"
#include "render/json_text.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/page/index_entry.hpp"
#include "walkthroughs/page/practice.hpp"
#include "walkthroughs/page/questions.hpp"
#include "walkthroughs/page/templates.hpp"
#include "walkthroughs/story/alternative_text.hpp"
#include "walkthroughs/story/captions.hpp"
#include "walkthroughs/story/pseudocode.hpp"
#include "walkthroughs/story/words.hpp"
#include "walkthroughs/trace/trace_json.hpp"

namespace walkthroughs {
namespace {

using Json = nlohmann::ordered_json;
using render::escaped;

std::string element(const std::string& name, const std::string& content) {
  return content.empty() ? "" : "<" + name + ">" + content + "</" + name.substr(0, name.find(' ')) + ">\n";
}

std::string link(const PageLink& to, const std::string& attributes = "") {
  return "<a " + attributes + "href=\"" + escaped(to.url) + "\">" + escaped(to.text) + "</a>\n";
}

/// Texts, each once: those of pictures and questions come again and again.
class Texts {
 public:
  std::size_t place_of(const std::string& text) {
    const auto known = std::ranges::find(all_, text);
    if (known != all_.end()) return static_cast<std::size_t>(known - all_.begin());
    all_.push_back(text);
    return all_.size() - 1;
  }
  const std::vector<std::string>& all() const { return all_; }

 private:
  std::vector<std::string> all_;
};

// -- One step ---------------------------------------------------------------------------------------------------------

/// What one of two searches has done last, whatever the frame tells of the other.
Focus focus_of_search(const Story& story, std::size_t index, std::size_t scene) {
  const Frame& frame = story.frames[index];
  if (story.tellings.size() == 1) return frame.focus;
  const Telling& telling = story.tellings[scene];
  for (std::size_t e = frame.events[scene].last + 1; e-- > 0;)
    if (const auto told = caption(telling.trace.events[e], story, telling, replay(telling.trace, e + 1)))
      return told->focus;
  return frame.focus;
}

/// Whether two searches have done the same so far.
bool are_together(const Story& story, std::size_t index) {
  const std::vector<EventRange>& events = story.frames[index].events;
  return story.walkthrough.layout == Layout::until_they_part &&
         (!story.parts_at || std::max(events[0].last, events[1].last) < *story.parts_at);
}

/// What runs in a search while a frame is shown.
struct Running {
  Running(const Story& story, std::size_t index, std::size_t scene)
      : now(story.frames[index].moments[scene]),
        focus(focus_of_search(story, index, scene)),
        names(story.names(index, scene)),
        number(running_algorithm(now, focus)),
        title(whose(story, index, scene) + title_of(number, story.tellings[scene].scene.rules, names, now.processed)),
        code(algorithm(number, story.tellings[scene].scene.rules)),
        current(current_line(code, now, focus)) {}

  const Moment& now;
  const Focus focus;
  const Names names;
  const int number;
  const std::string title;
  const std::vector<CodeLine>& code;
  const std::optional<std::size_t> current;

 private:
  static std::string whose(const Story& story, std::size_t index, std::size_t scene) {
    if (story.tellings.size() == 1) return "";
    return (scene == 0 && are_together(story, index) ? "both" : story.tellings[scene].scene.name) + ": ";
  }
};

/// The searches whose lines are to be shown: of two that have not parted yet they are the same; a mistaken one has its own, and the
/// report's are shown beside it as far as to where it should have gone on.
std::vector<std::size_t> scenes_with_code(const Story& story, std::size_t index) {
  const Layout layout = story.walkthrough.layout;
  const bool is_one = layout == Layout::search;
  if (layout == Layout::diagrams || (is_one && !story.walkthrough.panels.algorithm)) return {};
  if (is_one || (are_together(story, index) && !story.shows_mistake())) return {0};
  if (!story.shows_mistake()) return {0, 1};
  const bool is_right_for_both = !story.parts_at || story.frames[index].events[1].last <= *story.parts_at;
  return is_right_for_both ? std::vector<std::size_t>{1} : std::vector<std::size_t>{};
}

std::string where(const Story& story, std::size_t index) {
  const Frame& frame = story.frames[index];
  std::string text = "Step " + std::to_string(index + 1) + " of " + std::to_string(story.frames.size());
  if (!frame.moments.empty()) text += " · iteration " + std::to_string(frame.moments[0].iteration);
  if (frame.moments.size() == 1 && story.tellings[0].scene.scalar == Scalar::binary32) text += ", in float";
  if (frame.moments.size() == 1 && frame.moments[0].simplex.size() > 0)
    text += " · simplex " + story.names(index, 0).list(frame.moments[0].simplex);
  return text;
}

/// The class of its list item, which the style sheet gives a mark; words for who cannot see that.
std::string fact(const Fact& fact) {
  struct Kind {
    const char *name, *words;
  };
  const auto kind = [&]() -> Kind {
    switch (fact.mark) {
      case Fact::Mark::yes: return {"yes", "true: "};
      case Fact::Mark::no: return {"no", "not so: "};
      case Fact::Mark::skipped: return {"skipped", "skipped: "};
      case Fact::Mark::answer: return {"answer", ""};
      case Fact::Mark::truth: return {"truth", ""};
      case Fact::Mark::none: return {"", ""};
    }
    return {"", ""};
  }();
  const std::string name = kind.name, words = kind.words;
  return (name.empty() ? "<li>" : "<li class=\"" + name + "\">") + (words.empty() ? "" : "<i>" + words + "</i>") +
         html_of(fact.text) + "</li>";
}

/// "Algorithm 4: else if ACn·AO > 0 (R7)", of each search that is to be shown; scripts put the whole algorithm in its place.
std::string running_lines(const Story& story, std::size_t index) {
  std::string html;
  for (const std::size_t scene : scenes_with_code(story, index)) {
    const Running running(story, index, scene);
    const std::string line =
        running.current ? line_in_letters(running.number, running.code[*running.current], running.names) : "";
    html +=
        "<div class=\"code\">" + element("h3", html_of(running.title)) + element("code", html_of(line)) + "</div>\n";
  }
  return html;
}

/// A picture is named by sentences, each of which stands in the page once, where it is new. `told`: those before.
std::string shot(const Story& story, const PagePictures& pictures, std::size_t index, Texts& told) {
  std::string fresh, names;
  for (const std::string& sentence : picture_in_words(story, index)) {
    const std::size_t count = told.all().size(), place = told.place_of(sentence);
    const std::string id = "s" + std::to_string(place);
    if (place == count) fresh += "<p hidden id=\"" + id + "\">" + escaped(sentence) + "</p>\n";
    names += (names.empty() ? "" : " ") + id;
  }
  return "<div class=\"shot\"><img src=\"" + escaped(pictures.url(index, 0)) + "\" alt=\"Step " +
         std::to_string(index + 1) + "\" aria-labelledby=\"" + names + "\" loading=lazy></div>\n" + fresh;
}

std::string step(const Story& story, const PagePictures& pictures, std::size_t index, Texts& told) {
  const Frame& frame = story.frames[index];
  std::string facts;
  for (const Fact& each : frame.facts) facts += fact(each);
  return "<section class=\"step\" id=\"" + std::to_string(index + 1) + "\">\n" +
         shot(story, pictures, index, told) + "<div class=\"text\">" +
         element("p class=\"where\"", html_of(where(story, index))) + element("h2", html_of(frame.caption)) +
         element("ul", facts) + running_lines(story, index) + "</div></section>\n";
}

// -- What scripts need ------------------------------------------------------------------------------------------------

/// One word for the marks on the slider.
std::string kind_of(Focus focus) {
  switch (focus) {
    case Focus::crossing:
    case Focus::proof:
    case Focus::sign:
    case Focus::kept:
    case Focus::region: return "decision";
    case Focus::parting: return "parting";
    case Focus::proven:
    case Focus::end: return "end";
    default: return "";
  }
}

/// Listings of algorithms, each once: lines as [indent, text].
class Listings {
 public:
  std::size_t place_of(const Running& running) {
    Json lines = Json::array();
    for (const CodeLine& line : running.code)
      lines.push_back({line.indent, html_of(line_in_letters(running.number, line, running.names))});
    const auto known = std::find(listings_.begin(), listings_.end(), lines);
    if (known != listings_.end()) return static_cast<std::size_t>(known - listings_.begin());
    listings_.push_back(lines);
    return listings_.size() - 1;
  }
  const Json& all() const { return listings_; }

 private:
  Json listings_ = Json::array();
};

Json code_of(const Running& running, Listings& listings) {
  Json outcomes = Json::object();
  for (std::size_t i = 0; i < running.code.size(); ++i)
    if (const auto* test = test_of(running.code[i], running.now)) outcomes[std::to_string(i)] = outcome(*test, true);
  return {listings.place_of(running), running.current ? Json(*running.current) : Json(nullptr), outcomes};
}

Json step_data(const Story& story, std::size_t index, Listings& listings) {
  const Frame& frame = story.frames[index];
  Json step = Json::object();
  if (!frame.moments.empty()) step["iteration"] = frame.moments[0].iteration;
  if (const std::string kind = kind_of(frame.focus); !kind.empty()) step["kind"] = kind;
  for (const std::size_t scene : scenes_with_code(story, index))
    step["code"].push_back(code_of(Running(story, index, scene), listings));
  return step;
}

/// Returns: the frame that answers the question; nothing where the frame before it does not show what is asked about, as where there
/// is one frame an iteration.
std::optional<std::size_t> answering_frame(const Story& story, const Question& question) {
  const auto [scene, event] = std::pair(question.scene, question.event);
  for (std::size_t i = 1; i < story.frames.size(); ++i) {
    const EventRange range = story.frames[i].events.at(scene);
    if (range.last != event) continue;
    for (std::size_t e = range.first; e < event; ++e)
      if (std::holds_alternative<gjk::SupportFound<double>>(story.tellings[scene].trace.events[e])) return std::nullopt;
    return i;
  }
  return std::nullopt;
}

std::string kind_of(Decision::Kind kind) {
  switch (kind) {
    case Decision::Kind::crossing: return "crossing";
    case Decision::Kind::region: return "region";
    case Decision::Kind::vertices: return "vertices";
    case Decision::Kind::direction: return "direction";
    case Decision::Kind::line: return "line";
  }
  return "";
}

/// Those of `known` that the frames can ask. Texts of questions, choices and reasons are HTML, told by their places in `texts`.
Json questions(const Story& story, const std::vector<Question>& known, const PageSurroundings& surroundings) {
  Json list = Json::array();
  Texts texts;
  const auto place_of = [&](const std::string& text) { return texts.place_of(html_of(text)); };
  for (const Question& question : known) {
    const std::optional<std::size_t> frame = answering_frame(story, question);
    if (!frame) continue;
    Json choices = Json::array();
    for (const Choice& choice : question.choices)
      choices.push_back({place_of(choice.text), place_of(choice.reason), place_of(choice.hint)});
    const std::string practice = practice_for(question.decision, story.walkthrough.name);
    const std::string page = practice.empty() ? "" : surroundings.page_of(practice);
    list.push_back({{"before", *frame},
                    {"kind", kind_of(question.decision.kind)},
                    {"text", place_of(question.text)},
                    {"choices", choices},
                    {"right", question.right},
                    {"practice", {page.empty() ? practice : find_walkthrough(practice)->title, page}}});
  }
  return {{"questions", list}, {"texts", texts.all()}};
}

/// Returns: JSON that may stand in a script.
std::string script_text(const Json& json) { return json_for_html(render::json_text(json)); }

/// `asked`: so many questions of `known` ones.
Json steps(const Story& story, const PagePictures& pictures, std::size_t asked, std::size_t known) {
  Listings listings;
  Json steps = Json::array();
  for (std::size_t i = 0; i < story.frames.size(); ++i) steps.push_back(step_data(story, i, listings));
  Json turned = Json::array();
  for (std::size_t i = 0; pictures.turns > 0 && i < story.frames.size(); ++i) {
    turned.push_back(Json::array());
    for (int turn = 1; turn <= pictures.turns; ++turn) turned.back().push_back(pictures.url(i, turn));
  }
  return {{"name", story.walkthrough.name},
          {"steps", steps},
          {"listings", listings.all()},
          {"turned", turned},
          {"questions", asked},
          {"unasked", known - asked}};
}

/// The events of each scene, and which of them each step tells.
Json events(const Story& story) {
  Json scenes = Json::array(), steps = Json::array();
  for (const Telling& telling : story.tellings) {
    Json events = Json::array();
    for (const auto& event : telling.trace.events) events.push_back(Json::parse(event_json(event)));
    scenes.push_back({{"name", telling.scene.name}, {"events", events}});
  }
  for (const Frame& frame : story.frames) {
    steps.push_back(Json::array());
    for (const EventRange& range : frame.events) steps.back().push_back({range.first, range.last});
  }
  return {{"scenes", scenes}, {"steps", steps}};
}

/// What scripts need, each as JSON that may stand in one.
struct Data {
  std::string steps, events, questions;
};

Data data(const Story& story, const PagePictures& pictures, const PageSurroundings& surroundings) {
  const std::vector<Question> known = questions_of(story);
  const Json asked = questions(story, known, surroundings);
  return {script_text(steps(story, pictures, asked["questions"].size(), known.size())), script_text(events(story)),
          script_text(asked)};
}

// -- Around the steps -------------------------------------------------------------------------------------------------

std::string origin(const Walkthrough& walkthrough, const PageSurroundings& surroundings) {
  std::string html = element("p id=\"summary\"", escaped(walkthrough.summary));
  if (!surroundings.command.empty())
    html += "<p class=\"made\">Made by <code>" + escaped(surroundings.command) + "</code></p>\n";
  if (!surroundings.trace_command.empty())
    html += "<p class=\"made\">Its trace: " + (surroundings.has_files ? link({trace_file, trace_file}) : "") +
            "<code>" + escaped(surroundings.trace_command) + "</code></p>\n";
  for (const PageLink& source : surroundings.sources) html += "<p>Made from " + link(source) + "</p>\n";
  return html;
}

std::string ways(const PageSurroundings& surroundings) {
  std::string html;
  for (const PageLink& way : surroundings.ways) html += link(way);
  return html.empty() ? "" : "<nav aria-label=\"Walkthroughs\">\n" + html + "</nav>\n";
}

// -- What stands in the page, or in files beside it ---------------------------------------------------------------------

std::string style() { return std::string(templates::colors_css) + std::string(templates::page_css); }

std::string linked_style() { return std::string("<link rel=\"stylesheet\" href=\"") + style_file + "\">\n"; }
std::string linked_script(const std::string& file) { return "<script src=\"" + file + "\"></script>\n"; }

std::string inside(const std::string& id, const std::string& json) {
  return "<script type=\"application/json\" id=\"" + id + "\">" + json + "</script>\n";
}

std::string file_that_sets(const std::string& name, const std::string& json) {
  return "'use strict';\nwindow." + name + " = " + json + ";\n";
}

/// Of a page that holds it all.
std::string held_data(const Data& data) {
  return inside("data", data.steps) + inside("events", data.events) + inside("questions", data.questions);
}
std::string held_scripts() {
  return "<script>\n" + std::string(templates::predict_js) + "</script>\n<script>\n" +
         std::string(templates::page_js) + "</script>\n";
}

}  // namespace

std::vector<PageFile> page_files(const Story& story, const PagePictures& pictures,
                                 const PageSurroundings& surroundings) {
  const Data all = data(story, pictures, surroundings);
  return {{style_file, style()},
          {script_file, std::string(templates::page_js)},
          {steps_file, file_that_sets("gjkstepSteps", all.steps)},
          {events_file, file_that_sets("gjkstepEvents", all.events)},
          {quiz_file, std::string(templates::predict_js)},
          {questions_file, file_that_sets("gjkstepQuestions", all.questions)}};
}

std::string page_html(const Story& story, const PagePictures& pictures, const PageSurroundings& surroundings) {
  const Walkthrough& w = story.walkthrough;
  const bool is_whole = !surroundings.has_files;
  std::string steps;
  Texts told;
  for (std::size_t i = 0; i < story.frames.size(); ++i) steps += step(story, pictures, i, told);
  return filled(
      templates::page_html,
      {{"title", escaped(w.title)},
       {"summary", escaped(w.summary)},
       {"source", escaped(w.source)},
       {"count", std::to_string(story.frames.size())},
       {"cut", ".shot{" + cut_out(pictures.page, pictures.part) + "}" + text_size(pictures.text_scale)},
       {"pictures", pictures.is_dark ? "dark-pictures" : "light-pictures"},
       {"entry", entry_element(index_entry(story, pictures))},
       {"ways", ways(surroundings)},
       {"origin", origin(w, surroundings)},
       {"steps", steps},
       {"style", is_whole ? "<style>\n" + style() + "</style>\n" : linked_style()},
       {"data", is_whole ? held_data(data(story, pictures, surroundings)) : linked_script(steps_file)},
       {"script", is_whole ? held_scripts() : linked_script(script_file)}});
}

}  // namespace walkthroughs
