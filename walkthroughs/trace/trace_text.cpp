#include "walkthroughs/trace/trace_text.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "walkthroughs/model/moment.hpp"
#include "walkthroughs/model/truth.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/trace/replay.hpp"
#include "walkthroughs/trace/trace_json.hpp"
#include "walkthroughs/trace/trace_lines.hpp"

namespace walkthroughs::trace {
namespace {

using namespace text::reading;

using Events = std::vector<gjk::Event<double>>;

Complaint about(std::size_t line, std::string reason) { return {static_cast<int>(line), "", std::move(reason)}; }

/// Takes the lines of a trace off the front of its text.
struct Lines {
  std::string_view rest;
  std::size_t taken = 0;

  /// Returns: the next one.
  std::string_view next_text() const { return rest.substr(0, rest.find('\n')); }

  /// Takes one and reads it. Returns: what is wrong with it. One without line break behind it may be all that is left of one.
  template <class Read>
  std::optional<Complaint> next(const Read& read) {
    const std::size_t end = rest.find('\n');
    const bool is_ended = end != std::string_view::npos;
    const std::string_view text = rest.substr(0, end);
    rest.remove_prefix(is_ended ? end + 1 : rest.size());
    ++taken;
    if (text.find_first_not_of(" \t\r") == std::string_view::npos)
      return about(taken, "is empty, but a trace has an event on each line. " + trace_advice);
    const Document document(text, Document::Comments::refused);
    if (document.complaint() && !is_ended)
      return about(taken, "the line ends in the middle, so the trace is cut off. " + trace_advice);
    if (!document.complaint()) read(document.root());
    std::optional<Complaint> complaint = document.complaint();
    if (complaint) complaint->line = static_cast<int>(taken);
    return complaint;
  }
};

void read_event_of(const Scene& scene, const Value& line, Events& events) {
  expect(line, Kind::object, "an object that holds one event");
  const Value name = member(line, "scene");
  expect(name, Kind::string, "a string");
  if (name.text() != scene.name)
    name.fail("is " + in_quotes(name.text()) + ", but the search of the scene " + in_quotes(scene.name) +
              " has not finished");
  if (!line.is_good()) return;
  const gjk::Event<double> event = read_event(line);
  if (line.is_good()) events.push_back(event);
}

/// The move that close-ups show must be in both searches, and the crossing test applied to it.
std::optional<Complaint> objection_to_close_up(const TraceFile& file) {
  if (!file.walkthrough.close_up) return std::nullopt;
  const int shown = file.walkthrough.close_up->iteration;
  for (const Trace& trace : file.traces)
    if (std::ranges::none_of(trace.events, [&](const gjk::Event<double>& event) {
          const auto* crossing = std::get_if<gjk::CrossingTested<double>>(&event);
          return crossing && crossing->iteration == shown && crossing->value;
        }))
      return Complaint{1, "presentation.close_up.iteration",
                       "there is no crossing test in iteration " + std::to_string(shown) + " of every scene"};
  return std::nullopt;
}

/// Returns: what is wrong with the first line that is. That a line is not what its search says is found once the lines of that
/// search are read, as far as these are good.
std::optional<Complaint> read_lines(Lines lines, TraceFile& file) {
  const auto cut_off = [&](const std::string& missing) {
    return about(lines.taken + 1, "the trace is cut off: " + missing + " is missing. " + trace_advice);
  };
  if (lines.rest.empty()) return cut_off("its first line");
  int version = trace_version;
  if (auto wrong = lines.next([&](const Value& line) { file.walkthrough = read_header(line, version); })) return wrong;
  for (const Scene& scene : file.walkthrough.scenes) {
    const std::size_t before = lines.taken;
    Events& events = file.traces.emplace_back().events;
    std::optional<Complaint> wrong;
    while (!wrong && !lines.rest.empty() && (events.empty() || !is_last(events.back(), scene)))
      wrong = lines.next([&](const Value& line) { read_event_of(scene, line, events); });
    const auto parting = parting_from_search(scene, events);
    if (parting && parting->event < events.size())
      return about(before + parting->event + 1, parting->what + ". The trace contradicts itself. " + trace_advice);
    if (wrong) return wrong;
    if (parting) return cut_off(parting->what + " of the scene " + in_quotes(scene.name));
    if (version == oldest_trace_version) continue;  // says nothing of the truth
    const gjk::Status shown = answer_of(file.traces.back());
    const nlohmann::ordered_json truth = truth_json(scene, truth_of(scene, shown), shown);
    if (truth.is_null()) continue;
    if (lines.rest.empty()) return cut_off("'truth' of the scene " + in_quotes(scene.name));
    const std::string_view text = lines.next_text();
    wrong = lines.next([&](const Value& line) {
      expect(line, Kind::object, "an object that says the truth");
      if (!line.is_good()) return;
      if (const std::string objection = objection_to_truth(text, truth); !objection.empty())
        line.fail(objection + ". " + trace_advice);
    });
    if (wrong) return wrong;
  }
  const auto refuse = [](const Value& line) {
    expect(line, Kind::object, "an object that holds one event");
    line.fail("nothing may follow: all searches have finished");
  };
  return lines.rest.empty() ? objection_to_close_up(file) : lines.next(refuse);
}

}  // namespace

Reading<TraceFile> trace_in(std::string_view text) {
  Reading<TraceFile> reading;
  reading.complaint = read_lines({text}, reading.value);
  return reading;
}

}  // namespace walkthroughs::trace
