#include <algorithm>
#include <array>
#include <functional>
#include <map>

#include "walkthroughs/catalogue/figure_objects.hpp"
#include "walkthroughs/picture/diagram_parts.hpp"
#include "walkthroughs/picture/lens.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs::catalogue {
namespace {

using gjk::Role;
using render::Panel;
using render::Vec2;

constexpr double cell = 0.02;           // of the grid of origins that are counted, in scene units
constexpr double normal_length = 1.05;  // scene units; one that points to the viewer looks shorter
constexpr double axis_length = 52;      // page units
constexpr double margin = 20;           // page units around the tetrahedron
constexpr double gap = 20;              // page units
constexpr double sheet_share = 0.42;    // of the window, shown of the plane of the slice
constexpr double space_share = 0.42;    // of the page, for the tetrahedron beside its slice
constexpr double any_scale = 1e9;

/// What the picture of the tetrahedron shows, in scene units.
const Vec2 picture_low(-2.15, -0.5), picture_high(2.15, 2.5);

enum class Show { tetrahedron, slice };

/// The features that Algorithm 5 does not test because of the history.
constexpr std::array ruled_out_features = {"A", "B", "C", "D", "BC", "CD", "BD"};

struct Sketch {
  Simplex simplex = figure_8_simplex();
  render::Camera camera{
      -77, 13};  // in front of the face ACD and a little to the right, so that normals at its sides are seen
  Window window = figure_8_slice();
  std::vector<render::Face> faces = {face({Role::A, Role::B, Role::C}), face({Role::A, Role::C, Role::D}),
                                     face({Role::A, Role::D, Role::B}), face({Role::B, Role::D, Role::C})};

  render::Face face(std::vector<Role> roles) const {
    render::Face made;
    for (const Role role : roles) made.corners.push_back(simplex.point(role));
    return made;
  }
  Point middle() const { return (simplex[0].w + simplex[1].w + simplex[2].w + simplex[3].w) / 4; }
  /// Returns: the tests of the first three faces, in their order, with the outward normals as Algorithm 5 has computed them
  /// (Eq. 14). From the middle no face sees the origin, so all have been tested.
  std::vector<gjk::RegionTested<double>> face_tests() const {
    std::vector<gjk::RegionTested<double>> tests = ask(simplex, middle()).regions;
    std::erase_if(tests, [](const auto& test) { return !test.normal; });
    return tests;
  }
  std::vector<Vec2> project(const std::vector<Point>& points) const { return Lens{camera}(points); }
  /// Returns: the regions beyond the features that are ruled out.
  std::vector<std::vector<HalfSpace>> ruled_out() const {
    std::vector<std::vector<HalfSpace>> regions;
    for (const char* feature : ruled_out_features) regions.push_back(region_beyond(simplex, feature));
    return regions;
  }
  /// Returns: what the plane of the slice cuts out of the tetrahedron, as seen from above.
  std::vector<Vec2> cut() const {
    return common_part(window.corners(), tested_half_spaces(ask(simplex, middle()), simplex), window.height);
  }
};

// -- The tetrahedron in space -----------------------------------------------------------------------------------------

/// Returns: the part of a face above (+1) or below (-1) the plane z = `height`. A side is always cut from its lower end, so
/// that neighbours share the point where it is cut.
render::Face part_of(const render::Face& face, double height, double side) {
  render::Face part;
  for (std::size_t i = 0; i < face.corners.size(); ++i) {
    const Point &from = face.corners[i], &to = face.corners[(i + 1) % face.corners.size()];
    if (side * (from.z() - height) > 0) part.corners.push_back(from);
    if ((from.z() > height) == (to.z() > height)) continue;
    const Point &low = from.z() < to.z() ? from : to, &high = from.z() < to.z() ? to : from;
    part.corners.push_back(low + (high - low) * ((height - low.z()) / (high.z() - low.z())));
  }
  return part;
}

std::vector<render::Face> parts_of(const std::vector<render::Face>& faces, double height, double side) {
  std::vector<render::Face> parts;
  for (const render::Face& face : faces)
    if (render::Face part = part_of(face, height, side); part.corners.size() > 2) parts.push_back(std::move(part));
  return parts;
}

/// Translucent faces, farthest first, then the hidden and the visible edges.
void draw_solid(Panel& panel, const std::vector<render::Face>& faces, const Sketch& sketch, const Style& style) {
  for (const std::size_t i : render::back_to_front(faces, sketch.camera))
    panel.polygon(sketch.project(faces[i].corners), style.simplex_fill);
  const std::vector<render::Edge> edges = render::edges_of(faces, sketch.camera);
  const render::Stroke visible{style.theme.ink, 3.5 * style.theme.line};
  for (const render::Edge& edge : edges)
    if (edge.hidden) panel.line(sketch.camera(edge.from), sketch.camera(edge.to), style.hidden_edge);
  for (const render::Edge& edge : edges)
    if (!edge.hidden) panel.line(sketch.camera(edge.from), sketch.camera(edge.to), visible);
}

enum class Side { back, front };
enum class Names { shown, left_out };

/// The normals of the faces that show their back or their front, as arrows from the middles of the faces.
void draw_normals(Panel& panel, Side side, Names names, const Sketch& sketch, const Style& style) {
  const std::vector<gjk::RegionTested<double>> tests = sketch.face_tests();
  for (std::size_t i = 0; i < tests.size(); ++i) {
    const Point direction = tests[i].normal->normalized();
    if (sketch.camera.sees(direction) != (side == Side::front)) continue;
    const Point middle = sketch.faces[i].middle();
    const Vec2 from = sketch.camera(middle), to = sketch.camera(middle + direction * normal_length);
    panel.disc(from, 4 * style.theme.line, style.theme.blue);
    panel.arrow(from, to, style.normal);
    if (names == Names::left_out) continue;
    panel.label(to, side == Side::back ? Vec2(to - from) : Vec2(1, 1), to_string(tests[i].feature) + "_n",
                style.label(style.theme.blue, render::Weight::bold), 8);
  }
}

void draw_vertices(Panel& panel, const Sketch& sketch, const Style& style) {
  for (int i = 0; i < 4; ++i) draw_point(panel, sketch.camera(sketch.simplex[i].w), style.theme.green, style);
}

void name_vertices(Panel& panel, const Sketch& sketch, const Style& style) {
  const Vec2 middle = sketch.camera(sketch.middle());
  for (int i = 0; i < 4; ++i) {
    const Role role = static_cast<Role>(i);
    const Vec2 at = sketch.camera(sketch.simplex.point(role));
    panel.label(at, at - middle, std::string(1, gjk::letter(role)), style.label(style.theme.ink, render::Weight::bold),
                12);
  }
}

void draw_axes(Panel& panel, const render::Box& frame, const Sketch& sketch, const Style& style) {
  const Vec2 corner = panel.view().scene({frame.min.x() + 40, frame.min.y() + 104});
  const double length = axis_length / panel.view().scale();
  for (int i = 0; i < 3; ++i) {
    const char* name = std::array{"x", "y", "z"}[static_cast<std::size_t>(i)];
    const Vec2 along = sketch.camera(Point::Unit(i)) * length;
    panel.arrow(corner, corner + along, {style.theme.grey, 2 * style.theme.line});
    panel.label(corner + along, along, name, style.small_label(), 5);
  }
}

/// The plane of the slice, as a translucent sheet.
void draw_sheet(Panel& panel, const Sketch& sketch, const Style& style) {
  std::vector<Point> sheet;
  for (const Vec2& corner : sketch.window.corners())
    sheet.emplace_back(corner.x() * sheet_share, corner.y() * sheet_share, sketch.window.height);
  panel.polygon(sketch.project(sheet), style.tested_fill);
  panel.outline(sketch.project(sheet), {style.theme.blue, 2 * style.theme.line});
}

/// Seen from above the plane of the slice: what lies below it is covered by it, what lies above it covers it.
void draw_cut_solid(Panel& panel, const Sketch& sketch, const Style& style) {
  draw_solid(panel, parts_of(sketch.faces, sketch.window.height, -1), sketch, style);
  draw_sheet(panel, sketch, style);
  draw_normals(panel, Side::back, Names::left_out, sketch, style);
  draw_solid(panel, parts_of(sketch.faces, sketch.window.height, 1), sketch, style);
}

int draw_space(render::Canvas& canvas, const render::Box& box, const Style& style, const Sketch& sketch, Show show) {
  const render::Box room = draw_panel_title(canvas, box, "the 3-simplex ABCD", style);
  Panel panel(canvas, room, render::View::fit(picture_low, picture_high, room.grown(-margin), any_scale));
  name_vertices(panel, sketch, style);  // these have the least choice
  if (show == Show::slice) {
    draw_cut_solid(panel, sketch, style);
  } else {
    draw_normals(panel, Side::back, Names::shown, sketch, style);
    draw_solid(panel, sketch.faces, sketch, style);
  }
  draw_normals(panel, Side::front, show == Show::slice ? Names::left_out : Names::shown, sketch, style);
  draw_vertices(panel, sketch, style);
  draw_axes(panel, room, sketch, style);
  return panel.place_labels(style.smallest_label());
}

// -- The slice --------------------------------------------------------------------------------------------------------

render::Color fill_of(const std::string& answer, const Style& style) {
  if (answer == "inside") return style.theme.green.with_alpha(90);
  const bool edge = answer.size() > 3;  // "AC of ABC"
  const std::string face = answer.substr(answer.size() - 3);
  const render::Color color = face == "ABC"   ? style.theme.sky
                              : face == "ACD" ? style.theme.orange
                                              : style.theme.vermillion;
  return color.with_alpha(edge ? 45 : 110);
}

/// Returns: "AC" for "AC of ABC", "face ABC" for "ABC".
std::string short_name(const std::string& answer) {
  return answer.size() == 3 ? "face " + answer : answer.substr(0, answer.find(' '));
}

/// Of a size that does not grow with the theme: the areas of edges are narrow.
render::TextStyle edge_label(const Style& style) {
  return {
      .size = style.small.size, .weight = render::Weight::bold, .color = style.theme.ink, .halo = style.theme.paper};
}

int draw_slice(render::Canvas& canvas, const render::Box& box, const Style& style, const Sketch& sketch) {
  const render::Box room = draw_panel_title(canvas, box, "the slice at a third of the height, seen from above", style);
  Panel panel(canvas, room, render::View::fit(sketch.window.low, sketch.window.high, room, any_scale));
  const RegionGrid grid = ask_all_over(panel, sketch.simplex, sketch.window.height);
  draw_blocks(
      panel, grid.blocks(), [&](const std::string& answer) { return fill_of(answer, style); }, style.theme.paper);
  for (const std::vector<HalfSpace>& region : sketch.ruled_out())
    draw_ruled_out(panel, common_part(panel.corners(), region, sketch.window.height), style);
  for (const AnsweredArea& area : answered_areas(sketch.simplex, grid)) {
    const std::vector<Vec2> corners = common_part(panel.corners(), area.spaces, sketch.window.height);
    panel.outline(corners, {style.theme.grey, 1.5 * style.theme.line});
    const std::string name = short_name(area.name);
    panel.name_area(corners, name, name.size() == 2 ? edge_label(style) : style.small_label());
  }
  panel.outline(sketch.cut(), {style.theme.ink, 3 * style.theme.line});
  return panel.place_labels(style.smallest_label());
}

int draw(Sketch sketch, Show show, render::Canvas& canvas, const render::Box& box, const Style& style) {
  sketch.camera = sketch.camera.turned(style.turn, style.rise);
  if (show == Show::tetrahedron) return draw_space(canvas, box, style, sketch, show);
  const double right = box.min.x() + box.width() * space_share;
  return draw_space(canvas, {box.min, {right, box.max.y()}}, style, sketch, show) +
         draw_slice(canvas, {{right + gap, box.min.y()}, box.max}, style, sketch);
}

/// Returns: for how many of the origins beyond no feature that is ruled out the answer is the nearest feature.
std::string share_of_nearest(const Sketch& sketch) {
  std::map<std::string, std::vector<HalfSpace>> regions;
  for (const char* feature : {"ABC", "ACD", "ADB", "AB", "AC", "AD"})
    regions[feature] = region_beyond(sketch.simplex, feature);
  const std::vector<std::vector<HalfSpace>> ruled = sketch.ruled_out();
  std::size_t all = 0, nearest = 0;
  const RegionGrid grid = ask_everywhere(sketch.simplex, sketch.window, cell);
  for (const auto& [origin, answer] : grid.cells()) {
    if (std::ranges::any_of(ruled, [&](const auto& region) { return lies_in(origin, region); })) continue;
    ++all;
    nearest += answer == "inside" || lies_in(origin, regions.at(answer.substr(0, answer.find(' '))));
  }
  return (nearest == all ? "all " : with_commas(nearest) + " of ") + with_commas(all);
}

std::string normals_in_words(const Sketch& sketch) {
  const auto say = [](const auto& test) { return to_string(test.feature) + "_n = " + to_string(test.formula); };
  return joined(sketch.face_tests(), ", ", say) + " point outward (Eq. 14)";
}

std::vector<Diagram> figure_8_diagrams() {
  const Sketch sketch;
  const std::string solid =
      "A tetrahedron seen from the side: A on top, C lower left and D lower right in front. B at the back is hidden by "
      "the face ACD, and its three edges are dashed. ";
  return {
      Diagram{"The 3-simplex ABCD: A lies above the plane of BCD, B behind the face ACD.",
              {normals_in_words(sketch), "A lies in the direction of BC×BD; A is the newest vertex"},
              solid + "Arrows from the middles of the faces ABC, ACD and ADB point outward.",
              std::bind_front(draw, sketch, Show::tetrahedron),
              true},
      Diagram{"Wherever the origin lies in this slice, Algorithm 5 takes the first face that sees it.",
              {"in the order ABC, ACD, ADB; an edge stands beside the face it was found from",
               "hatched: nearest to A, B, C, D, BC, CD or BD, which its history rules out",
               "elsewhere the answer is the nearest feature, for " + share_of_nearest(sketch) + " origins"},
              solid +
                  "A sheet parallel to BCD cuts it at a third of its height. Right, the sheet from above: a triangle "
                  "marked inside, and around it an area for each face and each edge that the algorithm can answer.",
              std::bind_front(draw, sketch, Show::slice),
              true}};
}

}  // namespace

std::vector<Walkthrough> figure_8() {
  return {diagrams_of("figure-8", "Figure 8: a 3-simplex", "Section 3.2.4",
                      "a tetrahedron with the normals of its faces, and what Algorithm 5 answers in a slice of it",
                      figure_8_diagrams)};
}

}  // namespace walkthroughs::catalogue
