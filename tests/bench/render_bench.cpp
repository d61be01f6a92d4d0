/// What does a picture cost? At 1280x720: the start of the OpenGL context, the first frame, then each frame split into
/// laying out (captions, labels, triangles), drawing, with reading back, and PNG. Medians; milliseconds. And the whole program:
///
///     build/gjkstep-render-bench
///     /usr/bin/time -f "%e s, %M kB" build/gjkstep render --all --out pictures
///
/// On two processors (Debian 12, llvmpipe of Mesa 22.3.6): context 8 ms, first frame 14 ms; a frame in the plane
/// (figure-4-left) 0.6 to lay out, 4.4 to draw, 10.6 as PNG; one in space (regions/2-simplex-r1-above)
/// 0.7, 4.5, 10.8. All 932 pictures 11.1 s, of which libpng alone takes 9.8. Memory 96 MB for 3 pictures, 107 MB for all.
///
/// First frame of two sets of 1,250, 10,000 and 100,000 points: on a ball 18, 40, 229 ms; in a ball 98, 78, 405, as few
/// enough corners have faces; on a circle 14, 26, 127. The growth is that of reading and searching them.
///
/// What was tried, on the first 39 pictures:
///  * Writing on a second thread while the next picture is drawn: 634 ms become 438, and PNG is all that is left to wait
///    for. So drawing was left as it is: sending the atlas again with each picture costs nothing that can be measured, an
///    empty picture 0.2 ms, one rectangle over all of it 3.5, because translucent and opaque areas are blended alike.
///  * LP_NUM_THREADS 0, 1, 2: 423, 439, 437 ms. Left to Mesa.
///  * Reading back: RGB 0.51 ms; RGBA 0.52 and BGRA 0.71, each with the copy that drops alpha.
///  * PNG by zlib, milliseconds and kilobytes for a frame, without filter unless one is named. At 640x360 level 6 takes 3.0 ms and
///    32 kB, level 4 2.3 ms and 35 kB, "up" with level 4 2.4 ms and 37 kB. At 1280x720:
///
///        level 9  60.7  69    level 4   7.2  83    "up", level 6  9.8  79    filter chosen by libpng, level 6  19.2   81
///        level 6   9.7  78    level 3   4.4  92    "up", level 4  7.5  80    Z_FIXED                            9.8   90
///        level 5   7.6  81    level 1   4.1 100    "up", level 1  4.8  93    Z_RLE                              5.2  246
///
///    Level 6 without filter makes the smallest small pictures and stays. More memory for zlib changes nothing. libdeflate makes
///    the same sizes at level 6, and all walkthroughs take 37 s of processor for 50. There is no palette: anti-aliased pictures
///    have 400 to 2200 colours.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include "render/image.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/model/scene.hpp"
#include "walkthroughs/output/renderer.hpp"
#include "walkthroughs/picture/draw.hpp"
#include "walkthroughs/story/storyboard.hpp"

namespace {

using walkthroughs::model::Walkthrough;
using walkthroughs::picture::StagedStory;
using Milliseconds = double;

constexpr render::Size size{1280, 720};
constexpr int repeats = 3;

Milliseconds now() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

// -- One frame --------------------------------------------------------------------------------------------------------

/// Milliseconds for one frame.
struct Cost {
  Milliseconds layout = 0, draw = 0, png = 0;
};

Cost cost_of(const StagedStory& story, std::size_t index, walkthroughs::output::Studio& studio) {
  const walkthroughs::picture::Look look;
  const Milliseconds start = now();
  render::Canvas canvas(size, walkthroughs::picture::page_of_frame(look), look.style.theme.paper, studio.font);
  walkthroughs::picture::draw_frame(canvas, story, index, look);
  const Milliseconds laid_out = now();
  const render::Image image = studio.rasterizer.draw(canvas);
  const Milliseconds drawn = now();
  render::encode_png(image, {});
  return {laid_out - start, drawn - laid_out, now() - drawn};
}

void print_frames(const Walkthrough& walkthrough, walkthroughs::output::Studio& studio) {
  const StagedStory story(walkthroughs::story::tell(walkthrough));
  std::vector<Cost> costs;
  for (int repeat = 0; repeat < repeats; ++repeat)
    for (std::size_t i = 0; i < story.frames.size(); ++i) costs.push_back(cost_of(story, i, studio));
  const auto middle = [&](Milliseconds Cost::*part) {
    std::vector<double> values;
    for (const Cost& cost : costs) values.push_back(cost.*part);
    return median(values);
  };
  std::printf("%-28s %8zu %8.2f %8.2f %8.2f\n", walkthrough.name.c_str(), story.frames.size(), middle(&Cost::layout),
              middle(&Cost::draw), middle(&Cost::png));
}

/// Returns: the first walkthrough in space, or null.
const Walkthrough* in_space() {
  for (const Walkthrough& w : walkthroughs::catalogue::whole_catalogue())
    for (const walkthroughs::model::Scene& scene : w.scenes)
      if (scene.dimension == walkthroughs::model::Dimension::space) return &w;
  return nullptr;
}

// -- The start --------------------------------------------------------------------------------------------------------

/// Prints what the start of the context takes, and the first frame. Mesa starts once in a process: so this comes first.
void print_start() {
  const Milliseconds start = now();
  walkthroughs::output::Studio studio;
  const Milliseconds started = now();
  const Cost cost = cost_of(
      StagedStory(walkthroughs::story::tell(*walkthroughs::catalogue::find_walkthrough("figure-4-left"))), 0, studio);
  std::printf("context start %.1f ms, first frame %.1f ms\n\n", started - start, cost.layout + cost.draw);
}

// -- Many points ------------------------------------------------------------------------------------------------------

using walkthroughs::model::Point;

/// So many points on a ball or in it, or in the plane on a circle, around `center`.
walkthroughs::model::Points many_points(const std::string& where, int count, const Point& center) {
  std::mt19937 random(1);
  std::normal_distribution<double> number;
  std::uniform_real_distribution<double> share;
  walkthroughs::model::Points points;
  for (int i = 0; i < count; ++i) {
    Point p(number(random), number(random), where == "circle" ? 0 : number(random));
    p.normalize();
    if (where == "in a ball") p *= std::cbrt(share(random));
    points.push_back(center + p);
  }
  return points;
}

/// From the points to the pixels of the first frame: search, hulls, camera, laying out, drawing.
Milliseconds first_frame_of(const std::string& where, int count, walkthroughs::output::Studio& studio) {
  Walkthrough walkthrough{.name = where, .title = where, .source = "", .summary = ""};
  walkthrough.naming = walkthroughs::model::Naming::roles;
  const bool plane = where == "circle";
  walkthrough.scenes.push_back(
      {.name = "",
       .a = {"a", many_points(where, count, Point::Zero())},
       .b = {"b", many_points(where, count, Point(1.3, 0.4, plane ? 0 : 0.5))},
       .dimension = plane ? walkthroughs::model::Dimension::plane : walkthroughs::model::Dimension::space});
  const Milliseconds start = now();
  const StagedStory story(walkthroughs::story::tell(walkthrough));
  const Milliseconds staged = now();
  const Cost cost = cost_of(story, 0, studio);
  return staged - start + cost.layout + cost.draw;
}

/// A bar a row, so that a line is seen as one: its length doubles with the points.
void print_curve(walkthroughs::output::Studio& studio) {
  std::printf("\nfirst frame of two sets of so many points, ms\n");
  for (const char* const where : {"on a ball", "in a ball", "circle"})
    for (const int count : {1250, 2500, 5000, 10'000, 20'000, 40'000, 100'000}) {
      std::vector<double> times;
      for (int repeat = 0; repeat < repeats; ++repeat) times.push_back(first_frame_of(where, count, studio));
      const double time = median(times);
      std::printf("%-10s %7d %8.0f  %s\n", where, count, time,
                  std::string(static_cast<std::size_t>(time / 25), '#').c_str());
    }
}

}  // namespace

int main() {
  print_start();
  walkthroughs::output::Studio studio;
  std::printf("%-28s %8s %8s %8s %8s\n", "ms per frame", "frames", "layout", "draw", "PNG");
  print_frames(*walkthroughs::catalogue::find_walkthrough("figure-4-left"), studio);
  if (const Walkthrough* const w = in_space()) print_frames(*w, studio);
  print_curve(studio);
}
