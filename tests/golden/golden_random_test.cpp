// Searches that nobody chose are made, told and drawn as accepted: most of what no walkthrough comes to is held here.

#include <array>
#include <sstream>

#include "tests/golden/checksum.hpp"
#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/trace/random_scene_files.hpp"
#include "walkthroughs/page/page.hpp"
#include "walkthroughs/picture/draw.hpp"
#include "walkthroughs/story/alternative_text.hpp"
#include "walkthroughs/story/storyboard.hpp"
#include "walkthroughs/text/scene_file.hpp"
#include "walkthroughs/trace/trace_json.hpp"

using namespace golden;
using namespace walkthroughs;
using walkthroughs::test::RandomSceneFile;
using walkthroughs::test::RandomSceneFiles;

namespace {

constexpr unsigned seed = 17;
constexpr int scenes = 320;

/// Returns: the walkthrough of a scene file, with the panels and letters of which a reader may think as well.
Walkthrough varied(const RandomSceneFile& file, int i) {
  Walkthrough w = parse_scene(file.text, "random.json").walkthrough;
  w.panels = {.objects = i % 5 != 4,
              .hull = i % 7 != 6,
              .algorithm = i % 6 != 5,
              .decision = i % 8 != 7,
              .close_up = i % 9 == 8};
  if (i % 4 == 3) w.naming = Naming::fixed;
  return w;
}

Look look_of(int i) {
  Look look;
  render::Theme theme = std::array{render::themes::report, render::themes::slides, render::themes::dark}[i % 3U];
  if (i % 10 == 0) theme.text = 0.75;
  if (i % 10 == 5) theme.text = 1.5;
  look.style = Style(theme);
  if (i % 4 == 1) look.text = Text::none;
  look.values = i % 11 != 10;
  look.code = i % 12 != 11;
  look.turn = i % 13 == 12 ? 60 : 0;
  return look;
}

/// Of every fourth frame, for time, and the strip.
std::string drawing_of(const StagedStory& story, std::size_t first, const Look& look, render::Font& font) {
  Checksum sum;
  const auto add = [&](render::Size page, auto draw) {
    render::Canvas canvas(page, page, look.style.theme.paper, font);
    sum.add(long{draw(canvas)});
    sum.add(canvas);
  };
  for (std::size_t frame = first; frame < story.frames.size(); frame += 4)
    add(page_of_frame(look.text), [&](render::Canvas& canvas) { return draw_frame(canvas, story, frame, look); });
  add(strip_page(story, look), [&](render::Canvas& canvas) { return draw_strip(canvas, story, look); });
  return sum.text();
}

std::string said_in(const StagedStory& story) {
  Checksum sum;
  for (std::size_t frame = 0; frame < story.frames.size(); ++frame) sum.add(alternative_text(story, frame));
  for (const std::string& each : story.left_out()) sum.add(each);
  return sum.text();
}

std::string page_of(const StagedStory& story, const Look& look) {
  const PagePictures pictures{.url = [](std::size_t frame, int) { return std::to_string(frame) + ".png"; },
                              .page = page_of_frame(look.text),
                              .part = pictures_of_frame(story.walkthrough, look)};
  PageSurroundings around;
  around.command = "gjkstep render";
  around.has_files = true;
  std::string all = page_html(story, pictures, around);
  for (const PageFile& file : page_files(story, pictures, around))
    if (file.name == steps_file || file.name == events_file || file.name == questions_file) all += file.content;
  return checksum_of(all);
}

/// Returns: checksums of its trace, drawings, words and page.
std::string line_of(const RandomSceneFile& file, int i, render::Font& font) {
  const Walkthrough w = varied(file, i);
  std::ostringstream trace;
  write_traces(trace, w);
  const Look look = look_of(i);
  const StagedStory story(tell(w, i % 14 == 13 ? Detail::step : Detail::decision));
  return checksum_of(trace.str()) + " " + drawing_of(story, i % 4U, look, font) + " " + said_in(story) + " " +
         page_of(story, look);
}

/// Returns: "trace, page", or what else is different between two lines.
std::string difference(const std::string& accepted, const std::string& now) {
  std::istringstream before(accepted), after(now);
  std::string list, one, other;
  for (const char* what : {"trace", "drawings", "words", "page"})
    if (before >> one, after >> other, one != other) list += (list.empty() ? "" : ", ") + std::string(what);
  return list;
}

}  // namespace

TEST_CASE("random searches are made, told and drawn as accepted") {
  if (!letters_are_those_accepted()) return;
  render::Font font(render::Font::default_directory());
  RandomSceneFiles random(seed);
  std::vector<RandomSceneFile> files;
  std::vector<std::string> now;
  for (int i = 0; i < scenes; ++i) {
    files.push_back(random.next_without_sines());
    now.push_back(line_of(files.back(), i, font));
  }
  check_lines("random.txt", now, "random", [&](std::size_t i, const std::string& accepted) {
    return "scene " + std::to_string(i) + ": " + difference(accepted, now[i]) + ": " + files[i].text;
  });
}
