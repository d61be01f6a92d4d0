#include <functional>

#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/catalogue/figure_6_to_8_simplices.hpp"
#include "walkthroughs/picture/diagram_parts.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs {
namespace {

using gjk::Role;
using render::Panel;
using render::Vec2;

constexpr double cell = 0.022;           // of the grid of origins, in scene units
constexpr double beyond_the_page = 100;  // scene units
constexpr double any_scale = 1e9;

enum class Show { regions, answers };

struct Sketch {
  Simplex simplex = figure_6_simplex();
  Window window = figure_6_window();
  std::vector<RegionGrid::Block> blocks = ask_everywhere(simplex, window.with_margin(), cell).blocks();

  Vec2 A() const { return simplex.point(Role::A).head<2>(); }
  Vec2 B() const { return simplex.point(Role::B).head<2>(); }
  /// Returns: the part of the panel beyond a feature; of AB's the part at the left (+1) or right (-1) of the way from B to A.
  std::vector<Vec2> beyond(const Panel& panel, const char* feature, double side = 0) const {
    std::vector<HalfSpace> spaces = region_beyond(simplex, feature);
    const Point BA = simplex.point(Role::A) - simplex.point(Role::B);
    if (side != 0) spaces.push_back({simplex.point(Role::A), side * Point(-BA.y(), BA.x(), 0)});
    return common_part(panel.corners(), spaces, window.height);
  }
};

void draw_answers(Panel& panel, const Sketch& sketch, const Style& style) {
  draw_blocks(
      panel, sketch.blocks,
      [&](const std::string& answer) { return answer == "R3" ? style.object_a_fill : style.object_b_fill; },
      style.theme.paper);
  for (const char* end : {"B", "A"}) draw_ruled_out(panel, sketch.beyond(panel, end), style);
  const Vec2 far = (sketch.A() - sketch.B()).normalized() * beyond_the_page;
  panel.line(sketch.A() - far, sketch.A() + far, style.thin);
}

int draw(const Sketch& sketch, Show show, render::Canvas& canvas, const render::Box& box, const Style& style) {
  const render::Box room = draw_panel_title(canvas, box, "the 1-simplex AB and the regions around it", style);
  Panel panel(canvas, room, render::View::fit(sketch.window.low, sketch.window.high, room, any_scale));
  if (show == Show::answers) draw_answers(panel, sketch, style);
  const render::Stroke border{style.theme.grey, 2 * style.theme.line};
  panel.outline(panel.corners(), border);
  for (const char* end : {"B", "A"}) panel.outline(sketch.beyond(panel, end), border);
  panel.line(sketch.B(), sketch.A(), {style.theme.ink, 4 * style.theme.line});
  const render::TextStyle bold = style.label(style.theme.ink, render::Weight::bold);
  for (const auto& [name, at, toward] : {std::tuple("A", sketch.A(), Vec2(1, 1)), {"B", sketch.B(), Vec2(-1, -1)}}) {
    draw_point(panel, at, style.theme.green, style);
    panel.label(at, toward, name, bold);
  }
  const std::string skipped = show == Show::answers ? ": skipped" : "";
  panel.name_area(sketch.beyond(panel, "B"), "R1" + skipped, style.label(style.theme.ink));
  panel.name_area(sketch.beyond(panel, "A"), "R2" + skipped, style.label(style.theme.ink));
  panel.name_area(sketch.beyond(panel, "AB", 1), "R3", style.label(style.theme.ink));
  panel.name_area(sketch.beyond(panel, "AB", -1), "R4", style.label(style.theme.ink));
  return panel.place_labels(style.smallest_label());
}

std::vector<Diagram> figure_6_diagrams() {
  const Sketch sketch;
  std::vector<std::string> facts = reasons_for_skipping(ask(sketch.simplex, Point(0, 1, 0)).regions, [](const gjk::Roles& each) { return to_string(each); });
  facts.push_back("faint, below the hatching: what it would answer there; it relies on its history");
  const std::string where =
      "The segment from B, lower left, to A, upper right, and the lines at right angles to it through both ends. R1 "
      "lies "
      "beyond B, R2 beyond A, R3 above the segment and R4 below it. ";
  return {Diagram{"Around the segment AB the origin may lie in any of four regions.",
                  {"R1 beyond B, R2 beyond A, R3 and R4 on the two sides; A is the newest vertex"},
                  where,
                  std::bind_front(draw, sketch, Show::regions)},
          Diagram{"Algorithm 3, asked of every origin shown, answers R3 or R4.", facts,
                  where + "R3 is shaded in one colour, R4 in another. R1 and R2 are hatched: they are skipped.",
                  std::bind_front(draw, sketch, Show::answers)}};
}

}  // namespace

Walkthrough figure_6() {
  return {.name = "figure-6",
          .title = "Figure 6: the regions around a 1-simplex",
          .source = "ARL-TR-7474, Section 3.2.2",
          .summary = "the four regions around a segment, and what Algorithm 3 answers in them",
          .layout = Layout::diagrams,
          .diagrams = figure_6_diagrams};
}

}  // namespace walkthroughs
