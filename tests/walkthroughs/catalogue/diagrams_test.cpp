#include <algorithm>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/catalogue/figure_6_to_8_simplices.hpp"
#include "walkthroughs/picture/draw.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

namespace {

using gjk::Role;

/// Where the pictures of a page with text stand, and the widths that its text may have.
const render::Box panels{{40, 76}, {1240, 536}}, lower_panels{{40, 72}, {1240, 520}};
constexpr double caption_width = 990, fact_width = 956;

std::vector<const Walkthrough*> diagram_walkthroughs() {
  std::vector<const Walkthrough*> found;
  for (const Walkthrough& each : catalogue())
    if (each.layout == Layout::diagrams) found.push_back(&each);
  return found;
}

Point role(Role which) { return figure_8_simplex().point(which); }

render::Face face(Role p, Role q, Role r) { return {{role(p), role(q), role(r)}}; }

}  // namespace

TEST_CASE("Every diagram draws in every theme with all labels clear", "[unsanitized]") {
  render::Font font(render::Font::default_directory());
  for (const Walkthrough* each : diagram_walkthroughs())
    for (const Diagram& diagram : each->diagrams())
      for (const render::Theme& theme : {render::themes::report, render::themes::slides, render::themes::dark}) {
        render::Canvas canvas(frame_page, frame_page, theme.paper, font);
        INFO(each->name << ": " << diagram.caption);
        CHECK(diagram.draw(canvas, panels, Style(theme)) == 0);
        CHECK(diagram.draw(canvas, lower_panels, Style(theme)) == 0);
        CHECK(canvas.vertices().size() > 100);
      }
}

TEST_CASE("Every diagram has a caption of at most two lines, facts of one line, and a description", "[unsanitized]") {
  render::Font font(render::Font::default_directory());
  const Style style(render::themes::report);
  const render::Canvas canvas(frame_page, frame_page, style.theme.paper, font);
  for (const Walkthrough* each : diagram_walkthroughs()) {
    for (const Diagram& diagram : each->diagrams()) {
      INFO(each->name << ": " << diagram.caption);
      const std::size_t lines = render::wrap(canvas, diagram.caption, style.caption, caption_width).size();
      CHECK((lines == 1 || lines == 2));
      CHECK(lines + diagram.facts.size() <= 5);
      for (const std::string& fact : diagram.facts) {
        INFO(fact);
        CHECK(canvas.text_box({0, 0}, fact, style.fact).width() <= fact_width);
      }
      CHECK(diagram.description.size() > 20);
    }
  }
}

// -- Figure 8's claims ------------------------------------------------------------------------------------------------

TEST_CASE("Figure 8: A lies above the plane of BCD and in the direction of BC×BD") {
  const Point B = role(Role::B), BC = role(Role::C) - B, BD = role(Role::D) - B;
  for (const Role base : {Role::B, Role::C, Role::D}) CHECK(role(base).z() == 0);
  CHECK(role(Role::A).z() > 0);
  CHECK(BC.cross(BD).dot(role(Role::A) - B) > 0);
  CHECK(figure_8_slice().height == Approx(role(Role::A).z() / 3));  // parallel to BCD
  const render::Camera camera = figure_8_camera();
  for (const Role base : {Role::B, Role::C, Role::D}) CHECK(camera(role(Role::A)).y() > camera(role(base)).y() + 1);
}

TEST_CASE("Figure 8: the camera sees B through the face ACD, behind it") {
  const render::Camera camera = figure_8_camera();
  const Point A = role(Role::A), B = role(Role::B), C = role(Role::C), D = role(Role::D);
  const Vec2 b = camera(B);
  CHECK(triangle_contains(camera(A), camera(C), camera(D), b));
  // Where the line of sight through B meets the plane of ACD.
  const Point normal = (C - A).cross(D - A);
  const double toward_viewer = normal.dot(A - B) / normal.dot(camera.toward_viewer());
  CHECK(toward_viewer > 0.5);
  CHECK(camera.depth(B) - camera.depth(B + camera.toward_viewer() * toward_viewer) == Approx(toward_viewer));
}

TEST_CASE("Figure 8: only ACD shows its front, so exactly the edges of B are hidden") {
  const render::Camera camera = figure_8_camera();
  const std::vector<render::Face> faces = {face(Role::A, Role::B, Role::C), face(Role::A, Role::C, Role::D),
                                           face(Role::A, Role::D, Role::B), face(Role::B, Role::D, Role::C)};
  for (std::size_t i = 0; i < faces.size(); ++i) CHECK(camera.sees(faces[i].outward()) == (i == 1));
  const std::vector<render::Edge> edges = render::edges_of(faces, camera);
  CHECK(edges.size() == 6);
  for (const render::Edge& edge : edges) CHECK(edge.hidden == (edge.from == role(Role::B) || edge.to == role(Role::B)));
}

TEST_CASE("Figure 8: the normals that Algorithm 5 computes point away from the vertex off their face") {
  const Simplex simplex = figure_8_simplex();
  const Point middle = (role(Role::A) + role(Role::B) + role(Role::C) + role(Role::D)) / 4;
  int normals = 0;
  for (const auto& test : ask(simplex, middle).regions) {
    if (!test.normal) continue;
    ++normals;
    CHECK(test.formula.size() == std::string("AB×AC").size());
    for (const Role other : {Role::B, Role::C, Role::D}) {
      const double side = test.normal->dot(role(other) - role(Role::A));
      const bool on_face = test.feature.find(gjk::letter(other)) != std::string::npos;
      CHECK((on_face ? std::abs(side) < 1e-12 : side < -0.1));
    }
  }
  CHECK(normals == 3);
}

TEST_CASE("Figure 7: ABCn points to the reader, and the normals of the sides away from the triangle") {
  const Simplex simplex = figure_7_simplex();
  const Point A = simplex.point(Role::A), B = simplex.point(Role::B), C = simplex.point(Role::C);
  CHECK((B - A).cross(C - A).z() > 0);
  const Answer inside = ask(simplex, (A + B + C) / 3);
  for (const auto& test : inside.regions) {
    if (test.feature == "AB" && test.normal) CHECK(test.normal->dot(C - A) < 0);
    if (test.feature == "AC" && test.normal) CHECK(test.normal->dot(B - A) < 0);
  }
  CHECK(tested_half_spaces(inside, simplex).size() == 2);
}
