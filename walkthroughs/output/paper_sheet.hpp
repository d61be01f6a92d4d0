/// Frames on sheets of paper, to hand out.
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "render/vector.hpp"
#include "walkthroughs/output/sink.hpp"

namespace walkthroughs::output {

inline constexpr double least_points = 7;  ///< of letters on paper, apart from subscripts

/// Returns: the paper of that name: "a4", "letter", and either of them "-across"; nothing where there is none.
std::optional<render::PaperSize> paper_named(const std::string& name);

/// The frames of a story on paper: in a grid, each the panels without the pseudo-code, and the words beside or below.
/// The title stands above each page, its number below.
struct PaperSheet {
  double letters;       ///< the smallest of the panels, in points; words have least_points and more
  std::size_t columns;  ///< of the grid
  std::deque<render::Canvas> canvases = {};  ///< that stand
  std::vector<render::PdfPage> pages = {};   ///< on these pages
};

/// Returns: the panels as small as letters of least_points allow, so that many stand on a page. Where `larger_text` they
/// are laid out with larger text where that makes them smaller on paper. Where the paper is too narrow for legible
/// letters, the panels are as wide as it.
PaperSheet paper_sheet(const StagedStory& story, const Look& look, const render::PaperSize& paper, bool larger_text,
                       render::Font& font);

/// Told where letters are smaller than they should be, and how large they are, in points.
using TooSmall = std::function<void(const Story& story, double points)>;

/// sheet.pdf, as paper_sheet() lays it out.
OneFile paper_sheets(render::PaperSize paper, bool larger_text, TooSmall too_small);

}  // namespace walkthroughs::output
