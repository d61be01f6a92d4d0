#include <algorithm>
#include <array>
#include <ranges>
#include <set>

#include "render/json_text.hpp"
#include "walkthroughs/page/page.hpp"
#include "walkthroughs/story/storyboard.hpp"
#include "walkthroughs/story/words.hpp"
#include "walkthroughs/text/names.hpp"

namespace walkthroughs::page {
namespace {

constexpr std::string_view opening = "window.gjkstep = {\"entry\":", closing = ",\n";

/// Returns: of a region's walkthrough the iteration that it is about: that of the test which it explains, else of what
/// it explains first; nothing of others.
std::optional<int> told_iteration(const Walkthrough& w) {
  if (!w.region_case || w.remarks.empty()) return std::nullopt;
  const auto test = std::ranges::find(w.remarks, Remark::At::region_tested, &Remark::at);
  return (test == w.remarks.end() ? w.remarks.front() : *test).iteration;
}

/// Returns: where two searches part, else the last decision about a region, of the iteration that it is about; the last
/// frame where there is none.
std::size_t telling_frame(const Story& story) {
  if (const auto parting = story.parting()) return *parting;
  const std::optional<int> iteration = told_iteration(story.walkthrough);
  for (std::size_t i = story.frames.size(); i-- > 0;)
    if (story.frames[i].focus == Focus::region && (!iteration || story.frames[i].moments[0].iteration == *iteration))
      return i;
  return story.frames.size() - 1;
}

/// Returns: each word of its captions once, in small letters, for those who look for it.
std::string words_of_captions(const Story& story) {
  std::set<std::string> words;
  for (const Frame& frame : story.frames) {
    std::string caption = in_small_letters(plain(frame.caption));
    std::ranges::replace_if(
        caption, [](char c) { return c < 'a' || c > 'z'; }, ' ');
    for (const auto word : std::views::split(caption, ' ')) words.emplace(word.begin(), word.end());
  }
  words.erase("");
  return joined(words, " ");
}

/// Of its page, in percent of what is shown of it.
PageJson cut(const PagePictures& pictures) {
  const render::Box& part = pictures.part;
  return {{"width", 100 * pictures.page.width / part.width()},
          {"left", -100 * part.min.x() / part.width()},
          {"top", -100 * part.min.y() / part.height()},
          {"aspect", part.width() / part.height()}};
}

/// Whether both have the same keys with values of the same kinds.
bool are_alike(const PageJson& one, const PageJson& other) {
  return std::ranges::equal(one.items(), other.items(), [](const auto& a, const auto& b) {
    return a.key() == b.key() && a.value().type() == b.value().type();
  });
}

struct Known {
  std::string_view prefix, title;
};

/// As the report goes; a walkthrough belongs to the first whose prefix its name has, and what has none is the user's
/// own.
constexpr std::array<Known, 16> groups{{{"lesson", "Start here"},
                                        {"live", "Take hold"},
                                        {"figure-", "Figures of the report"},
                                        {"regions/0-simplex", "Regions of a 0-simplex, a vertex"},
                                        {"regions/1-simplex", "Regions of a 1-simplex, a segment"},
                                        {"regions/2-simplex", "Regions of a 2-simplex, a triangle"},
                                        {"regions/3-simplex", "Regions of a 3-simplex, a tetrahedron"},
                                        {"vehicle-and-threat/", "In space: vehicles and threats"},
                                        {"cycle-", "Where it goes wrong"},
                                        {"as-printed-", "Where it goes wrong"},
                                        {"failures/", "Where it goes wrong"},
                                        {"complete/", "The remedy: rules that end"},
                                        {"mistakes/", "Mistakes"},
                                        {"certified/", "Answers that are proven"},
                                        {"eager-", "A shortcut of ours"},
                                        {"", "Scenes of your own"}}};

const Known& group_of(const std::string& name) {
  return *std::ranges::find_if(groups, [&](const Known& group) { return name.starts_with(group.prefix); });
}

/// What stands in the index as long as no script has made its cards.
std::string cards_without_scripts(const std::vector<PageJson>& entries) {
  std::vector<PageLink> pages;
  for (const PageJson& entry : entries)
    pages.push_back({entry["name"].get<std::string>() + "/index.html", entry["title"]});
  return html_of(pages);
}

}  // namespace

PageJson index_entry(const Story& story, const PagePictures& pictures) {
  const Walkthrough& w = story.walkthrough;
  const bool is_search = !story.frames[0].moments.empty();
  PageJson answers = PageJson::array();
  for (const Telling& telling : story.tellings) answers.push_back(to_string(answer_of(telling.trace)));
  return {{"name", w.name},
          {"title", w.title},
          {"section", w.source},
          {"sentence", w.region_case ? w.region_case->text : literal(w.summary)},
          {"words", words_of_captions(story)},
          {"answers", answers},
          {"steps", story.frames.size()},
          {"iteration_ends", is_search ? PageJson(last_of_each_iteration(story.frames)) : PageJson::array()},
          {"picture", telling_frame(story)},
          {"cut", cut(pictures)},
          {"is_dark", pictures.is_dark}};
}

std::string json_in_script(const PageJson& json) {
  std::string text;
  for (const char c : render::json_text(json)) text += c == '<' ? std::string_view("\\u003c") : std::string_view(&c, 1);
  return text;
}

std::string story_script(const PageJson& entry, const PageJson& story) {
  return "'use strict';\n" + std::string(opening) + json_in_script(entry) + std::string(closing) +
         "\"story\":" + json_in_script(story) + "};\n";
}

std::optional<PageJson> entry_in(std::string_view text) {
  const std::size_t begin = text.find(opening);
  if (begin == std::string_view::npos) return std::nullopt;
  text.remove_prefix(begin + opening.size());
  const PageJson entry = PageJson::parse(text.substr(0, text.find(closing)), nullptr, false);
  static const PageJson sample =
      PageJson::parse(R"({"name": "", "title": "", "section": "", "sentence": "", "words": "",
      "answers": [], "steps": 0, "iteration_ends": [], "picture": 0, "cut": {}, "is_dark": false})");
  return are_alike(entry, sample) ? std::optional(entry) : std::nullopt;
}

PageJson in_groups(const std::vector<PageJson>& entries) {
  PageJson found = PageJson::array();
  for (const Known& group : groups)
    for (const PageJson& entry : entries) {
      if (&group_of(entry["name"]) != &group) continue;
      if (found.empty() || found.back()["title"] != group.title)
        found.push_back({{"title", group.title}, {"entries", PageJson::array()}});
      found.back()["entries"].push_back(entry);
    }
  return found;
}

std::size_t group_place(const std::string& name) { return static_cast<std::size_t>(&group_of(name) - groups.data()); }

std::string page_over(const std::vector<PageJson>& entries, const std::string& viewer_page) {
  const std::string script = "'use strict';\nwindow.gjkstepGroups = " + json_in_script(in_groups(entries)) + ";\n";
  return with_inside(filled(viewer_files.at(viewer_page), {{"cards", cards_without_scripts(entries)}}),
                     {{"entries.js", script}});
}

}  // namespace walkthroughs::page
