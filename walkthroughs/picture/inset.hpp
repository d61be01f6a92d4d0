/// A small picture in a corner of a panel: what stands so near to the origin that their marks cover each other.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/panel.hpp"
#include "walkthroughs/picture/style.hpp"

namespace walkthroughs::picture {

using Segment = std::pair<render::Vec2, render::Vec2>;

/// Where something is nearest to the origin.
struct Nearest {
  render::Vec2 at;  ///< in the picture, from the origin
  double distance;  ///< in the scene: it may lie in front of the origin, or behind
};

/// What may have to be magnified.
struct Surroundings {
  render::Vec2 origin;                 ///< in the picture
  std::vector<Nearest> nearest;        ///< of all that must be told from the origin
  std::vector<render::Vec2> vertices;  ///< from the origin
  std::vector<render::Vec2> others;    ///< from the origin: what else an inset must not cover
  std::vector<Segment> shape;          ///< in the picture: what an inset should not cover
};

struct Inset {
  render::Vec2 at;    ///< its middle, from the origin
  render::Box frame;  ///< where it stands on the page, with a strip on top for words
  double factor;      ///< by which it is larger than the picture
};

/// Returns: 1, 2 or 5 times a power of ten, at most `factor` and at most 1e302, so that a page has coordinates; and in words, "×5", "×1e12".
double round_factor(double factor);
std::string words_of_factor(double factor);

/// Returns: what the inside is drawn with, where there is little room.
Style style_of_inset(const Style& style);

/// Returns: an inset that shows the origin and what its mark covers, however near, and vertices that are about as near; else
/// two vertices whose marks cover each other; else, where it `is_wanted`, what is around the origin. Nothing where all stand
/// plainly apart, or in one place. It stands in the corner of `room` that is farthest from what it shows and from the shape.
std::optional<Inset> inset_of(const Surroundings& what, const render::Box& room, const render::View& view,
                              bool is_wanted, const Style& style);

/// Returns: that, and another with vertices in the place of the origin's mark that are too far away to be seen in the first.
std::vector<Inset> insets_of(const Surroundings& what, const render::Box& room, const render::View& view,
                             bool is_wanted, const Style& style);

/// Places the labels of `panel`, and draws the insets over what is there, a thin circle around what each shows. `draw`: what
/// that is; its zero is the origin.
void finish_with_insets(render::Canvas& canvas, render::Panel& panel, const render::Vec2& origin,
                        const std::vector<Inset>& insets, const Style& style,
                        const std::function<void(render::Panel&)>& draw);

}  // namespace walkthroughs::picture
