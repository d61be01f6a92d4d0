#include "walkthroughs/alternative_text.hpp"

#include <nlohmann/json.hpp>

#include "walkthroughs/words.hpp"

namespace walkthroughs {
namespace {

using Json = nlohmann::ordered_json;

constexpr int captions_version = 1;

std::string described(const Scene& scene, const LabelledHull& hull, const Moment& now) {
  std::string text = "The difference of a " + scene.a.name + " and a " + scene.b.name + " has the corners ";
  for (std::size_t i = 0; i < hull.corners.size(); ++i) {
    const Point corner(hull.corners[i].x(), hull.corners[i].y(), 0);
    text += (i ? ", " : "") + hull.name(corner) + " " + vector(corner);
  }
  text += now.simplex.size() == 0 ? ". There is no simplex yet."
                                  : ". The simplex, oldest first, is " + list_of_names(now.simplex, hull) + ".";
  if (now.direction) text += " The search direction d is " + vector(now.direction->value) + ".";
  if (now.found)
    text += " The support points are a " + vector(now.found->a.point) + " and b " + vector(now.found->b.point) +
            "; a minus b is " + hull.name(now.found->w) + ".";
  return text;
}

std::string mark_in_words(Fact::Mark mark) {
  switch (mark) {
    case Fact::Mark::yes: return "True: ";
    case Fact::Mark::no: return "Not so: ";
    case Fact::Mark::skipped: return "Skipped: ";
    case Fact::Mark::answer: return "Answer: ";
    case Fact::Mark::none: return "";
  }
  return "";
}

Json json(const FrameFile& item) {
  const Frame& frame = item.story.frames[item.index];
  Json facts = Json::array(), events = Json::object();
  for (const Fact& fact : frame.facts) facts.push_back(plain(fact.text));
  for (std::size_t s = 0; s < frame.events.size(); ++s)
    events[item.story.walkthrough.scenes[s].name] = {frame.events[s].first, frame.events[s].last};
  return {{"file", item.file.string()},
          {"walkthrough", item.story.walkthrough.name},
          {"caption", plain(frame.caption)},
          {"facts", facts},
          {"alternative_text", alternative_text(item.story, item.index)},
          {"events", events}};
}

}  // namespace

std::string alternative_text(const Story& story, std::size_t index) {
  const Frame& frame = story.frames[index];
  std::string text = plain(frame.caption);
  for (std::size_t s = 0; s < frame.moments.size(); ++s) {
    const bool several = frame.moments.size() > 1;
    text += (several ? "\nIn the " + story.walkthrough.scenes[s].name + " set: " : "\n") +
            described(story.walkthrough.scenes[s], story.hulls[s], frame.moments[s]);
  }
  for (const Fact& fact : frame.facts) text += "\n" + mark_in_words(fact.mark) + plain(fact.text) + ".";
  return text;
}

std::string captions_json(const std::vector<FrameFile>& frames) {
  Json list = Json::array();
  for (const FrameFile& frame : frames) list.push_back(json(frame));
  return Json{{"schema", "gjkstep-captions"}, {"version", captions_version}, {"frames", list}}.dump(2) + "\n";
}

}  // namespace walkthroughs
