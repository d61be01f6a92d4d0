#include "walkthroughs/text/scene_text.hpp"

#include "render/color.hpp"
#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/model/words_of.hpp"
#include "walkthroughs/text/names.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/text/scene_limits.hpp"
#include "walkthroughs/text/scene_values.hpp"

namespace walkthroughs::text {
namespace {

using namespace reading;

// -- Objects -----------------------------------------------------------------------------------------------------------

/// Divides directions as core/ divides them. Of a scene in floats they are divided in floats: the axis is the one that its
/// numbers have as floats.
struct DividedDirections : Cast<double> {
  Scalar scalar;

  Point direction(const Point& d) const {
    return with_scalar(scalar, [&]<class S>() -> Point {
      const gjk::Vec3<S> in_scalar = InScalar<S>{}.direction(d);
      return (in_scalar / in_scalar.cwiseAbs().maxCoeff()).template cast<double>();
    });
  }
};

Object scene_object(const Value& value, const Space& space, Scalar scalar) {
  Object object = read_object(value, space);
  object.form = converted<double>(object.form, DividedDirections{{}, scalar});
  return object;
}

/// Objects without a name are called what they are; two of a kind are told apart.
void name_the_nameless(Object& a, Object& b, const Space& space) {
  const std::string kind_of_a = kind_of(a.form, space.dimension), kind_of_b = kind_of(b.form, space.dimension);
  const bool alike = kind_of_a == kind_of_b;
  if (a.name.empty()) a.name = kind_of_a + (alike ? " a" : "");
  if (b.name.empty()) b.name = kind_of_b + (alike ? " b" : "");
}

// -- The rest ---------------------------------------------------------------------------------------------------------

gjk::Options<double> read_options(const Value& root, const Space& space) {
  gjk::Options<double> options;
  if (const auto first = root.member("first_direction")) options.first_direction = space.first_direction(*first);
  if (const auto limit = root.member("iteration_limit"))
    options.iteration_limit = whole_number(*limit, 1, scene_limits::iterations);
  options.crossing_test = chosen(root, "crossing_test", options.crossing_test);
  return options;
}

std::optional<render::Size> read_size(const Value& root) {
  const auto value = root.member("size");
  if (!value) return std::nullopt;
  const std::string expected = "expected \"1280x720\" or [1280, 720], each from " + std::to_string(render::min_pixels) +
                               " to " + std::to_string(render::max_pixels);
  if (value->is(Kind::string)) {
    const auto size = size_in(value->text());
    if (!size) value->fail(expected + ", found " + in_quotes(value->text()));
    return size;
  }
  if (!value->is(Kind::list)) value->fail(expected + ", found " + std::string(value->description()));
  const std::vector<Value> sides = value->children();
  if (sides.size() != 2) {
    value->fail(expected + ", found a list of " + std::to_string(sides.size()));
    return std::nullopt;
  }
  const auto side = [](const Value& v) { return whole_number(v, render::min_pixels, render::max_pixels); };
  return render::Size{side(sides[0]), side(sides[1])};
}

std::optional<double> read_text_scale(const Value& root) {
  const auto value = root.member("text_scale");
  if (!value) return std::nullopt;
  const double scale = number(*value);
  if (scale < render::least_text_scale || scale > render::most_text_scale)
    value->fail("expected a number from " + number_text(render::least_text_scale) + " to " +
                number_text(render::most_text_scale) + ", found " + number_text(scale));
  return scale;
}

Naming read_letters(const Value& root) {
  const auto value = root.member("letters");
  return value && choice(*value, words_of::letters) == 1 ? Naming::fixed : Naming::roles;
}

/// Pairs may note their answer as their truth.
bool is_answer(const Value& value) { return std::ranges::count(words_of::all(gjk::Status()), value.text()) > 0; }

std::optional<Mistake> read_mistake(const Value& root, const Scene& scene) {
  const auto value = root.member("mistake");
  if (!value) return std::nullopt;
  const auto mistake = static_cast<Mistake>(choice(*value, words_of::all(Mistake())));
  if (!may_be_mistaken(scene))
    value->fail("is made in the report's rules: 'rules' \"as-intended\", the crossing test on, the exact zero test, in double, "
                "not certified. This scene says otherwise");
  return mistake;
}

SceneFile read_root(const Value& root, const std::string& file_name) {
  expect_scene_or_pair(root, "an object { ... } that holds the scene");
  const auto title = root.member(root.member("title") ? "title" : "name");
  const std::string heading = title ? words(*title, scene_limits::title) : title_from_file(file_name);
  const auto scalar = chosen(root, "scalar", Scalar::binary64);
  const bool is_flat = !root.member("dimension") && is_planar(root);
  const Space space{.dimension = is_flat ? Dimension::plane : dimension_of(root), .numbers = numbers_of(scalar)};
  Object a = scene_object(required(root, "a", "give the first object"), space, scalar);
  Object b = scene_object(required(root, "b", "give the second object"), space, scalar);
  if (!root.is_good()) return {};
  name_the_nameless(a, b, space);
  const gjk::Options<double> options = read_options(root, space);
  const auto rules = chosen(root, "rules", RuleSet::as_intended);
  const auto zero_test = chosen(root, "zero_test", ZeroTest::exact);
  const bool certified = certified_of(root, a, b);
  Scene scene{"scene", std::move(a), std::move(b), options, space.dimension, rules, zero_test, scalar, certified};
  if (const auto truth = root.member("truth"); truth && !is_answer(*truth))
    scene.leaves_truth_out = !true_or_false(*truth);
  if (gjk::first_point(rules) == gjk::FirstPoint::tested && !root.member("first_direction"))
    scene = from_center_to_center(std::move(scene));

  SceneFile file;
  file.walkthrough = {.name = name_from_file(file_name), .title = heading, .source = "scene file", .summary = heading};
  if (const auto panels = root.member("panels")) file.walkthrough.panels = panels_in(*panels);
  file.size = read_size(root);
  file.text_scale = read_text_scale(root);
  file.walkthrough.naming = read_letters(root);
  const std::optional<Mistake> mistake = read_mistake(root, scene);
  if (!root.is_good()) return file;
  file.walkthrough.scenes.push_back(in_its_scalar(std::move(scene)));
  if (mistake) file.walkthrough = beside_mistake(*mistake, std::move(file.walkthrough));
  return file;
}

}  // namespace

Reading<SceneFile> scene_in(std::string_view text, const std::string& file_name) {
  const Document document(text);
  SceneFile file = read_root(document.root(), file_name);
  return {std::move(file), document.complaint()};
}

std::string example_scene() {
  return R"(// A scene for gjkstep. Only a and b must be there; everything else shows its default or an alternative.
{
  "title": "A can beside a tilted box",  // without it: the name of the file
  "dimension": 3,                        // 2: the plane; points are [x, y], spheres are discs

  // The two objects. Each has one shape.
  "a": {
    "name": "box",  // as captions call it
    "points": [     // their convex hull; the order does not matter
      [-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1],
      [-1, -1,  1], [1, -1,  1], [1, 1,  1], [-1, 1,  1]
    ],
    "pose": {  // first turned about the origin, then moved
      "rotation": {"axis": [1, 1, 0], "degrees": 30},  // or {"w": 1, "x": 0, "y": 0, "z": 1}, a quaternion of any
                                                       // length, or a matrix [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
      "translation": [2.5, 0.5, 0]
    }
  },
  "b": {
    "name": "can",
    "cylinder": {"center": [0, 0, 0], "axis": [0, 0, 1], "radius": 1, "height": 2}
    // One of these, in its place; a sum is each point of one shape plus each of the other:
)" + shapes_in_lines("    //   ", "") +
         R"(  },

  // How the algorithm runs.
  "first_direction": [1, 0, 0],  // left out, "eager" goes from the center of a to that of b
  "iteration_limit": 20,
  "crossing_test": "on",   // "off": go on until there are no new points
  "rules": "as-intended",  // "as-printed": Algorithm 1 read literally, with its mistake; "eager": P·d < 0 ends
                           // the search at the first point, too; "complete": keeps what is nearest to the origin,
                           // no region skipped by history; goes round only where numbers round
  "zero_test": "exact",    // "relative": products that rounding may have made count as zero
  "scalar": "double",      // "float": all numbers are rounded to floats, and the search computes in floats
  "certified": false,      // true: the answer is proven, and where doubles cannot do that, found anew by a second
                           // search; of objects that are points, without a pose
  // "mistake": "m14-order-below-triangle",  // the same search with one of 21 mistakes, and where the two part; in the rules
  //                                        // "as-intended", with all else here as it is by default
  "truth": true,           // where the search answers otherwise than the truth, the last picture says so; false: it does not

  // What is shown beside the search. What is left out is not computed. "close-up" magnifies what is around the origin
  // in all pictures of tests; without it only where marks would cover each other.
  "panels": ["objects", "hull", "algorithm", "decision"],
  "letters": "roles",  // A is always the newest vertex; "fixed": each keeps its letter for the whole search
  "size": "1280x720",      // or [1280, 720]; pixels
  "text_scale": 1          // 0.75 to 1.5: all text so many times as large
}
)";
}

std::string summary(const SceneFile& file) {
  const Walkthrough& walkthrough = file.walkthrough;
  const Scene& scene = walkthrough.scenes.back();
  const std::optional<Mistake> mistake = walkthrough.scenes.front().mistake;
  const auto object = [&](const Object& o) { return "'" + o.name + "' (" + described(o.form, scene.dimension) + ")"; };
  Panels shown = walkthrough.panels;
  shown.decision = shown.decision && scene.dimension == Dimension::space;
  std::string panels;
  for (const std::string_view word : words_of::of(shown)) panels.append(", ").append(word);
  return "'" + walkthrough.title + "', " + (scene.dimension == Dimension::plane ? "plane" : "space") + ", " +
         object(scene.a) + " and " + object(scene.b) + (scene.scalar == Scalar::binary32 ? ", in float" : "") +
         (scene.zero_test == ZeroTest::relative ? ", relative zero test" : "") +
         (scene.certified ? ", certified" : "") +
         (mistake ? ", mistake " + wrong_on_purpose::number_of(*mistake) : "") + ", panels: search" + panels;
}

}  // namespace walkthroughs::text
