// The regions around a segment and around a triangle, and what Algorithms 3 and 4 answer in them.

#include <functional>

#include "walkthroughs/catalogue/figure_objects.hpp"
#include "walkthroughs/picture/diagram_parts.hpp"
#include "walkthroughs/picture/region_picture.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs::catalogue {
namespace {

using gjk::Role;
using render::Panel;
using render::Vec2;

constexpr double beyond_the_page = 100;  // scene units
constexpr double any_scale = 1e9;

enum class Show { regions, answers };

using Areas = std::vector<std::vector<Vec2>>;

/// What both figures are made of.
struct Sketch {
  Simplex simplex;
  Window window;
  std::string_view ruled_out;  ///< of the report's regions, before any is asked: their numbers

  Vec2 at(Role role) const { return simplex.point(role).head<2>(); }
  /// Returns: of R1, R2, … what a panel shows.
  Areas areas(const Panel& panel) const {
    if (simplex.size() == 2) return regions_of_segment(at(Role::A), at(Role::B), at(Role::A), panel.corners());
    Areas all;
    for (const char* feature : {"ABC", "A", "AB", "B", "BC", "C", "AC"})
      all.push_back(common_part(panel.corners(), region_beyond(simplex, feature), window.height));
    return all;
  }
  bool is_ruled_out(std::size_t area) const {
    return ruled_out.find(static_cast<char>('1' + area)) != std::string_view::npos;
  }
  render::View view(const render::Box& room) const {
    return render::View::fit(window.low, window.high, room, any_scale);
  }
};

void draw_answers(Panel& panel, const Sketch& sketch, const Areas& areas, const Style& style) {
  const auto fill = [&](const std::string& answer) {
    return answer == "R1" ? style.chosen_fill : answer == "R3" ? style.object_a_fill : style.object_b_fill;
  };
  draw_blocks(panel, ask_all_over(panel, sketch.simplex, sketch.window.height).blocks(), fill, style.theme.paper);
  for (std::size_t i = 0; i < areas.size(); ++i)
    if (sketch.is_ruled_out(i)) draw_ruled_out(panel, areas[i], style);
}

void name_areas(Panel& panel, const Sketch& sketch, const Areas& areas, Show show, const Style& style) {
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const std::string skipped = show == Show::answers && sketch.is_ruled_out(i) ? ": skipped" : "";
    panel.name_area(areas[i], "R" + std::to_string(i + 1) + skipped, style.label(style.theme.ink));
  }
}

void draw_vertex(Panel& panel, const Sketch& sketch, Role role, const Vec2& toward, const Style& style) {
  draw_point(panel, sketch.at(role), style.theme.green, style);
  panel.label(sketch.at(role), toward, {gjk::letter(role)}, style.label(style.theme.ink, render::Weight::bold));
}

/// `any`: what is told of any origin.
std::vector<std::string> facts_of_answers(const Answer& any) {
  std::vector<std::string> facts;
  for (const auto& [reason, names] :
       reasons_for_skipping(any.regions, [](const gjk::Roles& each) { return to_string(each); }))
    facts.push_back(names + ": " + reason);
  facts.push_back("faint, under the hatching: what the algorithm would answer there");
  return facts;
}

// -- Figure 6 ---------------------------------------------------------------------------------------------------------

int draw_segment(const Sketch& sketch, Show show, render::Canvas& canvas, const render::Box& box, const Style& style) {
  const render::Box room = draw_panel_title(canvas, box, "the 1-simplex AB and the regions around it", style);
  Panel panel(canvas, room, sketch.view(room));
  const Areas areas = sketch.areas(panel);
  const Vec2 A = sketch.at(Role::A), B = sketch.at(Role::B), far = (A - B).normalized() * beyond_the_page;
  if (show == Show::answers) {
    draw_answers(panel, sketch, areas, style);
    panel.line(A - far, A + far, style.thin);
  }
  const render::Stroke border{style.theme.grey, 2 * style.theme.line};
  for (const std::vector<Vec2>& outlined : {panel.corners(), areas[0], areas[1]}) panel.outline(outlined, border);
  panel.line(B, A, {style.theme.ink, 4 * style.theme.line});
  draw_vertex(panel, sketch, Role::A, {1, 1}, style);
  draw_vertex(panel, sketch, Role::B, {-1, -1}, style);
  name_areas(panel, sketch, areas, show, style);
  return panel.place_labels(style.smallest_label());
}

std::vector<Diagram> figure_6_diagrams() {
  const Sketch sketch{figure_6_simplex(), figure_6_window(), "12"};
  const std::string where =
      "The segment from B, lower left, to A, upper right, and the lines at right angles to it through both ends. R1 "
      "lies beyond B, R2 beyond A, R3 above the segment and R4 below it. ";
  return {Diagram{"Around the segment AB the origin may lie in any of four regions.",
                  {"R1 beyond B, R2 beyond A, R3 and R4 on the two sides; A is the newest vertex"},
                  where,
                  std::bind_front(draw_segment, sketch, Show::regions)},
          Diagram{"Wherever the origin lies off the line AB, Algorithm 3 answers R3 or R4.",
                  facts_of_answers(ask(sketch.simplex, Point(0, 1, 0))),
                  where + "R3 is shaded in one colour, R4 in another. R1 and R2 are hatched: they are skipped.",
                  std::bind_front(draw_segment, sketch, Show::answers)}};
}

// -- Figure 7 ---------------------------------------------------------------------------------------------------------

struct TriangleSketch : Sketch {
  Answer inside = ask(simplex, (simplex[0].w + simplex[1].w + simplex[2].w) / 3);  // all of its tests are told

  Vec2 middle() const { return (at(Role::A) + at(Role::B) + at(Role::C)) / 3; }
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
};

/// The outward normals of AB and AC as Algorithm 4 has computed them.
void draw_normals(Panel& panel, const TriangleSketch& sketch, const Style& style) {
  for (const gjk::RegionTested<double>& test : sketch.inside.regions) {
    if (test.feature != "AB" && test.feature != "AC") continue;
    const Vec2 from = (sketch.at(Role::A) + sketch.at(test.feature[1])) / 2;
    const Vec2 direction = test.normal->head<2>().normalized();
    const Vec2 tip = from + direction * (style.arrow_length / panel.view().scale());
    panel.arrow(from, tip, style.normal);
    panel.label(tip, direction, to_string(test.feature) + "_n", style.label(style.theme.blue, render::Weight::bold), 8);
  }
}

int draw_triangle(const TriangleSketch& sketch, Show show, render::Canvas& canvas, const render::Box& box,
                  const Style& style) {
  const render::Box room = draw_panel_title(canvas, box, "the 2-simplex ABC and the regions around it", style);
  Panel panel(canvas, room, sketch.view(room));
  const Areas areas = sketch.areas(panel);
  if (show == Show::answers) {
    draw_answers(panel, sketch, areas, style);
    for (const auto& [from, to] : sketch.dividing_lines()) panel.line(from, to, style.thin);
  }
  for (std::size_t i = 1; i < areas.size(); ++i) panel.outline(areas[i], {style.theme.grey, 1.5 * style.theme.line});
  name_areas(panel, sketch, areas, show, style);
  const Vec2 corners[] = {sketch.at(Role::A), sketch.at(Role::B), sketch.at(Role::C)};
  panel.outline(corners, {style.theme.ink, 4 * style.theme.line});
  for (const Role role : {Role::A, Role::B, Role::C})
    draw_vertex(panel, sketch, role, sketch.at(role) - sketch.middle(), style);
  draw_normals(panel, sketch, style);
  return panel.place_labels(style.smallest_label());
}

std::vector<Diagram> figure_7_diagrams() {
  const TriangleSketch sketch{{figure_7_simplex(), figure_7_window(), "2456"}};
  const std::string where =
      "A triangle, A on top, B lower left, C lower right, and the lines at right angles to its sides through their "
      "ends. R1 is the inside, R2 lies beyond A, R3 beyond AB, R4 beyond B, R5 beyond BC, R6 beyond C and R7 beyond "
      "AC. Arrows from the middles of AB and AC, named ABn and ACn, point outward. ";
  return {Diagram{"Around the triangle ABC the origin may lie in any of seven regions.",
                  {"R1 inside; R2, R4, R6 beyond A, B, C; R3, R5, R7 beyond AB, BC, AC",
                   "all seven reach above and below the paper, too; A is the newest vertex",
                   "AB_n = AB×ABC_n and AC_n = ABC_n×AC point away from the triangle (Eq. 11)"},
                  where,
                  std::bind_front(draw_triangle, sketch, Show::regions)},
          Diagram{"Wherever the origin lies, Algorithm 4 answers R3, R7, else R1.", facts_of_answers(sketch.inside),
                  where + "R1, R3 and R7 are shaded in three colours; R2, R4, R5 and R6 are hatched: they are skipped.",
                  std::bind_front(draw_triangle, sketch, Show::answers)}};
}

}  // namespace

std::vector<Walkthrough> figures_6_and_7() {
  return {diagrams_of("figure-6", "Figure 6: the regions around a 1-simplex", "Section 3.2.2",
                      "the four regions around a segment, and what Algorithm 3 answers in them", figure_6_diagrams),
          diagrams_of("figure-7", "Figure 7: the regions around a 2-simplex", "Section 3.2.3",
                      "the seven regions around a triangle, and what Algorithm 4 answers in them", figure_7_diagrams)};
}

}  // namespace walkthroughs::catalogue
