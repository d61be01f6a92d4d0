#include "walkthroughs/page/index_entry.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "render/html.hpp"
#include "render/json_text.hpp"
#include "walkthroughs/page/templates.hpp"
#include "walkthroughs/story/storyboard.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view opening = "<script type=\"application/json\" id=\"entry\">", closing = "</script>";

std::string answers(const Story& story) {
  std::string all;
  for (const Telling& telling : story.tellings) {
    const std::string answer(to_string(answer_of(telling.trace)));
    if (all.find(answer) == std::string::npos) all += (all.empty() ? "" : ", ") + answer;
  }
  return all;
}

/// Returns: where two searches part, else the last decision about a region, of the iteration that it is about; the last frame where there
/// is none.
std::size_t telling_frame(const Story& story) {
  if (const auto parting = story.parting()) return *parting;
  const std::optional<int> iteration = told_iteration(story.walkthrough);
  for (std::size_t i = story.frames.size(); i-- > 0;)
    if (story.frames[i].focus == Focus::region && (!iteration || story.frames[i].moments[0].iteration == *iteration))
      return i;
  return story.frames.size() - 1;
}

/// Errors: Json::exception where it is none.
std::size_t count(const Json& json) { return json.get_ref<const Json::number_unsigned_t&>(); }

/// Errors: Json::exception where that is not what entry_json() writes.
IndexEntry entry_from(const Json& json) {
  IndexEntry entry;
  entry.name = json.at("name");
  entry.title = json.at("title");
  entry.section = json.at("section");
  entry.sentence = json.at("sentence");
  entry.answer = json.at("answer");
  entry.steps = count(json.at("steps"));
  for (const Json& end : json.at("iteration_ends")) entry.iteration_ends.push_back(count(end));
  entry.picture = count(json.at("picture"));
  entry.cut = json.at("cut");
  entry.is_dark = json.at("is_dark");
  return entry;
}

}  // namespace

std::optional<int> told_iteration(const Walkthrough& w) {
  if (!w.region_case || w.remarks.empty()) return std::nullopt;
  const auto test = std::ranges::find(w.remarks, Remark::At::region_tested, &Remark::at);
  return (test == w.remarks.end() ? w.remarks.front() : *test).iteration;
}

IndexEntry index_entry(const Story& story, const PagePictures& pictures) {
  const Walkthrough& w = story.walkthrough;
  IndexEntry entry;
  entry.name = w.name;
  entry.title = w.title;
  entry.section = w.source;
  entry.sentence = w.region_case ? w.region_case->text : literal(w.summary);
  entry.answer = answers(story);
  entry.steps = story.frames.size();
  if (!story.frames[0].moments.empty()) entry.iteration_ends = last_of_each_iteration(story.frames);
  entry.picture = telling_frame(story);
  entry.cut = cut_out(pictures.page, pictures.part);
  entry.is_dark = pictures.is_dark;
  return entry;
}

std::string entry_json(const IndexEntry& entry) {
  const Json json = {{"name", entry.name},
                     {"title", entry.title},
                     {"section", entry.section},
                     {"sentence", entry.sentence},
                     {"answer", entry.answer},
                     {"steps", entry.steps},
                     {"iteration_ends", entry.iteration_ends},
                     {"picture", entry.picture},
                     {"cut", entry.cut},
                     {"is_dark", entry.is_dark}};
  return render::json_text(json);
}

std::string entry_element(const IndexEntry& entry) {
  return std::string(opening) + json_for_html(entry_json(entry)) + std::string(closing) + "\n";
}

std::optional<IndexEntry> entry_of(std::string_view page) {
  const std::size_t begin = page.find(opening);
  if (begin == std::string_view::npos) return std::nullopt;
  page.remove_prefix(begin + opening.size());
  try {
    return entry_from(Json::parse(page.substr(0, page.find(closing))));
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace walkthroughs
