#include <string>

#include "tests/kit/catch.hpp"
#include "tests/kit/program.hpp"
#include "walkthroughs/output/frames.hpp"
#include "walkthroughs/text/printable.hpp"

namespace movie_test {

using namespace walkthroughs::program;

namespace {

/// Returns: the words that a program called ffmpeg would get, a line each.
std::string words_of(const std::string& line) {
  const kit::Outcome outcome = kit::shell("ffmpeg() { printf '%s\\n' \"$@\"; }\n" + line);
  CHECK(outcome.exit_code == 0);
  return outcome.out;
}

}  // namespace

TEST_CASE("A folder of any name reaches ffmpeg as it is, and nothing of it a terminal") {
  for (const std::string folder :
       {"/plain/a-b_c.d", "/it's \"mine\" $(no) `no`", "/red\x1b[31m\x07\x7f\t!", "/größe", "/o\xff\u202e"})
    for (const Movie kind : {Movie::mp4, Movie::gif}) {
      const std::string line = ffmpeg_line(kind, folder, 0.5, 1, {1, 2, 3}), words = words_of(line);
      CHECK(printable(line) == line);
      CHECK(words.find("\n" + folder + "/%03d.png\n") != std::string::npos);
      CHECK(words.ends_with("\n" + folder + (kind == Movie::mp4 ? "/animation.mp4\n" : "/animation.gif\n")));
    }
}

TEST_CASE("Paths that ffmpeg would take for something else begin in this folder") {
  for (const std::string folder : {"-i", "http:x", "100%"}) {
    const std::string words = words_of(ffmpeg_line(Movie::gif, folder, 0.02, 0.04, {1, 2, 3}));
    const std::string begin = folder == "100%" ? "\n" : "\n./";
    CHECK(words.find(begin + (folder == "100%" ? "100%%" : folder) + "/%03d.png\n") != std::string::npos);
    CHECK(words.find("\n1000/20\n") != std::string::npos);
  }
}

}  // namespace movie_test
