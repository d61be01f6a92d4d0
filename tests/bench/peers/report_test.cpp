/// What the report says of proofs and of peers that cannot be asked, and who can be asked about what.
#include "tests/bench/peers/report.hpp"

#include <sstream>

#include "tests/kit/catch.hpp"

namespace peers {

// Made elsewhere, so that the tests need no other library.
std::vector<Contender> gjkstep_contenders();
std::vector<Contender> cgal_contenders();

namespace test {
namespace {

Contender named(const std::string& name, bool is_peer = true, const std::string& proves = "") {
  return {.name = name, .how = "made up", .prepare = nullptr, .is_peer = is_peer, .proves = proves};
}

const std::vector<Contender> made_up{named("gjkstep", false), named("gjkstep eager", false),
                                     named("gjkstep certified", false, "gjkstep"), named(exact_peer), named("other")};

/// A family in which they took so long, in the order of `made_up`.
Match match(const std::string& family, const std::vector<double>& nanoseconds) {
  Match match{.family = family, .what = "made up", .pairs = 10, .meet = 5, .raced = 10};
  for (const double time : nanoseconds) {
    Score score;
    score.nanoseconds = time;
    if (time == 0) score.not_asked = 10;
    match.scores.push_back(score);
  }
  return match;
}

std::string report(const std::vector<Match>& matches, const std::vector<Contender>& contenders = made_up) {
  std::ostringstream out;
  write_markdown(out, "Title", matches, contenders);
  return out.str();
}

TEST_CASE("The report tells what a proof costs and how long the exact and the fastest peer take beside it", "[peers]") {
  const std::string text = report({match("triangles", {100, 90, 105, 210, 147})});
  CHECK_THAT(text,
             kit::contains("| what a proof costs | gjkstep certified ÷ gjkstep | CGAL exact ÷ gjkstep certified | "
                           "fastest peer ÷ gjkstep certified |\n"));
  CHECK_THAT(text, kit::contains("| triangles | 1.05 | 2.00 | 1.40 |\n"));
}

TEST_CASE("The report tells where a proven answer takes no longer than an exact one", "[peers]") {
  const std::string text = report({match("triangles", {100, 90, 105, 104, 147}),
                                   match("tetrahedra", {100, 90, 105, 420, 147}), match("hulls-8", {1, 1, 1, 0, 1})});
  CHECK_THAT(text, kit::contains(
                       "* gjkstep certified is at least as fast as CGAL exact on: tetrahedra (4.00, aim 5.0); slower "
                       "on: triangles (0.99)\n"));
  CHECK(report({match("hulls-8", {1, 1, 1, 0, 1})}).find("as CGAL exact on") == std::string::npos);
  CHECK_THAT(report({match("touching", {1, 1, 2, 2, 1})}), kit::contains("as CGAL exact on: touching (1.00)\n"));
}

TEST_CASE("The report tells on which families the fastest peer is slower as is aimed at, and by how much else",
          "[peers]") {
  const std::string text =
      report({match("triangles", {100, 90, 105, 210, 147}), match("scale-1e50", {100, 90, 105, 0, 140})});
  CHECK_THAT(text,
             kit::contains(
                 "* gjkstep is at least 1.5 times as fast as the fastest peer on: none; less on: triangles (1.47)\n"));
  CHECK_THAT(text,
             kit::contains("* gjkstep eager is at least 1.5 times as fast as the fastest peer on: triangles (1.63), "
                           "scale-1e50 (1.56)\n"));
  CHECK_THAT(text,
             kit::contains(
                 "* gjkstep certified is at least 1.5 times as fast as the fastest peer on: none; less on: triangles "
                 "(1.40)\n"));
  CHECK_THAT(text, !kit::contains("other is at least") && !kit::contains("CGAL exact is at least"));
}

TEST_CASE("What was not timed has no ratio", "[peers]") {
  CHECK_THAT(report({match("boxes", {100, 90, 105, 0, 147})}), kit::contains("| boxes | 1.05 | – | 1.40 |\n"));
  CHECK_THAT(report({match("spheres", {100, 90, 0, 0, 147})}), kit::contains("| spheres | – | – | – |\n"));
  const std::string without_others = report({match("boxes", {100, 90, 105})}, {made_up.begin(), made_up.begin() + 3});
  CHECK_THAT(without_others, kit::contains("| boxes | 1.05 | – | – |\n"));
}

TEST_CASE("Where nobody proves anything nothing is said of proofs", "[peers]") {
  const std::string text = report({match("boxes", {100, 90})}, {made_up.begin(), made_up.begin() + 2});
  CHECK(text.find("proof") == std::string::npos);
  CHECK(text.find("takes no longer beside") == std::string::npos);
}

TEST_CASE("Proofs may cost less on hulls than on small sets and on other families nothing is aimed at", "[peers]") {
  const std::string text = report({match("triangles", {1000, 900, 1060, 0, 0}), match("boxes", {1000, 900, 1061, 0, 0}),
                                   match("hulls-32-all-corners", {1000, 900, 1031, 0, 0}),
                                   match("hulls-256-all-corners", {1000, 900, 1030, 0, 0}),
                                   match("touching-face-askew", {1000, 900, 9000, 0, 0})});
  CHECK_THAT(text,
             kit::contains("* gjkstep certified takes no longer beside gjkstep than is aimed at on: triangles (1.060, "
                           "aim 1.06), hulls-256-all-corners (1.030, aim 1.03); longer on: boxes (1.061, aim 1.06), "
                           "hulls-32-all-corners (1.031, aim 1.03)\n"));
  CHECK(report({match("touching-face-askew", {1000, 900, 9000, 0, 0})}).find("than is aimed at on") ==
        std::string::npos);
  CHECK_THAT(report({match("boxes", {100, 90, 200, 0, 0})}),
             kit::contains("aimed at on: none; longer on: boxes (2.000"));
}

TEST_CASE("Who cannot be asked is not timed and told as not asked", "[peers]") {
  const std::string text = report({match("spheres", {100, 90, 0, 0, 147})});
  CHECK_THAT(text, kit::contains("| spheres | 10 | 10 | 100 | 90 | – | – | 147 |"));
  CHECK_THAT(text, kit::contains("| spheres | 5 | 0 | 0 | 10 not asked | 10 not asked | 0 |"));
}

// -- Who can be asked about what ----------------------------------------------------------------------------------------

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
