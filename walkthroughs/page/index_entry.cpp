#include "walkthroughs/page/index_entry.hpp"

#include <algorithm>

#include "render/json_text.hpp"
#include "walkthroughs/story/storyboard.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs {
namespace {

constexpr std::string_view opening = "window.gjkstep = {\"entry\":", closing = ",\n";

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

}  // namespace

std::optional<int> told_iteration(const Walkthrough& w) {
  if (!w.region_case || w.remarks.empty()) return std::nullopt;
  const auto test = std::ranges::find(w.remarks, Remark::At::region_tested, &Remark::at);
  return (test == w.remarks.end() ? w.remarks.front() : *test).iteration;
}

PageJson index_entry(const Story& story, const PagePictures& pictures) {
  const Walkthrough& w = story.walkthrough;
  const bool is_search = !story.frames[0].moments.empty();
  PageJson answers = PageJson::array();
  for (const Telling& telling : story.tellings) answers.push_back(to_string(answer_of(telling.trace)));
  return {{"name", w.name},
          {"title", w.title},
          {"section", w.source},
          {"sentence", w.region_case ? w.region_case->text : literal(w.summary)},
          {"answers", answers},
          {"steps", story.frames.size()},
          {"iteration_ends", is_search ? PageJson(last_of_each_iteration(story.frames)) : PageJson::array()},
          {"picture", telling_frame(story)},
          {"cut", cut(pictures)},
          {"is_dark", pictures.is_dark}};
}

std::string json_in_script(const PageJson& json) {
  std::string text = render::json_text(json);
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;) text.replace(at, 1, "\\u003c");
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
  static const PageJson sample = PageJson::parse(R"({"name": "", "title": "", "section": "", "sentence": "", "answers": [],
      "steps": 0, "iteration_ends": [], "picture": 0, "cut": {}, "is_dark": false})");
  return are_alike(entry, sample) ? std::optional(entry) : std::nullopt;
}

}  // namespace walkthroughs
