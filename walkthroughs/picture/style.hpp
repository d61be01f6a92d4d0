/// How things look in the pictures, given a theme: one place for line widths, dashes and text sizes.
#pragma once

#include <string>

#include "render/canvas.hpp"
#include "walkthroughs/rooms.hpp"

namespace walkthroughs::picture {

/// Requires: "report", "slides" or "dark".
inline const render::Theme& theme_named(const std::string& name) {
  if (name == "slides") return render::themes::slides;
  return name == "dark" ? render::themes::dark : render::themes::report;
}

struct Style {
  /// Requires: render::least_text_scale <= theme.text <= render::most_text_scale.
  explicit Style(const render::Theme& of) : theme(of) {}

  double scaled(double page_units) const { return theme.text * page_units; }  ///< of what is as high as a line of text
  double smallest_label() const { return theme.text > 1 ? 1 / theme.text : 1; }  ///< for Panel::place_labels()
  render::TextStyle label(render::Color color, render::Weight weight = render::Weight::regular) const {
    return {.size = scaled(26), .weight = weight, .color = color, .halo = theme.paper};
  }
  render::TextStyle small_label() const { return {.size = scaled(22), .color = theme.ink, .halo = theme.paper}; }

  render::Theme theme;
  double turn = 0, rise = 0;  ///< degrees by which the camera of a diagram in space is moved

  // Lines. Widths in page units.
  render::Stroke grid{theme.faint, 1}, frame{theme.faint, 1.5};
  render::Stroke hull{theme.grey, 2.5 * theme.line};                 ///< an outline of the difference,
  render::Stroke hidden_edge{theme.grey, 1.2 * theme.line, {5, 6}};  ///< and its edges that lie behind
  render::Stroke object_a{theme.blue, 3 * theme.line}, object_b{theme.ink, 3 * theme.line};  ///< their outlines
  render::Stroke crossing{theme.ink, 1.8 * theme.line}, crossing_border{theme.paper, 5 * theme.line};  ///< of both
  render::Stroke simplex{theme.green, 4 * theme.line, {11, 9}};            ///< edges of the simplex,
  render::Stroke move{theme.green, 2 * theme.line, {11, 9}};               ///< the move just made,
  render::Stroke former{theme.ink, 2.5 * theme.line, {3, 7}};              ///< edges of earlier simplices
  render::Stroke direction{theme.vermillion, 4.5 * theme.line};            ///< d, and the line or plane across it
  render::Stroke support_line{theme.vermillion, 2 * theme.line, {14, 5}};  ///< through the point found
  render::Stroke normal{theme.blue, 4 * theme.line}, tested{theme.blue, 3 * theme.line};
  render::Stroke thin{theme.grey, 1.5 * theme.line, {2, 5}};
  render::Stroke projection{theme.ink.with_alpha(90), 9 * theme.line};
  render::Stroke foot{theme.ink, 1.8 * theme.line, {3, 4}};  ///< from the origin to its place in a triangle's plane
  render::Stroke hatching{theme.grey.with_alpha(150), 1};    ///< of what the algorithm skips,
  render::Stroke hidden_hatching{theme.grey.with_alpha(70), 1, {4, 5}};  ///< and of what lies behind of that
  render::Stroke cross{theme.ink, 3.5 * theme.line};                     ///< through what it has rejected or dropped
  render::Stroke origin{theme.ink, 3.5 * theme.line};
  render::Stroke parting{theme.vermillion, 5 * theme.line};  ///< around the panel of what differs first, outside of it

  // Fills, translucent.
  render::Color object_a_fill = theme.sky.with_alpha(110), object_b_fill = theme.orange.with_alpha(110);
  render::Color hull_fill = theme.faint.with_alpha(110), hull_in_space = theme.faint.with_alpha(170);
  render::Color simplex_fill = theme.green.with_alpha(40);
  render::Color out_of_reach = theme.orange.with_alpha(50);
  render::Color chosen_fill = theme.green.with_alpha(64), tested_fill = theme.sky.with_alpha(80);
  render::Color rejected_fill = theme.grey.with_alpha(44);

  double point_radius = 7;
  double arrow_length = 60;  ///< directions have no length of their own
  double hatch_spacing = 11;

  // Text.
  render::TextStyle title{.size = scaled(30), .weight = render::Weight::bold, .color = theme.ink};
  render::TextStyle panel_title{.size = scaled(18), .color = theme.grey};
  render::TextStyle caption{.size = scaled(26), .color = theme.ink}, fact{.size = scaled(23), .color = theme.ink};
  render::TextStyle small{.size = scaled(20), .color = theme.grey}, skipped{.size = scaled(18), .color = theme.grey};
};

}  // namespace walkthroughs::picture
