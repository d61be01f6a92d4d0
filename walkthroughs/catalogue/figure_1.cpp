#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "walkthroughs/catalogue/figure_objects.hpp"
#include "walkthroughs/picture/diagram_parts.hpp"

namespace walkthroughs::catalogue {
namespace {

using render::Panel;
using render::Vec2;

constexpr double margin = 6;  // page units around what a panel shows
constexpr double verdict_height = 56, verdict_baseline = 24;
constexpr double any_scale = 1e9;
constexpr int sides = 96;  // of a polygon that stands for a circle
const Vec2 reach(1.25, 1.35);

/// What is taken out of the disk to make the crescent. All three sets are made of the unit circle around the origin.
struct Bite {
  Vec2 center{0.65, 0};
  double radius = 0.55;
};

std::vector<Vec2> arc(const Vec2& center, double radius, double from, double to) {
  std::vector<Vec2> points;
  for (int i = 0; i < sides; ++i) {
    const double angle = from + (to - from) * i / sides;
    points.push_back(center + Vec2(std::cos(angle), std::sin(angle)) * radius);
  }
  return points;
}

std::vector<Vec2> full_circle() { return arc(Vec2::Zero(), 1, 0, 2 * std::numbers::pi); }

/// What is left of the disk, between two arcs from tip to tip.
std::vector<Vec2> crescent_outline() {
  const Bite bite;
  const double x = (1 + bite.center.squaredNorm() - bite.radius * bite.radius) / (2 * bite.center.x());
  const double y = std::sqrt(1 - x * x);  // the tips are (x, y) and (x, -y)
  const double at_disk = std::atan2(y, x), at_bite = std::atan2(y, x - bite.center.x());
  constexpr double turn = 2 * std::numbers::pi;
  std::vector<Vec2> outline = arc(Vec2::Zero(), 1, at_disk, turn - at_disk);
  const std::vector<Vec2> inner = arc(bite.center, bite.radius, turn - at_bite, at_bite);
  outline.insert(outline.end(), inner.begin(), inner.end());
  return outline;
}

void draw_disk(Panel& panel, const Style& style) {
  panel.polygon(full_circle(), style.object_a_fill);
  panel.outline(full_circle(), style.object_a);
}

void draw_circle(Panel& panel, const Style& style) { panel.outline(full_circle(), style.object_a); }

void draw_crescent(Panel& panel, const Style& style) {
  panel.polygon(full_circle(), style.object_a_fill);
  panel.polygon(arc(Bite{}.center, Bite{}.radius, 0, 2 * std::numbers::pi), style.theme.paper);
  panel.outline(crescent_outline(), style.object_a);
}

/// Solid where it is in the set, dashed where it is not.
void draw_chord(Panel& panel, const Chord& chord, const Style& style) {
  const render::Stroke inside{style.theme.ink, 4 * style.theme.line};
  const render::Stroke outside{style.theme.vermillion, 4 * style.theme.line, {12, 9}};
  double at = 0;
  for (const render::Interval& part : chord.outside) {
    if (part.from > at) panel.line(chord.at(at), chord.at(part.from), inside);
    panel.line(chord.at(part.from), chord.at(part.to), outside);
    at = part.to;
  }
  if (at < 1) panel.line(chord.at(at), chord.at(1), inside);
}

struct Part {
  PlanarSet set;
  void (*draw)(Panel&, const Style&);
  ChordSearch search = decide_convexity(set);
};

int draw_part(render::Canvas& canvas, const render::Box& frame, const Part& part, const Style& style) {
  const render::Box below_title = draw_panel_title(canvas, frame, part.set.name, style);
  render::TextStyle verdict = style.label(style.theme.ink, render::Weight::bold);
  verdict.align = render::Align::center;
  canvas.text({frame.center().x(), frame.max.y() - verdict_baseline},
              part.search.leaving == 0 ? "convex" : "not convex", verdict);
  const render::Box room{below_title.min, below_title.max - Vec2(0, verdict_height)};
  Panel panel(canvas, room, render::View::fit(-reach, reach, room.grown(-margin), any_scale));
  part.draw(panel, style);
  const Chord& chord = part.search.chord;
  draw_chord(panel, chord, style);
  for (const auto& [name, end] : {std::pair("P_1", chord.from), {"P_2", chord.to}}) {
    draw_point(panel, end, style.theme.ink, style);
    panel.label(end, end, name, style.label(style.theme.ink, render::Weight::bold));
  }
  if (part.search.witness) {
    draw_hollow_point(panel, *part.search.witness, style.theme.vermillion, style);
    render::TextStyle outside = style.small_label();
    outside.color = style.theme.vermillion;
    const Vec2 along = chord.to - chord.from;
    panel.label(*part.search.witness, {std::abs(along.y()), -along.x()}, "outside", outside, 12);
  }
  return panel.place_labels(style.smallest_label());
}

std::string tried(const Part& part) {
  const ChordSearch& search = part.search;
  const std::string count = with_commas(search.tried), name = part.set.name + ": ";
  if (search.leaving == 0) return name + "none of " + count + " chords leaves it; shown: a long one that comes closest";
  const std::string some = search.leaving == search.tried ? "all " : with_commas(search.leaving) + " of ";
  return name + some + count + " chords leave it; shown: the longest part outside";
}

std::vector<Diagram> figure_1_diagrams() {
  const std::array<Part, 3> parts{
      {{{"solid disk", [](const Vec2& p) { return p.norm() - 1; }}, draw_disk},
       {{"circle", [](const Vec2& p) { return std::abs(p.norm() - 1); }}, draw_circle},
       {{"solid crescent",
         [](const Vec2& p) { return std::max(p.norm() - 1, Bite{}.radius - (p - Bite{}.center).norm()); }},
        draw_crescent}}};
  Diagram diagram;
  diagram.caption = "A set is convex if the line between any two of its points stays inside.";
  for (const Part& part : parts) diagram.facts.push_back(tried(part));
  diagram.description =
      "Three sets side by side, each with a chord from P1 to P2. The chord of the solid disk is solid from end to "
      "end: it stays inside. The chord of the circle is dashed all along: it runs through the empty middle. The "
      "chord of the crescent is solid in both horns and dashed across the gap between them. A ring marks a point of "
      "each dashed part that is not in the set.";
  diagram.draw = [parts](render::Canvas& canvas, const render::Box& box, const Style& style) {
    const std::vector<render::Box> frames = side_by_side(box, static_cast<int>(parts.size()));
    int crowded = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) crowded += draw_part(canvas, frames[i], parts[i], style);
    return crowded;
  };
  return {diagram};
}

}  // namespace

std::vector<Walkthrough> figure_1() {
  return {diagrams_of("figure-1", "Figure 1: convex and not convex", "Section 2.2",
                      "a solid disk, a circle and a crescent, each with the chord that decides", figure_1_diagrams)};
}

}  // namespace walkthroughs::catalogue
