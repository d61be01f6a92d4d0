#include "walkthroughs/live/live.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <variant>

#include "render/json_text.hpp"
#include "render/svg_text.hpp"
#include "walkthroughs/catalogue/lesson.hpp"
#include "walkthroughs/live/aims.hpp"
#include "walkthroughs/live/changes.hpp"
#include "walkthroughs/live/trace_reader.hpp"
#include "walkthroughs/model/words_of.hpp"
#include "walkthroughs/page/page.hpp"
#include "walkthroughs/picture/draw.hpp"
#include "walkthroughs/picture/panels.hpp"
#include "walkthroughs/story/storyboard.hpp"
#include "walkthroughs/story/truth_told.hpp"
#include "walkthroughs/text/scene_text.hpp"
#include "walkthroughs/trace/trace_json.hpp"

namespace walkthroughs::live {
namespace {

using Json = PageJson;

/// A story and what it is about, which it refers to.
struct Told {
  explicit Told(Walkthrough about, const Screen* screen = nullptr)
      : walkthrough(std::move(about)), story(screen ? as_shown_on(*screen, tell(walkthrough)) : tell(walkthrough)) {}
  explicit Told(TraceFile file) : walkthrough(std::move(file.walkthrough)), story(tell(walkthrough, file.traces)) {}

  const Walkthrough walkthrough;
  const StagedStory story;
};

Json error(const Complaint& complaint) {
  return {
      {"error",
       {{"line", complaint.line}, {"key", complaint.key}, {"reason", complaint.reason}, {"text", complaint.text()}}}};
}

/// The program that pages load first lacks some searches, and with them the reader of traces.
struct Missing {};
using Asked = std::variant<Walkthrough, TraceFile, Complaint, Missing>;

bool can_be_told(const Asked& asked) {
  const auto* walkthrough = std::get_if<Walkthrough>(&asked);
  return walkthrough ? std::ranges::all_of(walkthrough->scenes, model::has_search)
                     : !std::holds_alternative<Missing>(asked);
}

Asked asked_for(const Json& request) {
  if (request.contains("name")) {
    const std::string name = request["name"];
    const Walkthrough* known = find_walkthrough(name);
    return known ? Asked(*known) : Complaint{1, "name", "there is no walkthrough '" + name + "'"};
  }
  if (request.contains("trace")) {
    std::optional<Reading<TraceFile>> reading = trace_of_page(request["trace"].get<std::string>());
    if (!reading) return Missing();
    return reading->complaint ? Asked(*reading->complaint) : std::move(reading->value);
  }
  const std::string text = request["scene"];
  Reading<SceneFile> reading = scene_in(text, request.value("file", "scene.json"));
  return reading.complaint ? Asked(*reading.complaint) : std::move(reading.value.walkthrough);
}

/// Of a search, or of the right one of two of which one has a mistake.
const Scene* changeable_scene(const Walkthrough& walkthrough) {
  if (walkthrough.layout == Layout::search) return &walkthrough.scenes.front();
  const bool has_mistake = walkthrough.layout == Layout::until_they_part && walkthrough.scenes.front().mistake;
  return has_mistake ? &walkthrough.scenes.back() : nullptr;
}

const Screen* screen_of(const Json& request) {
  const std::size_t place = request.value("screen", screens().size());
  return place < screens().size() ? &screens()[place] : nullptr;
}

// -- A story ----------------------------------------------------------------------------------------------------------

/// Whether a camera looks at it.
bool is_in_space(const Told& told) {
  return std::ranges::any_of(told.walkthrough.scenes,
                             [](const Scene& scene) { return scene.dimension == Dimension::space; }) ||
         std::ranges::any_of(told.story.diagrams, &Diagram::in_space);
}

/// Where two searches part, or where those with this mistake do.
std::string parting_in_words(const Story& story, Mistake mistake) {
  const auto there = std::ranges::find(story.frames, Focus::parting, &Frame::focus);
  if (there == story.frames.end())
    return "the searches do not part here; they do in mistakes/" + std::string(model::words_of::of(mistake));
  return "they part at step " + std::to_string(there - story.frames.begin() + 1);
}

/// What the search answers, of two the first, and what is true.
Json answers_json(const Told& told) {
  const Telling &first = told.story.tellings.front(), &right = told.story.tellings.back();
  const gjk::Status shown = answer_of(first.trace), truth = right.truth.answer.status;
  const std::optional<Mistake> mistake = first.scene.mistake;
  Json answers{{"whose", mistake ? "With " + first.scene.name : "The search"},
               {"mistake", mistake ? Json(wrong_on_purpose::description_of(*mistake).meaning) : nullptr},
               {"parting", mistake ? Json(parting_in_words(told.story, *mistake)) : nullptr},
               {"search", words_for_answer(shown)},
               {"truth", nullptr},
               {"is_wrong", shown != gjk::Status::undecided && is_otherwise(right.truth, shown)}};
  if (!right.scene.leaves_truth_out)
    answers["truth"] = truth == gjk::Status::undecided ? "not known" : words_for_answer(truth);
  return answers;
}

Json story_json(const Told& told, std::size_t frame, bool is_brief, render::Font& font) {
  const PagePictures drawn_by_the_page{.url = [](std::size_t, int) { return std::string(); }, .font = &font};
  const Scene* scene = changeable_scene(told.walkthrough);
  const auto only = is_brief ? std::optional(frame) : std::nullopt;
  Json answer{{"title", told.walkthrough.title},
              {"story", page_data(told.story, drawn_by_the_page, {}, only)},
              {"frame", frame},
              {"in_space", is_in_space(told)},
              {"scene", nullptr},
              {"switches", Json::array()},
              {"answers", nullptr}};
  if (!scene) return answer;
  answer["answers"] = answers_json(told);
  if (is_brief) return answer;
  answer["scene"] = scene_json(told.walkthrough, *scene);
  answer["switches"] = switches_of(*scene, told.walkthrough.scenes.front().mistake);
  return answer;
}

// -- A picture --------------------------------------------------------------------------------------------------------

constexpr int least_height = 300, greatest_height = 1500;  // of panels

Look look_in(const Json& request) {
  render::Theme theme = theme_named(request.value("theme", "report"));
  theme.text = std::clamp(request.value("text", theme.text), render::least_text_scale, render::most_text_scale);
  Look look{.style = Style(theme), .text = Text::none, .grips = true};
  look.height = std::clamp(request.value("height", look.height), least_height, greatest_height);
  look.stacked = request.value("stacked", false);
  look.turn = request.value("turn", 0.0);
  look.rise = request.value("rise", 0.0);
  look.zoom = request.value("zoom", 1.0);
  return look;
}

Json vector_json(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Json grips_json(const render::Canvas& canvas, const render::Box& part, const Scene& scene) {
  Json all = Json::array();
  for (const render::Grip& grip : canvas.grips()) {
    if (grip.name.starts_with(difference_grip)) continue;
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

/// `asked`: a question, or the direction that comes next.
Json aims_json(const Told& told, std::size_t frame, const Json& asked, const render::Canvas& canvas,
               const render::Box& part) {
  if (asked == "direction") return aims_at_direction(told.story, frame, canvas, part);
  const std::vector<Question> questions = in_frames(questions_of(told.story), told.story);
  const std::size_t place = asked.get<std::size_t>();
  return place < questions.size() ? aims_at_choices(questions[place], canvas, part) : Json::array();
}

Json picture_of_frame(const Told& told, std::size_t frame, const Look& look, const Json& asked, render::Font& font) {
  const Scene* scene = changeable_scene(told.walkthrough);
  const render::Size page = page_of_frame(look);
  render::Canvas canvas(page, page, look.style.theme.paper, font);
  draw_frame(canvas, told.story, frame, look);
  const render::Box part = pictures_of_frame(told.walkthrough, look);
  Json answer = picture_json(canvas, part, scene);
  if (!asked.is_null()) answer["aims"] = aims_json(told, frame, asked, canvas, part);
  if (!answer["grips"].empty() || !scene) return answer;
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
  std::shared_ptr<const Told> told = {}, held = {}, cameras = {};

  Json tell(const Json& request) {
    Asked asked = asked_for(request);
    if (const auto* complaint = std::get_if<Complaint>(&asked)) return error(*complaint);
    if (!can_be_told(asked)) return {{"more", true}};
    const std::shared_ptr<const Told> before = held ? held : told;
    const Screen* screen = screen_of(request);
    if (auto* file = std::get_if<TraceFile>(&asked))
      told = std::make_shared<const Told>(std::move(*file));
    else
      told = std::make_shared<const Told>(std::move(std::get<Walkthrough>(asked)), screen);
    Json answer;
    if (before && request.contains("like")) {
      const std::vector<Frame>& known = before->story.frames;
      const std::size_t like = std::min(request["like"].get<std::size_t>(), known.size() - 1);
      answer = story_json(*told, counterpart(known, like, told->story.frames), request.value("brief", false), font);
    } else {
      cameras = nullptr;
      answer = story_json(*told, screen ? first_frame(*screen, told->story) : 0, false, font);
    }
    if (screen) answer["is_done"] = screen->is_done && screen->is_done(told->story);
    return answer;
  }

  Json draw(const Json& request) const {
    Look look = look_in(request);
    if (held && are_alike(*held, *told)) look.framing = &held->story;
    if (cameras && are_alike(*cameras, *told)) look.cameras = &cameras->story;
    const std::size_t frame = std::min(request.value("frame", std::size_t{0}), told->story.frames.size() - 1);
    return picture_of_frame(*told, frame, look, request.value("asks", Json()), font);
  }

  Json hold(bool holds) {
    held = holds ? told : nullptr;
    if (holds && !cameras) cameras = told;
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
