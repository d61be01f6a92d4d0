/// Frames on sheets of paper, to hand out.
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "render/vector.hpp"
#include "walkthroughs/output/sink.hpp"

namespace walkthroughs::output {

inline constexpr double least_points = 7;              ///< of letters on paper, apart from subscripts
inline constexpr double margin = 34, title_size = 15;  ///< of a page, in points

/// Returns: the paper of that name: "a4", "letter", and either of them "-across"; nothing where there is none.
std::optional<render::PaperSize> paper_named(const std::string& name);

/// Canvases, and the pages that they stand on.
struct Printed {
  render::PaperSize paper;
  std::deque<render::Canvas> canvases = {};
  std::vector<render::PdfPage> pages = {};
};

/// Returns: the pages as a file. `text`: its title and what it is about.
Renderer::Content pdf_of(const Printed& printed, const render::PngText& text, const render::Color& color);

/// The frames of a story on paper: in a grid, each the panels without the pseudo-code, and the words beside or below.
/// The title stands above each page, its number below.
struct PaperSheet : Printed {
  double letters;       ///< the smallest of the panels, in points; words have least_points and more
  std::size_t columns;  ///< of the grid
};

/// Returns: the panels as small as letters of least_points allow, so that many stand on a page. Where `larger_text` they
/// are laid out with larger text where that makes them smaller on paper. Where the paper is too narrow for legible
/// letters, the panels are as wide as it.
PaperSheet paper_sheet(const StagedStory& story, const Look& look, const render::PaperSize& paper, bool larger_text,
                       render::Font& font);

/// Writes into a canvas of that width from its top left corner on. Returns: how high it is.
using Write = std::function<double(render::Canvas& canvas, double width)>;

/// The panels of a frame, and what is written beside or below them; nothing where that is empty.
struct InGrid {
  std::size_t frame;
  Write write;
};

/// Returns: these in the grid of a paper_sheet(), without title and numbers of pages.
PaperSheet in_grid(const StagedStory& story, const std::vector<InGrid>& parts, const Look& look,
                   const render::PaperSize& paper, bool larger_text, render::Font& font);

/// Rows below each other, on as many further pages as they need, below the place for a title.
class Rows {
 public:
  explicit Rows(Printed& printed) : printed_(printed) {}
  /// `row`: corners are places in the row.
  void add(render::PdfPage row, double height);
  /// Adds what is written over the whole width.
  void write(const Write& write, const Style& style, render::Font& font);

 private:
  Printed& printed_;
  double top_ = std::numeric_limits<double>::infinity();  ///< of the next; the first begins a page
};

/// Returns: the grid on A4, held across where letters would be too small otherwise.
PaperSheet in_grid_on_a4(const StagedStory& story, const std::vector<InGrid>& parts, const Look& look,
                         render::Font& font);

/// Above each page the title, with the markup of render/font.hpp; below its number.
void add_heads_and_feet(Printed& printed, const std::string& title, const Style& style, render::Font& font);

/// Writes lines no longer than `width`, the first of which begins below `corner`. Returns: how high they are.
double write_lines(render::Canvas& canvas, const render::Vec2& corner, const std::string& text,
                   const render::TextStyle& style, double width);

/// Returns: the size of the smallest letters on it, apart from subscripts, in its page units; infinity where there are none.
double smallest_letters(const render::Canvas& canvas);

/// Told where letters are smaller than they should be, and how large they are, in points.
using TooSmall = std::function<void(const Story& story, double points)>;

/// sheet.pdf, as paper_sheet() lays it out.
OneFile paper_sheets(render::PaperSize paper, bool larger_text, TooSmall too_small);

}  // namespace walkthroughs::output
