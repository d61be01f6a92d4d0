// The graph of a search: what is known is drawn where it belongs, what is not yet known is not, and no letter is cut.

#include "walkthroughs/picture/progress_graph.hpp"

#include <algorithm>

#include "render/svg_text.hpp"
#include "tests/kit/catch.hpp"

namespace progress_graph_test {

using namespace walkthroughs::program;
using render::Vec2;

namespace {

std::vector<Progress> falling(const std::vector<double>& distances) {
  std::vector<Progress> all;
  for (const double distance : distances) {
    const int iteration = static_cast<int>(all.size()) + 1;
    all.push_back({.iteration = iteration, .distance = distance, .nearest = {gjk::Fraction(distance), 0, 0}});
  }
  return all;
}

struct Drawn {
  render::Font font{render::Font::default_directory()};
  render::Canvas canvas;

  explicit Drawn(const std::vector<ProgressLine>& lines, const render::Theme& theme = render::themes::report)
      : canvas(progress_page, progress_page, theme.paper, font) {
    draw_progress(canvas, lines, Style(theme));
  }

  template <class Shape>
  std::vector<Shape> all() const {
    std::vector<Shape> found;
    for (const render::Shape& shape : canvas.shapes())
      if (const auto* one = std::get_if<Shape>(&shape)) found.push_back(*one);
    return found;
  }
  /// Of the present iteration of a search.
  std::vector<Vec2> marks() const {
    std::vector<Vec2> places;
    for (const auto& disc : all<render::shape::Disc>())
      if (disc.radius == 5) places.push_back(disc.center);
    return places;
  }
  std::vector<Vec2> dots() const {
    std::vector<Vec2> places;
    for (const auto& line : all<render::shape::Polyline>())
      if (line.corners.size() == 1 && line.stroke.width == 7) places.push_back(line.corners[0]);
    return places;
  }
  std::optional<Vec2> place_of(const std::string& text) const {
    for (const auto& each : all<render::shape::Text>())
      if (each.text == text) return each.position;
    return std::nullopt;
  }
  bool has_all_letters_inside() const {
    return std::ranges::all_of(all<render::shape::Text>(), [this](const render::shape::Text& text) {
      const render::Box box = canvas.ink_box(text.position, text.text, text.style);
      return box.min.x() >= 0 && box.min.y() >= 0 && box.max.x() <= progress_page.width &&
             box.max.y() <= progress_page.height;
    });
  }
};

}  // namespace

TEST_CASE("Only what is known is drawn, on axes that stay where they are") {
  const std::vector<Progress> all = falling({4, 3, 1, 0});
  const Drawn none({{"search", all, 0}}), two({{"search", all, 2}}), whole({{"search", all, 4}});
  CHECK(none.marks().empty());
  CHECK(two.marks().size() == 1);
  CHECK(two.dots().size() == 1);
  CHECK(whole.dots().size() == 3);
  CHECK(whole.dots()[1] == two.marks()[0]);
  CHECK(none.place_of("0") == whole.place_of("0"));
  CHECK(two.place_of("3"));
  CHECK(two.place_of("2"));
  CHECK(whole.marks()[0].y() - whole.dots()[0].y() == Approx(4 * (whole.marks()[0].y() - whole.dots()[2].y())));
}

TEST_CASE("Over more than three powers of ten heights are powers, with 0 below them all") {
  const std::vector<Progress> all = falling({100, 1, 1e-4, 0}), near = falling({100, 1, 0.1});
  const Drawn drawn({{"search", all, 4}});
  const std::vector<Vec2> dots = drawn.dots();
  CHECK(dots[2].y() - dots[1].y() == Approx(2 * (dots[1].y() - dots[0].y())));
  CHECK(drawn.marks()[0].y() > dots[2].y() + 10);
  CHECK(drawn.place_of("0"));
  CHECK(drawn.place_of("kept simplex: distance from O, powers of ten"));
  CHECK(Drawn({{"search", near, 3}}).place_of("kept simplex: distance from O"));
}

TEST_CASE("A distance that comes again is led back to where it was") {
  const std::vector<Progress> all = falling({2, 1, 2});
  const auto leads_back = [](const Drawn& drawn) {
    return std::ranges::any_of(drawn.all<render::shape::Polyline>(), [](const render::shape::Polyline& line) {
      return line.stroke.dash.gap == 5 && line.corners.front().y() == line.corners.back().y();
    });
  };
  CHECK(leads_back(Drawn({{"search", all, 3}})));
  CHECK_FALSE(leads_back(Drawn({{"search", all, 2}})));
}

TEST_CASE("No line leads from the first search to the exact fallback, which begins anew") {
  std::vector<Progress> all = falling({4, 2, 3, 1});
  all[2].is_fallback = all[3].is_fallback = true;
  std::size_t lines = 0;
  const Drawn drawn({{"search", all, 4}});
  for (const auto& line : drawn.all<render::shape::Polyline>()) lines += line.stroke.width == 2.5;
  CHECK(lines == 2);
}

TEST_CASE("Two searches differ by dashes and the form of their marks, and are named") {
  const std::vector<Progress> one = falling({4, 3, 3.5}), other = falling({4, 3, 0});
  const Drawn drawn({{"a mistake", one, 3}, {"right", other, 3}});
  const auto lines = drawn.all<render::shape::Polyline>();
  CHECK(std::ranges::count_if(lines, [](const auto& line) { return line.stroke.dash.length == 7; }) == 1);
  CHECK(drawn.place_of("a mistake"));
  CHECK(drawn.place_of("right"));
  CHECK(drawn.place_of("3.5"));
}

TEST_CASE("No letter is cut, however large the text, long the names and far apart the numbers") {
  const std::vector<std::vector<double>> searches{
      {5},          {0},     {0, 0}, {1.234e150, 5.678e-150, 0}, {123456, 99}, std::vector<double>(1000, 0.3333),
      {1, 1e-9, 1}, {3e-320}};
  render::Theme large = render::themes::dark;
  large.text = render::most_text_scale;
  for (const std::vector<double>& distances : searches)
    for (const render::Theme& theme : {render::themes::report, render::themes::slides, render::themes::dark, large}) {
      const std::vector<Progress> all = falling(distances);
      const std::string name(38, 'M');
      for (std::size_t known = 0; known <= all.size(); known += 1 + all.size() / 7) {
        CHECK(Drawn({{"search", all, known}}, theme).has_all_letters_inside());
        CHECK(Drawn({{name, all, known}, {name, all, all.size()}}, theme).has_all_letters_inside());
      }
    }
}

TEST_CASE("As text a graph is small, also of as many iterations as a scene may ask for") {
  std::vector<double> distances(1000);
  for (std::size_t i = 0; i < distances.size(); ++i) distances[i] = 100 / (1.0 + static_cast<double>(i));
  for (const std::size_t size : {24, 80, 1000}) {
    const std::vector<Progress> all =
        falling({distances.begin(), distances.begin() + static_cast<std::ptrdiff_t>(size)});
    const Drawn drawn({{"search", all, size}});
    CHECK(svg_text(drawn.canvas, {{0, 0}, {progress_page.width, progress_page.height}}).size() < 6000);
  }
}

}  // namespace progress_graph_test
