#include "walkthroughs/output/paper_sheet.hpp"

#include <algorithm>

#include "walkthroughs/story/words.hpp"

namespace walkthroughs::output {
namespace {

using render::Box;
using render::Canvas;
using render::OnPaper;
using render::PaperSize;
using render::PdfPage;
using render::Size;
using render::Vec2;

constexpr double line_pitch = 1.25;  // sizes of its letters
// Points.
constexpr double gap = 14, foot = 20, foot_size = 9, points_of_an_inch = 72;
constexpr double least_picture_width = 230, least_words_width = 150;
constexpr double most_of_a_page = 0.7;  // that a picture takes, so that there is room for the words below
constexpr double larger_texts[] = {1.25, 1.5};

double inner_width(const PaperSize& paper) { return paper.width - 2 * margin; }
double rows_from() { return margin + title_size + gap; }
double rows_to(const PaperSize& paper) { return paper.height - margin - foot; }
double rows_height(const PaperSize& paper) { return rows_to(paper) - rows_from(); }

/// Points that a page unit of words has: so that the smallest are legible.
double points_of_words(const Style& style) { return least_points / style.skipped.size; }

/// The panels of what stands there, laid out with text of one scale.
struct PanelsOfFrames {
  PanelsOfFrames(const StagedStory& story, const std::vector<InGrid>& parts, Look look, double text_scale,
                 render::Font& font) {
    render::Theme theme = look.style.theme;
    theme.text = text_scale;
    look.style = Style(theme);
    look.text = Text::none;
    look.code = false;
    part = pictures_of_frame(story.walkthrough, look);
    letters = look.style.panel_title.size;
    const Size page = page_of_frame(look);
    for (const InGrid& each : parts) {
      draw_frame(canvases.emplace_back(page, page, theme.paper, font), story, each.frame, look);
      letters = std::min(letters, smallest_letters(canvases.back()));
    }
  }

  /// Returns: how wide they are where their letters are legible, and words have room below, in points.
  double least_width() const { return std::max(least_points / letters * part.width(), least_picture_width); }

  Box part;        ///< of each canvas
  double letters;  ///< the smallest, in page units
  std::deque<Canvas> canvases;
};

/// The smallest that are legible, so that many fit on a page.
PanelsOfFrames smallest_panels(const StagedStory& story, const std::vector<InGrid>& parts, const Look& look,
                               bool larger_text, render::Font& font) {
  PanelsOfFrames best(story, parts, look, look.style.theme.text, font);
  for (const double scale : larger_texts) {
    if (!larger_text || scale <= look.style.theme.text) continue;
    PanelsOfFrames larger(story, parts, look, scale, font);
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
Canvas head_and_foot(const std::string& title, const PaperSize& paper, const std::string& number, const Style& style,
                     render::Font& font) {
  const Size size{static_cast<int>(paper.width), static_cast<int>(paper.height)};
  Canvas canvas(size, size, style.theme.paper, font);
  const render::TextStyle text{.size = title_size, .color = style.theme.ink};
  canvas.text({margin, margin + title_size}, title, canvas.fitted(title, text, inner_width(paper)));
  canvas.text({paper.width - margin, paper.height - margin}, number,
              {.size = foot_size, .color = style.theme.ink, .align = render::Align::right});
  return canvas;
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

void Rows::add(PdfPage row, double height) {
  if (top_ + height > rows_to(printed_.paper)) {
    printed_.pages.emplace_back();
    top_ = rows_from();
  }
  for (OnPaper& part : row) {
    part.corner.y() += top_;
    printed_.pages.back().push_back(part);
  }
  top_ += height + gap;
}

void Rows::write(const Write& write, const Style& style, render::Font& font) {
  const double unit = points_of_words(style), width = inner_width(printed_.paper) / unit;
  const Size page{static_cast<int>(width), render::max_pixels};
  Canvas& canvas = printed_.canvases.emplace_back(page, page, style.theme.paper, font);
  const double height = write(canvas, width);
  add({{&canvas, {{0, 0}, {width, height}}, {margin, 0}, unit}}, unit * height);
}

PaperSheet in_grid(const StagedStory& story, const std::vector<InGrid>& parts, const Look& look, const PaperSize& paper,
                   bool larger_text, render::Font& font) {
  PanelsOfFrames panels = smallest_panels(story, parts, look, larger_text, font);
  const Grid grid(panels.least_width(), panels.part.height() / panels.part.width(), paper);
  const double scale = grid.picture / panels.part.width(), unit = points_of_words(look.style);
  const bool are_legible = grid.picture >= panels.least_width();
  const double letters = are_legible ? std::max(scale * panels.letters, least_points) : scale * panels.letters;
  PaperSheet sheet{{paper, std::move(panels.canvases)}, letters, grid.columns};
  const Size words_page{static_cast<int>(grid.words / unit), render::max_pixels};
  const Vec2 to_words = grid.is_beside ? Vec2(grid.picture + gap, 0) : Vec2(0, scale * panels.part.height());
  Rows rows(sheet);
  for (std::size_t first = 0; first < parts.size(); first += sheet.columns) {
    PdfPage row;
    double height = 0;
    for (std::size_t i = first; i < std::min(first + sheet.columns, parts.size()); ++i) {
      const double left = margin + static_cast<double>(i - first) * (grid.column + gap);
      row.push_back({&sheet.canvases[i], panels.part, {left, 0}, scale});
      height = std::max(height, scale * panels.part.height());
      if (!parts[i].write) continue;
      Canvas& words = sheet.canvases.emplace_back(words_page, words_page, look.style.theme.paper, font);
      const double words_height = parts[i].write(words, grid.words / unit);
      row.push_back({&words, {{0, 0}, {grid.words / unit, words_height}}, Vec2(left, 0) + to_words, unit});
      height = std::max(height, row.back().corner.y() + unit * words_height);
    }
    rows.add(std::move(row), height);
  }
  return sheet;
}

PaperSheet in_grid_on_a4(const StagedStory& story, const std::vector<InGrid>& parts, const Look& look,
                         render::Font& font) {
  const auto on = [&](const char* paper) { return in_grid(story, parts, look, *paper_named(paper), true, font); };
  PaperSheet upright = on("a4");
  if (upright.letters < least_points) return on("a4-across");
  return upright;
}

void add_heads_and_feet(Printed& printed, const std::string& title, const Style& style, render::Font& font) {
  const PaperSize& paper = printed.paper;
  for (std::size_t page = 0; page < printed.pages.size(); ++page) {
    const std::string number = "page " + std::to_string(page + 1) + " of " + std::to_string(printed.pages.size());
    const Canvas& around = printed.canvases.emplace_back(head_and_foot(title, paper, number, style, font));
    printed.pages[page].push_back({&around, {{0, 0}, {paper.width, paper.height}}, {0, 0}, 1});
  }
}

PaperSheet paper_sheet(const StagedStory& story, const Look& look, const PaperSize& paper, bool larger_text,
                       render::Font& font) {
  std::vector<InGrid> parts;
  for (std::size_t i = 0; i < story.frames.size(); ++i) {
    const auto write = [&, i](Canvas& canvas, double width) { return draw_words(canvas, width, story, i, look.style); };
    parts.push_back({i, look.text == Text::none ? Write() : write});
  }
  PaperSheet sheet = in_grid(story, parts, look, paper, larger_text, font);
  add_heads_and_feet(sheet, literal(story.walkthrough.title), look.style, font);
  return sheet;
}

double write_lines(Canvas& canvas, const Vec2& corner, const std::string& text, const render::TextStyle& style,
                   double width) {
  const std::vector<std::string> lines = render::wrap(canvas, text, style, width);
  for (std::size_t i = 0; i < lines.size(); ++i)
    canvas.text(corner + Vec2(0, style.size * (1 + line_pitch * static_cast<double>(i))), lines[i], style);
  return style.size * line_pitch * static_cast<double>(lines.size());
}

double smallest_letters(const Canvas& canvas) {
  double least = std::numeric_limits<double>::infinity();
  for (const render::Shape& shape : canvas.shapes())
    if (const auto* text = std::get_if<render::shape::Text>(&shape)) least = std::min(least, text->style.size);
  return least;
}

Renderer::Content pdf_of(const Printed& printed, const render::PngText& text, const render::Color& color) {
  return [pdf = encode_pdf(printed.pages, printed.paper, color, text)] { return pdf; };
}

OneFile paper_sheets(PaperSize paper, bool larger_text, TooSmall too_small) {
  const auto make = [=](const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer& renderer) {
    const PaperSheet sheet = paper_sheet(*story, output.look, paper, larger_text, renderer.font());
    if (sheet.letters < least_points) too_small(*story, sheet.letters);
    return pdf_of(sheet, text_of(story->walkthrough), output.look.style.theme.paper);
  };
  return {"sheet.pdf", make};
}

}  // namespace walkthroughs::output
