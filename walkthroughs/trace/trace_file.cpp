#include "walkthroughs/trace/trace_file.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/trace/replay.hpp"
#include "walkthroughs/trace/trace_event.hpp"
#include "walkthroughs/trace/trace_header.hpp"
#include "walkthroughs/trace/trace_values.hpp"

namespace walkthroughs {
namespace {

using namespace reading;

/// Takes the lines of a trace one by one, counted from 1.
class TraceReader {
 public:
  /// Errors: DocumentError. Requires: no complaint so far.
  void read(const Value& line) {
    if (!file_.has_value()) {
      file_.emplace().walkthrough = read_header(line);
      file_->traces.emplace_back();
    } else {
      read_next_event(line);
    }
    ++lines_;
  }

  /// Returns: what is wrong with the lines so far, which end there where `is_cut_off`; empty where nothing is.
  std::string complaint(bool is_cut_off) const {
    if (!file_) return is_cut_off ? cut_off("its first line") : "";
    if (is_complete()) return "";
    const auto parting = parting_from_search(scene(), events());
    if (!parting) return "";
    if (parting->event < events().size())
      return std::to_string(lines_ - events().size() + parting->event + 1) + ": " + parting->what +
             "; the trace contradicts itself: " + trace_advice;
    return is_cut_off ? cut_off(parting->what + " of the scene " + in_quotes(scene().name)) : "";
  }

  /// Returns: whether a scene has come to its end with the last line.
  bool is_at_end_of_scene() const {
    return file_ && !is_complete() && !events().empty() && is_last(events().back(), scene());
  }
  /// Requires: the last one is what its search says.
  void begin_next_scene() { file_->traces.emplace_back(); }

  /// Requires: nothing is wrong. Errors: DocumentError.
  TraceFile result() {
    file_->traces.pop_back();
    require_close_up();
    return std::move(*file_);
  }

 private:
  bool is_complete() const { return file_->traces.size() > file_->walkthrough.scenes.size(); }
  const Scene& scene() const { return file_->walkthrough.scenes[file_->traces.size() - 1]; }
  const std::vector<gjk::Event<double>>& events() const { return file_->traces.back().events; }

  std::string cut_off(const std::string& missing) const {
    return std::to_string(lines_ + 1) + ": the trace is cut off: " + missing + " is missing; " + trace_advice;
  }

  void read_next_event(const Value& line) {
    expect(line, Kind::object, "an object that holds one event");
    if (is_complete()) line.fail("nothing may follow: all searches have finished");
    const Value name = member(line, "scene");
    expect(name, Kind::string, "a string");
    if (name.text() != scene().name)
      name.fail("is " + in_quotes(name.text()) + ", but the search of the scene " + in_quotes(scene().name) +
                " has not finished");
    file_->traces.back()(read_event(line));
  }

  /// The move that close-ups show must be in both searches, and the crossing test applied to it.
  void require_close_up() const {
    if (!file_->walkthrough.close_up) return;
    const int shown = file_->walkthrough.close_up->iteration;
    for (const Trace& trace : file_->traces)
      if (std::ranges::none_of(trace.events, [&](const gjk::Event<double>& event) {
            const auto* crossing = std::get_if<gjk::CrossingTested<double>>(&event);
            return crossing && crossing->iteration == shown && crossing->value;
          }))
        throw DocumentError(1, "presentation.close_up.iteration",
                            "there is no crossing test in iteration " + std::to_string(shown) + " of every scene");
  }

  std::optional<TraceFile> file_;  ///< with a trace more than there are scenes once all have finished
  std::size_t lines_ = 0;
};

/// Returns: what is wrong with that line; empty where nothing is. A line without line break behind it may be all that is left of one.
std::string read_line(std::string_view text, bool is_ended, TraceReader& reader) {
  if (text.find_first_not_of(" \t\r") == std::string_view::npos)
    return "is empty; a trace has an event on each line: " + trace_advice;
  const auto said = [](const DocumentError& error) {
    return error.key + (error.key.empty() ? "" : ": ") + error.what();
  };
  std::optional<Document> document;
  try {
    document.emplace(text, Document::Comments::refused);
  } catch (const DocumentError& error) {
    return is_ended ? said(error) : "the line ends in the middle, so the trace is cut off; " + trace_advice;
  }
  try {
    reader.read(document->root());
  } catch (const DocumentError& error) {
    return said(error);
  }
  return "";
}

/// Returns: what is wrong with the first line that is; empty where none is.
std::string read_lines(std::string_view text, TraceReader& reader) {
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    if (const std::string objection = read_line(text.substr(0, end), end != std::string_view::npos, reader);
        !objection.empty()) {
      const std::string earlier = reader.complaint(false);
      return earlier.empty() ? std::to_string(number) + ": " + objection : earlier;
    }
    if (reader.is_at_end_of_scene()) {
      if (const std::string complaint = reader.complaint(true); !complaint.empty()) return complaint;
      reader.begin_next_scene();
    }
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return reader.complaint(true);
}

}  // namespace

TraceFile parse_trace(std::string_view text, const std::string& file_name) {
  TraceReader reader;
  if (const std::string complaint = read_lines(text, reader); !complaint.empty())
    throw TraceError(file_name + ":" + complaint);
  try {
    return reader.result();
  } catch (const DocumentError& error) {
    throw TraceError(file_name + ":" + std::to_string(error.line) + ": " + error.key + ": " + error.what());
  }
}

TraceFile read_trace(const std::filesystem::path& file) {
  std::string text;
  try {
    text = read_text(file, {"trace", trace_limits::bytes});
  } catch (const InputError& error) {
    throw TraceError(error.what());
  }
  return parse_trace(text, file.string());
}

}  // namespace walkthroughs
