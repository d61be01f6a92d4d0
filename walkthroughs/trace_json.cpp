#include "walkthroughs/trace_json.hpp"

#include <nlohmann/json.hpp>
#include <variant>

namespace walkthroughs {
namespace {

using Json = nlohmann::ordered_json;  // keys in the order in which a reader wants them

Json json(const Point& p) { return {p.x(), p.y(), p.z()}; }

Json json(const gjk::SupportPoint<double>& support) {
  Json j{{"point", json(support.point)}};
  if (support.index) j["index"] = *support.index;
  return j;
}

Json json(const gjk::Vertex<double>& vertex) {
  return {{"w", json(vertex.w)}, {"a", json(vertex.a)}, {"b", json(vertex.b)}};
}

/// Oldest first, newest (A) last.
Json json(const gjk::Simplex<double>& simplex) {
  Json list = Json::array();
  for (int i = 0; i < simplex.size(); ++i) list.push_back(json(simplex[i]));
  return list;
}

/// The form of an object, as in scene files.
struct FormJson {
  Json operator()(const Points& set) const {
    Json list = Json::array();
    for (const Point& p : set.points()) list.push_back(json(p));
    return {{"points", list}};
  }
  Json operator()(const Ball& ball) const {
    return {{"sphere", {{"center", json(ball.center())}, {"radius", ball.radius()}}}};
  }
  Json operator()(const Cylinder& cylinder) const {
    return {{"cylinder",
             {{"center", json(cylinder.center())},
              {"axis", json(cylinder.to_cap())},
              {"radius", cylinder.radius()},
              {"height", 2 * cylinder.to_cap().norm()}}}};
  }
};

Json json(const Object& object) {
  Json j{{"name", object.name}};
  j.update(std::visit(FormJson{}, object.form));
  if (!object.pose.rotation.isIdentity(0) || !object.pose.translation.isZero(0)) {
    Json rows = Json::array();
    for (int row = 0; row < 3; ++row) rows.push_back(json(Point(object.pose.rotation.row(row))));
    j["pose"] = {{"rotation", rows}, {"translation", json(object.pose.translation)}};
  }
  return j;
}

Json json(const Scene& scene) {
  return {{"name", scene.name},
          {"a", json(scene.a)},
          {"b", json(scene.b)},
          {"first_direction", json(scene.options.first_direction)},
          {"iteration_limit", scene.options.iteration_limit},
          {"crossing_test", scene.options.crossing_test == gjk::CrossingTest::on ? "on" : "off"},
          {"rules", scene.rules == RuleSet::as_intended ? "as-intended" : "as-printed"}};
}

const char* text(gjk::Crossing verdict) {
  switch (verdict) {
    case gjk::Crossing::crossed: return "crossed";
    case gjk::Crossing::not_crossed: return "not-crossed";
    case gjk::Crossing::first_point: return "not-applied-first-point";
    case gjk::Crossing::switched_off: return "not-applied-switched-off";
  }
  return "";
}

const char* text(gjk::Relation relation) {
  switch (relation) {
    case gjk::Relation::positive: return "> 0";
    case gjk::Relation::negative: return "< 0";
    case gjk::Relation::zero: return "= 0";
    case gjk::Relation::not_zero: return "!= 0";
  }
  return "";
}

const char* text(gjk::Verdict verdict) {
  switch (verdict) {
    case gjk::Verdict::chosen: return "chosen";
    case gjk::Verdict::rejected: return "rejected";
    case gjk::Verdict::skipped: return "skipped";
  }
  return "";
}

/// One overload for each event: its name and what it carries. What an event does not have is left out.
struct EventJson {
  Json operator()(const gjk::SearchStarted<double>& e) const {
    return {{"event", "search-started"}, {"direction", json(e.direction)}, {"why", e.why}};
  }
  Json operator()(const gjk::SupportFound<double>& e) const {
    Json j{{"event", "support-found"}, {"direction", json(e.direction)}};
    j.update(json(e.vertex));
    j["new"] = e.is_new;
    return j;
  }
  Json operator()(const gjk::CrossingTested<double>& e) const {
    Json j{{"event", "crossing-tested"}};
    if (e.value) j["value"] = *e.value;
    j["verdict"] = text(e.verdict);
    return j;
  }
  Json operator()(const gjk::VertexAdded<double>& e) const {
    return {{"event", "vertex-added"}, {"simplex", json(e.simplex)}};
  }
  Json operator()(const gjk::RegionTested<double>& e) const {
    Json j{{"event", "region-tested"}, {"simplex_size", e.simplex_size}, {"feature", e.feature}};
    if (!e.label.empty()) j["region"] = e.label;
    if (!e.face.empty()) j["face"] = e.face;
    if (!e.expression.empty()) j["expression"] = e.expression;
    if (!e.formula.empty()) j["formula"] = e.formula;
    if (e.normal) j["normal"] = json(*e.normal);
    if (const double* value = std::get_if<double>(&e.value)) j["value"] = *value;
    if (const Point* value = std::get_if<Point>(&e.value)) j["value"] = json(*value);
    if (j.contains("value")) j["relation"] = text(e.relation);
    j["verdict"] = text(e.verdict);
    j["reason"] = e.reason;
    return j;
  }
  Json operator()(const gjk::SimplexReduced<double>& e) const {
    return {{"event", "simplex-reduced"}, {"before", json(e.before)},
            {"after", json(e.after)},     {"kept", e.kept},
            {"dropped", e.dropped},       {"why", e.why}};
  }
  Json operator()(const gjk::DirectionChosen<double>& e) const {
    return {{"event", "direction-chosen"}, {"expression", e.expression}, {"direction", json(e.direction)}};
  }
  Json operator()(const gjk::Finished<double>& e) const {
    Json j{{"event", "finished"},
           {"status", gjk::to_string(e.result.status)},
           {"reason", gjk::to_string(e.result.reason)},
           {"iterations", e.result.iterations},
           {"simplex", json(e.result.simplex)}};
    if (const auto& proof = e.result.separation)
      j["separation"] = {{"direction", json(proof->direction)},
                         {"vertex", json(proof->vertex)},
                         {"support_value", proof->support_value}};
    return j;
  }
};

Json json(const gjk::Event<double>& event) {
  Json line{{"iteration", std::visit([](const auto& e) { return e.iteration; }, event)}};
  line.update(std::visit(EventJson{}, event));
  return line;
}

}  // namespace

std::string event_json(const gjk::Event<double>& event) { return json(event).dump(); }

void write_traces(std::ostream& out, const Walkthrough& walkthrough) {
  Json header{{"schema", "gjkstep-trace"},
              {"version", trace_version},
              {"walkthrough", walkthrough.name},
              {"scalar", "double"},
              {"scenes", Json::array()}};
  for (const Scene& scene : walkthrough.scenes) header["scenes"].push_back(json(scene));
  out << header.dump() << '\n';
  for (const Scene& scene : walkthrough.scenes) {
    for (const gjk::Event<double>& event : run(scene).events) {
      Json line{{"scene", scene.name}};
      line.update(json(event));
      out << line.dump() << '\n';
    }
  }
}

}  // namespace walkthroughs
