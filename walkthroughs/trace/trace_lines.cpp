#include "walkthroughs/trace/trace_lines.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "walkthroughs/model/event_fields.hpp"
#include "walkthroughs/model/labelled_hull.hpp"
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/model/words_of.hpp"
#include "walkthroughs/text/names.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/trace/trace_json.hpp"
#include "walkthroughs/trace/trace_limits.hpp"

namespace walkthroughs::trace {
namespace {

using namespace text::reading;

/// How the value of a field is read. `space`: of what belongs to a scene, where it lies; of events, whose numbers need not be finite,
/// none.
struct How {
  Meaning meaning = Meaning::plain;
  const Space* space = nullptr;
};

// -- Values, by the type of the field that takes them -----------------------------------------------------------------

/// Returns: the elements of a list of so many; none where it is something else.
std::vector<Value> elements(const Value& value, std::size_t count, const std::string& expected) {
  expect(value, Kind::list, expected);
  std::vector<Value> found = value.children();
  if (found.size() == count) return found;
  value.fail("expected " + expected + ", found a list of " + std::to_string(found.size()));
  return {};
}

/// Reads a list of `most` at most. `one_more`: what is wrong with the next.
template <class R>
void read_list(const Value& value, const std::string& expected, std::size_t most, const std::string& one_more,
               std::vector<R>& list) {
  expect(value, Kind::list, expected);
  for (const Value& each : value.children()) {
    if (list.size() == most) return each.fail(one_more);
    read(each, How{}, list.emplace_back());
  }
}

void read(const Value& value, const How&, double& number) {
  if (value.is(Kind::number)) {
    number = value.number();
    return;
  }
  expect(value, Kind::string, "a number, \"inf\", \"-inf\" or \"nan\"");
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (value.text() == "nan")
    number = std::numeric_limits<double>::quiet_NaN();
  else if (value.text() == "inf" || value.text() == "-inf")
    number = value.text() == "inf" ? infinity : -infinity;
  else
    value.fail(in_quotes(value.text()) +
               " is not a number; those that are not finite are \"inf\", \"-inf\" and \"nan\"");
}

void read(const Value& value, const How& how, Point& vector) {
  if (how.space) {
    vector = how.meaning == Meaning::direction ? how.space->first_direction(value) : how.space->point(value);
    return;
  }
  const std::vector<Value> numbers = elements(value, 3, "a vector [x, y, z]");
  for (std::size_t i = 0; i < numbers.size(); ++i) read(numbers[i], {}, vector[static_cast<int>(i)]);
}

void read(const Value& value, const How&, std::variant<std::monostate, double, Point>& of_expression) {
  if (value.is(Kind::list))
    read(value, {}, of_expression.emplace<Point>());
  else
    read(value, {}, of_expression.emplace<double>());
}

void read(const Value& value, const How& how, int& count) {
  const auto [least, most] = range_of(how.meaning);
  count = whole_number(value, least, most);
}

void read(const Value& value, const How& how, std::string& text) {
  expect(value, Kind::string, "a string");
  switch (how.meaning) {
    case Meaning::name: text = words(value, scene_limits::name); break;
    case Meaning::title: text = words(value, scene_limits::title); break;
    case Meaning::sentence: text = words(value, trace_limits::words); break;
    default: text = value.text();
  }
}

void read(const Value& value, const How&, gjk::Roles& roles) {
  expect(value, Kind::string, "a string");
  const auto named = gjk::Roles::named(value.text());
  if (!named) return value.fail(in_quotes(value.text()) + " names no vertices: write letters from A to D, each once");
  roles = *named;
}

void read(const Value& value, const How&, gjk::Expression& expression) {
  expect(value, Kind::string, "a string");
  const auto named = gjk::Expression::named(value.text());
  if (!named || named->empty())
    return value.fail(in_quotes(value.text()) + " is no expression, such as 'AB×AO×AB' or 'ABn·AO'");
  expression = *named;
}

void read(const Value& value, const How&, bool& is_true) { is_true = true_or_false(value); }

template <class E>
requires std::is_enum_v<E>
void read(const Value& value, const How&, E& enumerator) {
  enumerator = static_cast<E>(choice(value, words_of::all(E{})));
}

template <Record R>
void read(const Value& value, const How& how, R& record);

void read(const Value& value, const How&, gjk::Simplex<double>& simplex) {
  expect(value, Kind::list, "a list of vertices");
  const std::vector<Value> vertices = value.children();
  if (vertices.size() > 4)
    return value.fail("has " + std::to_string(vertices.size()) + " vertices; a simplex has at most 4");
  for (const Value& each : vertices) {
    gjk::Vertex<double> vertex;
    read(each, {}, vertex);
    simplex.add(vertex);
  }
}

void read(const Value& value, const How&, std::vector<gjk::FilterValue>& numbers) {
  read_list(value, "a list of numbers with their expressions", 4, "is a fifth number; a proof has at most four",
            numbers);
}

void read(const Value& value, const How&, gjk::IndexPairs& pairs) {
  expect(value, Kind::list, "a list of pairs of indices [i, j]");
  for (const Value& each : value.children()) {
    if (pairs.size() == 4) return each.fail("is a fifth pair; a simplex has at most four vertices");
    const std::vector<Value> both = elements(each, 2, "a pair of indices [i, j]");
    if (both.empty()) return;
    gjk::IndexPair pair;
    read(both[0], {Meaning::position}, pair.a);
    read(both[1], {Meaning::position}, pair.b);
    pairs.add(pair);
  }
}

void read(const Value& value, const How&, gjk::Certificate& certificate) {
  expect_object(value, {"direction", "nearest", "simplex"}, "an object with 'direction', 'nearest' or 'simplex'");
  if (value.children().size() != 1) value.fail("is to have one of 'direction', 'nearest' and 'simplex'");
  if (const auto direction = value.member("direction"))
    read(*direction, {}, certificate.emplace<gjk::SeparatingDirection>().d);
  else if (const auto nearest = value.member("nearest"))
    read(*nearest, {}, certificate.emplace<gjk::SeparatingFeature>().of);
  else
    read(member(value, "simplex"), {}, certificate.emplace<gjk::CommonSimplex>().of);
}

template <class T>
void read(const Value& value, const How& how, std::optional<T>& optional) {
  read(value, how, optional.emplace());
}

// -- Records ----------------------------------------------------------------------------------------------------------

struct RecordKeys {
  std::vector<std::string> all, needed;
};

template <Record R>
RecordKeys keys_of(const R& record) {
  RecordKeys keys;
  for_each_field(record, [&](const auto& field, const auto&) {
    keys.all.emplace_back(field.key);
    if (!field.may_be_missing()) keys.needed.emplace_back(field.key);
  });
  return keys;
}

// What a field that is told in words may hold.

template <class E>
requires std::is_enum_v<E> std::vector<E> all_of(E last) {
  std::vector<E> all;
  for (int i = 0; i <= static_cast<int>(last); ++i) all.push_back(static_cast<E>(i));
  return all;
}
std::vector<gjk::FirstDirection> candidates(gjk::FirstDirection) { return all_of(gjk::FirstDirection::as_told); }
std::vector<gjk::ReductionReason> candidates(gjk::ReductionReason) { return all_of(gjk::ReductionReason::as_told); }
/// Those of the report's rules first, of which nearly all events are.
const std::vector<gjk::Finding>& candidates(const gjk::Finding&) {
  static const std::vector<gjk::Finding> findings = [] {
    const auto reasons = all_of(gjk::RegionReason::no_face_sees_origin);
    std::vector<gjk::Finding> all;
    for (const gjk::RegionReason is : reasons) all.push_back({is});
    for (const gjk::RegionReason is : reasons)
      for (const gjk::RegionReason as_if : reasons) all.push_back({is, as_if});
    return all;
  }();
  return findings;
}
std::vector<gjk::Roles> candidates(const gjk::Roles&) { return {"ABC", "ABD", "ACD"}; }

/// The words that the program has for a field are looked up; there are no others.
template <class R>
void understand(const Value& value, const auto& field, R& record) {
  const std::string text = words(value, trace_limits::words);
  for (const auto& candidate : candidates(record.*field.member)) {
    record.*field.member = candidate;
    if (field.say(record) == text) return;
  }
  value.fail("is " + in_quotes(text) + ", which no search says there. " + trace_advice);
}

template <class R>
void require_derived(const Value& object, const auto& field, const R& record) {
  const std::string said = field.say(record);
  const std::optional<Value> value = object.member(field.key);
  if (!value && field.may_be_missing() && said.empty()) return;
  const Value given = member(object, field.key);
  expect(given, Kind::string, "a string");
  if (given.text() != said)
    given.fail("is " + in_quotes(given.text()) + ", but the other fields say " + in_quotes(said) + ". " + trace_advice);
}

template <Record R>
void read_fields(const Value& object, const How& how, R& record) {
  for_each_field(record, [&](const auto& field, auto& into) {
    const bool is_there = object.member(field.key).has_value();
    if (!field.beside.empty() && is_there != object.member(field.beside).has_value())
      object.fail("'" + std::string(field.beside) + "' and '" + std::string(field.key) + "' belong together");
    if (!is_there && field.may_be_missing()) return;
    if constexpr (requires { field.word; }) {
      choice(member(object, field.key), std::array{field.word});
      into = true;
    } else if constexpr (requires { field.meaning; }) {
      read(member(object, field.key), How{field.meaning, how.space}, into);
    } else if constexpr (requires { field.member; }) {
      understand(member(object, field.key), field, into);
    }
  });
  for_each_field(record, [&](const auto& field, auto& whole) {
    if constexpr (
        requires { field.say; } && !requires { field.member; })
      require_derived(object, field, whole);
  });
}

template <Record R>
void read(const Value& value, const How& how, R& record) {
  const RecordKeys keys = keys_of(record);
  expect_object(value, keys.all, "an object with " + list_of(keys.needed, "and"));
  read_fields(value, how, record);
}

// -- Fields that only scenes have -------------------------------------------------------------------------------------

void read(const Value& value, const How&, Dimension& dimension) {
  dimension = whole_number(value, 2, 3) == 2 ? Dimension::plane : Dimension::space;
}

void read(const Value& value, const How& how, Eigen::Matrix3d& rotation) {
  if (!expect(value, Kind::list, "a matrix of three rows")) return;
  const std::vector<Value> rows = value.children();
  if (rows.size() != 3) return value.fail("expected three rows, found " + std::to_string(rows.size()));
  for (int row = 0; row < 3; ++row)
    rotation.row(row) = Space{Dimension::space}.point(rows[static_cast<std::size_t>(row)]);
  if (how.space->is_plane() && (rotation(2, 0) != 0 || rotation(2, 1) != 0))
    value.fail("turns the object out of the plane");
}

/// A matrix that was written may lack more of a rotation than some roundings of sines and cosines.
void read(const Value& value, const How& how, Pose& pose) {
  read<Pose>(value, how, pose);
  if (!value.is_good()) return;
  const Scalar scalar = how.space->numbers == Numbers::binary32 ? Scalar::binary32 : Scalar::binary64;
  const double roundings = 64 * precision_of(scalar).epsilon;
  const auto tolerance = [&](double otherwise) { return std::max(roundings, otherwise); };
  if (!(distance_from_rotation(pose.rotation) <= tolerance(pose.matrix_as_written ? rotation_tolerance : 0)))
    member(value, "rotation")
        .fail("is not a rotation: its columns are not perpendicular unit vectors in right-handed order");
  if (!pose.quaternion) return;
  const auto& [w, x, y, z] = *pose.quaternion;
  const Eigen::Vector4d numbers(w, x, y, z);
  if (!numbers.allFinite() || numbers.isZero(0) ||
      !((matrix_of(*pose.quaternion) - pose.rotation).cwiseAbs().maxCoeff() <= roundings))
    member(value, "quaternion").fail("is not the quaternion of that rotation");
}

void read(const Value& value, const How& how, Object& object) {
  if (!expect_object(value, object_keys(), "an object with a shape")) return;
  object.form = read_shape(value, *how.space);
  object.name = words(member(value, "name"), scene_limits::name);
  if (const auto pose = value.member("pose")) read(*pose, how, object.pose);
}

void read(const Value& value, const How&, Panels& panels) { panels = panels_in(value); }

/// What else a scene says must be what its mistake is known with.
void require_usual_search(const Value& mistake, const Scene& scene) {
  const Scene usual = mistaken(scene, *scene.mistake);
  if (scene.rules != usual.rules || scene.options.crossing_test != usual.options.crossing_test ||
      scene.zero_test != usual.zero_test || scene.scalar != usual.scalar || scene.certified)
    mistake.fail("is made with 'rules' " + in_quotes(to_string(usual.rules)) +
                 ", the crossing test on, the exact zero test and in double, and this scene says otherwise");
}

/// Objects as read are there where rounding them to float makes those of the scene, and others.
void require_rounded(const Value& value, const Scene& scene) {
  const auto require = [&](const char* key, const std::optional<Object>& as_read, const Object& object) {
    if (!as_read) return;
    Scene rounded = scene;
    rounded.a = *as_read;
    rounded.a_as_read.reset();
    if (scene.scalar != Scalar::binary32)
      member(value, key).fail("belongs to a scene whose 'scalar' is 'float'");
    else if (rounded = in_float(std::move(rounded)); !is_same(rounded.a, object) || !rounded.a_as_read)
      member(value, key).fail("is not what was rounded to the scene's object. " + trace_advice);
  };
  require("a_as_read", scene.a_as_read, scene.a);
  require("b_as_read", scene.b_as_read, scene.b);
}

void read(const Value& value, const How&, Scene& scene) {
  expect(value, Kind::object, "an object that describes a scene");
  const Space space{.dimension = dimension_of(value), .numbers = numbers_of(chosen(value, "scalar", Scalar::binary64))};
  read<Scene>(value, {.space = &space}, scene);
  certified_of(value, scene.a, scene.b);
  if (!value.is_good()) return;
  require_rounded(value, scene);
  scene = in_its_scalar(std::move(scene));
  if (scene.mistake) require_usual_search(member(value, "mistake"), scene);
}

void read(const Value& value, const How&, std::vector<Remark>& remarks) {
  read_list(value, "a list of remarks", trace_limits::remarks, "is one remark too many; there may be 100", remarks);
}

// -- The header -------------------------------------------------------------------------------------------------------

std::vector<Scene> read_scenes(const Value& value) {
  std::vector<Scene> scenes;
  read_list(value, "a list of scenes", 2, "is a third scene; a walkthrough has at most two", scenes);
  if (scenes.size() == 2 && scenes[0].name == scenes[1].name)
    value.fail("has two scenes of the name " + in_quotes(scenes[0].name) + "; their lines could not be told apart");
  return scenes;
}

/// A letter for each corner of a hull.
void require_letters_for_corners(const Value& naming, const std::vector<Scene>& scenes) {
  for (const Scene& scene : scenes) {
    const std::size_t a = vertices_of(scene.a).size(), b = vertices_of(scene.b).size();
    if (scene.dimension != Dimension::plane || a == 0 || b == 0)
      return naming.fail("'corners' needs point sets in the plane; others have no corners to name: write 'roles'");
    if (a > trace_limits::differences / b || difference_hull(scene).corners.size() > trace_limits::corners)
      naming.fail("'corners' has letters for 26 corners, and this difference has more: write 'roles'");
  }
}

void read_presentation(const Value& value, Walkthrough& walkthrough) {
  read(value, {}, walkthrough);
  if (!value.is_good()) return;
  const Value layout = member(value, "layout");
  if (walkthrough.naming == Naming::corners) require_letters_for_corners(member(value, "naming"), walkthrough.scenes);
  const std::size_t scenes = walkthrough.layout == Layout::search ? 1 : 2;
  if (walkthrough.scenes.size() != scenes)
    layout.fail("'" + layout.text() + "' shows " + std::to_string(scenes) + (scenes == 1 ? " scene" : " scenes") +
                ", but the trace has " + std::to_string(walkthrough.scenes.size()));
  for (const Scene& scene : walkthrough.scenes)
    if (scene.mistake && (walkthrough.layout != Layout::until_they_part || &scene != &walkthrough.scenes[0]))
      layout.fail("shows no mistake; 'until-they-part' does, of the first scene, with the report's run as the second");
  if (walkthrough.close_up.has_value() != (walkthrough.layout == Layout::close_ups))
    layout.fail("'close_up' is there exactly where the layout is 'close-ups'");
}

/// A name like "regions/2-simplex-r3".
std::string read_name(const Value& value) {
  expect(value, Kind::string, "a string");
  if (const std::string objection = objection_to_name(value.text()); !objection.empty()) value.fail(objection);
  return value.text();
}

/// Returns: its version, if this is a trace, and one that this program knows: before anything else can look wrong about it.
int known_version(const Value& root) {
  const auto schema = root.is(Kind::object) ? root.member("schema") : std::nullopt;
  if (!schema || !schema->is(Kind::string) || schema->text() != "gjkstep-trace")
    root.fail("is not the first line of a trace: it has no \"schema\": \"gjkstep-trace\". " + trace_advice);
  const Value version = member(root, "version");
  expect(version, Kind::number, "a number");
  if (version.number() != trace_version && version.number() != oldest_trace_version)
    version.fail("version " + number_text(version.number()) + " is not known. This program reads versions " +
                 std::to_string(oldest_trace_version) + " and " + std::to_string(trace_version) + ". " + trace_advice);
  return version.number() == oldest_trace_version ? oldest_trace_version : trace_version;
}

// -- Events -----------------------------------------------------------------------------------------------------------

template <class E>
gjk::Event<double> read_as(const Value& line) {
  E event;
  std::vector<std::string> known = keys_of(event).all;
  known.insert(known.end(), {"scene", "iteration", "event"});
  for (const Value& each : line.children())
    if (std::ranges::count(known, each.key()) == 0) each.fail("is not a key of " + in_quotes(FieldsOf<E>::event));
  read_fields(line, {}, event);
  read(member(line, "iteration"), {Meaning::iterations}, event.iteration);
  return event;
}

}  // namespace

gjk::Event<double> read_event(const Value& line) {
  const auto read_one_of = [&]<class... Events>(std::type_identity<std::variant<Events...>>) {
    constexpr std::array readers{read_as<Events>...};
    return readers[choice(member(line, "event"), event_names)](line);
  };
  return read_one_of(std::type_identity<gjk::Event<double>>{});
}

Walkthrough read_header(const Value& root, int& version) {
  version = known_version(root);
  expect_object(root, {"schema", "version", "walkthrough", "scalar", "presentation", "scenes"}, "an object");
  constexpr std::array<std::string_view, 1> scalars{"double"};
  choice(member(root, "scalar"), scalars);
  Walkthrough walkthrough;
  walkthrough.name = read_name(member(root, "walkthrough"));
  walkthrough.scenes = read_scenes(member(root, "scenes"));
  read_presentation(member(root, "presentation"), walkthrough);
  return walkthrough;
}

}  // namespace walkthroughs::trace
