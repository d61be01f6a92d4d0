// What is true of a scene, beside what its search answers.

#include "walkthroughs/model/truth.hpp"

#include "tests/kit/catch.hpp"
#include "tests/kit/dice.hpp"
#include "tests/walkthroughs/truth_about.hpp"
#include "walkthroughs/model/moment.hpp"

namespace truth_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;
using gjk::Status;

namespace {

Scene plane_scene(const std::vector<Point>& a, const std::vector<Point>& b) {
  return walkthrough_of(a, {}, b).scenes[0];
}

Status shown(const Scene& scene) { return answer_of(run(scene)); }

Truth truth(const Scene& scene) { return truth_of(scene, shown(scene)); }

/// Two segments that share an end; as doubles, too.
Scene shared_end() { return plane_scene({{0, 0.5, 0}, {0.3, 0.2, 0}}, {{0.3, 0.8, 0}, {0, 0.5, 0}}); }

/// In decimals the point lies on the segment. In doubles it does not.
Scene near_segment() { return plane_scene({{0, 0, 0}, {-2, -3, 0}}, {{-0.2, -0.3, 0}}); }

}  // namespace

TEST_CASE("Two segments that share an end are found apart, and touch in truth, by a certificate") {
  const Scene scene = shared_end();
  REQUIRE(shown(scene) == Status::separated);
  const Truth known = truth(scene);
  CHECK(known.answer.status == Status::intersecting);
  REQUIRE(known.answer.nearest.size() == 1);
  CHECK(known.answer.nearest[0] == gjk::IndexPair{0, 1});
  CHECK(is_otherwise(known, Status::separated));
  CHECK_FALSE(is_otherwise(known, Status::intersecting));
  CHECK(says_more(known, Status::separated));
}

TEST_CASE("Decimals as typed may answer otherwise than their doubles") {
  const Scene scene = near_segment();
  const Truth known = truth(scene);
  CHECK(known.answer.status == truth_about(scene));
  CHECK(known.answer.status == Status::separated);
  CHECK(known.of_decimals == Status::intersecting);
  Scene of_whole_numbers = plane_scene({{0, 0, 0}, {-20, -30, 0}}, {{-2, -3, 0}});
  CHECK_FALSE(truth(of_whole_numbers).of_decimals);
  // What has a factor of ten to spare, or needs one, is the same number.
  for (const double power : {1e-12, 1e-3, 1e6}) {
    Scene scaled = plane_scene({{0, 0, 0}, {-2 * power, -3 * power, 0}}, {{-power, -power, 0}});
    CHECK_FALSE(truth(scaled).of_decimals);
  }
  // Of any size, and of as many digits as doubles have.
  for (const std::string exponent : {"e-50", "e23", "e60"}) {
    const auto at = [&](const std::string& digits) { return std::stod(digits + exponent); };
    INFO(exponent);
    const Scene scaled = plane_scene({{0, 0, 0}, {at("-2"), at("-3"), 0}}, {{at("-0.2"), at("-0.3"), 0}});
    CHECK((truth(scaled).of_decimals == Status::intersecting) == (truth_about(scaled) == Status::separated));
  }
  const Scene of_many_digits = plane_scene({{0, 0, 0}, {0.6666666666666666, 0.3333333333333333, 0}},
                                           {{0.2222222222222222, 0.1111111111111111, 0}});
  CHECK(truth(of_many_digits).answer.status == truth_about(of_many_digits));
  CHECK((truth(of_many_digits).of_decimals == Status::intersecting) ==
        (truth_about(of_many_digits) == Status::separated));
}

TEST_CASE("Where rounding the matrix of a turn may have decided that is known, also where the search is right of it") {
  const auto turned = [](double degrees, std::vector<Point> a, std::vector<Point> b) {
    Scene scene = plane_scene(a, b);
    scene.a.pose.rotation =
        Eigen::AngleAxisd(degrees * static_cast<double>(EIGEN_PI) / 180, Point::UnitZ()).toRotationMatrix();
    return scene;
  };
  // 2 cos 60° is 1: they touch, in no doubles.
  const Scene touching = turned(60, {{2, 0, 0}, {4, 0, 0}}, {{1, -5, 0}, {1, 5, 0}});
  CHECK(truth(touching).answer.status == shown(touching));
  CHECK(truth(touching).by_rounded_turn);
  CHECK(says_more(truth(touching), shown(touching)));
  CHECK_FALSE(truth(turned(60, {{2, 0, 0}, {4, 0, 0}}, {{0.99, -5, 0}, {0.99, 5, 0}})).by_rounded_turn);
  // A matrix that was written is taken as it stands.
  Scene written = touching;
  written.a.pose.matrix_as_written = true;
  CHECK_FALSE(truth(written).by_rounded_turn);
}

TEST_CASE("What the search answers with a and b exchanged is known where it is another") {
  const Truth known = truth(shared_end());
  CHECK(known.exchanged == Status::intersecting);
  CHECK_FALSE(truth(walkthrough("figure-4-left").scenes[0]).exchanged);
  Scene proven = shared_end();
  proven.certified = true;
  CHECK_FALSE(says_more(truth(proven), Status::intersecting));
  for (const Walkthrough* w : find_walkthroughs("mistakes"))
    for (const Scene& scene : w->scenes)
      if (scene.mistake) CHECK_FALSE(truth(scene).exchanged);
}

TEST_CASE("A search between the centers is exchanged from the other side, whatever it is rounded to") {
  kit::Dice dice(9);
  const auto points = [&] {
    const auto number = [&] { return dice.between(-300, 300) / 100.0; };
    return Points{{number(), number(), number()}, {number(), number(), number()}, {number(), number(), number()}};
  };
  for (int i = 0; i < 300; ++i) {
    Scene scene;
    scene.a = {"a", points()};
    scene.b = {"b", points()};
    std::get<Points>(scene.b.form)[0] = std::get<Points>(scene.a.form)[0];
    scene.rules = RuleSet::eager;
    scene.options.iteration_limit = dice.between(1, 3);  // so that answers depend on the way
    const bool is_float = dice.coin();
    const auto searched = [&](Scene made) {
      made = from_center_to_center(std::move(made));
      return is_float ? in_float(std::move(made)) : made;
    };
    Scene exchanged = scene;
    std::swap(exchanged.a, exchanged.b);
    INFO("scene " << i);
    const Scene between = searched(scene);
    CHECK(truth(between).exchanged.value_or(shown(between)) == shown(searched(exchanged)));
  }
}

TEST_CASE("Decimals are known of quaternions, and of round shapes under a written matrix") {
  Scene turned = plane_scene({{1, 2, 3}}, {{1, -1.2, 3.4}, {1, 5, 3.4}});
  turned.a.pose.quaternion = gjk::Quaternion{2, 1, 0, 0};
  turned.a.pose.rotation = matrix_of(*turned.a.pose.quaternion);
  CHECK(truth(turned).answer.status == Status::separated);
  CHECK(truth(turned).of_decimals == Status::intersecting);
  // (1, 0, 0) comes to (0.6, 0.8, 0); a ball of radius 1 beside it ends there, in decimals.
  Scene written;
  written.a = {"a", Ball{{1.1, 0, 0}, 0.1}};
  written.a.pose.rotation << 0.6, -0.8, 0, 0.8, 0.6, 0, 0, 0, 1;
  written.a.pose.matrix_as_written = true;
  written.b = {"b", Ball{{0.66, 1.88, 0}, 0.9}};
  const Truth known = truth(written);
  CHECK((known.answer.status == Status::intersecting || known.of_decimals == Status::intersecting));
  // Of more digits than doubles hold nothing is known, and that is told.
  Scene of_many_digits;
  of_many_digits.a = {"a", Ball{{1.0 / 3, 0, 0}, 1.0 / 3}};
  of_many_digits.b = {"b", Ball{{1, 0, 0}, 0.33333333333333337}};
  CHECK(truth(of_many_digits).of_decimals == Status::undecided);
  of_many_digits.b.form = Ball{{2, 0, 0}, 0.33333333333333337};
  CHECK_FALSE(truth(of_many_digits).of_decimals);
}

TEST_CASE("The truth of a scene in float is that of the numbers as read") {
  // 0.1 is above its float, so that the point is outside of the triangle as read, and on its edge in floats.
  const Scene scene = in_float(plane_scene({{0, 0, 0}, {0.1, 0, 0}, {0, 1, 0}}, {{0.10000000149011612, 0, 0}}));
  REQUIRE(scene.a_as_read);
  CHECK_FALSE(scene.b_as_read);
  CHECK(truth_about(scene) == Status::intersecting);
  CHECK(truth_about(*scene.a_as_read, scene.b) == Status::separated);
  CHECK(truth(scene).answer.status == Status::separated);
  CHECK(is_same(*in_float(scene).a_as_read, *scene.a_as_read));
}

TEST_CASE("Of a scene that leaves the truth out nothing is computed beside its search") {
  Scene scene = shared_end();
  const Status answer = shown(scene);
  scene.leaves_truth_out = true;
  scene.a.support_calls = 0;
  CHECK_FALSE(says_more(truth_of(scene, answer), answer));
  CHECK(scene.a.support_calls == 0);
}

TEST_CASE("The truth about the catalogue's sets of points is that of linear equations") {
  for (const Walkthrough& w : whole_catalogue())
    for (const Scene& scene : w.scenes) {
      const std::size_t pairs = vertices_of(a_as_read(scene)).size() * vertices_of(b_as_read(scene)).size();
      if (pairs == 0 || pairs > 12) continue;
      INFO(w.name << ", " << scene.name);
      CHECK(truth(scene).answer.status == truth_about(a_as_read(scene), b_as_read(scene)));
    }
}

}  // namespace truth_test
