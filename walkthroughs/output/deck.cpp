#include <algorithm>

#include "walkthroughs/output/paper_sheet.hpp"
#include "walkthroughs/story/alternative_text.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs::output {
namespace {

using render::Align;
using render::Box;
using render::Canvas;
using render::Vec2;

constexpr render::PaperSize slide{960, 540};
constexpr double points_of_unit = slide.width / frame_page.width;
// On the page of a frame.
constexpr double side = 40, head = 46, panels_top = 66, caption_top = 560, bottom = 714, head_size = 22, head_gap = 30;
constexpr int least_height = 390;  // of panels: lower ones have no room for four views of a decision

/// The panels of a frame, without the pseudo-code, as wide as a slide, or as wide as their height allows.
struct PanelsOfSlide {
  PanelsOfSlide(const StagedStory& story, Look of_words) : look(of_words) {
    const double height = (of_words.text == Text::none ? bottom : caption_top) - panels_top;
    look.text = Text::none;
    look.code = false;
    look.height = least_height;
    for (int i = 0; i < 2; ++i) {  // how wide they are depends on their letters
      set(of_words.style.theme, scale);
      part = pictures_of_frame(story.walkthrough, look);
      scale = std::min(width / part.width(), height / part.height());
    }
    look.height += static_cast<int>(height / scale - part.height());
    part = pictures_of_frame(story.walkthrough, look);
  }

  /// Letters and lines are as large on the slide as the theme has them, or larger.
  void set(render::Theme theme, double magnified) {
    theme.text = std::max(1.0, theme.text / magnified);
    theme.line = std::max(1.0, theme.line / magnified);
    look.style = Style(theme);
  }

  double left() const { return (frame_page.width - scale * part.width()) / 2; }

  static constexpr double width = frame_page.width - 2 * side;
  Look look;
  double scale = 1;  ///< units of the slide per unit of its own page
  Box part;          ///< of that page
};

/// In its own colours, but with letters and lines no smaller than those of slides.
render::Theme for_a_hall(render::Theme theme) {
  theme.text = std::max(theme.text, render::themes::slides.text);
  theme.line = std::max(theme.line, render::themes::slides.line);
  return theme;
}

/// Where the search is, above; the caption below.
void draw_around(Canvas& canvas, const StagedStory& story, std::size_t index, const Look& look) {
  const render::TextStyle small{.size = head_size, .color = look.style.theme.grey};
  render::TextStyle right = small;
  right.align = Align::right;
  const std::string state = state_in_words(story, index),
                    step = "step " + std::to_string(index + 1) + " of " + std::to_string(story.frames.size()),
                    where = state.empty() ? step : step + " · " + state, title = literal(story.walkthrough.title);
  canvas.text({frame_page.width - side, head}, where, right);
  const double room = PanelsOfSlide::width - canvas.width(where, small) - head_gap;
  canvas.text({side, head}, title, canvas.fitted(title, small, room));
  if (look.text == Text::around)
    draw_caption(canvas, {{side, caption_top}, {frame_page.width - side, bottom}}, story.frames[index], look.style);
}

/// What draw_words() writes, and below in smaller letters what is seen.
double write_notes(Canvas& canvas, double width, const StagedStory& story, std::size_t index, const Style& style) {
  double height = draw_words(canvas, width, story, index, style);
  const std::string seen = joined(picture_in_words(story, index), " ");
  if (!seen.empty()) height += write_lines(canvas, {0, height}, literal(seen), style.skipped, width);
  return height;
}

}  // namespace

OneFile deck() {
  const auto make = [](const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer& renderer) {
    const render::Theme theme = for_a_hall(output.look.style.theme);
    Look look = output.look;
    look.style = Style(theme);
    const PanelsOfSlide panels(*story, look);
    const render::Size page = page_of_frame(panels.look);
    Printed deck{slide};
    for (std::size_t i = 0; i < story->frames.size(); ++i) {
      Canvas& picture = deck.canvases.emplace_back(page, page, theme.paper, renderer.font());
      draw_frame(picture, *story, i, panels.look);
      Canvas& around = deck.canvases.emplace_back(frame_page, frame_page, theme.paper, renderer.font());
      draw_around(around, *story, i, look);
      deck.pages.push_back(
          {{&picture, panels.part, points_of_unit * Vec2(panels.left(), panels_top), points_of_unit * panels.scale},
           {&around, {{0, 0}, {frame_page.width, frame_page.height}}, {0, 0}, points_of_unit}});
    }
    return pdf_of(deck, text_of(story->walkthrough), theme.paper);
  };
  return {"deck.pdf", make};
}

OneFile notes() {
  const auto make = [](const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer& renderer) {
    std::vector<InGrid> parts;
    for (std::size_t i = 0; i < story->frames.size(); ++i)
      parts.push_back({i, [&, i](Canvas& canvas, double width) {
                         return write_notes(canvas, width, *story, i, output.look.style);
                       }});
    PaperSheet sheet = in_grid_on_a4(*story, parts, output.look, renderer.font());
    add_heads_and_feet(sheet, "Notes: " + literal(story->walkthrough.title), output.look.style, renderer.font());
    return pdf_of(sheet, text_of(story->walkthrough), output.look.style.theme.paper);
  };
  return {"notes.pdf", make};
}

}  // namespace walkthroughs::output
