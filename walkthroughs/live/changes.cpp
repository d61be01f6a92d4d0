#include "walkthroughs/live/changes.hpp"

#include <cstddef>
#include <utility>
#include <variant>

#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/model/words_of.hpp"

namespace walkthroughs::live {
namespace {

using Json = PageJson;

// -- Grips ------------------------------------------------------------------------------------------------------------

/// The places that a shape without a pose stands at.
struct PlacesOf {
  const std::string& object;
  std::string shape;
  Json paths = Json::array();

  void operator()(field::Place place, const auto&) { paths.push_back(Json::array({object, shape, place.name})); }
  void operator()(field::Places, const Points& points) {
    for (std::size_t i = 0; i < points.size(); ++i) paths.push_back(Json::array({object, shape, i}));
  }
  void operator()(auto, const auto&) {}
};

/// A sum, which has no place of its own, gets a pose.
Json places_of(const std::string& key, const Object& object) {
  PlacesOf places{key, std::string(key_of(object.form))};
  if (is_at_rest(object.pose)) visit_fields(places, object.form);
  return places.paths.empty() ? Json::array({Json::array({key, "pose", "translation"})}) : places.paths;
}

const Object& object_called(const std::string& key, const Scene& scene) { return key == "a" ? scene.a : scene.b; }

// -- Switches ---------------------------------------------------------------------------------------------------------

Json choice(std::string_view text, const Json& value) { return {{"text", text}, {"value", value}}; }

Json a_switch(std::string_view key, std::string_view label, std::size_t chosen, const Json& choices) {
  return {{"key", key}, {"label", label}, {"chosen", chosen}, {"choices", choices}};
}

/// What the scene says with one of an enumeration's words.
template <class E>
Json words_switch(std::string_view key, std::string_view label, E chosen) {
  Json choices = Json::array();
  for (const std::string_view word : model::words_of::all(chosen)) choices.push_back(choice(word, word));
  return a_switch(key, label, static_cast<std::size_t>(chosen), choices);
}

Json vector(const Point& v, Dimension dimension) {
  return dimension == Dimension::plane ? Json::array({v.x(), v.y()}) : Json::array({v.x(), v.y(), v.z()});
}

/// Along x, or from the center of a to that of b.
Json start_switch(const Scene& scene) {
  const Point along_x = gjk::Options<double>{}.first_direction, now = scene.options.first_direction;
  const Point between = from_center_to_center(scene).options.first_direction;
  Json choices = Json::array({choice("along x", vector(along_x, scene.dimension)),
                              choice("between the centers", vector(between, scene.dimension))});
  if (now != along_x && now != between) choices.push_back(choice("as it is drawn", vector(now, scene.dimension)));
  return a_switch("first_direction", "Start", now == along_x ? 0 : now == between ? 1 : 2, choices);
}

Json mistake_switch(std::optional<Mistake> mistake) {
  Json choices = Json::array({choice("none", nullptr)});
  for (const auto& each : wrong_on_purpose::all())
    choices.push_back(choice(wrong_on_purpose::number_of(each.value) + ": " + std::string(each.meaning), each.word));
  return a_switch("mistake", "Mistake", mistake ? 1 + static_cast<std::size_t>(*mistake) : 0, choices);
}

/// As scene files have it.
bool can_be_certified(const Object& object) {
  return std::holds_alternative<Points>(object.form) && is_at_rest(object.pose);
}

}  // namespace

PageJson moved_by(const render::Grip& grip, const Scene& scene) {
  if (grip.name == "first_direction")
    return {{"says", "first direction"}, {"paths", Json::array({Json::array({grip.name})})}};
  const std::size_t dot = grip.name.find('.');
  const std::string key = grip.name.substr(0, dot);
  const Object& object = object_called(key, scene);
  if (dot == std::string::npos) return {{"says", object.name + ", as a whole"}, {"paths", places_of(key, object)}};
  const std::size_t bracket = grip.name.find('[') + 1;
  const auto corner = model::decimal<std::size_t>(grip.name.substr(bracket, grip.name.size() - bracket - 1)).value();
  return {{"says", "corner " + std::to_string(corner + 1) + " of " + object.name},
          {"paths", Json::array({Json::array({key, "points", corner})})}};
}

PageJson switches_of(const Scene& scene, std::optional<Mistake> mistake) {
  Json all = Json::array({words_switch("rules", "Rules", scene.rules), start_switch(scene),
                          words_switch("crossing_test", "Crossing test", scene.options.crossing_test),
                          words_switch("zero_test", "Zero test", scene.zero_test),
                          words_switch("scalar", "Numbers", scene.scalar)});
  if (can_be_certified(scene.a) && can_be_certified(scene.b))
    all.push_back(
        a_switch("certified", "Certified", scene.certified ? 1 : 0, {choice("no", false), choice("yes", true)}));
  all.push_back(mistake_switch(mistake));
  return all;
}

}  // namespace walkthroughs::live
