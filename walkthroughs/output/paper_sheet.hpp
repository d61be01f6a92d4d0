/// Frames on sheets of paper, to hand out.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/pdf.hpp"
#include "walkthroughs/output/sink.hpp"

namespace walkthroughs {

inline constexpr double least_points = 7;  ///< of letters on paper, apart from subscripts

/// Returns: the paper of that name: "a4", "letter", and either of them "-across"; nothing where there is none.
std::optional<render::PaperSize> paper_named(const std::string& name);

/// How the frames of a story stand on paper: the panels without the pseudo-code, and beside them, or below, the words.
struct PaperLayout {
  render::PaperSize paper;
  Look look;                             ///< of the panels
  double letters;                        ///< the smallest of the panels, in points; words have least_points and more
  double picture_width, picture_height;  ///< in points
  double words_width;                    ///< in points; 0 where there are none
  bool words_below;                      ///< where beside them the panels would not be legible
  std::vector<std::vector<std::size_t>> pages;  ///< the frames of each, from top to bottom
  std::vector<double> heights;                  ///< of the frames with their words, in points
};

/// Returns: the panels as small as the letters allow, so that as many frames as possible stand on a page. Where `larger_text`
/// those are laid out with larger text where that makes them smaller on paper. Where the paper is too narrow for legible
/// letters, the panels are as wide as it.
PaperLayout paper_layout(const StagedStory& story, const Output& output, const render::PaperSize& paper,
                         bool larger_text, render::Font& font);

/// FOLDER/NAME/sheet-1.png, sheet-2.png, … and all of them as FOLDER/NAME/sheet.pdf. Removes further pages of an earlier run.
class PaperSheets : public Sink {
 public:
  /// Told where letters are smaller than they should be, and how large they are, in points.
  using TooSmall = std::function<void(const Story& story, double points)>;

  PaperSheets(render::PaperSize paper, bool larger_text, TooSmall too_small, FileWritten written)
      : paper_(paper), larger_text_(larger_text), too_small_(std::move(too_small)), written_(std::move(written)) {}
  std::vector<std::string> files(const Walkthrough&) const override { return {"sheet-#.png", "sheet.pdf"}; }
  void add(const std::shared_ptr<const StagedStory>& story, const Output& output, Renderer& renderer) override;

 private:
  render::PaperSize paper_;
  bool larger_text_;
  TooSmall too_small_;
  FileWritten written_;
};

}  // namespace walkthroughs
