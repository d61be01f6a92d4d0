#include <algorithm>
#include <functional>

#include "walkthroughs/catalogue/figure_objects.hpp"
#include "walkthroughs/model/labelled_hull.hpp"
#include "walkthroughs/picture/diagram_parts.hpp"
#include "walkthroughs/picture/lens.hpp"

namespace walkthroughs::catalogue {
namespace {

using render::Panel;
using render::Vec2;

constexpr double stretch = 1.3;     // how far outside the hull the band is held, in scene units
constexpr double margin = 24;       // page units around the stretched band
constexpr double still_out = 0.35;  // of that, a moment after it was let go
constexpr double arrow_gap = 0.06;  // of that, between arrow and band
constexpr double any_scale = 1e9;

enum class Band { none, stretched, let_go, snapped };

/// The pins, of which about half lie inside, and what is computed from them.
struct Pinboard {
  std::vector<Vec2> pins = {{-8.5, 0.5}, {-6, 2.25},  {-5, -0.75}, {-4, -2}, {-1.75, 1}, {-0.75, -1}, {0, 2.75},
                            {1.5, 0.25}, {2.5, -2.5}, {4, 1.5},    {5, -1},  {7, 2},     {8.5, -1.25}};
  std::vector<Vec2> hull = convex_hull(pins);
  std::vector<Vec2> stretched = offset_outward(hull, stretch);
  std::vector<Vec2> halfway = offset_outward(hull, stretch* still_out);

  bool is_corner(const Vec2& pin) const { return std::ranges::find(hull, pin) != hull.end(); }
};

render::Stroke band_stroke(const Style& style) { return {style.theme.vermillion, 5 * style.theme.line}; }

/// From the middle of each side of the hull outward, an arrow back.
void draw_arrows(Panel& panel, const Pinboard& board, const Style& style) {
  for (std::size_t i = 0; i < board.hull.size(); ++i) {
    const Vec2 &p = board.hull[i], &q = board.hull[(i + 1) % board.hull.size()];
    const Vec2 outward = Vec2(q.y() - p.y(), p.x() - q.x()).normalized() * stretch;
    const Vec2 middle = (p + q) / 2;
    panel.arrow(middle + outward, middle + outward * (still_out + arrow_gap), {style.theme.ink, 3 * style.theme.line});
  }
}

void draw_band(Panel& panel, const Pinboard& board, Band band, const Style& style) {
  switch (band) {
    case Band::none: return;
    case Band::stretched: return panel.outline(board.stretched, band_stroke(style));
    case Band::let_go:
      panel.outline(board.stretched, style.former);
      panel.outline(board.halfway, band_stroke(style));
      return draw_arrows(panel, board, style);
    case Band::snapped:
      panel.polygon(board.hull, style.hull_fill);
      return panel.outline(board.hull, band_stroke(style));
  }
}

void draw_pins(Panel& panel, const Pinboard& board, Band band, const Style& style) {
  for (const Vec2& pin : board.pins) {
    if (band == Band::snapped && !board.is_corner(pin))
      draw_hollow_point(panel, pin, style.theme.ink, style);
    else
      draw_point(panel, pin, style.theme.ink, style);
  }
}

/// Names the band at the corner of its outline farthest to the upper right, and when it has snapped one pin of each kind.
void name_parts(Panel& panel, const Pinboard& board, Band band, const Style& style) {
  const auto beside = [&](const std::vector<Vec2>& outline, const std::string& text) {
    const Vec2 at = *std::ranges::max_element(outline, {}, [](const Vec2& p) { return p.x() + p.y(); });
    panel.label(at, {1, 0.3}, text, style.label(style.theme.vermillion, render::Weight::bold));
  };
  if (band == Band::none) return;
  if (band == Band::stretched) return beside(board.stretched, "rubber band");
  if (band == Band::let_go) return beside(board.stretched, "let go");
  beside(board.hull, "convex hull");
  const auto inner = std::ranges::find_if(board.pins, [&](const Vec2& pin) { return !board.is_corner(pin); });
  panel.label(*inner, {0, 1}, "inside", style.small_label());
  panel.label(board.hull.front(), {-1, 0}, "corner", style.small_label());
}

int draw_board(const Pinboard& board, Band band, render::Canvas& canvas, const render::Box& box, const Style& style) {
  const auto [low, high] = render::Box::around(board.stretched);
  const render::Box room = draw_panel_title(canvas, box, "the plane, with a pin at each point", style);
  Panel panel(canvas, room, render::View::fit(low, high, room.grown(-margin), any_scale));
  draw_band(panel, board, band, style);
  draw_pins(panel, board, band, style);
  name_parts(panel, board, band, style);
  return panel.place_labels(style.smallest_label());
}

std::vector<Diagram> figure_2_diagrams() {
  const Pinboard board;
  const std::string count = std::to_string(board.pins.size()), corners = std::to_string(board.hull.size());
  const std::string inside = std::to_string(board.pins.size() - board.hull.size());
  return {Diagram{"Put a pin at each point of a finite set.",
                  {count + " points"},
                  count + " pins, scattered over the plane.",
                  std::bind_front(draw_board, board, Band::none)},
          Diagram{"Stretch a rubber band around all of them.",
                  {"no pin touches the band"},
                  "The same pins, and a rubber band around all of them that touches none.",
                  std::bind_front(draw_board, board, Band::stretched)},
          Diagram{"Let the band go: it collapses toward the pins.",
                  {"dotted: where the band was"},
                  "The band is smaller and rounder at its corners; dots show where it was, arrows point inward.",
                  std::bind_front(draw_board, board, Band::let_go)},
          Diagram{"The band snaps around the outermost pins: the convex hull of the points.",
                  {corners + " of the " + count + " pins are corners of the hull, " + inside +
                       " lie inside and hold nothing",
                   "the corners were computed by Andrew's monotone chain"},
                  "The band is a convex polygon. The " + corners + " pins at its corners are filled; the other " +
                      inside + ", all inside, are hollow.",
                  std::bind_front(draw_board, board, Band::snapped)}};
}

}  // namespace

std::vector<Walkthrough> figure_2() {
  return {diagrams_of("figure-2", "Figure 2: a rubber band finds the convex hull", "Section 2.2",
                      "pins in the plane, a band stretched around them, let go, snapped to the hull",
                      figure_2_diagrams)};
}

}  // namespace walkthroughs::catalogue
