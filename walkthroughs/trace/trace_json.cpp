#include "walkthroughs/trace/trace_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "render/json_text.hpp"
#include "walkthroughs/model/event_fields.hpp"
#include "walkthroughs/model/moment.hpp"
#include "walkthroughs/model/scene.hpp"
#include "walkthroughs/model/words_of.hpp"

namespace walkthroughs::trace {
namespace {

using Json = nlohmann::ordered_json;  // keys in the order in which a reader wants them

/// What is not finite has no number in JSON and is a word.
Json json(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value;
}

Json json(const Point& p) { return {json(p.x()), json(p.y()), json(p.z())}; }

Json json(gjk::IndexPair pair) { return {pair.a, pair.b}; }

Json json(const AnyShape& shape);

template <Record R>
Json json(const R& record);

template <class List>
Json list_json(const List& list) {
  Json all = Json::array();
  for (const auto& each : list) all.push_back(json(each));
  return all;
}

/// Writes the fields of a shape, as in scene files.
struct FieldWriter {
  Json& to;

  void operator()(field::Place place, const Point& p) const { to[std::string(place.name)] = json(p); }
  void operator()(field::Direction direction, const Point& d) const { to[std::string(direction.name)] = json(d); }
  void operator()(field::Length length, double x) const { to[std::string(length.name)] = x; }
  void operator()(field::Size size, const Point& p) const { to[std::string(size.name)] = json(p); }
  void operator()(field::Places, const Points& points) const { to = list_json(points); }
  void operator()(field::Shapes, const std::vector<AnyShape>& summands) const { to = list_json(summands); }
};

Json json(const AnyShape& shape) {
  Json fields;
  visit_fields(FieldWriter{fields}, shape);
  return {{std::string(key_of(shape)), fields}};
}

Json json(const Eigen::Matrix3d& rotation) {
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row) rows.push_back(json(Point(rotation.row(row))));
  return rows;
}

Json json(const Object& object) {
  Json j{{"name", object.name}};
  j.update(json(object.form));
  if (!is_at_rest(object.pose)) j["pose"] = json(object.pose);
  return j;
}

Json json(Dimension dimension) { return dimension == Dimension::plane ? 2 : 3; }

Json json(const Panels& panels) { return words_of::of(panels); }
Json json(bool truth) { return truth; }
Json json(int count) { return count; }
Json json(const std::string& text) { return text; }
Json json(const gjk::Roles& roles) { return to_string(roles); }
Json json(const gjk::Expression& expression) { return to_string(expression); }

template <class E>
requires std::is_enum_v<E> Json json(E enumerator) { return words_of::of(enumerator); }

Json json(const std::variant<std::monostate, double, Point>& value) {
  if (const double* number = std::get_if<double>(&value)) return json(*number);
  return json(std::get<Point>(value));
}

/// Oldest first, newest (A) last.
Json json(const gjk::Simplex<double>& simplex) { return list_json(simplex); }

Json json(const gjk::IndexPairs& pairs) { return list_json(pairs); }

Json json(const gjk::Certificate& certificate) {
  if (const auto* direction = std::get_if<gjk::SeparatingDirection>(&certificate))
    return {{"direction", json(direction->d)}};
  if (const auto* feature = std::get_if<gjk::SeparatingFeature>(&certificate)) return {{"nearest", json(feature->of)}};
  return {{"simplex", json(std::get<gjk::CommonSimplex>(certificate).of)}};
}

template <Record R>
Json json(const std::vector<R>& records) {
  return list_json(records);
}

template <class T>
Json json(const std::optional<T>& value) {
  return json(*value);
}

template <Record R>
Json json(const R& record) {
  Json j = Json::object();
  for_each_field(record, [&j](const auto& field, const auto& value) {
    if (field.is_left_out_where_empty && is_empty(value)) return;
    if (!field.beside.empty() && !j.contains(field.beside)) return;
    if constexpr (requires { field.word; })
      j[std::string(field.key)] = field.word;
    else
      j[std::string(field.key)] = json(value);
  });
  return j;
}

Json json(const gjk::Event<double>& event) {
  Json line{{"iteration", std::visit([](const auto& e) { return e.iteration; }, event)},
            {"event", event_names[event.index()]}};
  line.update(std::visit([](const auto& e) { return json(e); }, event));
  return line;
}

/// Takes the third number from each point and vector.
void flatten(Json& value) {
  const bool is_vector = value.is_array() && value.size() == 3 && value[0].is_number();
  if (is_vector) value.erase(2);
  for (Json& each : value)
    if (each.is_structured()) flatten(each);
}

}  // namespace

Json scene_json(const Walkthrough& walkthrough, const Scene& scene) {
  Scene as_read = scene;
  as_read.a = a_as_read(scene);
  as_read.b = b_as_read(scene);
  Json file{{"title", walkthrough.title}};
  file.update(json(as_read));
  for (const char* key : {"name", "a_as_read", "b_as_read"}) file.erase(key);
  if (const std::optional<Mistake> mistake = walkthrough.scenes.front().mistake) file["mistake"] = json(*mistake);
  if (scene.leaves_truth_out) file["truth"] = false;
  if (scene.dimension == Dimension::plane)
    for (const char* key : {"a", "b", "first_direction"}) flatten(file[key]);
  file["panels"] = json(walkthrough.panels);
  if (walkthrough.naming != Naming::roles) file["letters"] = "fixed";
  return file;
}

Json event_json(const gjk::Event<double>& event) { return json(event); }

Json truth_json(const Scene& scene, const Truth& truth, gjk::Status shown) {
  if (!says_more(truth, shown)) return nullptr;
  Json line{{"scene", scene.name}, {"event", "truth"}, {"status", json(truth.answer.status)}};
  if (truth.answer.nearest.size() > 0) line["nearest"] = json(truth.answer.nearest);
  if (is_open(truth) && std::isfinite(truth.answer.gap)) line["gap"] = truth.answer.gap;
  if (truth.of_decimals) line["of_decimals"] = json(*truth.of_decimals);
  if (truth.by_rounded_turn) line["by_rounded_turn"] = true;
  if (truth.exchanged) line["exchanged"] = json(*truth.exchanged);
  return line;
}

std::string traces_json(const Walkthrough& walkthrough, const std::vector<Trace>& traces,
                        const std::vector<Truth>& truths) {
  Json header{{"schema", "gjkstep-trace"}, {"version", trace_version},          {"walkthrough", walkthrough.name},
              {"scalar", "double"},        {"presentation", json(walkthrough)}, {"scenes", json(walkthrough.scenes)}};
  std::string lines = render::json_text(header) + '\n';
  for (std::size_t s = 0; s < traces.size(); ++s) {
    for (const gjk::Event<double>& event : traces[s].events) {
      Json line{{"scene", walkthrough.scenes[s].name}};
      line.update(json(event));
      lines += render::json_text(line) + '\n';
    }
    if (const Json truth = truth_json(walkthrough.scenes[s], truths[s], answer_of(traces[s])); !truth.is_null())
      lines += render::json_text(truth) + '\n';
  }
  return lines;
}

}  // namespace walkthroughs::trace
