// Figures that show no search: their words fit, and what they are computed by holds beyond them.

#include <numbers>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/catalogue/figure_objects.hpp"
#include "walkthroughs/picture/diagram_parts.hpp"
#include "walkthroughs/picture/draw.hpp"

namespace diagrams_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;

TEST_CASE("Every diagram has a caption of at most two lines, facts of one line, and a description", "[unsanitized]") {
  constexpr double caption_width = 990, fact_width = 956;  // of a page with text
  render::Font font(render::Font::default_directory());
  const Style style(render::themes::report);
  const render::Canvas canvas(frame_page, frame_page, style.theme.paper, font);
  for (const Walkthrough& each : whole_catalogue()) {
    if (each.layout != Layout::diagrams) continue;
    for (const Diagram& diagram : each.diagrams()) {
      INFO(each.name << ": " << diagram.caption);
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

TEST_CASE("A chord with two parts outside has both") {
  const PlanarSet ring{"ring of two gaps", [](const Vec2& p) {
                         const double x = p.x();
                         return (x > 0.2 && x < 0.3) || (x > 0.5 && x < 0.9) ? 1.0 : -1.0;
                       }};
  const ChordSearch search = deciding_chord(ring, {{0, 0}, {1, 0}}, 0);
  REQUIRE(search.chord.outside.size() == 2);
  CHECK(search.chord.outside[0].from == Approx(0.2));
  CHECK(search.chord.outside[0].to == Approx(0.3));
  CHECK(search.chord.outside[1].from == Approx(0.5));
  CHECK(search.chord.outside[1].to == Approx(0.9));
  CHECK(search.witness->x() == Approx(0.7));
}

TEST_CASE("A band around a polygon turns left all the way around, once") {
  const std::vector<Vec2> band = offset_outward({{0, 0}, {4, 0}, {0, 3}}, 0.5);
  double turned = 0;
  for (std::size_t i = 0; i < band.size(); ++i) {
    const Vec2 u = band[(i + 1) % band.size()] - band[i], v = band[(i + 2) % band.size()] - band[(i + 1) % band.size()];
    CHECK(cross(u, v) >= -1e-12);
    turned += std::atan2(cross(u, v), u.dot(v));
  }
  CHECK(turned == Approx(2 * std::numbers::pi));
}

TEST_CASE("An outline is found whatever corner the first question finds") {
  for (int turn = 0; turn < 8; ++turn) {
    std::vector<Point> corners;
    for (int i = 0; i < 4; ++i) {
      const double angle = std::numbers::pi * (turn / 16.0 + i / 2.0) + 0.1;
      corners.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    CHECK(outline_by_support(gjk::PointSet<double>(corners), 360).size() == 4);
  }
}

}  // namespace diagrams_test
