#include "walkthroughs/output/paper_sheet.hpp"

#include <algorithm>
#include <limits>

#include "walkthroughs/story/words.hpp"

namespace walkthroughs::output {
namespace {

using render::Box;
using render::Canvas;
using render::OnPaper;
using render::PaperSize;
using render::Size;
using render::Vec2;

// Points.
constexpr double margin = 34, gap = 14, foot = 20, title_size = 15, foot_size = 9, points_of_an_inch = 72;
constexpr double least_picture_width = 230, least_words_width = 150;
constexpr double most_of_a_page = 0.7;  // that a picture takes, so that there is room for the words below
constexpr double larger_texts[] = {1.25, 1.5};

double inner_width(const PaperSize& paper) { return paper.width - 2 * margin; }
double rows_from() { return margin + title_size + gap; }
double rows_to(const PaperSize& paper) { return paper.height - margin - foot; }
double rows_height(const PaperSize& paper) { return rows_to(paper) - rows_from(); }

/// Points that a page unit of words has: so that the smallest are legible.
double points_of_words(const Style& style) { return least_points / style.skipped.size; }

/// The panels of all frames, laid out with text of one scale.
struct PanelsOfFrames {
  PanelsOfFrames(const StagedStory& story, Look look, double text_scale, render::Font& font) {
    render::Theme theme = look.style.theme;
    theme.text = text_scale;
    look.style = Style(theme);
    look.text = Text::none;
    look.code = false;
    part = pictures_of_frame(story.walkthrough, look);
    letters = look.style.panel_title.size;
    const Size page = page_of_frame(look);
    for (std::size_t i = 0; i < story.frames.size(); ++i) {
      draw_frame(canvases.emplace_back(page, page, theme.paper, font), story, i, look);
      for (const render::Shape& shape : canvases.back().shapes())
        if (const auto* text = std::get_if<render::shape::Text>(&shape)) letters = std::min(letters, text->style.size);
    }
  }

  /// Returns: how wide they are where their letters are legible, and words have room below, in points.
  double least_width() const { return std::max(least_points / letters * part.width(), least_picture_width); }

  Box part;        ///< of each canvas
  double letters;  ///< the smallest, in page units
  std::deque<Canvas> canvases;
};

/// The smallest that are legible, so that many fit on a page.
PanelsOfFrames smallest_panels(const StagedStory& story, const Look& look, bool larger_text, render::Font& font) {
  PanelsOfFrames best(story, look, look.style.theme.text, font);
  for (const double scale : larger_texts) {
    if (!larger_text || scale <= look.style.theme.text) continue;
    PanelsOfFrames larger(story, look, scale, font);
    if (larger.least_width() < best.least_width()) best = std::move(larger);
  }
  return best;
}

/// How wide things are, in points.
struct Grid {
  Grid(double least_width, double ratio, const PaperSize& paper)
      : columns(std::max<std::size_t>(1, static_cast<std::size_t>((inner_width(paper) + gap) / (least_width + gap)))) {
    const auto count = static_cast<double>(columns);
    column = (inner_width(paper) - (count - 1) * gap) / count;
    picture = std::min({columns == 1 ? least_width : column, column, most_of_a_page * rows_height(paper) / ratio});
    is_beside = column - picture - gap >= least_words_width;
    words = is_beside ? column - picture - gap : column;
  }

  std::size_t columns;
  double column, picture, words;
  bool is_beside;  ///< whether the words stand there, not below
};

/// The title, and below the number of the page. Its page unit is a point.
Canvas head_and_foot(const StagedStory& story, const PaperSize& paper, const std::string& number, const Style& style,
                     render::Font& font) {
  const Size size{static_cast<int>(paper.width), static_cast<int>(paper.height)};
  Canvas canvas(size, size, style.theme.paper, font);
  const std::string title = literal(story.walkthrough.title);
  const render::TextStyle text{.size = title_size, .color = style.theme.ink};
  canvas.text({margin, margin + title_size}, title, canvas.fitted(title, text, inner_width(paper)));
  canvas.text({paper.width - margin, paper.height - margin}, number,
              {.size = foot_size, .color = style.theme.ink, .align = render::Align::right});
  return canvas;
}

void add_heads_and_feet(PaperSheet& sheet, const StagedStory& story, const PaperSize& paper, const Style& style,
                        render::Font& font) {
  for (std::size_t page = 0; page < sheet.pages.size(); ++page) {
    const std::string number = "page " + std::to_string(page + 1) + " of " + std::to_string(sheet.pages.size());
    const Canvas& around = sheet.canvases.emplace_back(head_and_foot(story, paper, number, style, font));
    sheet.pages[page].push_back({&around, {{0, 0}, {paper.width, paper.height}}, {0, 0}, 1});
  }
}

}  // namespace

std::optional<PaperSize> paper_named(const std::string& name) {
  const std::string sheet = name.substr(0, name.find("-across"));
  PaperSize paper{210 / 25.4 * points_of_an_inch, 297 / 25.4 * points_of_an_inch};
  if (sheet == "letter") paper = {8.5 * points_of_an_inch, 11 * points_of_an_inch};
  if (sheet != "letter" && sheet != "a4") return std::nullopt;
  if (sheet != name) std::swap(paper.width, paper.height);
  return paper;
}

PaperSheet paper_sheet(const StagedStory& story, const Look& look, const PaperSize& paper, bool larger_text,
                       render::Font& font) {
  PanelsOfFrames panels = smallest_panels(story, look, larger_text, font);
  const Grid grid(panels.least_width(), panels.part.height() / panels.part.width(), paper);
  const double scale = grid.picture / panels.part.width(), unit = points_of_words(look.style);
  const bool are_legible = grid.picture >= panels.least_width();
  const double letters = are_legible ? std::max(scale * panels.letters, least_points) : scale * panels.letters;
  PaperSheet sheet{letters, grid.columns, std::move(panels.canvases)};
  const Size words_page{static_cast<int>(grid.words / unit), render::max_pixels};
  const Vec2 to_words = grid.is_beside ? Vec2(grid.picture + gap, 0) : Vec2(0, scale * panels.part.height());
  double top = std::numeric_limits<double>::infinity();
  for (std::size_t first = 0; first < story.frames.size(); first += sheet.columns) {
    render::PdfPage row;
    double height = 0;
    for (std::size_t i = first; i < std::min(first + sheet.columns, story.frames.size()); ++i) {
      const double left = margin + static_cast<double>(i - first) * (grid.column + gap);
      row.push_back({&sheet.canvases[i], panels.part, {left, 0}, scale});
      height = std::max(height, scale * panels.part.height());
      if (look.text == Text::none) continue;
      Canvas& words = sheet.canvases.emplace_back(words_page, words_page, look.style.theme.paper, font);
      const double words_height = draw_words(words, grid.words / unit, story, i, look.style);
      row.push_back({&words, {{0, 0}, {grid.words / unit, words_height}}, Vec2(left, 0) + to_words, unit});
      height = std::max(height, row.back().corner.y() + unit * words_height);
    }
    if (top + height > rows_to(paper)) {
      sheet.pages.emplace_back();
      top = rows_from();
    }
    for (OnPaper& part : row) {
      part.corner.y() += top;
      sheet.pages.back().push_back(part);
    }
    top += height + gap;
  }
  add_heads_and_feet(sheet, story, paper, look.style, font);
  return sheet;
}

OneFile paper_sheets(PaperSize paper, bool larger_text, TooSmall too_small) {
  const auto make = [=](const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer& renderer) {
    const PaperSheet sheet = paper_sheet(*story, output.look, paper, larger_text, renderer.font());
    if (sheet.letters < least_points) too_small(*story, sheet.letters);
    const render::Color color = output.look.style.theme.paper;
    return [pdf = encode_pdf(sheet.pages, paper, color, text_of(story->walkthrough))] { return pdf; };
  };
  return {"sheet.pdf", make};
}

}  // namespace walkthroughs::output
