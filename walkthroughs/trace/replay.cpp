#include "walkthroughs/trace/replay.hpp"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "render/json_text.hpp"
#include "walkthroughs/model/event_fields.hpp"
#include "walkthroughs/model/scene.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/trace/trace_json.hpp"

namespace walkthroughs::trace {
namespace {

using Json = nlohmann::ordered_json;

// -- The search, run again --------------------------------------------------------------------------------------------

/// Answers with the points that a trace has found, one after another; where there are no more with what is no number, upon which
/// any search ends.
class Recorded {
 public:
  Recorded(const Scene& scene, const std::vector<gjk::Event<double>>& events) : scene_(scene) {
    for (std::size_t i = 0; i < events.size(); ++i)
      if (const auto* found = std::get_if<gjk::SupportFound<double>>(&events[i])) found_.push_back({i, &found->vertex});
  }

  SupportFunctions supports() {
    return {[this](const Point& d) { return answer(asked_of_a_++, d, "a", scene_.a, &gjk::Vertex<double>::a); },
            [this](const Point& d) { return answer(asked_of_b_++, d, "b", scene_.b, &gjk::Vertex<double>::b); }};
  }

  /// The first answer that is not the farthest point of its object.
  const std::optional<Parting>& wrong() const { return wrong_; }

 private:
  struct Found {
    std::size_t event;
    const gjk::Vertex<double>* vertex;
  };

  gjk::SupportPoint<double> answer(std::size_t call, const Point& d, const std::string& key, const Object& object,
                                   gjk::SupportPoint<double> gjk::Vertex<double>::*of_object) {
    if (call >= found_.size()) return {Point::Constant(std::numeric_limits<double>::quiet_NaN()), {}};
    const gjk::SupportPoint<double>& point = found_[call].vertex->*of_object;
    if (!wrong_)
      if (const std::string objection = objection_to(point, object, d, scene_.scalar); !objection.empty())
        wrong_ = {found_[call].event, in_quotes(key) + " " + objection};
    return point;
  }

  const Scene& scene_;
  std::vector<Found> found_;
  std::size_t asked_of_a_ = 0, asked_of_b_ = 0;
  std::optional<Parting> wrong_;
};

// -- Comparing --------------------------------------------------------------------------------------------------------

bool is_list_of_records(const Json& json) { return json.is_array() && !json.empty() && json[0].is_object(); }

std::string said(const Json* json) { return json ? render::json_text(*json) : "missing"; }

/// Returns: the first field in which two values differ, and what it is in both. Requires: that they differ.
std::string difference(const Json* trace, const Json* search, const std::string& key) {
  const bool are_lists = trace && search && is_list_of_records(*trace) && is_list_of_records(*search);
  if (are_lists && trace->size() == search->size()) {
    for (std::size_t i = 0; i < trace->size(); ++i)
      if (const Json& t = (*trace)[i], &s = (*search)[i]; said(&t) != said(&s))
        return difference(&t, &s, key + "[" + std::to_string(i) + "]");
  }
  if (trace && search && trace->is_object() && search->is_object()) {
    const auto within = [&](const std::string& name) { return key.empty() ? name : key + "." + name; };
    for (const auto& [name, of_search] : search->items()) {
      const auto found = trace->find(name);
      const Json* const of_trace = found == trace->end() ? nullptr : &*found;
      if (said(of_trace) != said(&of_search)) return difference(of_trace, &of_search, within(name));
    }
    for (const auto& [name, of_trace] : trace->items())
      if (!search->contains(name)) return difference(&of_trace, nullptr, within(name));
  }
  return in_quotes(key) + " is " + said(trace) + ", but the search says " + said(search);
}

/// Returns: empty where the events are the same.
std::string difference(const gjk::Event<double>& trace, const gjk::Event<double>& search) {
  const Json of_trace = event_json(trace), of_search = event_json(search);
  if (said(&of_trace) == said(&of_search)) return "";
  if (trace.index() != search.index())
    return in_quotes(event_names[trace.index()]) + " stands here, but the search says " +
           in_quotes(event_names[search.index()]);
  return difference(&of_trace, &of_search, "");
}

std::optional<Parting> first_difference(const std::vector<gjk::Event<double>>& trace,
                                        const std::vector<gjk::Event<double>>& search) {
  for (std::size_t i = 0; i < std::min(trace.size(), search.size()); ++i)
    if (std::string what = difference(trace[i], search[i]); !what.empty()) return Parting{i, std::move(what)};
  if (trace.size() < search.size()) return Parting{trace.size(), in_quotes(event_names[search[trace.size()].index()])};
  return std::nullopt;
}

}  // namespace

std::optional<Parting> parting_from_search(const Scene& scene, const std::vector<gjk::Event<double>>& events) {
  if (scene.certified) return first_difference(events, run(scene).events);
  Recorded recorded(scene, events);
  const Trace search = run(scene, recorded.supports());
  const std::optional<Parting> different = first_difference(events, search.events);
  const bool is_point_first = recorded.wrong() && (!different || recorded.wrong()->event < different->event);
  return is_point_first ? recorded.wrong() : different;
}

std::string objection_to_truth(std::string_view line, const Json& expected) {
  const Json found = Json::parse(line, nullptr, false);
  return said(&found) == said(&expected) ? "" : "is " + said(&found) + ", but the truth is " + said(&expected);
}

bool is_last(const gjk::Event<double>& event, const Scene& scene) {
  return event.index() == (scene.certified ? event_index<gjk::Certified> : event_index<gjk::Finished>);
}

}  // namespace walkthroughs::trace
