#include "walkthroughs/trace/trace_text.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/trace/replay.hpp"
#include "walkthroughs/trace/trace_lines.hpp"

namespace walkthroughs::trace {
namespace {

using namespace text::reading;

Complaint about(std::size_t line, std::string reason) { return {static_cast<int>(line), "", std::move(reason)}; }

/// Takes the lines of a trace one by one, counted from 1.
class TraceReader {
 public:
  /// Where the line is wrong it is complained about, and not taken. Requires: no complaint so far.
  void read(const Value& line) {
    if (file_.has_value()) {
      read_next_event(line);
    } else if (Walkthrough walkthrough = read_header(line); line.is_good()) {
      file_.emplace().walkthrough = std::move(walkthrough);
      file_->traces.emplace_back();
    }
    if (line.is_good()) ++lines_;
  }

  /// Returns: what is wrong with the lines so far, which end there where `is_cut_off`.
  std::optional<Complaint> complaint(bool is_cut_off) const {
    const auto cut_off = [&](const std::string& missing) -> std::optional<Complaint> {
      if (!is_cut_off) return std::nullopt;
      return about(lines_ + 1, "the trace is cut off: " + missing + " is missing. " + trace_advice);
    };
    if (!file_) return cut_off("its first line");
    if (is_complete()) return std::nullopt;
    const auto parting = parting_from_search(scene(), events());
    if (!parting) return std::nullopt;
    if (parting->event < events().size())
      return about(lines_ - events().size() + parting->event + 1,
                   parting->what + ". The trace contradicts itself. " + trace_advice);
    return cut_off(parting->what + " of the scene " + in_quotes(scene().name));
  }

  /// Returns: whether a scene has come to its end with the last line.
  bool is_at_end_of_scene() const {
    return file_ && !is_complete() && !events().empty() && is_last(events().back(), scene());
  }
  /// Requires: the last one is what its search says.
  void begin_next_scene() { file_->traces.emplace_back(); }

  /// Requires: nothing is wrong with the lines.
  Reading<TraceFile> result() {
    file_->traces.pop_back();
    std::optional<Complaint> complaint = objection_to_close_up();
    return {std::move(*file_), std::move(complaint)};
  }

 private:
  bool is_complete() const { return file_->traces.size() > file_->walkthrough.scenes.size(); }
  const Scene& scene() const { return file_->walkthrough.scenes[file_->traces.size() - 1]; }
  const std::vector<gjk::Event<double>>& events() const { return file_->traces.back().events; }

  void read_next_event(const Value& line) {
    expect(line, Kind::object, "an object that holds one event");
    if (is_complete()) return line.fail("nothing may follow: all searches have finished");
    const Value name = member(line, "scene");
    expect(name, Kind::string, "a string");
    if (name.text() != scene().name)
      name.fail("is " + in_quotes(name.text()) + ", but the search of the scene " + in_quotes(scene().name) +
                " has not finished");
    if (!line.is_good()) return;
    const gjk::Event<double> event = read_event(line);
    if (line.is_good()) file_->traces.back()(event);
  }

  /// The move that close-ups show must be in both searches, and the crossing test applied to it.
  std::optional<Complaint> objection_to_close_up() const {
    if (!file_->walkthrough.close_up) return std::nullopt;
    const int shown = file_->walkthrough.close_up->iteration;
    for (const Trace& trace : file_->traces)
      if (std::ranges::none_of(trace.events, [&](const gjk::Event<double>& event) {
            const auto* crossing = std::get_if<gjk::CrossingTested<double>>(&event);
            return crossing && crossing->iteration == shown && crossing->value;
          }))
        return Complaint{1, "presentation.close_up.iteration",
                         "there is no crossing test in iteration " + std::to_string(shown) + " of every scene"};
    return std::nullopt;
  }

  std::optional<TraceFile> file_;  ///< with a trace more than there are scenes once all have finished
  std::size_t lines_ = 0;
};

/// Returns: what is wrong with that line. One without line break behind it may be all that is left of one.
std::optional<Complaint> read_line(std::string_view text, bool is_ended, TraceReader& reader) {
  if (text.find_first_not_of(" \t\r") == std::string_view::npos)
    return about(1, "is empty, but a trace has an event on each line. " + trace_advice);
  const Document document(text, Document::Comments::refused);
  if (document.complaint() && !is_ended)
    return about(1, "the line ends in the middle, so the trace is cut off. " + trace_advice);
  if (!document.complaint()) reader.read(document.root());
  return document.complaint();
}

/// Returns: what is wrong with the first line that is.
std::optional<Complaint> read_lines(std::string_view text, TraceReader& reader) {
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    if (auto objection = read_line(text.substr(0, end), end != std::string_view::npos, reader)) {
      objection->line = number;
      const auto earlier = reader.complaint(false);
      return earlier ? earlier : objection;
    }
    if (reader.is_at_end_of_scene()) {
      if (const auto complaint = reader.complaint(true)) return complaint;
      reader.begin_next_scene();
    }
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return reader.complaint(true);
}

}  // namespace

Reading<TraceFile> trace_in(std::string_view text) {
  TraceReader reader;
  if (auto complaint = read_lines(text, reader)) return {{}, std::move(complaint)};
  return reader.result();
}

}  // namespace walkthroughs::trace
