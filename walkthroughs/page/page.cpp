#include "walkthroughs/page/page.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>

#include "render/html.hpp"
#include "render/svg_text.hpp"
#include "walkthroughs/catalogue/lesson.hpp"
#include "walkthroughs/page/questions.hpp"
#include "walkthroughs/picture/progress_graph.hpp"
#include "walkthroughs/story/alternative_text.hpp"
#include "walkthroughs/story/progress.hpp"
#include "walkthroughs/story/pseudocode.hpp"
#include "walkthroughs/story/words.hpp"
#include "walkthroughs/trace/trace_json.hpp"

namespace walkthroughs::page {
namespace {

constexpr std::array of_viewer{"colors.css", "page.css",   "begin.js", "pages.js", "quiz.js",
                               "lesson.js",  "running.js", "stage.js", "page.js"};

/// Returns: the place of a value among all of a list, which has each once: what comes again and again is told by its
/// place.
std::size_t place_in(PageJson& list, const PageJson& value) {
  const auto place = static_cast<std::size_t>(std::ranges::find(list, value) - list.begin());
  if (place == list.size()) list.push_back(value);
  return place;
}

// -- What runs beside a frame -----------------------------------------------------------------------------------------

/// Whether two searches have done the same so far.
bool are_together(const Story& story, std::size_t index) {
  const std::vector<EventRange>& events = story.frames[index].events;
  return story.walkthrough.layout == Layout::until_they_part &&
         (!story.parts_at || std::max(events[0].last, events[1].last) < *story.parts_at);
}

/// The searches whose lines are to be shown: of two that have not parted yet they are the same; a mistaken one has its
/// own, and the report's are shown beside it as far as to where it should have gone on.
std::vector<std::size_t> scenes_with_code(const Story& story, std::size_t index) {
  const Layout layout = story.walkthrough.layout;
  const bool is_one = layout == Layout::search;
  if (layout == Layout::diagrams || (is_one && !story.walkthrough.panels.algorithm)) return {};
  if (is_one || (are_together(story, index) && !story.shows_mistake())) return {0};
  if (!story.shows_mistake()) return {0, 1};
  const bool is_right_for_both = !story.parts_at || story.frames[index].events[1].last <= *story.parts_at;
  return is_right_for_both ? std::vector<std::size_t>{1} : std::vector<std::size_t>{};
}

// -- How near the searches have come ------------------------------------------------------------------------------------

/// What is told of it beside each frame. Of a story without searches nothing.
class ProgressBeside {
 public:
  ProgressBeside(const Story& story, render::Font* font) : story_(story), font_(font) {}

  /// Returns: the places of its sentence and of its graph; null where no search has a simplex.
  PageJson of(std::size_t frame, PageJson& texts) {
    if (all_.empty())  // not before it is asked for: while one drags it is not
      for (const Telling& telling : story_.tellings) all_.push_back(progress_of(telling));
    if (std::ranges::all_of(all_, &std::vector<Progress>::empty)) return nullptr;
    std::vector<std::size_t> known;
    for (std::size_t s = 0; s < all_.size(); ++s)
      known.push_back(known_at(all_[s], story_.frames[frame].events[s].last));
    PageJson data = PageJson::array({place_in(texts, sentence(known))});
    if (!font_) return data;
    const auto [place, is_new] = places_.emplace(known, graphs_.size() + 1);
    if (is_new) graphs_.push_back(graph(known));
    data.push_back(place->second);
    return data;
  }
  /// Returns: what all graphs begin with, and the rest of each.
  PageJson graphs() const {
    if (graphs_.empty()) return PageJson::array();
    const std::string& first = graphs_.front();
    std::size_t same = first.size();
    for (const std::string& graph : graphs_)
      same = std::min(same, static_cast<std::size_t>(std::ranges::mismatch(first, graph).in1 - first.begin()));
    same = first.rfind('<', same);  // whole elements, and whole characters
    PageJson all = PageJson::array({first.substr(0, same)});
    for (const std::string& graph : graphs_) all.push_back(graph.substr(same));
    return all;
  }

 private:
  std::string sentence(const std::vector<std::size_t>& known) const {
    std::vector<std::string> told;
    for (std::size_t s = 0; s < all_.size(); ++s)
      told.push_back(progress_told(all_[s], known[s], story_.tellings[s].scene.dimension));
    if (told.size() == 1) return told[0];
    if (told[0] == told[1]) return "Both: " + told[0];
    for (std::size_t s = 0; s < told.size(); ++s) told[s] = as_sentence(story_.tellings[s].scene.name + ": ") + told[s];
    return joined(told, "\n");
  }
  std::string graph(const std::vector<std::size_t>& known) const {
    const picture::Style style(render::themes::report);
    std::vector<ProgressLine> lines;
    for (std::size_t s = 0; s < all_.size(); ++s) lines.push_back({story_.tellings[s].scene.name, all_[s], known[s]});
    render::Canvas canvas(progress_page, progress_page, style.theme.paper, *font_);
    draw_progress(canvas, lines, style);
    return svg_text(canvas, {{0, 0}, {progress_page.width, progress_page.height}});
  }

  const Story& story_;
  render::Font* font_;
  std::vector<std::vector<Progress>> all_;
  std::map<std::vector<std::size_t>, std::size_t> places_;  // in graphs(), by how much of each search is known
  std::vector<std::string> graphs_;
};

// -- A frame ----------------------------------------------------------------------------------------------------------

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

/// In the order of Fact::Mark, and of Decision::Kind.
constexpr const char* names_of_marks[] = {"", "yes", "no", "skipped", "answer", "truth"};
constexpr const char* names_of_kinds[] = {"crossing", "region", "vertices", "direction", "line"};

/// What runs in a search while a frame is shown: the lines of the algorithm as [indent, text], each listing once; which
/// of them, and what came of each test that has run.
PageJson code(const Story& story, std::size_t index, std::size_t scene, PageJson& listings, PageJson& texts) {
  const Telling& telling = story.tellings[scene];
  const Moment& now = story.frames[index].moments[scene];
  const Focus focus = story.frames[index].focus_of(scene);
  const Names names = story.names(index, scene);
  const int number = running_algorithm(now, focus);
  const std::vector<CodeLine>& code = algorithm(number, telling.scene.rules);
  PageJson lines = PageJson::array(), outcomes = PageJson::object();
  for (std::size_t i = 0; i < code.size(); ++i) {
    lines.push_back({code[i].indent, line_in_letters(number, code[i], names)});
    if (const auto* test = test_of(code[i], now)) outcomes[std::to_string(i)] = outcome(*test, true);
  }
  const std::string whose = story.tellings.size() == 1                 ? ""
                            : scene == 0 && are_together(story, index) ? "both: "
                                                                       : telling.scene.name + ": ";
  const std::string title = whose + title_of(number, telling.scene.rules, names, now.processed);
  PageJson data = {{"title", place_in(texts, title)}, {"listing", place_in(listings, lines)}};
  if (!outcomes.empty()) data["outcomes"] = outcomes;
  if (const auto current = current_line(code, now, focus)) data["current"] = *current;
  return data;
}

/// `texts`: sentences about pictures, of which most stay from frame to frame.
PageJson frame_data(const Story& story, const PagePictures& pictures, std::size_t index, PageJson& listings,
                    PageJson& texts) {
  const Frame& frame = story.frames[index];
  PageJson data = {{"caption", frame.caption}};
  if (frame.mark() != Fact::Mark::none) data["mark"] = names_of_marks[static_cast<int>(frame.mark())];
  if (!frame.moments.empty()) data["iterations"] = frame.iterations();
  if (frame.moments.size() == 1 && frame.moments[0].simplex.size() > 0)
    data["simplex"] = story.names(index, 0).list(frame.moments[0].simplex);
  if (const std::string kind = kind_of(frame.focus); !kind.empty()) data["kind"] = kind;
  for (const char* list : {"facts", "pictures", "words", "code", "events"}) data[list] = PageJson::array();
  for (const Fact& fact : frame.facts)
    if (!fact.is_in_caption)
      data["facts"].push_back({names_of_marks[static_cast<int>(fact.mark)], place_in(texts, fact.text)});
  for (int turn = 0; turn <= pictures.turns; ++turn) data["pictures"].push_back(pictures.url(index, turn));
  for (const std::string& sentence : picture_in_words(story, index)) data["words"].push_back(place_in(texts, sentence));
  for (const std::size_t scene : scenes_with_code(story, index))
    data["code"].push_back(code(story, index, scene, listings, texts));
  for (const EventRange& range : frame.events) data["events"].push_back({range.first, range.last});
  return data;
}

// -- Questions --------------------------------------------------------------------------------------------------------

/// `practice`: where one practises what it is about, as [title, URL].
PageJson question_data(const Question& question, std::size_t practice, PageJson& texts) {
  PageJson choices = PageJson::array();
  for (const Choice& choice : question.choices)
    choices.push_back({place_in(texts, choice.text), place_in(texts, choice.reason), place_in(texts, choice.hint)});
  return {{"before", question.frame},
          {"kind", names_of_kinds[static_cast<int>(question.decision.kind)]},
          {"text", place_in(texts, question.text)},
          {"choices", choices},
          {"right", question.right},
          {"practice", practice}};
}

/// Where there is no page, a name and no URL; nothing where there is nothing to practise with.
PageJson practice_data(const Question& question, const Story& story, const PageSurroundings& around) {
  const std::string practice = practice_for(question.decision, story.walkthrough.name);
  const std::string page = practice.empty() ? "" : around.page_of(practice);
  return {page.empty() ? practice : find_walkthrough(practice)->title, page};
}

// -- The lesson -------------------------------------------------------------------------------------------------------

constexpr const char* names_of_doings[] = {"change", "answer", "draw"};

PageJson lesson_data(const PageSurroundings& around) {
  PageJson all = PageJson::array();
  for (const catalogue::Screen& screen : catalogue::screens())
    all.push_back({{"title", screen.title},
                   {"idea", screen.idea},
                   {"task", screen.task},
                   {"hint", screen.hint},
                   {"seen", screen.seen},
                   {"doing", names_of_doings[static_cast<int>(screen.doing)]},
                   {"is_before_search", screen.is_before_search},
                   {"name", screen.walkthrough},
                   {"page", around.page_of(std::string(screen.walkthrough))}});
  return all;
}

// -- Files ------------------------------------------------------------------------------------------------------------

std::string events_script(const Story& story) {
  PageJson scenes = PageJson::array();
  for (const Telling& telling : story.tellings) {
    PageJson events = PageJson::array();
    for (const auto& event : telling.trace.events) events.push_back(event_json(event));
    scenes.push_back({{"name", telling.scene.name}, {"events", events}});
  }
  return "'use strict';\nwindow.gjkstepEvents = " + json_in_script(scenes) + ";\n";
}

/// What stands in the page as long as no script has read its data. Pictures that are inside of them are not there yet.
std::string steps_without_scripts(const PageJson& frames, bool has_files_beside) {
  std::string html;
  for (const PageJson& frame : frames) {
    const std::string picture = frame["pictures"][0], caption = frame["caption"];
    html += "<section class=\"step\">";
    if (has_files_beside) html += "<img src=\"" + render::escaped(picture) + "\" alt=\"\" loading=lazy>";
    html += "<h2>" + render::escaped(plain(caption)) + "</h2></section>\n";
  }
  return html;
}

/// Scripts and styles that stand in a page are let in by a number, and nobody who has written a text in it can know it: it follows
/// from all that the page holds.
std::string number_for(const std::string& html, const std::map<std::string, std::string>& files) {
  std::uint64_t number = 0xcbf29ce484222325;  // FNV-1a
  const auto add = [&](const std::string& text) {
    for (const char c : text) number = (number ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  };
  add(html);
  for (const auto& [name, content] : files) add(content);
  return std::to_string(number);
}

/// Dark pictures stand on a dark page, whatever its reader prefers.
std::string viewer_file(const std::string& name, const PagePictures& pictures) {
  std::string content = viewer_files.at(name);
  const std::string_view condition = "(prefers-color-scheme: dark)";
  const std::size_t at = content.find(condition);
  if (pictures.is_dark && name == "colors.css" && at != std::string::npos) content.replace(at, condition.size(), "all");
  return content;
}

}  // namespace

std::string filled(std::string_view text, const std::vector<PageFile>& fillings) {
  std::string html;
  while (true) {
    const std::size_t begin = text.find("{{"), end = text.find("}}", begin);
    html += text.substr(0, begin);
    if (begin == std::string_view::npos || end == std::string_view::npos) return html;
    const auto filling = std::ranges::find(fillings, text.substr(begin + 2, end - begin - 2), &PageFile::name);
    if (filling == fillings.end()) throw std::logic_error("a page has a place that nothing fills");
    html += filling->content;
    text.remove_prefix(end + 2);
  }
}

std::string with_inside(std::string html, std::map<std::string, std::string> files) {
  files.insert(viewer_files.begin(), viewer_files.end());
  const std::string nonce = number_for(html, files);
  for (const auto& [name, content] : files) {
    const bool is_style = name.ends_with(".css");
    const std::string tag = is_style ? "style" : "script";
    const std::string asks =
        is_style ? "<link rel=\"stylesheet\" href=\"" + name + "\">" : "<script src=\"" + name + "\"></script>";
    if (const std::size_t at = html.find(asks); at != std::string::npos)
      html.replace(at, asks.size(), "<" + tag + " nonce=\"" + nonce + "\">\n" + content + "</" + tag + ">");
  }
  for (const std::string policy : {"style-src", "script-src"})
    if (const std::size_t at = html.find(policy); at != std::string::npos)
      html.insert(at + policy.size(), " 'nonce-" + nonce + "'");
  return html;
}

std::string html_of(const std::vector<PageLink>& links) {
  std::string html;
  for (const auto& [url, text] : links) {
    const std::string words = render::escaped(text);
    html +=
        (url.empty() ? "<code>" + words + "</code>" : "<a href=\"" + render::escaped(url) + "\">" + words + "</a>") +
        "\n";
  }
  return html;
}

std::vector<std::string> page_file_names() {
  std::vector<std::string> names{story_file, events_file, page_file};
  names.insert(names.end(), of_viewer.begin(), of_viewer.end());
  return names;
}

PageJson page_data(const Story& story, const PagePictures& pictures, const PageSurroundings& around,
                   std::optional<std::size_t> only) {
  PageJson frames = PageJson::array(), questions = frames, practices = frames, listings = frames, texts = frames;
  for (std::size_t i = 0; i < story.frames.size(); ++i)
    frames.push_back(only.value_or(i) == i ? frame_data(story, pictures, i, listings, texts) : PageJson());
  ProgressBeside progress(story, pictures.font);
  for (std::size_t i = 0; i < frames.size() && !only; ++i) frames[i]["progress"] = progress.of(i, texts);
  const std::vector<Question> known = only ? std::vector<Question>() : questions_of(story);
  for (const Question& question : in_frames(known, story))
    questions.push_back(question_data(question, place_in(practices, practice_data(question, story, around)), texts));
  return {{"is_float", story.tellings.size() == 1 && story.tellings[0].scene.scalar == Scalar::binary32},
          {"text_scale", pictures.text_scale},
          {"live", around.live},
          {"programs", around.programs},
          {"is_brief", only.has_value()},
          {"unasked", known.size() - questions.size()},
          {"frames", frames},
          {"questions", questions},
          {"practices", practices},
          {"listings", listings},
          {"graphs", progress.graphs()},
          {"texts", texts}};
}

std::vector<PageFile> page_files(const Story& story, const PagePictures& pictures, const PageSurroundings& around) {
  const Walkthrough& w = story.walkthrough;
  PageJson data = page_data(story, pictures, around);
  if (w.name == catalogue::lesson_name && !around.live.is_null()) data["lesson"] = lesson_data(around);
  std::vector<PageFile> files{{story_file, story_script(index_entry(story, pictures), data)},
                              {events_file, events_script(story)}};
  for (const char* name : of_viewer) files.push_back({name, viewer_file(name, pictures)});
  const std::string html =
      filled(viewer_files.at("page.html"), {{"title", render::escaped(w.title)},
                                            {"summary", render::escaped(w.summary)},
                                            {"source", render::escaped(w.source)},
                                            {"ways", html_of(around.ways)},
                                            {"steps", steps_without_scripts(data["frames"], around.has_files_beside)},
                                            {"command", render::escaped(around.command)},
                                            {"sources", html_of(around.sources)}});
  if (!around.has_files_beside) {
    std::string all = files[0].content + files[1].content + viewer_files.at("quiz.js") + viewer_files.at("lesson.js");
    if (!around.live.is_null())
      for (const PageFile& program : page_programs()) all += program.content;
    return {{page_file, with_inside(html, {{story_file, all}})}};
  }
  files.push_back({page_file, html});
  return files;
}

}  // namespace walkthroughs::page
