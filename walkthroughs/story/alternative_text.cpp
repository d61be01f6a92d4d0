#include "walkthroughs/story/alternative_text.hpp"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "render/json_text.hpp"
#include "walkthroughs/story/decision.hpp"
#include "walkthroughs/story/number_line.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs::story {
namespace {

using Json = nlohmann::ordered_json;

constexpr int captions_version = 1;

using Places = std::vector<Point>;

/// Returns: "A (1, 2), B (3, 4)".
std::string with_names(const Places& places, const Names& names, Dimension dimension) {
  return joined(places, ", ", [&](const Point& w) { return names.label(w) + " " + vector(w, dimension); });
}

/// Returns: of the difference, as far as they have names.
Places corners_of(const Telling& telling) {
  Places corners;
  for (const render::Vec2& corner : telling.hull.corners) corners.emplace_back(corner.x(), corner.y(), 0);
  return corners;
}

Places vertices_of(const Simplex& simplex) {
  Places vertices;
  for (int i = 0; i < simplex.size(); ++i) vertices.push_back(simplex[i].w);
  return vertices;
}

std::string vertices_in_words(const Telling& telling, const Names& names, const Moment& now) {
  const std::string both = with_article(telling.scene.a.name) + " and " + with_article(telling.scene.b.name);
  const auto named = [&](const Places& places) { return with_names(places, names, telling.scene.dimension); };
  if (const Places corners = corners_of(telling); !corners.empty())
    return "The difference of " + both + " has the corners " + named(corners) + ". ";
  const std::string what = "It is about the difference of " + both + ". ";
  return now.simplex.size() == 0 ? what
                                 : what + "The vertices of the simplex are " + named(vertices_of(now.simplex)) + ". ";
}

using Sentences = std::vector<std::string>;

Sentences described(const Telling& telling, const Names& names, const Moment& now) {
  const Dimension dimension = telling.scene.dimension;
  std::string text = vertices_in_words(telling, names, now);
  text += now.simplex.size() == 0 ? "There is no simplex yet."
                                  : "The simplex, oldest first, is " + names.list(now.simplex) + ".";
  if (now.direction) text += " The search direction d is " + vector(now.direction->value, dimension) + ".";
  if (now.found)
    text += " The support points are a " + vector(now.found->a.point, dimension) + " and b " +
            vector(now.found->b.point, dimension) + "; a minus b is " + names.of(now.found->w) + " " +
            vector(now.found->w, dimension) + ".";
  return {text};
}

Sentences described_briefly(const Telling& telling, const Names& names, const Moment& now) {
  const auto at = [&](const Point& place) { return vector(place, telling.scene.dimension); };
  const auto named = [&](const Places& places) { return with_names(places, names, telling.scene.dimension); };
  const Places corners = corners_of(telling), vertices = vertices_of(now.simplex);
  Sentences all;
  if (!corners.empty()) all.push_back("The difference has the corners " + named(corners) + ".");
  all.push_back(vertices.empty() ? "There is no simplex yet." : "The simplex is " + named(vertices) + ".");
  if (now.direction) all.push_back("d is " + at(now.direction->value) + ".");
  if (now.found)
    all.push_back("a is " + at(now.found->a.point) + ", b " + at(now.found->b.point) + "; a minus b is " +
                  names.of(now.found->w) + " " + at(now.found->w) + ".");
  return all;
}

/// In the order of Fact::Mark; a truth says so itself.
constexpr const char* marks_in_words[] = {"", "True: ", "Not so: ", "Skipped: ", "Answer: ", ""};

Json json(const FrameFile& item) {
  const Frame& frame = item.story.frames[item.index];
  Json facts = Json::array(), events = Json::object();
  for (const Fact& fact : frame.facts) facts.push_back(plain(fact.text));
  for (std::size_t s = 0; s < frame.events.size(); ++s)
    events[item.story.walkthrough.scenes[s].name] = {frame.events[s].first, frame.events[s].last};
  return {{"file", item.file},
          {"walkthrough", item.story.walkthrough.name},
          {"caption", plain(frame.caption)},
          {"facts", facts},
          {"alternative_text", alternative_text(item.story, item.index)},
          {"events", events}};
}

using Describe = Sentences (*)(const Telling&, const Names&, const Moment&);

Sentences panels_in_words(const Story& story, std::size_t index, Describe describe) {
  const Frame& frame = story.frames[index];
  Sentences all;
  if (frame.focus == Focus::diagram) all.push_back(plain(story.diagrams[index].description));
  for (std::size_t s = 0; s < frame.moments.size(); ++s) {
    Sentences of_scene = describe(story.tellings[s], story.names(index, s), frame.moments[s]);
    if (frame.moments.size() > 1)
      of_scene.front() = "Of the two, " + story.tellings[s].scene.name + ": " + of_scene.front();
    std::ranges::move(of_scene, std::back_inserter(all));
  }
  if (story.walkthrough.panels.decision && frame.moments.size() == 1)
    if (const auto line = number_line(frame.moments[0], frame.focus, story.names(index, 0)))
      all.push_back(plain(in_words(*line)));
  if (shows_decision(story))
    for (const DecisionView& view : decision_views(frame.moments[0], frame.focus))
      all.push_back(plain(in_words(view, frame.moments[0], story.names(index, 0))));
  return all;
}

}  // namespace

std::vector<std::string> picture_in_words(const Story& story, std::size_t index) {
  return panels_in_words(story, index, described_briefly);
}

std::string alternative_text(const Story& story, std::size_t index) {
  const Frame& frame = story.frames[index];
  std::string text = plain(frame.caption);
  for (const std::string& seen : panels_in_words(story, index, described)) text += "\n" + seen;
  for (const Fact& fact : frame.facts)
    if (!fact.is_in_caption)
      text += std::string("\n") + marks_in_words[static_cast<int>(fact.mark)] + plain(fact.text) +
              (fact.text.ends_with('.') || fact.text.ends_with('?') ? "" : ".");
  return text;
}

std::string captions_json(const std::vector<FrameFile>& frames) {
  Json list = Json::array();
  for (const FrameFile& frame : frames) list.push_back(json(frame));
  const Json all = {{"schema", "gjkstep-captions"}, {"version", captions_version}, {"frames", list}};
  return render::json_text(all, 2) + "\n";
}

}  // namespace walkthroughs::story
