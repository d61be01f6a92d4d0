// No sentence under a picture is false, unless it, or one beside it, says what exact arithmetic finds.

#include <cmath>
#include <map>
#include <numbers>

#include "tests/kit/catch.hpp"
#include "tests/kit/dice.hpp"
#include "tests/kit/text.hpp"
#include "tests/walkthroughs/truth_about.hpp"
#include "walkthroughs/model/moment.hpp"

namespace truthful_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;
using gjk::Status;
using gjk::test::ExactVec;
using gjk::test::ExactVecs;
using gjk::test::Rational;
using kit::has;

namespace {

// -- Scenes -----------------------------------------------------------------------------------------------------------

/// Pairs of one to three points each, in the plane and in space: small whole numbers; two decimals with a shared point;
/// powers of ten; contact by construction. And in space round shapes and boxes of small whole numbers, half of them moved by
/// poses, as some of the points are.
class HostileScenes {
 public:
  explicit HostileScenes(std::uint64_t seed) : dice_(seed) {}

  Walkthrough next() {
    const int kind = dice_.between(0, 5);
    is_plane_ = kind < 4 && dice_.coin();
    unit_ = kind == 2 ? std::pow(10.0, dice_.between(-150, 150)) : 1;
    decimals_ = kind == 1 || kind == 3 || kind == 5;
    std::vector<Point> a = some_points(), b = some_points();
    if (kind == 1) b[0] = a[0];
    if (kind == 3) b[0] = on_edge(a);
    Walkthrough w = walkthrough_of(a, {}, b);
    w.naming = Naming::roles;
    Scene& scene = w.scenes[0];
    scene.dimension = is_plane_ ? Dimension::plane : Dimension::space;
    if (kind == 4) scene.a.form = some_shape();
    if (kind == 4 && dice_.coin()) scene.b.form = some_shape();
    if (kind == 5 || (kind == 4 && dice_.coin())) scene.a.pose = some_pose();
    scene.rules = static_cast<RuleSet>(dice_.between(0, 3));
    if (kind != 2 && dice_.between(0, 3) == 0) scene = in_float(scene);
    return w;
  }

 private:
  double number() { return decimals_ ? dice_.between(-300, 300) / 100.0 : unit_ * dice_.between(-4, 4); }
  Point point() { return {number(), number(), is_plane_ ? 0 : number()}; }
  std::vector<Point> some_points() {
    std::vector<Point> points(static_cast<std::size_t>(dice_.between(1, 3)));
    for (Point& p : points) p = point();
    return points;
  }
  Pose some_pose() {
    Pose pose{.translation = point()};
    const auto whole = [&] { return static_cast<double>(dice_.between(-2, 2)); };
    switch (dice_.between(0, 2)) {
      case 0:
        pose.quaternion = gjk::Quaternion{whole(), whole(), whole(), 1};
        pose.rotation = matrix_of(*pose.quaternion);
        break;
      case 1:
        pose.matrix_as_written = true;
        pose.rotation << 0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1;
        break;
      default:
        pose.rotation =
            Eigen::AngleAxisd(dice_.between(-6, 6) * std::numbers::pi / 6, Point::UnitZ()).toRotationMatrix();
    }
    return pose;
  }
  AnyShape some_shape() {
    const auto length = [&] { return static_cast<double>(dice_.between(0, 3)); };
    switch (dice_.between(0, 3)) {
      case 0: return Ball{point(), length()};
      case 1: return BoxOf<double>{point(), {length(), length(), length()}};
      case 2: return CapsuleOf<double>{point(), point(), length()};
      default: return Cylinder{point(), {number(), 3, number()}, length(), length()};
    }
  }
  /// Some tenths of the way from one point to another: there in decimals, near there in doubles.
  Point on_edge(const std::vector<Point>& points) {
    const double t = dice_.between(1, 9) / 10.0;
    return (1 - t) * points.front() + t * points.back();
  }

  kit::Dice dice_;
  bool is_plane_ = true, decimals_ = false;
  double unit_ = 1;
};

// -- What is true of a number -----------------------------------------------------------------------------------------

ExactVec cross(const ExactVec& u, const ExactVec& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

ExactVec exact_difference(const gjk::Vertex<double>& vertex) {
  return gjk::test::exact(vertex.a.point) - gjk::test::exact(vertex.b.point);
}

/// The vectors that the report's letters name, by the text of an expression.
class Letters {
 public:
  Letters(const Simplex& simplex, const std::string& formula) : formula_(formula) {
    for (int i = 0; i < simplex.size(); ++i)
      places_[static_cast<char>('A' + simplex.size() - 1 - i)] = exact_difference(simplex[i]);
  }

  ExactVec product(const std::string& text) const {
    const std::size_t times = text.find("×");
    if (times == std::string::npos) return vector(text);
    ExactVec left = vector(text.substr(0, times));
    std::string rest = text.substr(times + 2);  // two bytes
    for (std::size_t next; (next = rest.find("×")) != std::string::npos; rest = rest.substr(next + 2))
      left = cross(left, vector(rest.substr(0, next)));
    return cross(left, vector(rest));
  }

 private:
  ExactVec vector(const std::string& name) const {
    if (name == "AO") return ExactVec(-places_.at('A'));
    if (!name.ends_with('n')) return places_.at(name[1]) - places_.at(name[0]);
    if (name.size() == 3) return product(formula_);
    return cross(places_.at(name[1]) - places_.at(name[0]), places_.at(name[2]) - places_.at(name[0]));
  }

  std::map<char, ExactVec> places_;
  std::string formula_;
};

int sign(const Rational& x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }
int sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

/// Whether the number that an event tells has the sign that it has in fractions.
bool is_right(const gjk::RegionTested<double>& event, const Simplex& simplex) {
  const std::string text = to_string(event.expression);
  if (text.empty()) return true;
  const Letters letters(simplex, to_string(event.formula));
  const std::size_t dot = text.find("·");
  if (dot == std::string::npos) {
    const Point& value = std::get<Point>(event.value);
    return (letters.product(text) == ExactVec(ExactVec::Zero())) == (value == Point::Zero());
  }
  const Rational exact = letters.product(text.substr(0, dot)).dot(letters.product(text.substr(dot + 2)));
  return sign(exact) == sign(std::get<double>(event.value));
}

/// No point of the difference reaches farther along d.
bool is_farthest(const Scene& scene, const gjk::Vertex<double>& found, const Point& d) {
  const auto reach = [&](const Point& a, const Point& b) {
    return (gjk::test::exact(a) - gjk::test::exact(b)).dot(gjk::test::exact(d));
  };
  for (const Point& a : vertices_of(scene.a))
    for (const Point& b : vertices_of(scene.b))
      if (reach(a, b) > reach(found.a.point, found.b.point)) return false;
  return true;
}

ExactVecs exact_differences(const Simplex& simplex) {
  ExactVecs points;
  for (const auto& vertex : simplex) points.push_back(exact_difference(vertex));
  return points;
}

// -- What is said -----------------------------------------------------------------------------------------------------

bool is_hedged(const Frame& frame) {
  const auto is_truth = [](const Fact& fact) { return fact.mark == Fact::Mark::truth; };
  return std::ranges::any_of(frame.facts, is_truth) || has(frame.caption, "search concludes");
}

/// Whether it says that a feature of the simplex holds the origin. On the line AB is not on AB.
bool says_place(const Frame& frame) {
  if (has(frame.caption, "nearest to the origin lies on ")) return false;
  for (const char* place :
       {"lies in triangle", "lies in tetrahedron", "lies on segment", "lies on edge", "is the origin"})
    if (has(frame.caption, place)) return true;
  return false;
}

/// By other means than the program's where there are such.
Status truth_told_of(const Telling& telling) {
  const auto is_points = [](const Object& object) {
    return std::holds_alternative<Points>(object.form) && !moves(object.pose);
  };
  const Object &a = a_as_read(telling.scene), &b = b_as_read(telling.scene);
  return is_points(a) && is_points(b) ? truth_about(a, b) : telling.truth.answer.status;
}

/// Returns: what is false in a frame, and not hedged; empty where nothing is.
std::string falsehood(const Frame& frame, const Scene& scene, const gjk::Event<double>& event) {
  const Moment& now = frame.moments[0];
  const bool is_of_points = std::holds_alternative<Points>(scene.a.form) && !moves(scene.a.pose) &&
                            std::holds_alternative<Points>(scene.b.form);
  const bool claims_farthest = is_of_points && has(frame.caption, "Nothing of the difference reaches farther");
  if (claims_farthest && !is_farthest(scene, *now.found, now.direction->value)) return "reaches farther";
  if (const auto* region = std::get_if<gjk::RegionTested<double>>(&event);
      region && !is_hedged(frame) && !is_right(*region, now.processed))
    return to_string(region->expression);
  if (const auto* region = std::get_if<gjk::RegionTested<double>>(&event);
      region && !is_hedged(frame) && says_place(frame) &&
      !gjk::test::contain_origin(exact_differences(now.processed.only(region->feature))))
    return "place of the origin";
  if (const auto* crossing = std::get_if<gjk::CrossingTested<double>>(&event); crossing && crossing->value)
    if (const Rational exact = exact_difference(*now.found).dot(gjk::test::exact(now.direction->value));
        !is_hedged(frame) && sign(exact) != sign(*crossing->value))
      return "P·d";
  if (const auto* reduction = std::get_if<gjk::SimplexReduced<double>>(&event); reduction && !now.regions.empty()) {
    const bool says_beyond = std::ranges::any_of(
        frame.facts, [](const Fact& fact) { return fact.text.starts_with("the origin lies beyond edge"); });
    if (says_beyond && !is_right(now.regions.back(), now.processed)) return "beyond edge";
  }
  return "";
}

/// Returns: what is false, and not hedged, at the end of a story.
std::string falsehood_at_end(const Story& story) {
  const Frame& last = story.frames.back();
  const Telling& telling = story.tellings[0];
  const Status shown = answer_of(telling.trace), truth = truth_told_of(telling);
  if (truth == Status::undecided) return has(last.caption, "search concludes") ? "" : "not known, and not hedged";
  const bool says_truth = has(
      last.caption, std::string("In truth ") + (truth == Status::intersecting ? "they intersect" : "they are apart"));
  if (shown != truth && !says_truth) return "no truth";
  if (shown == truth && has(last.caption, "In truth")) return "truth where all is right";
  if (shown != truth && !is_hedged(last)) return "not hedged";
  const Simplex simplex = all<gjk::Finished>(telling.trace).at(0).result.simplex;
  if (shown == Status::intersecting && !has(last.caption, "search concludes") &&
      !gjk::test::contain_origin(exact_differences(simplex)))
    return "place of the origin";
  return "";
}

void check_sentences(int scenes, std::uint64_t seed) {
  HostileScenes hostile(seed);
  int otherwise = 0;
  for (int i = 0; i < scenes; ++i) {
    const Walkthrough w = hostile.next();
    const Story story = tell(w);
    otherwise += has(story.frames.back().caption, "In truth");
    INFO("seed " << seed << ", scene " << i << ": " << story.frames.back().caption);
    for (const Frame& frame : story.frames) {
      INFO(frame.caption);
      REQUIRE(falsehood(frame, w.scenes[0], story.tellings[0].trace.events[frame.events[0].last]) == "");
    }
    REQUIRE(falsehood_at_end(story) == "");
  }
  CHECK(otherwise > scenes / 50);  // or the scenes are not hostile
}

}  // namespace

TEST_CASE("Where points overflow nothing is said of exact numbers") {
  Walkthrough w = walkthrough("as-printed-spheres");
  w.layout = Layout::search;
  w.scenes = {w.scenes[1]};
  w.remarks = {};
  w.scenes[0].a.form = Ball{{3e38, 0, 0}, 3e38};
  w.scenes[0].b.form = Ball{{-3e38, 1, 0}, 3e38};
  w.scenes[0] = in_float(w.scenes[0]);
  const Story story = tell(w);
  REQUIRE_FALSE(all<gjk::SupportFound>(story.tellings[0].trace).at(0).vertex.a.point.allFinite());
  CHECK(has(story.frames.back().caption, "In truth they are apart."));
}

TEST_CASE("Three hundred hostile scenes are told without a sentence that is false and not hedged") {
  check_sentences(300, 20261128);
}

TEST_CASE("Ten thousand hostile scenes are told without a sentence that is false and not hedged",
          "[unsanitized][full]") {
  check_sentences(10000, 37);
}

}  // namespace truthful_test
