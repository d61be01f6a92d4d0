#include "walkthroughs/catalogue/region_grid.hpp"

#include <set>

#include "tests/kit/catch.hpp"
#include "tests/kit/pictures.hpp"
#include "tests/walkthroughs/catalogue/nearest_feature.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/catalogue/figure_objects.hpp"
#include "walkthroughs/picture/draw.hpp"

namespace region_grid_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;
using render::Vec2;

namespace {

std::set<std::string> features_of(int size) {
  if (size == 2) return {"A", "B", "AB"};
  if (size == 3) return {"A", "B", "C", "AB", "AC", "BC", "ABC"};
  return {"A", "B", "C", "D", "AB", "AC", "AD", "BC", "BD", "CD", "ABC", "ABD", "ACD", "BCD", "ABCD"};
}

}  // namespace

TEST_CASE("A point lies in the region beyond a feature exactly when that feature is the nearest") {
  for (const auto& [simplex, window] : {std::pair(figure_6_simplex(), figure_6_window()),
                                        {figure_7_simplex(), figure_7_window()},
                                        {figure_8_simplex(), figure_8_slice()}}) {
    const RegionGrid grid = ask_everywhere(simplex, window, 0.1);
    for (const RegionGrid::Cell& cell : grid.cells()) {
      const Point& p = cell.middle;
      const std::string nearest = nearest_feature(simplex, p);
      if (nearest.empty()) continue;
      for (const std::string& feature : features_of(simplex.size())) {
        INFO(feature << " at " << p.transpose());
        REQUIRE(lies_in(p, region_beyond(simplex, feature)) == (feature == nearest));
      }
    }
  }
}

TEST_CASE("Blocks cover each cell once, with its text") {
  const Window window{.low = {-1, 2}, .high = {3, 4}};
  const RegionGrid grid(window, 8, 5, [](const Point& p) { return p.x() + p.y() > 4 ? "far" : "near"; });
  const std::vector<RegionGrid::Block> blocks = grid.blocks();
  CHECK(blocks.size() < 8 * 5);
  CHECK(grid.cells().size() == 8 * 5);
  for (const RegionGrid::Cell& cell : grid.cells()) {
    const Vec2 p = cell.middle.head<2>();
    std::vector<std::string> found;
    for (const RegionGrid::Block& block : blocks)
      if ((p.array() > block.low.array()).all() && (p.array() < block.high.array()).all()) found.push_back(block.text);
    REQUIRE(found == std::vector<std::string>{p.x() + p.y() > 4 ? "far" : "near"});
  }
}

TEST_CASE("The answers are painted from border to border, also where larger text makes a panel wider than it was") {
  render::Font font(render::Font::default_directory());
  for (const std::string name : {"figure-6", "figure-7", "figure-8"})
    for (const double text : {0.75, 1.0, 1.5}) {
      INFO(name << ", text " << text);
      render::Theme theme = render::themes::report;
      theme.text = text;
      render::Canvas page(frame_page, frame_page, theme.paper, font);
      draw_frame(page, StagedStory(tell(walkthrough(name))), 1, {.style = Style(theme)});
      std::vector<render::CanvasVertex> painted = kit::vertices_of(page);
      std::erase_if(painted, [](const auto& v) {
        return v.kind != render::CanvasVertex::Kind::fill || v.color.a != 255 || v.color.r == v.color.b;
      });
      const render::Box box = kit::box_around(painted);
      CHECK(box.max.x() >= 1240);  // of the page's panels
      if (name != "figure-8") CHECK(box.min.x() <= 40);
    }
}

}  // namespace region_grid_test
