#include "walkthroughs/trace/trace_file.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "walkthroughs/model/labelled_hull.hpp"
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/model/precision.hpp"
#include "walkthroughs/model/words_of.hpp"
#include "walkthroughs/text/scene_file.hpp"
#include "walkthroughs/text/scene_limits.hpp"
#include "walkthroughs/text/scene_values.hpp"
#include "walkthroughs/trace/trace_check.hpp"
#include "walkthroughs/trace/trace_json.hpp"

namespace walkthroughs {
namespace {

using namespace reading;

const std::string trace_again = "write the trace again with 'gjkstep trace'";

// -- Values -----------------------------------------------------------------------------------------------------------

Value member(const Value& object, std::string_view key) { return required(object, key, trace_again); }

/// Returns: the enumerator of that word.
template <class E, std::size_t count>
E enumerator(const Value& value, const std::array<std::string_view, count>& known) {
  return static_cast<E>(choice(value, known));
}

std::string sentence(const Value& object, std::string_view key) {
  return words(member(object, key), trace_limits::words);
}

/// Returns: a short text, which may be missing.
std::string word(const Value& object, std::string_view key) {
  const std::optional<Value> value = object.member(key);
  if (!value) return "";
  expect(*value, Kind::string, "a string");
  return value->text();
}

int iteration(const Value& value) { return whole_number(value, 0, scene_limits::iterations); }

double real(const Value& value) {
  if (value.is(Kind::number)) return value.number();
  expect(value, Kind::string, "a number, \"inf\", \"-inf\" or \"nan\"");
  if (value.text() == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (value.text() == "inf") return std::numeric_limits<double>::infinity();
  if (value.text() == "-inf") return -std::numeric_limits<double>::infinity();
  value.fail(in_quotes(value.text()) + " is not a number; those that are not finite are \"inf\", \"-inf\" and \"nan\"");
}

Point vector(const Value& value) {
  expect(value, Kind::list, "a vector [x, y, z]");
  const std::vector<Value> numbers = value.children();
  if (numbers.size() != 3) value.fail("expected a vector [x, y, z], found a list of " + std::to_string(numbers.size()));
  return {real(numbers[0]), real(numbers[1]), real(numbers[2])};
}

gjk::SupportPoint<double> support_point(const Value& value) {
  expect_object(value, {"point", "index"}, "an object with 'point'");
  gjk::SupportPoint<double> found{vector(member(value, "point"))};
  if (const auto index = value.member("index"))
    found.index = whole_number(*index, 0, static_cast<int>(scene_limits::points) - 1);
  return found;
}

/// Of an object that may have other keys too.
gjk::Vertex<double> vertex_in(const Value& object) {
  return {support_point(member(object, "a")), support_point(member(object, "b")), vector(member(object, "w"))};
}

gjk::Vertex<double> vertex(const Value& value) {
  expect_object(value, {"w", "a", "b"}, "an object with 'w', 'a' and 'b'");
  return vertex_in(value);
}

gjk::Simplex<double> simplex(const Value& value) {
  expect(value, Kind::list, "a list of vertices");
  const std::vector<Value> vertices = value.children();
  if (vertices.size() > 4) value.fail("has " + std::to_string(vertices.size()) + " vertices; a simplex has at most 4");
  gjk::Simplex<double> read;
  for (const Value& each : vertices) read.add(vertex(each));
  return read;
}

// -- The first line ---------------------------------------------------------------------------------------------------

Pose read_pose(const Value& value, const Space& space, Scalar scalar) {
  expect_object(value, {"rotation", "translation"}, "an object with 'rotation' and 'translation'");
  const Value rotation = member(value, "rotation");
  expect(rotation, Kind::list, "a matrix of three rows");
  const std::vector<Value> rows = rotation.children();
  if (rows.size() != 3) rotation.fail("expected three rows, found " + std::to_string(rows.size()));
  Pose pose;
  for (int row = 0; row < 3; ++row)
    pose.rotation.row(row) = Space{Dimension::space}.point(rows[static_cast<std::size_t>(row)]);
  const double allowed = 64 * precision_of(scalar).epsilon;  // some roundings of sines and cosines
  const Eigen::Matrix3d product = pose.rotation * pose.rotation.transpose();
  if (!((product - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <= allowed && pose.rotation.determinant() > 0))
    rotation.fail("is not a rotation: its rows are not perpendicular unit vectors in right-handed order");
  if (space.is_plane() && (pose.rotation(2, 0) != 0 || pose.rotation(2, 1) != 0))
    rotation.fail("turns the object out of the plane");
  pose.translation = space.point(member(value, "translation"));
  return pose;
}

// What may throw is computed before an aggregate is begun: GCC 12 destroys members of unfinished aggregates twice.
Object read_object(const Value& value, const Space& space, Scalar scalar) {
  expect_object(value, object_keys(), "an object with a shape");
  AnyShape form = read_shape(value, space);
  Object object{.name = {}, .form = std::move(form)};
  object.name = words(member(value, "name"), scene_limits::name);
  if (const auto pose = value.member("pose")) object.pose = read_pose(*pose, space, scalar);
  return object;
}

Scene read_scene(const Value& value) {
  expect_object(value,
                {"name", "dimension", "a", "b", "first_direction", "iteration_limit", "crossing_test", "rules",
                 "zero_test", "scalar"},
                "an object that describes a scene");
  const std::string name = words(member(value, "name"), scene_limits::name);
  const Space space{whole_number(member(value, "dimension"), 2, 3) == 2 ? Dimension::plane : Dimension::space};
  const auto in = value.member("scalar");
  const Scalar scalar = in ? enumerator<Scalar>(*in, words_of::scalar) : Scalar::binary64;
  Object a = read_object(member(value, "a"), space, scalar), b = read_object(member(value, "b"), space, scalar);
  const gjk::Options<double> options{
      .first_direction = space.direction(member(value, "first_direction")),
      .iteration_limit = whole_number(member(value, "iteration_limit"), 1, scene_limits::iterations),
      .crossing_test = enumerator<gjk::CrossingTest>(member(value, "crossing_test"), words_of::crossing_test)};
  const auto rules = enumerator<RuleSet>(member(value, "rules"), words_of::rules);
  const auto zero = value.member("zero_test");
  const ZeroTest zero_test = zero ? enumerator<ZeroTest>(*zero, words_of::zero_test) : ZeroTest::exact;
  return in_its_scalar({name, std::move(a), std::move(b), options, space.dimension, rules, zero_test}, value);
}

std::vector<Scene> read_scenes(const Value& value) {
  expect(value, Kind::list, "a list of scenes");
  std::vector<Scene> scenes;
  for (const Value& each : value.children()) {
    if (scenes.size() == 2) each.fail("is a third scene; a walkthrough has at most two");
    scenes.push_back(read_scene(each));
  }
  if (scenes.size() == 2 && scenes[0].name == scenes[1].name)
    value.fail("has two scenes of the name " + in_quotes(scenes[0].name) + "; their lines could not be told apart");
  return scenes;
}

Panels read_panels(const Value& value) {
  expect(value, Kind::list, "a list out of 'objects', 'hull' and 'algorithm'");
  Panels panels{.objects = false, .hull = false, .algorithm = false};
  for (const Value& each : value.children()) {
    bool* const all[] = {&panels.objects, &panels.hull, &panels.algorithm};
    bool& panel = *all[choice(each, words_of::panels)];
    if (panel) each.fail("'" + each.text() + "' appears twice; name it once");
    panel = true;
  }
  return panels;
}

std::vector<Remark> read_remarks(const Value& value) {
  expect(value, Kind::list, "a list of remarks");
  std::vector<Remark> remarks;
  for (const Value& each : value.children()) {
    if (remarks.size() == trace_limits::remarks) each.fail("is one remark too many; there may be 100");
    expect_object(each, {"at", "iteration", "text", "only_for", "fact"}, "an object with 'at', 'iteration' and 'text'");
    const auto at = enumerator<Remark::At>(member(each, "at"), words_of::remark_at);
    const int in_iteration = iteration(member(each, "iteration"));
    const std::string text = sentence(each, "text");
    const std::string only_for = each.member("only_for") ? sentence(each, "only_for") : "";
    const std::string fact = each.member("fact") ? sentence(each, "fact") : "";
    remarks.push_back({at, in_iteration, text, only_for, fact});
  }
  return remarks;
}

CloseUp read_close_up(const Value& value) {
  expect_object(value, {"iteration", "direction", "support", "crossing"}, "an object that describes a move");
  const int in_iteration = whole_number(member(value, "iteration"), 2, scene_limits::iterations);
  const std::string direction = sentence(value, "direction"), support = sentence(value, "support");
  return {in_iteration, direction, support, sentence(value, "crossing")};
}

/// A letter for each corner of a hull.
void require_letters_for_corners(const Value& naming, const std::vector<Scene>& scenes) {
  for (const Scene& scene : scenes) {
    const std::size_t a = vertices_of(scene.a).size(), b = vertices_of(scene.b).size();
    if (scene.dimension != Dimension::plane || a == 0 || b == 0)
      naming.fail("'corners' needs point sets in the plane; others have no corners to name: write 'roles'");
    if (a > trace_limits::differences / b || difference_hull(scene).corners.size() > trace_limits::corners)
      naming.fail("'corners' has letters for 26 corners, and this difference has more: write 'roles'");
  }
}

void read_presentation(const Value& value, Walkthrough& walkthrough) {
  expect_object(value, {"title", "source", "summary", "layout", "panels", "naming", "remarks", "close_up"},
                "an object that says how the trace is presented");
  walkthrough.title = words(member(value, "title"), scene_limits::title);
  walkthrough.source = sentence(value, "source");
  walkthrough.summary = sentence(value, "summary");
  const Value layout = member(value, "layout"), naming = member(value, "naming");
  walkthrough.layout = enumerator<Layout>(layout, words_of::layout);
  walkthrough.panels = read_panels(member(value, "panels"));
  walkthrough.naming = enumerator<Naming>(naming, words_of::naming);
  if (walkthrough.naming == Naming::corners) require_letters_for_corners(naming, walkthrough.scenes);
  if (const auto remarks = value.member("remarks")) walkthrough.remarks = read_remarks(*remarks);
  if (const auto move = value.member("close_up")) walkthrough.close_up = read_close_up(*move);
  const std::size_t scenes = walkthrough.layout == Layout::search ? 1 : 2;
  if (walkthrough.scenes.size() != scenes)
    layout.fail("'" + layout.text() + "' shows " + std::to_string(scenes) + (scenes == 1 ? " scene" : " scenes") +
                ", but the trace has " + std::to_string(walkthrough.scenes.size()));
  if (walkthrough.close_up.has_value() != (walkthrough.layout == Layout::close_ups))
    layout.fail("'close_up' is there exactly where the layout is 'close-ups'");
}

/// Names like "regions/2-simplex-r3": pictures go to a folder of that name, which must not lie elsewhere.
std::string read_name(const Value& value) {
  const std::string name = words(value, trace_limits::name);
  const auto is_plain = [](char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '_' || c == '-';
  };
  bool is_begin = true;
  for (const char c : name + "/") {
    const bool is_good = is_begin ? is_plain(c) : is_plain(c) || c == '.' || c == '/';
    if (!is_good)
      value.fail(in_quotes(name) + " cannot name a folder; use letters, digits, '_', '-', and inside of words '.'");
    is_begin = c == '/';
  }
  return name;
}

/// Whether this is a trace, and one that this program knows: before anything else can look wrong about it.
void require_known_version(const Value& root) {
  const auto schema = root.is(Kind::object) ? root.member("schema") : std::nullopt;
  if (!schema || !schema->is(Kind::string) || schema->text() != "gjkstep-trace")
    root.fail("is not the first line of a trace: it has no \"schema\": \"gjkstep-trace\"; " + trace_again);
  const Value version = member(root, "version");
  expect(version, Kind::number, "a number");
  if (version.number() != trace_version)
    version.fail("version " + number_text(version.number()) + " is not known; this program reads version " +
                 std::to_string(trace_version) + ": " + trace_again);
}

Walkthrough read_header(const Value& root) {
  require_known_version(root);
  expect_object(root, {"schema", "version", "walkthrough", "scalar", "presentation", "scenes"}, "an object");
  constexpr std::array<std::string_view, 1> scalars{"double"};
  choice(member(root, "scalar"), scalars);
  Walkthrough walkthrough;
  walkthrough.name = read_name(member(root, "walkthrough"));
  walkthrough.scenes = read_scenes(member(root, "scenes"));
  read_presentation(member(root, "presentation"), walkthrough);
  return walkthrough;
}

// -- Events -----------------------------------------------------------------------------------------------------------

using Event = gjk::Event<double>;

/// As expect_object(), for an event: every line also says its scene, iteration and event.
void expect_keys(const Value& line, Keys keys) {
  std::vector<std::string> all{"scene", "iteration", "event"};
  all.insert(all.end(), keys);
  for (const Value& each : line.children())
    if (std::ranges::count(all, each.key()) == 0)
      each.fail("is not a key of " + in_quotes(member(line, "event").text()));
}

Event search_started(const Value& line) {
  expect_keys(line, {"direction", "why"});
  return gjk::SearchStarted<double>{.direction = vector(member(line, "direction")), .why = sentence(line, "why")};
}

Event support_found(const Value& line) {
  expect_keys(line, {"direction", "w", "a", "b", "new"});
  const Value is_new = member(line, "new");
  expect(is_new, Kind::boolean, "true or false");
  return gjk::SupportFound<double>{
      .direction = vector(member(line, "direction")), .vertex = vertex_in(line), .is_new = is_new.is_true()};
}

Event crossing_tested(const Value& line) {
  expect_keys(line, {"value", "verdict"});
  gjk::CrossingTested<double> event{.value = {}};
  if (const auto value = line.member("value")) event.value = real(*value);
  event.verdict = enumerator<gjk::Crossing>(member(line, "verdict"), words_of::crossing);
  return event;
}

Event vertex_added(const Value& line) {
  expect_keys(line, {"simplex"});
  return gjk::VertexAdded<double>{.simplex = simplex(member(line, "simplex"))};
}

Event region_tested(const Value& line) {
  expect_keys(line, {"simplex_size", "feature", "region", "face", "expression", "formula", "normal", "value",
                     "relation", "verdict", "reason"});
  gjk::RegionTested<double> event;
  event.simplex_size = whole_number(member(line, "simplex_size"), 1, 4);
  member(line, "feature");
  event.feature = word(line, "feature");
  event.label = word(line, "region");
  event.face = word(line, "face");
  event.expression = word(line, "expression");
  event.formula = word(line, "formula");
  if (const auto normal = line.member("normal")) event.normal = vector(*normal);
  const auto value = line.member("value"), relation = line.member("relation");
  if (value.has_value() != relation.has_value()) line.fail("'value' and 'relation' belong together");
  if (value && value->is(Kind::list)) event.value = vector(*value);
  if (value && !value->is(Kind::list)) event.value = real(*value);
  if (relation) event.relation = enumerator<gjk::Relation>(*relation, words_of::relation);
  event.verdict = enumerator<gjk::Verdict>(member(line, "verdict"), words_of::verdict);
  event.reason = sentence(line, "reason");
  return event;
}

Event simplex_reduced(const Value& line) {
  expect_keys(line, {"before", "after", "kept", "dropped", "why"});
  member(line, "kept");
  member(line, "dropped");
  gjk::SimplexReduced<double> event;
  event.before = simplex(member(line, "before"));
  event.after = simplex(member(line, "after"));
  event.kept = word(line, "kept");
  event.dropped = word(line, "dropped");
  event.why = sentence(line, "why");
  return event;
}

Event direction_chosen(const Value& line) {
  expect_keys(line, {"expression", "direction"});
  member(line, "expression");
  return gjk::DirectionChosen<double>{.expression = word(line, "expression"),
                                      .direction = vector(member(line, "direction"))};
}

Event finished(const Value& line) {
  expect_keys(line, {"status", "reason", "iterations", "simplex", "separation"});
  gjk::Finished<double> event;
  event.result.status = enumerator<gjk::Status>(member(line, "status"), words_of::status);
  event.result.reason = enumerator<gjk::Reason>(member(line, "reason"), words_of::reason);
  event.result.iterations = iteration(member(line, "iterations"));
  event.result.simplex = simplex(member(line, "simplex"));
  if (const auto proof = line.member("separation")) {
    expect_object(*proof, {"direction", "vertex", "support_value"}, "an object that proves the separation");
    const Point direction = vector(member(*proof, "direction"));
    const gjk::Vertex<double> farthest = vertex(member(*proof, "vertex"));
    event.result.separation = gjk::Separation<double>{direction, farthest, real(member(*proof, "support_value"))};
  }
  return event;
}

Event read_event(const Value& line) {
  using Reader = Event (*)(const Value&);
  constexpr Reader readers[] = {search_started, support_found,   crossing_tested,  vertex_added,
                                region_tested,  simplex_reduced, direction_chosen, finished};
  Event event = readers[choice(member(line, "event"), words_of::event)](line);
  const int in_iteration = iteration(member(line, "iteration"));
  std::visit([=](auto& e) { e.iteration = in_iteration; }, event);
  return event;
}

// -- The file ---------------------------------------------------------------------------------------------------------

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
    Event event = read_event(line);
    (*check_)(event);
    file_->traces.back()(std::move(event));
    if (check_->is_finished()) begin_scene();
  }

  /// The move that close-ups show must be in both searches, and the crossing test applied to it.
  void require_close_up() const {
    if (!file_->walkthrough.close_up) return;
    const int shown = file_->walkthrough.close_up->iteration;
    for (const Trace& trace : file_->traces)
      if (std::ranges::none_of(trace.events, [&](const Event& event) {
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
    return place + "is empty; a trace has an event on each line: " + trace_again;
  std::optional<Document> document;
  try {
    document.emplace(text, Document::Comments::refused);
  } catch (const DocumentError& error) {
    if (!is_ended) return place + "the line ends in the middle, so the trace is cut off; " + trace_again;
    return place + error.key + (error.key.empty() ? "" : ": ") + error.what();
  }
  try {
    reader.read(document->root());
  } catch (const DocumentError& error) {
    return place + error.key + (error.key.empty() ? "" : ": ") + error.what();
  } catch (const Contradiction& error) {
    return place + error.what() + "; the trace contradicts itself: " + trace_again;
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
                     " is missing; " + trace_again);
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
