#include <nlohmann/json.hpp>
#include <type_traits>

#include "render/json_text.hpp"
#include "walkthroughs/model/event_fields.hpp"
#include "walkthroughs/model/words_of.hpp"
#include "walkthroughs/trace/trace_json.hpp"
#include "walkthroughs/trace/trace_limits.hpp"

namespace walkthroughs::trace {
namespace {

using Json = nlohmann::ordered_json;

// -- Parts of schemas -------------------------------------------------------------------------------------------------

Json reference(const std::string& definition) { return {{"$ref", "#/$defs/" + definition}}; }

Json one_of(const auto& words) { return {{"enum", words}}; }

Json text(std::size_t longest) { return {{"type", "string"}, {"minLength", 1}, {"maxLength", longest}}; }

Json list_of(const Json& items, std::size_t least, std::size_t most) {
  return {{"type", "array"}, {"items", items}, {"minItems", least}, {"maxItems", most}};
}

/// An object that has these keys and no others.
Json object(const Json& properties, const Json& required) {
  return {{"type", "object"}, {"additionalProperties", false}, {"required", required}, {"properties", properties}};
}

Json described(const std::string& description, const Json& schema) {
  Json whole{{"description", description}};
  whole.update(schema);
  return whole;
}

// -- What a field may hold, by its type -------------------------------------------------------------------------------

template <class T>
struct Holds {};

Json schema(Holds<double>, Meaning) { return reference("number"); }
Json schema(Holds<Point>, Meaning meaning) { return reference(meaning == Meaning::direction ? "point" : "vector"); }
Json schema(Holds<std::variant<std::monostate, double, Point>>, Meaning) {
  return {{"anyOf", {reference("number"), reference("vector")}}};
}
Json schema(Holds<bool>, Meaning) { return {{"type", "boolean"}}; }
Json schema(Holds<int>, Meaning meaning) {
  const auto [least, most] = range_of(meaning);
  return {{"type", "integer"}, {"minimum", least}, {"maximum", most}};
}
Json schema(Holds<std::string>, Meaning meaning) {
  switch (meaning) {
    case Meaning::name: return text(scene_limits::name);
    case Meaning::title: return text(scene_limits::title);
    case Meaning::sentence: return reference("text");
    default: return {{"type", "string"}, {"pattern", "^-?[0-9]+(/[0-9]+)?$"}};  // an exact fraction
  }
}
Json schema(Holds<gjk::Roles>, Meaning) { return {{"type", "string"}, {"pattern", "^[A-D]{1,4}$"}}; }
Json schema(Holds<gjk::Expression>, Meaning) { return {{"type", "string"}, {"pattern", "^[−()A-DOnwdmaxyz·×. ]+$"}}; }
Json schema(Holds<Dimension>, Meaning) { return one_of(std::array{2, 3}); }
Json schema(Holds<Panels>, Meaning) {
  Json panels = list_of(one_of(words_of::panels), 0, words_of::panels.size());
  panels["uniqueItems"] = true;
  return panels;
}
Json schema(Holds<Eigen::Matrix3d>, Meaning) {
  return described("The rows of an orthogonal matrix of determinant 1.", list_of(reference("point"), 3, 3));
}
Json schema(Holds<Object>, Meaning) { return reference("object"); }
Json schema(Holds<gjk::SupportPoint<double>>, Meaning) { return reference("support"); }
Json schema(Holds<gjk::Vertex<double>>, Meaning) { return reference("vertex"); }
Json schema(Holds<gjk::Simplex<double>>, Meaning) { return reference("simplex"); }
Json schema(Holds<gjk::Certificate>, Meaning) {
  Json one = object({{"direction", reference("vector")},
                     {"nearest", reference("index_pairs")},
                     {"simplex", reference("index_pairs")}},
                    Json::array());
  one["minProperties"] = one["maxProperties"] = 1;
  return described(
      "A direction d with a·d < b·d for all points; or index pairs (i, j) of points of the difference: the point of "
      "their hull nearest to the origin separates, or their hull holds the origin.",
      one);
}

template <class E>
requires std::is_enum_v<E> Json schema(Holds<E>, Meaning) { return one_of(words_of::all(E{})); }

template <Record R>
Json schema(Holds<R>, Meaning);

template <Record R>
Json schema(Holds<std::vector<R>>, Meaning meaning) {
  return list_of(schema(Holds<R>{}, meaning), 0, trace_limits::remarks);
}

template <class T>
Json schema(Holds<std::optional<T>>, Meaning meaning) {
  return schema(Holds<T>{}, meaning);
}

/// Adds the fields of a record to those of `whole`.
template <Record R>
void add_fields(Json& whole) {
  const auto add = [&](const auto& field, const auto& schema_of_field) {
    const std::string key(field.key);
    whole["properties"][key] = schema_of_field;
    if (!field.may_be_missing()) whole["required"].push_back(key);
    if (!field.beside.empty()) {
      whole["dependentRequired"][key].push_back(field.beside);
      whole["dependentRequired"][std::string(field.beside)].push_back(key);
    }
  };
  R record{};
  for_each_field(record, [&](const auto& field, const auto& value) {
    if constexpr (requires { field.word; })
      add(field, Json{{"const", field.word}});
    else if constexpr (requires { field.meaning; })
      add(field, schema(Holds<std::remove_cvref_t<decltype(value)>>{}, field.meaning));
    else
      add(field, Json{{"type", "string"}, {"maxLength", trace_limits::words}});
  });
}

template <Record R>
Json record() {
  Json whole = object(Json::object(), Json::array());
  add_fields<R>(whole);
  return whole;
}

template <Record R>
Json schema(Holds<R>, Meaning) {
  return record<R>();
}

// -- Shapes -----------------------------------------------------------------------------------------------------------

Json schema(field::Place) { return reference("point"); }
Json schema(field::Direction) { return reference("point"); }
Json schema(field::Length) { return reference("length"); }
Json schema(field::Size) { return list_of(reference("length"), 3, 3); }
Json schema(field::Places) { return list_of(reference("point"), 1, scene_limits::points); }
Json schema(field::Shapes) {
  Json summand = reference("shape");
  summand["maxProperties"] = 1;
  return list_of(summand, 2, 2);
}

template <class Shape>
Json shape_value() {
  Json fields = object(Json::object(), Json::array()), whole;
  ShapeRow<Shape>::fields([&](const auto& field) {
    if constexpr (requires { field.name; }) {
      fields["properties"][std::string(field.name)] = schema(field);
      fields["required"].push_back(field.name);
    } else {
      whole = schema(field);
    }
  });
  return whole.is_null() ? fields : whole;
}

Json shape() {
  Json shape{{"type", "object"}, {"properties", Json::object()}, {"oneOf", Json::array()}};
  for_each_kind([&]<class Shape>(std::type_identity<Shape>) {
    shape["properties"][std::string(ShapeRow<Shape>::key)] = shape_value<Shape>();
    shape["oneOf"].push_back({{"required", {ShapeRow<Shape>::key}}});
  });
  return shape;
}

// -- The whole --------------------------------------------------------------------------------------------------------

constexpr std::string_view name_pattern =
    "^[A-Za-z0-9_\u00A1-\U0010FFFF-][A-Za-z0-9._\u00A1-\U0010FFFF-]*(/[A-Za-z0-9_\u00A1-\U0010FFFF-]"
    "[A-Za-z0-9._\u00A1-\U0010FFFF-]*)*$";

Json header() {
  const Json properties{
      {"schema", {{"const", "gjkstep-trace"}}},
      {"version", one_of(std::array{oldest_trace_version, trace_version})},
      {"walkthrough",
       described("Names a folder of pictures.", {{"type", "string"}, {"pattern", name_pattern}, {"maxLength", 200}})},
      {"scalar", {{"const", "double"}}},
      {"presentation", described("What the pictures need and the search does not.", record<Walkthrough>())},
      {"scenes", list_of(reference("scene"), 1, 2)}};
  return object(properties, {"schema", "version", "walkthrough", "scalar", "presentation", "scenes"});
}

template <class E>
Json event() {
  Json line = object({{"scene", {{"type", "string"}}},
                      {"iteration", schema(Holds<int>{}, Meaning::iterations)},
                      {"event", {{"const", FieldsOf<E>::event}}}},
                     {"scene", "iteration", "event"});
  add_fields<E>(line);
  return line;
}

Json truth() {
  const Json status = schema(Holds<gjk::Status>{}, Meaning::plain);
  return described(
      "What is true beside the answer of a scene; behind its events, where that is more than they say. 'status' is "
      "proven of the objects as read, by 'nearest': index pairs of points whose differences are the feature nearest to "
      "the origin, or hold it. Where nothing is proven they are nearer to contact than 'gap'. 'of_decimals' is the "
      "answer about the shortest decimals of the numbers, 'exchanged' "
      "that "
      "of the search with a and b exchanged, where these are others. 'by_rounded_turn' where rounding the matrix of a "
      "turn "
      "may have decided.",
      object({{"scene", {{"type", "string"}}},
              {"event", {{"const", "truth"}}},
              {"status", status},
              {"nearest", reference("index_pairs")},
              {"gap", {{"type", "number"}}},
              {"of_decimals", status},
              {"by_rounded_turn", {{"const", true}}},
              {"exchanged", status}},
             {"scene", "event", "status"}));
}

Json definitions() {
  const Json number{{"anyOf", {{{"type", "number"}}, one_of(std::array{"inf", "-inf", "nan"})}}};
  Json object_of_scene = reference("shape");
  object_of_scene["unevaluatedProperties"] = false;
  object_of_scene["required"] = {"name"};
  object_of_scene["properties"] = {{"name", text(scene_limits::name)}, {"pose", reference("pose")}};
  Json defs{
      {"text", described("Words, which nothing follows from.", text(trace_limits::words))},
      {"number", described("A double; what is not finite is a word.", number)},
      {"length", {{"type", "number"}, {"minimum", 0}, {"maximum", scene_limits::magnitude}}},
      {"finite", {{"type", "number"}, {"minimum", -scene_limits::magnitude}, {"maximum", scene_limits::magnitude}}},
      {"point", described("A point of a scene, in its own unit of length.", list_of(reference("finite"), 3, 3))},
      {"vector", list_of(reference("number"), 3, 3)},
      {"support", described("With its position in the list of points; round objects have none.",
                            record<gjk::SupportPoint<double>>())},
      {"vertex", described("A point of the Minkowski difference: w = a - b.", record<gjk::Vertex<double>>())},
      {"simplex", described("Oldest first; the newest is A, then B, C, D.", list_of(reference("vertex"), 0, 4))},
      {"index_pairs", list_of(list_of(schema(Holds<int>{}, Meaning::position), 2, 2), 1, 4)},
      {"shape", shape()},
      {"pose", described("The object is turned about the origin, then moved.", record<Pose>())},
      {"object", described("A shape with a name and perhaps a pose.", object_of_scene)},
      {"scene", record<Scene>()},
      {"header", described("The first line.", header())},
      {"truth", truth()}};
  const auto add_events = [&]<class... Events>(std::type_identity<std::variant<Events...>>) {
    ((defs[std::string(FieldsOf<Events>::event)] = event<Events>()), ...);
  };
  add_events(std::type_identity<gjk::Event<double>>{});
  return defs;
}

}  // namespace

std::string trace_schema() {
  Json lines = Json::array({reference("header")});
  for (const std::string_view name : event_names) lines.push_back(reference(std::string(name)));
  lines.push_back(reference("truth"));
  const Json whole{
      {"$schema", "https://json-schema.org/draft/2020-12/schema"},
      {"title", "One line of a trace of gjkstep, version " + std::to_string(trace_version)},
      {"description",
       "A trace is JSON Lines: a header, then the events of each scene in order. That they are what the search says is "
       "checked by `gjkstep render --from-trace`."},
      {"oneOf", lines},
      {"$defs", definitions()}};
  return render::json_text(whole, 2) + '\n';
}

}  // namespace walkthroughs::trace
