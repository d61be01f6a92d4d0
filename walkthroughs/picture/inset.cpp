#include "walkthroughs/picture/inset.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace walkthroughs::picture {
namespace {

using render::Box;
using render::Vec2;
using render::View;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Page units.
constexpr double least_distance = 18, wanted_distance = 19;
constexpr double rounding = 1e-12;                            // of that: less is rounding of the picture
constexpr double least_apart = 14, wanted_apart = 30;         // of two vertices
constexpr double in_sight = 36, least_factor = 2;             // of the nearest line, where an inset is wanted
constexpr double gap = 8, circle_radius = 14, widest = 0.45;  // the last in parts of the room
const Vec2 size_of_frame(120, 92), size_of_label(44, 20), label_margin(5, 5);

double distance_to_line(const Vec2& p, const Segment& line) {
  return std::abs(render::turn((line.second - line.first).stableNormalized(), p - line.first));
}

/// Returns: a box in the corner of `room` where it is farthest from `at` and from `shape`.
Box best_corner(const Vec2& at, const std::vector<Segment>& shape, const Box& room, const Vec2& size,
                const View& view) {
  Box best;
  double most = -1;
  for (const bool right : {false, true})
    for (const bool low : {false, true}) {
      const Vec2 corner(right ? room.max.x() - size.x() : room.min.x(), low ? room.max.y() - size.y() : room.min.y());
      const Vec2 middle = view.scene(corner + size / 2);
      double clear = (middle - at).norm();
      for (const Segment& s : shape) clear = std::min(clear, render::distance_to_segment(middle, s.first, s.second));
      if (clear <= most) continue;
      most = clear;
      best = {corner, corner + size};
    }
  return best;
}

View magnified(const Vec2& at, const Box& frame, const View& view, double factor) {
  return View::fit(at, at, frame).with_scale(view.scale() * factor);
}

}  // namespace

double round_factor(double factor) {
  return factor <= 1024 ? std::exp2(std::ceil(std::log2(factor))) : std::pow(10, std::ceil(std::log10(factor)));
}

std::string words_of_factor(double factor) {
  char text[32];
  if (factor < 1e6)
    std::snprintf(text, sizeof text, "×%.0f", factor);
  else
    std::snprintf(text, sizeof text, "×1e%.0f", std::log10(factor));
  return text;
}

std::optional<Inset> inset_of(const Vec2& at, const std::vector<Segment>& lines, const std::vector<Segment>& shape,
                              const Box& room, const View& view, bool is_wanted) {
  const auto around = [&](const Vec2& middle, double factor) {
    const Vec2 size = size_of_frame.cwiseMin((room.max - room.min) * widest);
    const Box frame = best_corner(middle, shape, room.grown(-gap), size, view);
    const Box inside{frame.min + label_margin, frame.max - label_margin};
    return Inset{middle, frame, factor,
                 best_corner(middle, lines, inside, size_of_label, magnified(middle, frame, view, factor))};
  };
  double distance = infinity;
  for (const Segment& line : lines) distance = std::min(distance, distance_to_line(at, line) * view.scale());
  if (distance > rounding * least_distance && distance < least_distance)
    return around(at, round_factor(wanted_distance / distance));
  for (const Segment& line : lines) {
    const double apart = (line.second - line.first).norm() * view.scale();
    if (apart > rounding * least_apart && apart < least_apart)
      return around((line.first + line.second) / 2, round_factor(wanted_apart / apart));
  }
  if (!is_wanted || !(distance > rounding * least_distance) || distance == infinity) return std::nullopt;
  return around(at, std::max(least_factor, std::exp2(std::floor(std::log2(in_sight / distance)))));
}

void finish_with_inset(render::Canvas& canvas, render::Panel& panel, const std::optional<Inset>& inset,
                       const Style& style, const std::function<void(render::Panel&)>& draw) {
  if (inset) panel.keep_clear(inset->frame);
  canvas.add_crowded(panel.place_labels(style.smallest_label()));
  if (!inset) return;
  const auto& [at, frame, factor, label] = *inset;
  const render::Stroke line{style.theme.ink, 1.2};
  canvas.circle(panel.view().page(at), circle_radius, line);
  canvas.rectangle(frame, style.theme.paper);
  {
    render::Panel inside(canvas, frame, magnified(at, frame, panel.view(), factor));
    inside.keep_clear(label);
    draw(inside);
    inside.place_labels(style.smallest_label());
  }
  canvas.outline(frame.corners(), line);
  render::TextStyle text = style.small_label();
  text.align = render::Align::center;
  canvas.text(label.center() + Vec2(0, canvas.cap_height(text) / 2), words_of_factor(factor), text);
}

}  // namespace walkthroughs::picture
