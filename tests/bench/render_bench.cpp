/// What does a picture cost? At 1280x720: the start of the OpenGL context, the first frame, then each frame split into
/// laying out (captions, labels, triangles), drawing, reading back and PNG; and the whole program beside libpng alone for
/// the same pictures, in time and in memory. Medians; milliseconds.
///
///     build/gjkstep-render-bench        all of it, about two minutes
///
/// On two processors (Debian 12, llvmpipe of Mesa 22.3.6): context 8 ms, first frame 14 ms; a frame in the plane
/// (figure-4-left) 0.6 to lay out, 3.8 to draw, 0.6 to read back, 10.6 as PNG; one in space (regions/2-simplex-r1-above)
/// 0.7, 3.9, 0.6, 10.8. All 932 pictures 11.1 s, libpng alone 9.8 s: ratio 1.14. Memory 96 MB for 3 pictures, 107 MB for
/// all.
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
///  * PNG, milliseconds and kilobytes for a frame, without filter unless one is named. At 640x360 level 6 takes 3.0 ms and
///    32 kB, level 4 2.3 ms and 35 kB, "up" with level 4 2.4 ms and 37 kB. At 1280x720:
///
///        level 9  60.7  69    level 4   7.2  83    "up", level 6  9.8  79    filter chosen by libpng, level 6  19.2   81
///        level 6   9.7  78    level 3   4.4  92    "up", level 4  7.5  80    Z_FIXED                            9.8   90
///        level 5   7.6  81    level 1   4.1 100    "up", level 1  4.8  93    Z_RLE                              5.2  246
///
///    Level 6 without filter makes the smallest small pictures and stays. More memory for zlib changes nothing. There is
///    no palette: anti-aliased pictures have 400 to 2200 colours.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "render/image.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/model/run.hpp"
#include "walkthroughs/picture/draw.hpp"
#include "walkthroughs/picture/studio.hpp"
#include "walkthroughs/story/storyboard.hpp"

namespace {

namespace fs = std::filesystem;
using walkthroughs::StagedStory;
using walkthroughs::Walkthrough;
using Milliseconds = double;

constexpr render::Size size{1280, 720};
constexpr int repeats = 3;

[[noreturn]] void stop(const char* why) {
  std::fprintf(stderr, "gjkstep-render-bench: %s\n", why);
  std::exit(1);
}

Milliseconds now() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

/// A folder that goes with everything in it.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("gjkstep-render-bench-" + std::to_string(getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
};

// -- One frame --------------------------------------------------------------------------------------------------------

/// Milliseconds for one frame.
struct Cost {
  Milliseconds layout = 0, draw = 0, read_back = 0, png = 0;
};

Cost cost_of(const StagedStory& story, std::size_t index, walkthroughs::Studio& studio) {
  const walkthroughs::Look look;
  const Milliseconds start = now();
  render::Canvas canvas(size, walkthroughs::page_of_frame(look.text), look.style.theme.paper, studio.font);
  walkthroughs::draw_frame(canvas, story, index, look);
  const Milliseconds laid_out = now();
  studio.rasterizer.finish_drawing(canvas);
  const Milliseconds drawn = now();
  const render::Image image = studio.rasterizer.read_back();
  const Milliseconds read = now();
  render::encode_png(image, {});
  return {laid_out - start, drawn - laid_out, read - drawn, now() - read};
}

void print_frames(const Walkthrough& walkthrough, walkthroughs::Studio& studio) {
  const StagedStory story(walkthroughs::tell(walkthrough));
  std::vector<Cost> costs;
  for (int repeat = 0; repeat < repeats; ++repeat)
    for (std::size_t i = 0; i < story.frames.size(); ++i) costs.push_back(cost_of(story, i, studio));
  const auto middle = [&](Milliseconds Cost::*part) {
    std::vector<double> values;
    for (const Cost& cost : costs) values.push_back(cost.*part);
    return median(values);
  };
  std::printf("%-28s %8zu %8.2f %8.2f %10.2f %8.2f\n", walkthrough.name.c_str(), story.frames.size(),
              middle(&Cost::layout), middle(&Cost::draw), middle(&Cost::read_back), middle(&Cost::png));
}

/// Returns: the first walkthrough in space, or null.
const Walkthrough* in_space() {
  for (const Walkthrough& w : walkthroughs::catalogue())
    for (const walkthroughs::Scene& scene : w.scenes)
      if (scene.dimension == walkthroughs::Dimension::space) return &w;
  return nullptr;
}

// -- The start --------------------------------------------------------------------------------------------------------

/// Prints two numbers: the start of the context, and the first frame. Mesa starts once in a process: so this is one.
void print_start() {
  const Milliseconds start = now();
  walkthroughs::Studio studio;
  const Milliseconds started = now();
  const StagedStory story(walkthroughs::tell(*walkthroughs::find_walkthrough("figure-4-left")));
  const Cost cost = cost_of(story, 0, studio);
  std::printf("%f %f\n", started - start, cost.layout + cost.draw + cost.read_back);
}

void print_starts(const std::string& program) {
  std::vector<double> contexts, frames;
  for (int i = 0; i < repeats; ++i) {
    double context = 0, frame = 0;
    std::FILE* const child = popen(("'" + program + "' --start").c_str(), "r");
    if (child == nullptr || std::fscanf(child, "%lf %lf", &context, &frame) != 2) stop("cannot run itself");
    pclose(child);
    contexts.push_back(context);
    frames.push_back(frame);
  }
  std::printf("context start %.1f ms, first frame %.1f ms\n\n", median(contexts), median(frames));
}

// -- Many points ------------------------------------------------------------------------------------------------------

using walkthroughs::Point;

/// So many points on a ball or in it, or in the plane on a circle, around `center`.
walkthroughs::Points many_points(const std::string& where, int count, const Point& center) {
  std::mt19937 random(1);
  std::normal_distribution<double> number;
  std::uniform_real_distribution<double> share;
  walkthroughs::Points points;
  for (int i = 0; i < count; ++i) {
    Point p(number(random), number(random), where == "circle" ? 0 : number(random));
    p.normalize();
    if (where == "in a ball") p *= std::cbrt(share(random));
    points.push_back(center + p);
  }
  return points;
}

/// From the points to the pixels of the first frame: search, hulls, camera, laying out, drawing.
Milliseconds first_frame_of(const std::string& where, int count, walkthroughs::Studio& studio) {
  Walkthrough walkthrough{.name = where, .title = where, .source = "", .summary = ""};
  walkthrough.naming = walkthroughs::Naming::roles;
  const bool plane = where == "circle";
  walkthrough.scenes.push_back({.name = "",
                                .a = {"a", many_points(where, count, Point::Zero())},
                                .b = {"b", many_points(where, count, Point(1.3, 0.4, plane ? 0 : 0.5))},
                                .dimension = plane ? walkthroughs::Dimension::plane : walkthroughs::Dimension::space});
  const Milliseconds start = now();
  const StagedStory story(walkthroughs::tell(walkthrough));
  const Milliseconds staged = now();
  const Cost cost = cost_of(story, 0, studio);
  return staged - start + cost.layout + cost.draw + cost.read_back;
}

/// A bar a row, so that a line is seen as one: its length doubles with the points.
void print_curve(walkthroughs::Studio& studio) {
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

// -- The whole program ------------------------------------------------------------------------------------------------

struct Run {
  Milliseconds time, processor_time;
  double megabytes;  ///< the most memory that it had
};

/// Runs gjkstep with these arguments, its output thrown away.
Run run(const std::vector<std::string>& arguments) {
  std::fflush(stdout);  // or the child would print it again
  const Milliseconds start = now();
  const pid_t child = fork();
  if (child == 0) {
    std::vector<char*> words = {const_cast<char*>(GJKSTEP_PROGRAM)};
    for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    if (std::freopen("/dev/null", "w", stdout) != nullptr) execv(GJKSTEP_PROGRAM, words.data());
    _exit(1);
  }
  int status = 0;
  rusage usage{};
  if (wait4(child, &status, 0, &usage) != child || status != 0) stop("cannot run " GJKSTEP_PROGRAM);
  const auto milliseconds = [](timeval time) {
    return 1e3 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e3;
  };
  return {now() - start, milliseconds(usage.ru_utime) + milliseconds(usage.ru_stime),
          static_cast<double>(usage.ru_maxrss) / 1024};
}

struct Encoded {
  Milliseconds time = 0;  ///< without reading the pictures
  std::size_t count = 0;
};

/// Encodes every picture below `folder` once more, one at a time.
Encoded libpng_alone(const fs::path& folder) {
  Encoded total;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    const render::Image image = render::read_png(entry.path());
    const Milliseconds start = now();
    render::encode_png(image, {});
    total.time += now() - start;
    ++total.count;
  }
  return total;
}

void print_program() {
  const Folder folder;
  const std::vector<std::string> all = {"render", "--all", "--out", folder.path.string()};
  run(all);
  // One after the other, so that other work on the machine slows both alike.
  std::vector<double> programs, processor, libpngs, ratios;
  std::size_t pictures = 0;
  for (int i = 0; i < repeats; ++i) {
    const Encoded alone = libpng_alone(folder.path);
    pictures = alone.count;
    libpngs.push_back(alone.time);
    const Run whole = run(all);
    programs.push_back(whole.time);
    processor.push_back(whole.processor_time);
    ratios.push_back(whole.time / libpngs.back());
  }
  std::printf(
      "\nrender --all: %zu pictures, %.0f ms (of two processors together %.0f ms); libpng alone %.0f ms; ratio %.2f\n",
      pictures, median(programs), median(processor), median(libpngs), median(ratios));
}

/// Linux counts for a child what its parent had when it was started: so this comes before anything is drawn here.
void print_memory() {
  const Folder folder;
  const auto memory = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--out", folder.path.string()});
    std::vector<double> values;
    for (int i = 0; i < repeats; ++i) values.push_back(run(arguments).megabytes);
    return median(values);
  };
  std::printf("peak memory: %.0f MB for 3 pictures, %.0f MB for all\n\n", memory({"render", "figure-5"}),
              memory({"render", "--all"}));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && std::string(argv[1]) == "--start") {
    print_start();
    return 0;
  }
  print_memory();
  print_starts(argv[0]);
  std::printf("%-28s %8s %8s %8s %10s %8s\n", "ms per frame", "frames", "layout", "draw", "read back", "PNG");
  {
    walkthroughs::Studio studio;
    print_frames(*walkthroughs::find_walkthrough("figure-4-left"), studio);
    if (const Walkthrough* const w = in_space()) print_frames(*w, studio);
    print_curve(studio);
  }
  std::fflush(stdout);
  print_program();
}
