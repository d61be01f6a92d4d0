#include "walkthroughs/live/live.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <variant>

#include "render/json_text.hpp"
#include "render/svg_text.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/live/changes.hpp"
#include "walkthroughs/model/words_of.hpp"
#include "walkthroughs/page/page.hpp"
#include "walkthroughs/picture/draw.hpp"
#include "walkthroughs/story/storyboard.hpp"
#include "walkthroughs/text/scene_text.hpp"
#include "walkthroughs/trace/trace_json.hpp"
#include "walkthroughs/trace/trace_text.hpp"

namespace walkthroughs::live {
namespace {

using Json = PageJson;

/// A story and what it is about, which it refers to.
struct Told {
  explicit Told(Walkthrough about) : walkthrough(std::move(about)), story(tell(walkthrough)) {}
  explicit Told(TraceFile file) : walkthrough(std::move(file.walkthrough)), story(tell(walkthrough, file.traces)) {}

  const Walkthrough walkthrough;
  const StagedStory story;
};

Json error(const Complaint& complaint) {
  return {
      {"error",
       {{"line", complaint.line}, {"key", complaint.key}, {"reason", complaint.reason}, {"text", complaint.text()}}}};
}

std::optional<Mistake> mistake_called(const std::string& word) {
  const auto& all = wrong_on_purpose::all();
  const auto found = std::ranges::find(all, word, &wrong_on_purpose::Description::word);
  return found == all.end() ? std::nullopt : std::optional(found->value);
}

#ifdef GJKSTEP_FEW_SEARCHES
constexpr bool reads_traces = false;
#else
constexpr bool reads_traces = true;
#endif

/// The program that pages load first does not have what was asked for.
struct More {};
using Asked = std::variant<Walkthrough, TraceFile, Complaint, More>;

/// The scene beside itself, searched with a mistake.
Asked with_mistake(const SceneFile& file, const std::string& word) {
  const std::optional<Mistake> mistake = mistake_called(word);
  if (!mistake) return Complaint{1, "mistake", "there is no mistake '" + word + "'"};
  const Scene& scene = file.walkthrough.scenes.front();
  if (scene.rules != RuleSet::as_intended || scene.certified)
    return Complaint{1, "rules",
                     "mistakes are made in the report's rules; choose \"as-intended\", and \"certified\": false"};
  Walkthrough both = beside_the_report(*mistake, scene);
  both.title = file.walkthrough.title;
  both.name = file.walkthrough.name;
  return both;
}

Asked asked_for(const Json& request) {
  if (request.contains("name")) {
    const std::string name = request["name"];
    const Walkthrough* known = find_walkthrough(name);
    return known ? Asked(*known) : Complaint{1, "name", "there is no walkthrough '" + name + "'"};
  }
  if (request.contains("trace")) {
    if constexpr (!reads_traces)
      return More();
    else {
      Reading<TraceFile> reading = trace_in(request["trace"].get<std::string>());
      return reading.complaint ? Asked(*reading.complaint) : std::move(reading.value);
    }
  }
  const std::string text = request["scene"];
  const Reading<SceneFile> reading = scene_in(text, request.value("file", "scene.json"));
  if (reading.complaint) return *reading.complaint;
  if (request.contains("mistake")) return with_mistake(reading.value, request["mistake"]);
  return reading.value.walkthrough;
}

/// Of a search, or of the right one of two of which one has a mistake.
const Scene* changeable_scene(const Walkthrough& walkthrough) {
  if (walkthrough.layout == Layout::search) return &walkthrough.scenes.front();
  const bool has_mistake = walkthrough.layout == Layout::until_they_part && walkthrough.scenes.front().mistake;
  return has_mistake ? &walkthrough.scenes.back() : nullptr;
}

// -- A story ----------------------------------------------------------------------------------------------------------

PagePictures pictures_of(const Told& told, const Look& look) {
  return {.url = [](std::size_t, int) { return std::string(); },
          .page = page_of_frame(look),
          .part = pictures_of_frame(told.walkthrough, look)};
}

/// Whether a camera looks at it.
bool is_in_space(const Told& told) {
  return std::ranges::any_of(told.walkthrough.scenes,
                             [](const Scene& scene) { return scene.dimension == Dimension::space; }) ||
         std::ranges::any_of(told.story.diagrams, &Diagram::in_space);
}

Json story_json(const Told& told, std::size_t frame, bool is_brief) {
  const PagePictures pictures = pictures_of(told, {.text = Text::none});
  const Scene* scene = changeable_scene(told.walkthrough);
  const auto only = is_brief ? std::optional(frame) : std::nullopt;
  Json answer{{"title", told.walkthrough.title},
              {"story", page_data(told.story, pictures, {}, only)},
              {"frame", frame},
              {"in_space", is_in_space(told)},
              {"scene", nullptr},
              {"mistake", nullptr},
              {"switches", Json::array()},
              {"answer", nullptr},
              {"truth", nullptr}};
  if (!scene) return answer;
  const std::optional<Mistake> mistake = told.walkthrough.scenes.front().mistake;
  if (mistake) answer["mistake"] = model::words_of::of(*mistake);
  if (!is_brief) answer["scene"] = scene_json(told.walkthrough, *scene);
  if (!is_brief) answer["switches"] = switches_of(*scene, mistake);
  answer["answer"] = to_string(answer_of(told.story.tellings.front().trace));
  if (!scene->leaves_truth_out) answer["truth"] = to_string(told.story.tellings.back().truth.answer.status);
  return answer;
}

// -- A picture --------------------------------------------------------------------------------------------------------

constexpr int least_height = 300, greatest_height = 1500;  // of panels

Look look_in(const Json& request, const StagedStory* framing) {
  Look look{.style = Style(theme_named(request.value("theme", "report"))), .text = Text::none};
  look.style = Style([&] {
    render::Theme theme = look.style.theme;
    theme.text = std::clamp(request.value("text", theme.text), render::least_text_scale, render::most_text_scale);
    return theme;
  }());
  look.height = std::clamp(request.value("height", look.height), least_height, greatest_height);
  look.turn = request.value("turn", 0.0);
  look.rise = request.value("rise", 0.0);
  look.zoom = request.value("zoom", 1.0);
  look.framing = framing;
  return look;
}

Json vector_json(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Json grips_json(const render::Canvas& canvas, const render::Box& part, const Scene& scene) {
  Json all = Json::array();
  for (const render::Grip& grip : canvas.grips()) {
    const render::Vec2 at = grip.at - part.min;
    Json each{{"name", grip.name},
              {"at", {at.x(), at.y()}},
              {"right", vector_json(grip.right)},
              {"up", vector_json(grip.up)}};
    each.update(moved_by(grip, scene));
    if (grip.value) each["value"] = vector_json(*grip.value);
    all.push_back(each);
  }
  return all;
}

/// `scene`: what can be taken hold of, if anything.
Json picture_json(const render::Canvas& canvas, const render::Box& part, const Scene* scene) {
  return {{"picture", svg_text(canvas, part)},
          {"width", part.width()},
          {"height", part.height()},
          {"grips", scene ? grips_json(canvas, part, *scene) : Json::array()}};
}

Json picture_of_frame(const Told& told, std::size_t frame, const Look& look, render::Font& font) {
  const Scene* scene = changeable_scene(told.walkthrough);
  const render::Size page = page_of_frame(look);
  render::Canvas canvas(page, page, look.style.theme.paper, font);
  draw_frame(canvas, told.story, frame, look);
  Json answer = picture_json(canvas, pictures_of_frame(told.walkthrough, look), scene);
  if (!canvas.grips().empty() || !scene) return answer;
  render::Canvas objects(objects_page, objects_page, look.style.theme.paper, font);
  draw_objects_alone(objects, told.story, frame, told.story.tellings.size() - 1, look);
  answer["objects"] = picture_json(objects, {render::Vec2::Zero(), {objects_page.width, objects_page.height}}, scene);
  return answer;
}

/// Whether pictures of one can be as large as those of the other.
bool are_alike(const Told& one, const Told& other) {
  return std::ranges::equal(one.walkthrough.scenes, other.walkthrough.scenes, {}, &Scene::dimension, &Scene::dimension);
}

}  // namespace

struct Live::Impl {
  render::Font& font;
  std::shared_ptr<const Told> told = {}, held = {};

  Json tell(const Json& request) {
    Asked asked = asked_for(request);
    if (const auto* complaint = std::get_if<Complaint>(&asked)) return error(*complaint);
    const auto* walkthrough = std::get_if<Walkthrough>(&asked);
    const bool is_known = walkthrough && std::ranges::all_of(walkthrough->scenes, model::has_search);
    if (!is_known && !std::holds_alternative<TraceFile>(asked)) return {{"more", true}};
    const std::shared_ptr<const Told> before = held ? held : told;
    if (auto* file = std::get_if<TraceFile>(&asked))
      told = std::make_shared<const Told>(std::move(*file));
    else
      told = std::make_shared<const Told>(std::move(std::get<Walkthrough>(asked)));
    std::size_t frame = 0;
    if (before && request.contains("like"))
      frame = counterpart(before->story.frames,
                          std::min(request["like"].get<std::size_t>(), before->story.frames.size() - 1),
                          told->story.frames);
    return story_json(*told, frame, request.value("brief", false));
  }

  Json draw(const Json& request) const {
    const StagedStory* framing = held && are_alike(*held, *told) ? &held->story : nullptr;
    const std::size_t frame = std::min(request.value("frame", std::size_t{0}), told->story.frames.size() - 1);
    return picture_of_frame(*told, frame, look_in(request, framing), font);
  }

  Json hold(bool holds) {
    held = holds ? told : nullptr;
    return Json::object();
  }
};

Live::Live(render::Font& font) : impl_(new Impl{font}) {}
Live::~Live() = default;

std::string Live::answer(std::string_view text) {
  const Json request = Json::parse(text);
  if (request.contains("tell")) return render::json_text(impl_->tell(request["tell"]));
  if (request.contains("draw")) return render::json_text(impl_->draw(request["draw"]));
  return render::json_text(impl_->hold(request["hold"]));
}

}  // namespace walkthroughs::live
