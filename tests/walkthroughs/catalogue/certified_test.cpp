// The walkthroughs whose answer is proven: that it is the true one, and that the pictures say how.

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/story/stories.hpp"
#include "walkthroughs/story/exact.hpp"
#include "walkthroughs/story/number_line.hpp"
#include "walkthroughs/story/storyboard.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

namespace {

std::vector<std::string> captions_of(const Story& story) {
  std::vector<std::string> captions;
  for (const Frame& frame : story.frames) captions.push_back(frame.caption);
  return captions;
}

bool says(const Frame& frame, const std::string& words) {
  return std::ranges::any_of(frame.facts, [&](const Fact& fact) { return fact.text.find(words) != std::string::npos; });
}

bool says(const Story& story, const std::string& words) {
  return std::ranges::any_of(story.frames, [&](const Frame& frame) {
    return frame.caption.find(words) != std::string::npos || says(frame, words);
  });
}

gjk::CertifiedResult result_of(const Story& story) {
  return std::get<gjk::Certified<double>>(story.tellings[0].trace.events.back()).result;
}

}  // namespace

TEST_CASE("Every answer of certified/... is the true one") {
  const auto all = find_walkthroughs("certified");
  CHECK(all.size() == 11);
  for (const Walkthrough* each : all) {
    INFO(each->name);
    Scene without_circles = each->scenes[0];
    without_circles.rules = RuleSet::complete;
    CHECK(answer_of(run(each->scenes[0])) == exact_answer(without_circles));
  }
}

TEST_CASE("Two are proven in doubles, by a direction and by a tetrahedron, and number lines show by how much") {
  for (const auto& [name, proof] : {std::pair("certified/separation", gjk::Proof::direction),
                                    std::pair("certified/tetrahedron", gjk::Proof::tetrahedron)}) {
    const Story story = tell(walkthrough(name));
    CHECK(result_of(story).proof == proof);
    const std::size_t last = story.frames.size() - 1;
    const Frame& frame = story.frames[last - 1];
    REQUIRE(frame.focus == Focus::proof);
    const auto line = number_line(frame.moments[0], frame.focus, story.names(last - 1, 0));
    REQUIRE(line);
    CHECK(line->low == -line->high);
    const auto is_beyond = [&](const NumberLine::Number& each) {
      return each.value < line->low || each.value > line->high;
    };
    CHECK(std::ranges::all_of(line->numbers, is_beyond));
  }
}

TEST_CASE("Panel, caption and pseudo-code call the point of a proof P, as the picture does") {
  const Story story = tell(walkthrough("certified/separation"));
  const std::size_t proof = story.frames.size() - 2;
  const auto line = number_line(story.frames[proof].moments[0], Focus::proof, story.names(proof, 0));
  REQUIRE(line);
  CHECK(line->numbers[0].equation() == "−P·d = 10.19");
  CHECK(says(story.frames[proof], "−P·d = 10.19 > "));
}

TEST_CASE("The five failures, and both circles, are told from their guess on, and end with what is true") {
  for (const char* const name : {"vanished-product", "overflowed-product", "beyond-an-edge", "coplanar-askew",
                                 "far-from-the-origin", "cycle-separated", "cycle-intersecting"}) {
    const Story story = tell(walkthrough(std::string("certified/") + name));
    INFO(name);
    CHECK(story.frames.front().focus == Focus::end);
    CHECK(story.frames.back().focus == Focus::proven);
    const gjk::CertifiedResult result = result_of(story);
    CHECK(result.proof == gjk::Proof::second_search);
    const gjk::Status guess = story.frames.front().moments[0].result->status;
    CHECK(guess != result.status);
    CHECK(says(story.frames.back(), "the first search had ended " + std::string(to_string(guess))));
    CHECK(story.frames[1].focus == Focus::proof);
    CHECK_FALSE(story.frames[1].moments[0].proof->holds);
  }
}

TEST_CASE("A separation that the second search proves is told with the number that decides") {
  int apart = 0;
  for (const Walkthrough* each : find_walkthroughs("certified")) {
    const Story story = tell(*each);
    const gjk::CertifiedResult result = result_of(story);
    if (result.proof != gjk::Proof::second_search || result.status != gjk::Status::separated) continue;
    INFO(each->name);
    const auto decides = std::ranges::find(story.frames.back().facts, Fact::Mark::yes, &Fact::mark);
    REQUIRE(decides != story.frames.back().facts.end());
    CHECK(decides->text.starts_with("the largest P·d"));
    CHECK(decides->text.ends_with(" < 0"));
    ++apart;
  }
  CHECK(apart >= 3);
}

TEST_CASE("A corner on an edge, and one double higher: the same decisions until a sign is another") {
  const Story touching = tell(walkthrough("certified/touching")), apart = tell(walkthrough("certified/one-step-apart"));
  CHECK(result_of(touching).status == gjk::Status::intersecting);
  CHECK(result_of(apart).status == gjk::Status::separated);
  CHECK(says(touching, "exactly 0"));
  CHECK(says(apart, "exactly 3/9007199254740992 > 0"));
  CHECK(says(apart, "The sign of (AB×AO).z is in doubt"));
  CHECK_FALSE(says(apart, "(AB×AO).x is in doubt"));  // in the plane nobody doubts it
}

TEST_CASE("The line of a sign in doubt holds zero between its ends, and the exact value too") {
  int lines = 0;
  for (const Walkthrough* each : find_walkthroughs("certified")) {
    const Story story = tell(*each);
    for (std::size_t i = 0; i < story.frames.size(); ++i) {
      const Frame& frame = story.frames[i];
      const auto line = number_line(frame.moments[0], frame.focus, story.names(i, 0));
      if (frame.focus != Focus::sign || !line) continue;
      INFO(each->name << ": " << frame.caption);
      CHECK((line->low <= 0 && line->high >= 0));
      REQUIRE(line->numbers.size() == 2);
      CHECK(line->numbers[1].is_exact);
      const double slack = 1e-12 * (line->high - line->low);
      CHECK((line->numbers[1].value >= line->low - slack && line->numbers[1].value <= line->high + slack));
      ++lines;
    }
  }
  CHECK(lines >= 8);
}

TEST_CASE("Fractions are written out where they are short") {
  CHECK(short_fraction("-3/1024") == "−3/1024");
  CHECK(short_fraction("0") == "0");
  CHECK(short_fraction("1" + std::string(400, '0')) == "≈ 1e400");
  CHECK(short_fraction(std::string(400, '9')) == "≈ 1e400");  // not 10e399
  CHECK(short_fraction("-1/8" + std::string(99, '0')) == "≈ −1.25e−100");
  CHECK(NumberLine::Number{"exactly", short_fraction("-3/4")}.equation() == "exactly = −3/4");
  CHECK(NumberLine::Number{"exactly", short_fraction("1" + std::string(40, '0'))}.equation() == "exactly ≈ 1e40");
}

TEST_CASE("After the guess nothing of the first search is drawn but where it has been") {
  const Story story = tell(walkthrough("certified/coplanar-askew"));
  for (const Frame& frame : story.frames) {
    const Moment& now = frame.moments[0];
    CHECK(now.is_second_search == now.guess.has_value());
    if (!now.is_second_search) continue;
    CHECK_FALSE(now.result);
    CHECK(now.regions.empty());
    CHECK_FALSE(now.crossing);
  }
  CHECK(captions_of(story).at(2) == "A second search begins with a vertex of the first: A.");
}
