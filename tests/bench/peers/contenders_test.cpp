/// Who can be asked about what.
#include <algorithm>

#include "tests/bench/peers/match.hpp"
#include "tests/kit/catch.hpp"

namespace peers {

// Made elsewhere, so that the tests need no other library.
std::vector<Contender> gjkstep_contenders();
std::vector<Contender> cgal_contenders();

namespace test {
namespace {

Answer answer(const Contender& contender, const study::Pair& pair) { return contender.prepare({pair})->ask(0); }

const study::Points triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
const study::Points tetrahedron{{0, 0, -1}, {3, 0, -1}, {0, 3, -1}, {0.25, 0.25, 1}};
const study::Points quadrangle{{0, 0, 5}, {1, 0, 5}, {0, 1, 5}, {1, 1, 5}};
const study::Points segment{{0, 0, 5}, {1, 1, 5}}, in_a_line{{0, 0, 5}, {1, 1, 5}, {2, 2, 5}};
const study::Ball ball{{9, 9, 9}, 1};

TEST_CASE("CGAL is asked about triangles and tetrahedra that are not flat", "[peers]") {
  const Contender exact = cgal_contenders().front();
  CHECK_FALSE(exact.is_peer);
  study::Points beside = triangle;
  for (study::Vec& point : beside) point.x() += 1.5;
  CHECK(answer(exact, {triangle, tetrahedron}) == Answer::intersecting);
  CHECK(answer(exact, {tetrahedron, triangle}) == Answer::intersecting);
  CHECK(answer(exact, {tetrahedron, tetrahedron}) == Answer::intersecting);
  CHECK(answer(exact, {triangle, beside}) == Answer::separated);
  for (const study::Body& other :
       {study::Body(quadrangle), study::Body(segment), study::Body(in_a_line), study::Body(ball)}) {
    CHECK(answer(exact, {triangle, other}) == Answer::not_asked);
    CHECK(answer(exact, {other, tetrahedron}) == Answer::not_asked);
  }
}

TEST_CASE("Proven answers are asked about sets of points only and stand after what they prove", "[peers]") {
  const std::vector<Contender> ours = gjkstep_contenders();
  int provers = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    INFO(ours[i].name);
    CHECK_FALSE(ours[i].is_peer);
    CHECK(answer(ours[i], {triangle, quadrangle}) == Answer::separated);
    CHECK(answer(ours[i], {triangle, tetrahedron}) == Answer::intersecting);
    if (ours[i].proves.empty()) {
      CHECK(answer(ours[i], {triangle, ball}) == Answer::separated);
      continue;
    }
    ++provers;
    CHECK(answer(ours[i], {triangle, ball}) == Answer::not_asked);
    CHECK(std::any_of(ours.begin(), ours.begin() + static_cast<std::ptrdiff_t>(i),
                      [&](const Contender& other) { return other.name == ours[i].proves; }));
  }
  CHECK(provers == 3);
}

TEST_CASE("In a match who is not asked is neither wrong nor timed", "[peers]") {
  std::vector<Contender> all = gjkstep_contenders();
  for (Contender& contender : cgal_contenders()) all.push_back(contender);
  const Match match = play(study::family_named("spheres"), all, {.seed = 1, .pairs = 4, .repeats = 1});
  for (std::size_t i = 0; i < all.size(); ++i) {
    INFO(all[i].name);
    const bool is_asked = all[i].name != exact_peer && all[i].proves.empty();
    CHECK(match.scores[i].not_asked == (is_asked ? 0 : 4));
    CHECK(match.scores[i].false_positives + match.scores[i].false_negatives == 0);
    CHECK((match.scores[i].nanoseconds > 0) == is_asked);
  }
}

}  // namespace
}  // namespace test
}  // namespace peers
