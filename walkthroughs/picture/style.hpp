/// How things look in the pictures, given a theme: one place for line widths, dashes and text sizes.
#pragma once

#include <string>

#include "render/canvas.hpp"
#include "walkthroughs/rooms.hpp"

namespace walkthroughs::picture {

/// Requires: "report", "slides" or "dark".
const render::Theme& theme_named(const std::string& name);

struct Style {
  /// Requires: render::least_text_scale <= theme.text <= render::most_text_scale.
  explicit Style(const render::Theme& theme);

  render::Theme theme;

  // Lines. Widths in page units.
  render::Stroke grid, frame;
  render::Stroke hull, hidden_edge;        ///< an outline of the difference, and its edges that lie behind
  render::Stroke object_a, object_b;       ///< outlines of the objects
  render::Stroke simplex, move, former;    ///< edges of the simplex, the move just made, edges of earlier simplices
  render::Stroke direction, support_line;  ///< d, and the line or plane across it through the point found
  render::Stroke normal, tested, thin, projection;
  render::Stroke foot;                       ///< from the origin to its place in the plane of a triangle
  render::Stroke hatching, hidden_hatching;  ///< of what the algorithm skips, and of what lies behind of that
  render::Stroke cross;                      ///< through what it has rejected or dropped
  render::Stroke origin;
  render::Stroke parting;  ///< around what differs first

  // Fills, translucent.
  render::Color object_a_fill, object_b_fill, hull_fill, simplex_fill, out_of_reach;
  render::Color chosen_fill, tested_fill, rejected_fill;

  double point_radius = 7;
  double arrow_length = 60;  ///< directions have no length of their own
  double hatch_spacing = 11;

  // Text.
  double scaled(double page_units) const { return theme.text * page_units; }  ///< of what is as high as a line of text
  double smallest_label() const { return theme.text > 1 ? 1 / theme.text : 1; }  ///< for Panel::place_labels()
  render::TextStyle title, panel_title, caption, fact, small, skipped;
  render::TextStyle label(render::Color color, render::Weight weight = render::Weight::regular) const;
  render::TextStyle small_label() const;
};

}  // namespace walkthroughs::picture
