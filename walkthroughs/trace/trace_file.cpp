#include "walkthroughs/trace/trace_file.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/trace/trace_check.hpp"
#include "walkthroughs/trace/trace_event.hpp"
#include "walkthroughs/trace/trace_header.hpp"
#include "walkthroughs/trace/trace_values.hpp"

namespace walkthroughs {
namespace {

using namespace reading;

/// Takes the lines of a trace one by one. Errors of its functions: DocumentError, Contradiction.
class TraceReader {
 public:
  void read(const Value& line) {
    if (!file_.has_value()) {
      file_.emplace().walkthrough = read_header(line);
      begin_scene();
    } else {
      read_next_event(line);
    }
  }

  /// Returns: what is still to come, in words; empty where the trace is complete.
  std::string missing() const {
    if (!file_) return "its first line";
    if (check_) return check_->expected() + " of the scene " + in_quotes(scene().name);
    return "";
  }

  /// Requires: nothing is missing.
  TraceFile result() {
    require_close_up();
    return std::move(*file_);
  }

 private:
  const Scene& scene() const { return file_->walkthrough.scenes[file_->traces.size() - 1]; }

  void begin_scene() {
    check_.reset();
    if (file_->traces.size() == file_->walkthrough.scenes.size()) return;
    file_->traces.emplace_back();
    check_.emplace(scene());
  }

  void read_next_event(const Value& line) {
    expect(line, Kind::object, "an object that holds one event");
    if (!check_) line.fail("nothing may follow: all searches have finished");
    const Value name = member(line, "scene");
    expect(name, Kind::string, "a string");
    if (name.text() != scene().name)
      name.fail("is " + in_quotes(name.text()) + ", but the search of the scene " + in_quotes(scene().name) +
                " has not finished");
    gjk::Event<double> event = read_event(line);
    (*check_)(event);
    file_->traces.back()(std::move(event));
    if (check_->is_finished()) begin_scene();
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

  std::optional<TraceFile> file_;
  std::optional<TraceCheck> check_;  ///< of the last scene; empty where all have finished
};

/// A line without line break behind it may be all that is left of one.
std::string read_line(std::string_view text, bool is_ended, TraceReader& reader, int number) {
  const std::string place = std::to_string(number) + ": ";
  if (text.find_first_not_of(" \t\r") == std::string_view::npos)
    return place + "is empty; a trace has an event on each line: " + trace_advice;
  std::optional<Document> document;
  try {
    document.emplace(text, Document::Comments::refused);
  } catch (const DocumentError& error) {
    if (!is_ended) return place + "the line ends in the middle, so the trace is cut off; " + trace_advice;
    return place + error.key + (error.key.empty() ? "" : ": ") + error.what();
  }
  try {
    reader.read(document->root());
  } catch (const DocumentError& error) {
    return place + error.key + (error.key.empty() ? "" : ": ") + error.what();
  } catch (const Contradiction& error) {
    return place + error.what() + "; the trace contradicts itself: " + trace_advice;
  }
  return "";
}

}  // namespace

TraceFile parse_trace(std::string_view text, const std::string& file_name) {
  TraceReader reader;
  int number = 0;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::string complaint = read_line(text.substr(0, end), end != std::string_view::npos, reader, ++number);
    if (!complaint.empty()) throw TraceError(file_name + ":" + complaint);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  if (const std::string missing = reader.missing(); !missing.empty())
    throw TraceError(file_name + ":" + std::to_string(number + 1) + ": the trace is cut off: " + missing +
                     " is missing; " + trace_advice);
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
