/// All frames in one picture, as on a contact sheet.
#pragma once

#include "walkthroughs/output/sink.hpp"

namespace walkthroughs::output {

inline constexpr double sheet_scale = 0.375;
inline constexpr int sheet_columns = 4, sheet_gap = 8;  // so many in a row; pixels around each frame

/// Where the frames of a contact sheet stand, in pixels.
struct SheetLayout {
  int count, columns;
  render::Size frame;  ///< of which size frames are asked for,
  render::Size cell;   ///< and which they have, perhaps without text

  int left(int index) const { return sheet_gap + index % columns * (cell.width + sheet_gap); }
  int top(int index) const { return sheet_gap + index / columns * (cell.height + sheet_gap); }
  render::Size size() const {
    return {left(columns - 1) + cell.width + sheet_gap, top(count - 1) + cell.height + sheet_gap};
  }
};

/// Returns: `count` frames of `output` at `sheet_scale`, `sheet_columns` in a row; more in a row where the sheet would be
/// higher than max_image_side, and smaller ones where that is not enough. Requires: count >= 1.
/// Errors: render::FileError where even the smallest do not fit, which takes 400,000 of them.
SheetLayout sheet_layout(int count, const Output& output);

/// sheet.png: all frames in reading order, each drawn anew, as sheet_layout() says.
OneFile sheet();

}  // namespace walkthroughs::output
