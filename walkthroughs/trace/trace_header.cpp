#include "walkthroughs/trace/trace_header.hpp"

#include <utility>

#include "walkthroughs/model/labelled_hull.hpp"
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/model/precision.hpp"
#include "walkthroughs/text/names.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/trace/header_fields.hpp"
#include "walkthroughs/trace/read_fields.hpp"
#include "walkthroughs/trace/trace_json.hpp"

namespace walkthroughs {
namespace reading {

// -- Fields that only scenes have -------------------------------------------------------------------------------------

static void read(const Value& value, const How&, Dimension& dimension) {
  dimension = whole_number(value, 2, 3) == 2 ? Dimension::plane : Dimension::space;
}

static void read(const Value& value, const How& how, Eigen::Matrix3d& rotation) {
  if (!expect(value, Kind::list, "a matrix of three rows")) return;
  const std::vector<Value> rows = value.children();
  if (rows.size() != 3) return value.fail("expected three rows, found " + std::to_string(rows.size()));
  for (int row = 0; row < 3; ++row)
    rotation.row(row) = Space{Dimension::space}.point(rows[static_cast<std::size_t>(row)]);
  const Scalar scalar = how.space->numbers == Numbers::floats ? Scalar::binary32 : Scalar::binary64;
  const double allowed = 64 * precision_of(scalar).epsilon;  // some roundings of sines and cosines
  const Eigen::Matrix3d product = rotation * rotation.transpose();
  if (!((product - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <= allowed && rotation.determinant() > 0))
    value.fail("is not a rotation: its rows are not perpendicular unit vectors in right-handed order");
  if (how.space->is_plane() && (rotation(2, 0) != 0 || rotation(2, 1) != 0))
    value.fail("turns the object out of the plane");
}

static void read(const Value& value, const How& how, Object& object) {
  if (!expect_object(value, object_keys(), "an object with a shape")) return;
  object.form = read_shape(value, *how.space);
  object.name = words(member(value, "name"), scene_limits::name);
  if (const auto pose = value.member("pose")) read(*pose, how, object.pose);
}

static void read(const Value& value, const How&, Panels& panels) { panels = panels_in(value); }

/// What else a scene says must be what its mistake is known with.
static void require_usual_search(const Value& mistake, const Scene& scene) {
  const Scene usual = mistaken(scene, *scene.mistake);
  if (scene.rules != usual.rules || scene.options.crossing_test != usual.options.crossing_test ||
      scene.zero_test != usual.zero_test || scene.scalar != usual.scalar || scene.certified)
    mistake.fail("is made with 'rules' " + in_quotes(to_string(usual.rules)) +
                 ", the crossing test on, the exact zero test and in double, and this scene says otherwise");
}

static void read(const Value& value, const How&, Scene& scene) {
  expect(value, Kind::object, "an object that describes a scene");
  const Space space{.dimension = dimension_of(value), .numbers = numbers_of(chosen(value, "scalar", Scalar::binary64))};
  read_record(value, {.space = &space}, scene);
  certified_of(value, scene.a, scene.b);
  if (!value.is_good()) return;
  scene = in_its_scalar(std::move(scene));
  if (scene.mistake) require_usual_search(member(value, "mistake"), scene);
}

static void read(const Value& value, const How& how, std::vector<Remark>& remarks) {
  expect(value, Kind::list, "a list of remarks");
  for (const Value& each : value.children()) {
    if (remarks.size() == trace_limits::remarks) return each.fail("is one remark too many; there may be 100");
    read(each, how, remarks.emplace_back());
  }
}

}  // namespace reading

namespace {

using namespace reading;

std::vector<Scene> read_scenes(const Value& value) {
  expect(value, Kind::list, "a list of scenes");
  std::vector<Scene> scenes;
  for (const Value& each : value.children()) {
    if (scenes.size() == 2) {
      each.fail("is a third scene; a walkthrough has at most two");
      break;
    }
    read(each, {}, scenes.emplace_back());
  }
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
  read_record(value, {}, walkthrough);
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

/// Whether this is a trace, and one that this program knows: before anything else can look wrong about it.
void require_known_version(const Value& root) {
  const auto schema = root.is(Kind::object) ? root.member("schema") : std::nullopt;
  if (!schema || !schema->is(Kind::string) || schema->text() != "gjkstep-trace")
    root.fail("is not the first line of a trace: it has no \"schema\": \"gjkstep-trace\"; " + trace_advice);
  const Value version = member(root, "version");
  expect(version, Kind::number, "a number");
  if (version.number() != trace_version && version.number() != oldest_trace_version)
    version.fail("version " + number_text(version.number()) + " is not known; this program reads versions " +
                 std::to_string(oldest_trace_version) + " and " + std::to_string(trace_version) + ": " + trace_advice);
}

}  // namespace

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

}  // namespace walkthroughs
