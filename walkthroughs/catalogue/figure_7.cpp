#include <array>
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

/// The report's regions; those that it rules out beforehand are marked.
struct Region {
  const char *label, *feature;
  bool ruled_out;
};
constexpr std::array regions = {Region{"R1", "ABC", false}, Region{"R2", "A", true},  Region{"R3", "AB", false},
                                Region{"R4", "B", true},    Region{"R5", "BC", true}, Region{"R6", "C", true},
                                Region{"R7", "AC", false}};

/// An outward normal as Algorithm 4 has computed it.
struct Normal {
  std::string name;
  Vec2 from, direction;
};

struct Sketch {
  Simplex simplex = figure_7_simplex();
  Window window = figure_7_window();
  std::vector<RegionGrid::Block> blocks = ask_everywhere(simplex, window.with_margin(), cell).blocks();
  Answer inside = ask(simplex, (simplex[0].w + simplex[1].w + simplex[2].w) / 3);  // all of its tests are told

  Vec2 at(Role role) const { return simplex.point(role).head<2>(); }
  Vec2 middle() const { return (at(Role::A) + at(Role::B) + at(Role::C)) / 3; }
  std::vector<Vec2> beyond(const Panel& panel, const Region& region) const {
    return common_part(panel.corners(), region_beyond(simplex, region.feature), window.height);
  }
  /// Returns: for each test of Algorithm 4 the line through A where its answer changes, as far as the tests before fail.
  std::vector<std::pair<Vec2, Vec2>> dividing_lines() const {
    const std::vector<HalfSpace> failed = tested_half_spaces(inside, simplex);
    std::vector<std::pair<Vec2, Vec2>> lines;
    for (std::size_t i = 0; i < failed.size(); ++i) {
      const Vec2 along = Vec2(-failed[i].normal.y(), failed[i].normal.x()).normalized() * beyond_the_page;
      const std::vector<HalfSpace> before(failed.begin(), failed.begin() + static_cast<std::ptrdiff_t>(i));
      const std::vector<Vec2> line = common_part({at(Role::A) - along, at(Role::A) + along}, before, window.height);
      lines.emplace_back(line[0], line[1]);
    }
    return lines;
  }
  std::vector<Normal> normals() const {
    std::vector<Normal> found;
    for (const gjk::RegionTested<double>& test : inside.regions) {
      if (test.feature != "AB" && test.feature != "AC") continue;
      const Role other = test.feature == "AB" ? Role::B : Role::C;
      found.push_back({to_string(test.feature) + "_n", (at(Role::A) + at(other)) / 2, test.normal->head<2>().normalized()});
    }
    return found;
  }
};

void draw_answers(Panel& panel, const Sketch& sketch, const Style& style) {
  draw_blocks(
      panel, sketch.blocks,
      [&](const std::string& answer) {
        return answer == "R1" ? style.chosen_fill : answer == "R3" ? style.object_a_fill : style.object_b_fill;
      },
      style.theme.paper);
  for (const Region& region : regions)
    if (region.ruled_out) draw_ruled_out(panel, sketch.beyond(panel, region), style);
  for (const auto& [from, to] : sketch.dividing_lines()) panel.line(from, to, style.thin);
}

void draw_triangle(Panel& panel, const Sketch& sketch, const Style& style) {
  const Vec2 corners[] = {sketch.at(Role::A), sketch.at(Role::B), sketch.at(Role::C)};
  panel.outline(corners, {style.theme.ink, 4 * style.theme.line});
  for (int i = 0; i < 3; ++i) {
    draw_point(panel, corners[i], style.theme.green, style);
    panel.label(corners[i], corners[i] - sketch.middle(), std::string(1, gjk::letter(static_cast<Role>(i))),
                style.label(style.theme.ink, render::Weight::bold));
  }
}

int draw(const Sketch& sketch, Show show, render::Canvas& canvas, const render::Box& box, const Style& style) {
  const render::Box room = draw_panel_title(canvas, box, "the 2-simplex ABC and the regions around it", style);
  Panel panel(canvas, room, render::View::fit(sketch.window.low, sketch.window.high, room, any_scale));
  if (show == Show::answers) draw_answers(panel, sketch, style);
  for (const Region& region : regions) {
    if (region.feature != std::string("ABC"))
      panel.outline(sketch.beyond(panel, region), {style.theme.grey, 1.5 * style.theme.line});
    const std::string skipped = show == Show::answers && region.ruled_out ? ": skipped" : "";
    panel.name_area(sketch.beyond(panel, region), region.label + skipped, style.label(style.theme.ink));
  }
  draw_triangle(panel, sketch, style);
  for (const Normal& normal : sketch.normals()) {
    const Vec2 tip = normal.from + normal.direction * (style.arrow_length / panel.view().scale());
    panel.arrow(normal.from, tip, style.normal);
    panel.label(tip, normal.direction, normal.name, style.label(style.theme.blue, render::Weight::bold), 8);
  }
  return panel.place_labels(style.smallest_label());
}

std::vector<Diagram> figure_7_diagrams() {
  const Sketch sketch;
  std::vector<std::string> facts = reasons_for_skipping(sketch.inside.regions, [](const gjk::Roles& each) { return to_string(each); });
  facts.push_back("faint, below the hatching: what it would answer there; it relies on its history");
  const std::string where =
      "A triangle, A on top, B lower left, C lower right, and the lines at right angles to its sides through their "
      "ends. "
      "R1 is the inside, R2 lies beyond A, R3 beyond AB, R4 beyond B, R5 beyond BC, R6 beyond C and R7 beyond AC. "
      "Arrows "
      "from the middles of AB and AC, named ABn and ACn, point outward. ";
  return {Diagram{"Around the triangle ABC the origin may lie in any of seven regions.",
                  {"R1 inside, above and below the paper too; R2, R4, R6 beyond A, B, C;",
                   "R3, R5, R7 beyond the sides AB, BC, AC; A is the newest vertex",
                   "AB_n = AB×ABC_n and AC_n = ABC_n×AC point away from the triangle (Eq. 11)"},
                  where,
                  std::bind_front(draw, sketch, Show::regions)},
          Diagram{"Algorithm 4, asked of every origin shown, answers R3, R7, else R1.", facts,
                  where + "R1, R3 and R7 are shaded in three colours; R2, R4, R5 and R6 are hatched: they are skipped.",
                  std::bind_front(draw, sketch, Show::answers)}};
}

}  // namespace

Walkthrough figure_7() {
  return {.name = "figure-7",
          .title = "Figure 7: the regions around a 2-simplex",
          .source = "ARL-TR-7474, Section 3.2.3",
          .summary = "the seven regions around a triangle, and what Algorithm 4 answers in them",
          .layout = Layout::diagrams,
          .diagrams = figure_7_diagrams};
}

}  // namespace walkthroughs
