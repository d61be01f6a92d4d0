#include "walkthroughs/output/paper_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "render/file.hpp"
#include "walkthroughs/output/frames.hpp"
#include "walkthroughs/output/manifest.hpp"
#include "walkthroughs/picture/footer.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs {
namespace {

namespace fs = std::filesystem;
using render::Canvas;
using render::Size;
using render::Vec2;

// Points.
constexpr double margin = 34, gap = 12, foot = 20, title_size = 15, foot_size = 9, line_width = 0.5;
constexpr double least_picture_width = 230, least_words_width = 150;
constexpr double points_of_an_inch = 72, dots_of_an_inch = 300;
constexpr double larger_texts[] = {1.25, 1.5};

int dots(double points) { return static_cast<int>(std::lround(points / points_of_an_inch * dots_of_an_inch)); }

double inner_width(const render::PaperSize& paper) { return paper.width - 2 * margin; }
double rows_from() { return margin + title_size + gap; }
double rows_to(const render::PaperSize& paper) { return paper.height - margin - foot; }

/// Points that a page unit of words has: so that the smallest are legible.
double points_of_words(const Style& style) { return least_points / style.skipped.size; }

Look on_paper(Look look, double text_scale) {
  render::Theme theme = look.style.theme;
  theme.text = text_scale;
  look.style = Style(theme);
  look.text = Text::none;
  look.code = false;
  return look;
}

/// Returns: the size of the smallest letters of all frames, in page units.
double smallest_letters(const StagedStory& story, const Look& look, render::Font& font) {
  double smallest = look.style.panel_title.size;
  for (std::size_t i = 0; i < story.frames.size(); ++i) {
    Canvas canvas(page_of_frame(look.text), page_of_frame(look.text), look.style.theme.paper, font);
    draw_frame(canvas, story, i, look);
    for (const render::Shape& shape : canvas.shapes())
      if (const auto* const text = std::get_if<render::shape::Text>(&shape)) smallest = std::min(smallest, text->style.size);
  }
  return smallest;
}

/// The panels as small as the letters allow.
PaperLayout with_panels(const StagedStory& story, const render::PaperSize& paper, const Look& look, bool has_words,
                        render::Font& font) {
  PaperLayout layout{paper, look, 0, 0, 0, 0, false, {}, {}};
  const render::Box part = pictures_of_frame(story.walkthrough, look);
  const double letters = smallest_letters(story, look, font);
  const double wanted = std::max(least_points / letters * part.width(), least_picture_width);
  layout.words_below = has_words && wanted > inner_width(paper) - gap - least_words_width;
  const bool is_alone = layout.words_below || !has_words;
  const double most_width = is_alone ? inner_width(paper) : inner_width(paper) - gap - least_words_width;
  layout.picture_width = std::min(wanted, most_width);
  layout.picture_height = layout.picture_width * part.height() / part.width();
  const double reached = letters * layout.picture_width / part.width();
  layout.letters = wanted <= most_width ? std::max(reached, least_points) : reached;  // whatever rounding says
  if (has_words) layout.words_width = inner_width(paper) - (is_alone ? 0 : gap + layout.picture_width);
  return layout;
}

double height_of_words(const PaperLayout& layout, const StagedStory& story, std::size_t index, const Style& style,
                       render::Font& font) {
  Canvas measured({16, 16}, {16, 16}, style.theme.paper, font);
  const double unit = points_of_words(style);
  return unit * draw_words(measured, layout.words_width / unit, story, index, style);
}

void fill_pages(PaperLayout& layout) {
  double used = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < layout.heights.size(); ++i) {
    if (used + gap + layout.heights[i] > rows_to(layout.paper) - rows_from()) {
      layout.pages.emplace_back();
      used = -gap;
    }
    layout.pages.back().push_back(i);
    used += gap + layout.heights[i];
  }
}

}  // namespace

std::optional<render::PaperSize> paper_named(const std::string& name) {
  const std::string sheet = name.substr(0, name.find("-across"));
  render::PaperSize paper{210 / 25.4 * points_of_an_inch, 297 / 25.4 * points_of_an_inch};
  if (sheet == "letter") paper = {8.5 * points_of_an_inch, 11 * points_of_an_inch};
  if (sheet != "letter" && sheet != "a4") return std::nullopt;
  if (sheet != name) std::swap(paper.width, paper.height);
  return paper;
}

PaperLayout paper_layout(const StagedStory& story, const Output& output, const render::PaperSize& paper,
                         bool larger_text, render::Font& font) {
  const bool has_words = output.look.text == Text::around;
  const double usual = output.look.style.theme.text;
  PaperLayout best = with_panels(story, paper, on_paper(output.look, usual), has_words, font);
  for (const double scale : larger_texts) {
    if (!larger_text || scale <= usual) continue;
    PaperLayout larger = with_panels(story, paper, on_paper(output.look, scale), has_words, font);
    const bool is_legible = larger.letters >= least_points;
    if (is_legible ? larger.picture_height < best.picture_height || best.letters < least_points
                   : larger.letters > best.letters)
      best = std::move(larger);
  }
  for (std::size_t i = 0; i < story.frames.size(); ++i) {
    const double words = has_words ? height_of_words(best, story, i, output.look.style, font) : 0;
    best.heights.push_back(best.words_below ? best.picture_height + words : std::max(best.picture_height, words));
  }
  fill_pages(best);
  return best;
}

namespace {

std::string file_of_page(std::size_t page) { return "sheet-" + std::to_string(page + 1) + ".png"; }

/// Draws the pages of one story.
class PageDrawing {
 public:
  PageDrawing(const StagedStory& story, const Output& output, const PaperLayout& layout, Renderer& renderer)
      : story_(story), style_(output.look.style), layout_(layout), renderer_(renderer) {}

  render::Image draw(std::size_t page) const {
    const Size size{dots(layout_.paper.width), dots(layout_.paper.height)};
    const std::string number = "page " + std::to_string(page + 1) + " of " + std::to_string(layout_.pages.size());
    render::Image sheet =
        renderer_.draw_page(size, size, style_.theme.paper, [&](Canvas& canvas) { head_and_foot(canvas, number); });
    double top = rows_from();
    for (const std::size_t index : layout_.pages[page]) {
      paste_panels(sheet, index, top);
      if (layout_.words_width > 0) paste_words(sheet, index, top);
      top += layout_.heights[index] + gap;
    }
    return sheet;
  }

 private:
  /// A page unit is a dot.
  void head_and_foot(Canvas& canvas, const std::string& number) const {
    const double left = dots(margin), right = dots(layout_.paper.width - margin);
    const auto write = [&](const std::string& words, double size, double baseline, render::Align align) {
      render::TextStyle text{.size = 1.0 * dots(size), .color = style_.theme.ink, .align = align};
      const double needed = canvas.text_box({0, 0}, words, text).width();
      if (needed > right - left) text.size *= (right - left) / needed;
      canvas.text({align == render::Align::left ? left : right, baseline}, words, text);
    };
    write(literal(story_.walkthrough.title), title_size, dots(margin + title_size), render::Align::left);
    write(number, foot_size, dots(layout_.paper.height - margin), render::Align::right);
  }

  void paste_panels(render::Image& sheet, std::size_t index, double top) const {
    const render::Box part = pictures_of_frame(story_.walkthrough, layout_.look);
    const double unit = dots(layout_.picture_width) / part.width();  // in dots
    const Size page = page_of_frame(layout_.look.text);
    const render::Image whole = renderer_.draw_page(
        {static_cast<int>(page.width * unit), static_cast<int>(page.height * unit)}, page,
        layout_.look.style.theme.paper, [&](Canvas& canvas) { draw_frame(canvas, story_, index, layout_.look); });
    const auto at = [unit](double units) { return static_cast<int>(units * unit); };
    sheet.paste(render::part_of(whole, at(part.min.x()), at(part.min.y()), {at(part.width()), at(part.height())}),
                dots(margin), dots(top));
  }

  void paste_words(render::Image& sheet, std::size_t index, double top) const {
    const double unit = points_of_words(style_), width = layout_.words_width;
    const double height = layout_.heights[index] - (layout_.words_below ? layout_.picture_height : 0);
    const Vec2 corner(margin + (layout_.words_below ? 0 : layout_.picture_width + gap),
                      top + (layout_.words_below ? layout_.picture_height : 0));
    const Size page{static_cast<int>(width / unit), static_cast<int>(height / unit)};
    sheet.paste(renderer_.draw_page({dots(width), dots(height)}, page, style_.theme.paper,
                                    [&](Canvas& canvas) { draw_words(canvas, width / unit, story_, index, style_); }),
                dots(corner.x()), dots(corner.y()));
  }

  const StagedStory& story_;
  const Style& style_;
  const PaperLayout& layout_;
  Renderer& renderer_;
};

void write_pdf(const fs::path& folder, std::size_t pages, const render::PaperSize& paper, const render::PngText& text) {
  render::Pdf pdf(text);
  for (std::size_t page = 0; page < pages; ++page) {
    const fs::path file = folder / file_of_page(page);
    pdf.add(render::decode_png(read_back(file), file.string()), paper);
  }
  write_output(folder / "sheet.pdf", pdf.finish());
}

}  // namespace

void PaperSheets::add(const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer& renderer) {
  const render::PngText text{story->walkthrough.title, story->walkthrough.summary};
  const PaperLayout layout = paper_layout(*story, output, paper_, larger_text_, renderer.font());
  if (layout.letters < least_points) too_small_(*story, layout.letters);
  const fs::path folder = folder_of(output, story->walkthrough);
  const auto tell = [written = written_, story](const fs::path& file) { written(file, *story); };
  const PageDrawing drawing(*story, output, layout, renderer);
  std::set<std::string> pages;
  for (std::size_t page = 0; page < layout.pages.size(); ++page) {
    renderer.write(folder / file_of_page(page), drawing.draw(page), text, tell);
    pages.insert(file_of_page(page));
  }
  renderer.then([folder, tell, text, pages, paper = paper_] {
    write_pdf(folder, pages.size(), paper, text);
    remove_outputs(folder, {"sheet-#.png"}, text.title, pages);
    tell(folder / "sheet.pdf");
  });
}

}  // namespace walkthroughs
