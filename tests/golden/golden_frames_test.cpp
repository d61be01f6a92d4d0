// Every frame of every walkthrough, and searches at random, are laid out and described as accepted: frames.txt. These checksums tell
// only that something did change, and where; accept.py draws those frames, before and now, side by side.

#include <zlib.h>

#include <cmath>
#include <cstdio>
#include <iterator>
#include <map>
#include <sstream>

#include "render/triangles.hpp"
#include "tests/golden/random_searches.hpp"
#include "tests/golden/store.hpp"
#include "tests/kit/catch.hpp"
#include "tests/kit/text.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/story/alternative_text.hpp"

namespace golden_frames_test {

using namespace golden;
using render::Canvas, render::CanvasVertex;
using walkthroughs::picture::Look, walkthroughs::picture::StagedStory;

namespace {

// -- Checksums --------------------------------------------------------------------------------------------------------

class Checksum {
 public:
  void add(const std::string& text) { bytes_ += text; }
  void add(long number) { bytes_.append(reinterpret_cast<const char*>(&number), sizeof number); }
  /// Lengths in pixels, rounded far below what can be seen: the last bits of a sine do not matter. The step is one that no number
  /// of a drawing is a multiple of, so that none lies on the border of two.
  void add(double number) {
    if (std::abs(number) < 1e15)
      add(std::lround(std::floor(number / 0.0137 + 0.317)));
    else
      add(std::string(number > 0 ? "large " : number < 0 ? "-large " : "nan "));
  }
  void add(const CanvasVertex& v) {
    for (const float number : {v.x, v.y, v.half_length, v.radius}) add(double{number});
    if (v.kind != CanvasVertex::Kind::glyph)  // where letters stand in the font's atlas cannot be seen
      for (const float number : {v.u, v.v}) add(double{number});
    for (const int number : {int{v.color.r}, int{v.color.g}, int{v.color.b}, int{v.color.a}, static_cast<int>(v.kind)})
      add(long{number});
  }
  void add(const Canvas& canvas) {
    const auto [vertices, runs] = render::triangles_of(canvas);
    for (const CanvasVertex& v : vertices) add(v);
    for (const render::Triangles::Run& run : runs)
      for (const int number : {run.first, run.left, run.top, run.right, run.bottom}) add(long{number});
  }
  std::string text() const {
    char digits[9];
    std::snprintf(digits, sizeof digits, "%08lx",
                  crc32_z(0, reinterpret_cast<const Bytef*>(bytes_.data()), bytes_.size()));
    return digits;
  }

 private:
  std::string bytes_;
};

/// Returns: how many labels found no place.
int add_frame(Checksum& sum, const StagedStory& story, std::size_t frame, const Look& look, render::Font& font) {
  const render::Size page = walkthroughs::picture::page_of_frame(look);
  Canvas canvas(page, page, look.style.theme.paper, font);
  draw_frame(canvas, story, frame, look);
  sum.add(canvas);
  sum.add(walkthroughs::story::alternative_text(story, frame));
  return canvas.crowded();
}

// -- Lines: a name, and the checksum of each frame; of searches at random one for all ---------------------------------

struct Line {
  std::string name;
  std::vector<std::string> sums;
  std::string options, scene;  ///< of gjkstep render, and what it draws where that is no walkthrough

  std::string text() const {
    std::string text = name;
    for (const std::string& sum : sums) text += " " + sum;
    return text;
  }
};

Line line_of(const walkthroughs::model::Walkthrough& w, render::Font& font) {
  const StagedStory story(walkthroughs::story::tell(w));
  Line line{w.name, {}, {}, {}};
  for (std::size_t i = 0; i < story.frames.size(); ++i) {
    Checksum sum;
    add_frame(sum, story, i, {}, font);
    line.sums.push_back(sum.text());
  }
  return line;
}

/// Of every third frame, for time, and the strip.
Line line_of(const RandomSearch& each, render::Font& font) {
  const StagedStory story(walkthroughs::story::tell(each.walkthrough, each.detail));
  Checksum sum;
  for (std::size_t frame = each.scene.size() % 3; frame < story.frames.size(); frame += 3)
    sum.add(long{add_frame(sum, story, frame, each.look, font)});
  const render::Size page = strip_page(story, each.look);
  Canvas strip(page, page, each.look.style.theme.paper, font);
  draw_strip(strip, story, each.look);
  sum.add(long{strip.crowded()});
  sum.add(strip);
  return {each.name, {sum.text()}, each.options, each.scene};
}

std::vector<Line> lines_now() {
  render::Font font(render::Font::default_directory());
  std::vector<Line> lines;
  for (const walkthroughs::model::Walkthrough& w : walkthroughs::catalogue::whole_catalogue())
    lines.push_back(line_of(w, font));
  for (const RandomSearch& each : random_searches()) lines.push_back(line_of(each, font));
  return lines;
}

// -- What changed -----------------------------------------------------------------------------------------------------

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream in(line);
  return {std::istream_iterator<std::string>(in), {}};
}

/// Returns: "1,4", the steps of a line whose frames are others or new; of a search at random none, which is all.
std::string changed_frames(const std::vector<std::string>& accepted, const Line& now) {
  std::string frames;
  for (std::size_t i = 0; i < now.sums.size() && now.scene.empty(); ++i)
    if (i + 1 >= accepted.size() || accepted[i + 1] != now.sums[i])
      frames += (frames.empty() ? "" : ",") + std::to_string(i + 1);
  return frames;
}

/// Leaves what accept.py draws, and the scenes to draw it from. Returns: name, frames and options of each line that changed.
std::vector<std::string> leave_changed(const std::string& accepted_lines, const std::vector<Line>& lines) {
  std::map<std::string, std::vector<std::string>> accepted;
  for (const std::string& line : kit::lines(accepted_lines)) accepted[words_of(line)[0]] = words_of(line);
  std::vector<std::string> changed;
  for (const Line& line : lines) {
    if (accepted[line.name] == words_of(line.text())) continue;
    if (!line.scene.empty()) leave_candidate(line.name + ".json", line.scene);
    changed.push_back(line.name + "\t" + changed_frames(accepted[line.name], line) + "\t" + line.options);
  }
  std::string list;
  for (const std::string& line : changed) list += line + "\n";
  leave_candidate("changed-frames.txt", list);
  return changed;
}

}  // namespace

TEST_CASE("frames of all walkthroughs are laid out and described as accepted", "[unsanitized]") {
  if (!letters_are_those_accepted()) return;
  const std::vector<Line> lines = lines_now();
  std::string now;
  for (const Line& line : lines) now += line.text() + "\n";
  const std::string accepted = accepted_text("frames.txt");
  const std::vector<std::string> changed = leave_changed(accepted, lines);
  if (now == accepted) {
    SUCCEED("as accepted");
    return;
  }
  if (accepting()) return accept("frames.txt", now, std::to_string(changed.size()) + " lines are others");
  FAIL_CHECK(changed.size() << " walkthroughs have other frames, such as "
                            << (changed.empty() ? "one that is gone" : changed[0])
                            << "\nTo see them before and now: tests/golden/accept.py frames; to accept them: "
                            << command_to_accept("frames"));
}

}  // namespace golden_frames_test
