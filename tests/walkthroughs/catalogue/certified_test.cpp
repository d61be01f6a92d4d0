// The walkthroughs whose answer is proven: that it is the true one, and that the pictures say how.

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/story/stories.hpp"
#include "tests/walkthroughs/truth_about.hpp"
#include "walkthroughs/story/exact.hpp"
#include "walkthroughs/story/number_line.hpp"

namespace certified_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;
using gjk::Proof;
using gjk::Status;

namespace {

gjk::CertifiedResult result_of(const Story& story) {
  return std::get<gjk::Certified<double>>(story.tellings[0].trace.events.back()).result;
}

std::optional<NumberLine> line_of(const Story& story, std::size_t frame) {
  return number_line(story.frames[frame].moments[0], story.frames[frame].focus, story.names(frame, 0));
}

}  // namespace

TEST_CASE("Every answer of certified/... is the true one, and proven as its name says") {
  const auto all = find_walkthroughs("certified");
  CHECK(all.size() == 11);
  for (const Walkthrough* each : all) {
    INFO(each->name);
    const gjk::CertifiedResult result = result_of(tell(*each));
    CHECK(result.status == truth_about(each->scenes[0]));
    CHECK(result.proof == (each->name.ends_with("/separation")    ? Proof::direction
                           : each->name.ends_with("/tetrahedron") ? Proof::tetrahedron
                                                                  : Proof::exact_fallback));
  }
}

TEST_CASE("The line of a sign in doubt holds zero between its ends, and the exact value too") {
  int lines = 0;
  for (const Walkthrough* each : find_walkthroughs("certified")) {
    const Story story = tell(*each);
    for (std::size_t i = 0; i < story.frames.size(); ++i) {
      const auto line = line_of(story, i);
      if (story.frames[i].focus != Focus::sign || !line) continue;
      INFO(each->name << ": " << story.frames[i].caption);
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

}  // namespace certified_test
