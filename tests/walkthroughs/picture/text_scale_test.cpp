// Larger and smaller text: what the layout of frames and strips makes of it. Told of laid out pages, without rasterizing them.

#include <algorithm>
#include <array>
#include <optional>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/picture/algorithm_panel.hpp"
#include "walkthroughs/picture/draw.hpp"
#include "walkthroughs/story/pseudocode.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

namespace {

Look look_of(double text_scale) {
  render::Theme theme = render::themes::report;
  theme.text = text_scale;
  return {.style = Style(theme)};
}

/// Searches that go round in circles show the same again and again.
bool repeats(const Walkthrough& w) { return w.name.starts_with("cycle-"); }

}  // namespace

TEST_CASE("At every scale of text all lines below the panels fit, and hardly a label is crowded",
          "[text-scale][unsanitized]") {
  render::Font font{render::Font::default_directory()};
  constexpr std::array scales{0.75, 1.25, 1.5};
  for (std::size_t which = 0; which < scales.size(); ++which) {
    const double scale = scales[which];
    const Look look = look_of(scale);
    int frames = 0, with_crowded = 0;
    for (const Walkthrough& w : catalogue()) {
      if (repeats(w)) continue;
      const StagedStory story(tell(w));
      for (std::size_t i = which; i < story.frames.size(); i += scales.size()) {  // all are half a minute
        INFO(w.name << ", frame " << i << ", text " << scale);
        render::Canvas page(frame_page, frame_page, look.style.theme.paper, font);
        const int crowded = draw_frame(page, story, i, look);
        CHECK(crowded <= (!w.scenes.empty() && w.scenes[0].dimension == Dimension::space ? 3 : 1));
        with_crowded += crowded > 0 ? 1 : 0;
        ++frames;
      }
    }
    CHECK(with_crowded * 10 <= frames);
  }
}

TEST_CASE("All words of a frame, and its pseudo-code, are so many times as large", "[text-scale]") {
  const Style usual(look_of(1).style), large(look_of(1.5).style);
  const auto sizes = [](const Style& style) {
    return std::vector{style.title.size, style.panel_title.size, style.caption.size,   style.fact.size,
                       style.small.size, style.skipped.size,     style.label({}).size, style.small_label().size};
  };
  for (std::size_t i = 0; i < sizes(usual).size(); ++i) CHECK(sizes(large)[i] == 1.5 * sizes(usual)[i]);
  CHECK(Style(render::themes::slides).caption.size > usual.caption.size);
}

namespace {

/// Where the pseudo-code of a moment would be drawn: what is marked, and how small the letters are.
struct Listed {
  double smallest;
  bool is_marked;   ///< whether a line is
  int in_last_row;  ///< letters, each a quad
};

Listed list(const StagedStory& story, std::size_t index, double text_scale, double height, render::Font& font) {
  const Look look = look_of(text_scale);
  render::Canvas page({500, 720}, {500, 720}, look.style.theme.paper, font);
  const Moment now = story.drawn(index, 0);
  const Names names(story.walkthrough.naming, story.stages[0].telling->hull, now);
  draw_algorithm(page, {{0, 0}, {480, height}},
                 {*story.stages[0].telling, story.stages[0], now, names, story.frames[index].focus,
                  story.stages[0].lens, look.style});
  bool is_marked = false;
  for (const render::CanvasVertex& vertex : page.vertices())
    is_marked = is_marked || (vertex.color == look.style.tested_fill && vertex.y < height);
  const auto is_text = [&](const render::CanvasVertex& vertex) { return vertex.color == look.style.theme.ink; };
  float lowest = 0;
  for (const render::CanvasVertex& vertex : page.vertices())
    if (is_text(vertex)) lowest = std::max(lowest, vertex.y);
  const auto in_last_row = std::ranges::count_if(page.vertices(), [&](const render::CanvasVertex& vertex) {
    return is_text(vertex) && vertex.y > lowest - look.style.scaled(20);
  });
  return {page.smallest_text(), is_marked, static_cast<int>(in_last_row / 6)};
}

}  // namespace

TEST_CASE(
    "Of pseudo-code in large letters an excerpt holds the line that runs, and ends in dots where the code goes on",
    "[text-scale]") {
  render::Font font{render::Font::default_directory()};
  const StagedStory story(tell(walkthrough("regions/3-simplex-face-adb-edge-ad")));
  int with_dots = 0, without = 0;
  for (std::size_t i = 0; i < story.frames.size(); ++i) {
    INFO("frame " << i);
    const bool is_marked = list(story, i, 1, 448, font).is_marked;
    for (const double scale : {1.25, 1.5})
      for (const double height : {240.0, 358.0}) {
        const Listed listed = list(story, i, scale, height, font);
        CHECK(listed.is_marked == is_marked);
        CHECK(listed.smallest >= 17);  // as large as the largest at the usual scale, though long lines are fitted
      }
    const Moment now = story.drawn(i, 0);
    const Focus focus = story.frames[i].focus;
    const auto& code = algorithm(running_algorithm(now, focus), RuleSet::as_intended);
    const std::optional<std::size_t> current = current_line(code, now, focus);
    if (code.size() < 20 || !current) continue;
    const int letters = list(story, i, 1.5, 240, font).in_last_row;
    if (*current < 8) CHECK(letters == 1);
    if (*current > 17) CHECK(letters > 4);
    with_dots += *current < 8;
    without += *current > 17;
  }
  CHECK(with_dots > 0);
  CHECK(without > 0);
}

TEST_CASE("Strips with larger text are higher, and as wide", "[text-scale][unsanitized]") {
  render::Font font{render::Font::default_directory()};
  for (const char* name : {"figure-4-left", "figure-5", "figure-8"}) {
    const StagedStory story(tell(walkthrough(name)));
    const render::Size usual = strip_page(story), large = strip_page(story, look_of(1.5));
    CHECK(large.width == usual.width);
    CHECK(large.height > usual.height);
    for (const double scale : {0.75, 1.25, 1.5}) {
      INFO(name << ", text " << scale);
      const render::Size page = strip_page(story, look_of(scale));
      render::Canvas strip(page, page, render::palette::white, font);
      CHECK(draw_strip(strip, story, look_of(scale)) == 0);
      for (const render::CanvasVertex& vertex : strip.vertices())
        if (vertex.kind == render::CanvasVertex::Kind::glyph) CHECK(vertex.y <= static_cast<float>(page.height));
    }
  }
}
