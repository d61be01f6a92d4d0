/// A small picture in a corner of a panel: the part around a point that stands very near to a line.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "render/panel.hpp"
#include "walkthroughs/picture/style.hpp"

namespace walkthroughs::picture {

using Segment = std::pair<render::Vec2, render::Vec2>;

struct Inset {
  render::Vec2 at;    ///< its middle, scene units
  render::Box frame;  ///< where it stands on the page
  double factor;      ///< by which it is larger than the picture
  render::Box label;  ///< where on the page that is written, away from the lines
};

/// Returns: a power of two, of ten where that would be long, at least `factor`; and in words, "×8", "×1e12".
double round_factor(double factor);
std::string words_of_factor(double factor);

/// Returns: an inset that shows `at` where its mark covers which side of one of `lines` (longer both ways) it is on; else
/// two ends of `lines` whose marks cover each other; else, where it `is_wanted`, `at` as large as the nearest line allows.
/// Nothing where all stand plainly apart, or in one place. It stands in the corner of `room` that is farthest from what it
/// shows and from `shape`.
std::optional<Inset> inset_of(const render::Vec2& at, const std::vector<Segment>& lines,
                              const std::vector<Segment>& shape, const render::Box& room, const render::View& view,
                              bool is_wanted);

/// Places the labels of `panel`, and draws the inset, where there is one, over what is there, a thin circle around what it shows.
/// `draw`: what that is.
void finish_with_inset(render::Canvas& canvas, render::Panel& panel, const std::optional<Inset>& inset,
                       const Style& style, const std::function<void(render::Panel&)>& draw);

}  // namespace walkthroughs::picture
