// Every frame of every walkthrough is laid out as it was accepted, and says what was accepted: the chosen pictures show
// what changed, these checksums only that something did, wherever it is.

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <sstream>

#include "render/file.hpp"
#include "render/rendered_by.hpp"
#include "tests/catch.hpp"
#include "tests/golden/store.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/picture/draw.hpp"
#include "walkthroughs/story/alternative_text.hpp"
#include "walkthroughs/story/storyboard.hpp"

using namespace golden;
using render::CanvasVertex;
using walkthroughs::StagedStory;

namespace {

namespace fs = std::filesystem;

/// Of numbers that are rounded: a step that no number of a drawing is a multiple of, so that none lies on the border of two
/// steps, and the last bits of a sine do not matter.
long step_of(float number) { return std::lround(std::floor(number / 0.0137 + 0.317)); }

class Checksum {
 public:
  void add(long number) { add(std::to_string(number) + " "); }
  void add(const std::string& text) {
    value_ = crc32_z(value_, reinterpret_cast<const Bytef*>(text.data()), text.size());
  }
  std::string text() const {
    char digits[9];
    std::snprintf(digits, sizeof digits, "%08lx", value_);
    return digits;
  }

 private:
  uLong value_ = crc32(0, nullptr, 0);
};

/// Where a letter stands in the atlas is no part of the drawing.
void add(Checksum& sum, const CanvasVertex& v) {
  for (const float number : {v.x, v.y, v.half_length, v.radius}) sum.add(step_of(number));
  if (v.kind != CanvasVertex::Kind::glyph)
    for (const float number : {v.u, v.v}) sum.add(step_of(number));
  for (const int number : {int{v.color.r}, int{v.color.g}, int{v.color.b}, int{v.color.a}, static_cast<int>(v.kind)})
    sum.add(number);
}

std::string checksum_of(const render::Canvas& canvas, const std::string& words) {
  Checksum sum;
  for (const CanvasVertex& v : canvas.vertices()) add(sum, v);
  for (const render::Canvas::Run& run : canvas.runs())
    for (const int number : {run.first, run.left, run.top, run.right, run.bottom}) sum.add(number);
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

std::string frames_now() {
  render::Font font(render::Font::default_directory());
  std::string text;
  for (const walkthroughs::Walkthrough& w : walkthroughs::catalogue()) text += line_of(w, font) + "\n";
  return text;
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

std::string differences(const std::string& accepted, const std::string& now) {
  std::istringstream before(accepted), after(now);
  std::string list, line_before, line_after;
  while (std::getline(after, line_after)) {
    if (!std::getline(before, line_before)) line_before.clear();
    if (line_before != line_after) list += difference(line_before, line_after) + "\n";
  }
  return list;
}

std::string accepted_frames() {
  const fs::path file = folder() / "frames.txt";
  if (!fs::exists(file)) return "";
  const auto read = render::read_file(file);
  return {read.begin(), read.end()};
}

bool is_same_freetype() {
  const auto notes = render::read_rendered_by(folder() / "images");
  return notes && std::ranges::any_of(*notes, [](const auto& note) {
           return note.first == "FreeType" && note.second == render::freetype_version();
         });
}

}  // namespace

TEST_CASE("frames of all walkthroughs are laid out and described as accepted") {
  const std::string now = frames_now(), accepted = accepted_frames();
  CHECK(now.size() <= 20 * 1024);
  if (!is_same_freetype())
    WARN("skipped: letters are as wide as another FreeType makes them");
  else if (accepted != now && accepting())
    accept("frames.txt", now, "the layout or the words of frames changed");
  else if (accepted != now)
    FAIL_CHECK(differences(accepted, now)
               << "Look at them (gjkstep render), and accept them: " << command_to_accept("golden-tests: frames"));
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
