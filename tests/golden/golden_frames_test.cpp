// Every frame of every walkthrough is laid out as it was accepted, and says what was accepted: the chosen pictures show
// what changed, these checksums only that something did, wherever it is.

#include <iterator>
#include <sstream>

#include "tests/golden/checksum.hpp"
#include "tests/golden/store.hpp"
#include "tests/kit/catch.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/picture/draw.hpp"
#include "walkthroughs/story/alternative_text.hpp"
#include "walkthroughs/story/storyboard.hpp"

using namespace golden;
using walkthroughs::StagedStory;

namespace {

std::string checksum_of(const render::Canvas& canvas, const std::string& words) {
  Checksum sum;
  sum.add(canvas);
  sum.add(words);
  return sum.text();
}

render::Canvas laid_out(const StagedStory& story, std::size_t frame, render::Font& font) {
  const walkthroughs::Look look;
  render::Canvas canvas(walkthroughs::frame_page, walkthroughs::frame_page, look.style.theme.paper, font);
  draw_frame(canvas, story, frame, look);
  return canvas;
}

/// Returns: the name of the walkthrough, then the checksum of each frame.
std::string line_of(const walkthroughs::Walkthrough& w, render::Font& font) {
  const StagedStory story(walkthroughs::tell(w));
  std::string line = w.name;
  for (std::size_t i = 0; i < story.frames.size(); ++i)
    line += " " + checksum_of(laid_out(story, i, font), walkthroughs::alternative_text(story, i));
  return line;
}

std::vector<std::string> frames_now() {
  render::Font font(render::Font::default_directory());
  std::vector<std::string> lines;
  for (const walkthroughs::Walkthrough& w : walkthroughs::catalogue()) lines.push_back(line_of(w, font));
  return lines;
}

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream in(line);
  return {std::istream_iterator<std::string>(in), {}};
}

/// Returns: "figure-1: frames 0, 3", or what else is different between two lines.
std::string difference(const std::string& accepted, const std::string& now) {
  const std::vector<std::string> before = words_of(accepted), after = words_of(now);
  if (before.empty() || after.empty() || before[0] != after[0]) return "'" + accepted + "' is now '" + now + "'";
  if (before.size() != after.size())
    return after[0] + ": " + std::to_string(before.size() - 1) + " frames are now " + std::to_string(after.size() - 1);
  std::string frames;
  for (std::size_t i = 1; i < after.size(); ++i)
    if (before[i] != after[i]) frames += (frames.empty() ? "" : ", ") + std::to_string(i - 1);
  return after[0] + ": frames " + frames;
}

}  // namespace

TEST_CASE("frames of all walkthroughs are laid out and described as accepted", "[unsanitized]") {
  if (!letters_are_those_accepted()) return;
  const std::vector<std::string> now = frames_now();
  check_lines("frames.txt", now, "frames",
              [&](std::size_t i, const std::string& accepted) { return difference(accepted, now[i]); });
}

TEST_CASE("frames differ where one line, one colour or one word does") {
  render::Font font(render::Font::default_directory());
  const StagedStory story(walkthroughs::tell(*walkthroughs::find_walkthrough("figure-4-left")));
  const auto spoilt = [&](auto spoil) {
    render::Canvas canvas = laid_out(story, 4, font);
    std::string words = walkthroughs::alternative_text(story, 4);
    spoil(canvas, words);
    return checksum_of(canvas, words);
  };
  const std::string sound = spoilt([](render::Canvas&, std::string&) {});
  CHECK(sound == spoilt([](render::Canvas& c, std::string&) { c.vertices()[7].x += 0; }));
  CHECK(sound != spoilt([](render::Canvas& c, std::string&) { c.vertices()[7].x += 0.02f; }));
  CHECK(sound != spoilt([](render::Canvas& c, std::string&) { c.vertices()[7].color.a -= 1; }));
  CHECK(sound != spoilt([](render::Canvas& c, std::string&) { c.line({0, 0}, {9, 9}, {}); }));
  CHECK(sound != spoilt([](render::Canvas&, std::string& words) { words.back() = '!'; }));
}
