/// What does a picture cost? At 1280x720: the start of the OpenGL context, the first frame, then each frame split into
/// laying out (captions, labels), drawing (triangles, pixels, reading back) and PNG. Medians; milliseconds. frames.md has what
/// the whole program takes, growth.md what many frames take.
///
///     build/gjkstep-render-bench
///
/// What was tried, and is not worth its code:
///  * Drawing on a thread of its own, beside who lays out and who compresses: two processors are busy as it is.
///  * The atlas kept by OpenGL from picture to picture, RGBA read back in place of RGB, other numbers of threads for Mesa: no
///    difference that can be measured.
///  * Filters of PNG, as libpng chooses them, or "up" for rows that are as those above: files as large or larger, later.
///    There is no palette: anti-aliased pictures have 400 to 3,000 colours.
///  * Level 5 of libdeflate: an eighth sooner, files 3 in 100 larger.
#include <algorithm>
#include <chrono>
#include <cstdio>
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

}  // namespace

int main() {
  print_start();
  walkthroughs::output::Studio studio;
  std::printf("%-28s %8s %8s %8s %8s\n", "ms per frame", "frames", "layout", "draw", "PNG");
  print_frames(*walkthroughs::catalogue::find_walkthrough("figure-4-left"), studio);
  if (const Walkthrough* const w = in_space()) print_frames(*w, studio);
}
