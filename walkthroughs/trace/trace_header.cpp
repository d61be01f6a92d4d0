#include "walkthroughs/trace/trace_header.hpp"

#include <algorithm>
#include <utility>

#include "walkthroughs/model/labelled_hull.hpp"
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/model/precision.hpp"
#include "walkthroughs/model/words_of.hpp"
#include "walkthroughs/text/names.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/trace/trace_json.hpp"
#include "walkthroughs/trace/trace_values.hpp"

namespace walkthroughs {
namespace {

using namespace reading;

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

/// What else the scene says must be what a mistake is known with.
Mistake read_mistake(const Value& value, const Scene& scene) {
  expect(value, Kind::string, "a string");
  const auto known = wrong_on_purpose::all();
  const auto found = std::ranges::find(known, value.text(), &wrong_on_purpose::Description::word);
  if (found == known.end()) value.fail("is " + in_quotes(value.text()) + ", which is no mistake that is known");
  const Scene usual = mistaken(scene, found->value);
  if (scene.rules != usual.rules || scene.options.crossing_test != usual.options.crossing_test ||
      scene.zero_test != usual.zero_test || scene.scalar != usual.scalar || scene.certified)
    value.fail("is made with 'rules' " + in_quotes(to_string(usual.rules)) +
               ", the crossing test on, the exact zero test and in double, and this scene says otherwise");
  return found->value;
}

Scene read_scene(const Value& value) {
  expect_object(value,
                {"name", "dimension", "a", "b", "first_direction", "iteration_limit", "crossing_test", "rules",
                 "zero_test", "scalar", "certified", "mistake"},
                "an object that describes a scene");
  const std::string name = words(member(value, "name"), scene_limits::name);
  const Scalar scalar = scalar_of(value);
  const Space space{
      .dimension = whole_number(member(value, "dimension"), 2, 3) == 2 ? Dimension::plane : Dimension::space,
      .numbers = numbers_of(scalar)};
  Object a = read_object(member(value, "a"), space, scalar), b = read_object(member(value, "b"), space, scalar);
  const gjk::Options<double> options{
      .first_direction = space.first_direction(member(value, "first_direction")),
      .iteration_limit = whole_number(member(value, "iteration_limit"), 1, scene_limits::iterations),
      .crossing_test = enumerator<gjk::CrossingTest>(member(value, "crossing_test"), words_of::crossing_test)};
  const auto rules = enumerator<RuleSet>(member(value, "rules"), words_of::rules);
  const auto zero = value.member("zero_test");
  const ZeroTest zero_test = zero ? enumerator<ZeroTest>(*zero, words_of::zero_test) : ZeroTest::exact;
  const bool certified = certified_of(value, a, b);
  Scene scene =
      in_its_scalar({name, std::move(a), std::move(b), options, space.dimension, rules, zero_test, scalar, certified});
  if (const auto mistake = value.member("mistake")) scene.mistake = read_mistake(*mistake, scene);
  return scene;
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

std::vector<Remark> read_remarks(const Value& value) {
  expect(value, Kind::list, "a list of remarks");
  std::vector<Remark> remarks;
  for (const Value& each : value.children()) {
    if (remarks.size() == trace_limits::remarks) each.fail("is one remark too many; there may be 100");
    expect_object(each, {"at", "iteration", "text", "only_for", "fact", "contradicts"},
                  "an object with 'at', 'iteration' and 'text'");
    const auto at = enumerator<Remark::At>(member(each, "at"), words_of::remark_at);
    const int in_iteration = iteration(member(each, "iteration"));
    const std::string text = sentence(member(each, "text"));
    const std::string only_for = each.member("only_for") ? sentence(member(each, "only_for")) : "";
    const std::string fact = each.member("fact") ? sentence(member(each, "fact")) : "";
    const std::optional<Value> contradicts = each.member("contradicts");
    if (contradicts) expect(*contradicts, Kind::boolean, "true or false");
    remarks.push_back({at, in_iteration, text, only_for, fact, contradicts && contradicts->is_true()});
  }
  return remarks;
}

CloseUp read_close_up(const Value& value) {
  expect_object(value, {"iteration", "direction", "support", "crossing"}, "an object that describes a move");
  const int in_iteration = whole_number(member(value, "iteration"), 2, scene_limits::iterations);
  const std::string direction = sentence(member(value, "direction")), support = sentence(member(value, "support"));
  return {in_iteration, direction, support, sentence(member(value, "crossing"))};
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
  expect_object(value, {"title", "source", "summary", "layout", "panels", "naming", "begins", "remarks", "close_up"},
                "an object that says how the trace is presented");
  walkthrough.title = words(member(value, "title"), scene_limits::title);
  walkthrough.source = sentence(member(value, "source"));
  walkthrough.summary = sentence(member(value, "summary"));
  const Value layout = member(value, "layout"), naming = member(value, "naming");
  walkthrough.layout = enumerator<Layout>(layout, words_of::layout);
  walkthrough.panels = panels_in(member(value, "panels"));
  walkthrough.naming = enumerator<Naming>(naming, words_of::naming);
  if (walkthrough.naming == Naming::corners) require_letters_for_corners(naming, walkthrough.scenes);
  if (const auto begins = value.member("begins")) {
    choice(*begins, std::array{begins_with_the_guess});
    walkthrough.begins_with_the_guess = true;
  }
  if (const auto remarks = value.member("remarks")) walkthrough.remarks = read_remarks(*remarks);
  if (const auto move = value.member("close_up")) walkthrough.close_up = read_close_up(*move);
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
  if (version.number() != trace_version)
    version.fail("version " + number_text(version.number()) + " is not known; this program reads version " +
                 std::to_string(trace_version) + ": " + trace_advice);
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
