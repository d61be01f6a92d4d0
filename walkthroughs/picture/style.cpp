#include "walkthroughs/picture/style.hpp"

namespace walkthroughs::picture {

using render::Stroke;
using render::TextStyle;

const render::Theme& theme_named(const std::string& name) {
  if (name == "slides") return render::themes::slides;
  return name == "dark" ? render::themes::dark : render::themes::report;
}

Style::Style(const render::Theme& t)
    : theme(t),
      grid{t.faint, 1},
      frame{t.faint, 1.5},
      hull{t.grey, 2.5 * t.line},
      hidden_edge{t.grey, 1.2 * t.line, {5, 6}},
      object_a{t.blue, 3 * t.line},
      object_b{t.ink, 3 * t.line},
      simplex{t.green, 4 * t.line, {11, 9}},
      move{t.green, 2 * t.line, {11, 9}},
      former{t.ink, 2.5 * t.line, {3, 7}},
      direction{t.vermillion, 4.5 * t.line},
      support_line{t.vermillion, 2 * t.line, {14, 5}},
      normal{t.blue, 4 * t.line},
      tested{t.blue, 3 * t.line},
      thin{t.grey, 1.5 * t.line, {2, 5}},
      projection{t.ink.with_alpha(90), 9 * t.line},
      foot{t.ink, 1.8 * t.line, {3, 4}},
      hatching{t.grey.with_alpha(150), 1},
      hidden_hatching{t.grey.with_alpha(70), 1, {4, 5}},
      cross{t.ink, 3.5 * t.line},
      origin{t.ink, 3.5 * t.line},
      parting{t.vermillion, 5 * t.line},
      object_a_fill(t.sky.with_alpha(110)),
      object_b_fill(t.orange.with_alpha(110)),
      hull_fill(t.faint.with_alpha(110)),
      simplex_fill(t.green.with_alpha(40)),
      out_of_reach(t.orange.with_alpha(50)),
      chosen_fill(t.green.with_alpha(64)),
      tested_fill(t.sky.with_alpha(80)),
      rejected_fill(t.grey.with_alpha(44)),
      title{.size = scaled(30), .weight = render::Weight::bold, .color = t.ink},
      panel_title{.size = scaled(18), .color = t.grey},
      caption{.size = scaled(26), .color = t.ink},
      fact{.size = scaled(23), .color = t.ink},
      small{.size = scaled(20), .color = t.grey},
      skipped{.size = scaled(18), .color = t.grey} {}

TextStyle Style::label(render::Color color, render::Weight weight) const {
  return {.size = scaled(26), .weight = weight, .color = color, .halo = theme.paper};
}

TextStyle Style::small_label() const { return {.size = scaled(22), .color = theme.ink, .halo = theme.paper}; }

}  // namespace walkthroughs::picture
