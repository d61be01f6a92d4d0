#include "walkthroughs/catalogue/region_grid.hpp"

#include <map>
#include <set>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/catalogue/nearest_feature.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/catalogue/figure_6_to_8_simplices.hpp"
#include "walkthroughs/story/words.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

namespace {

constexpr double cell = 0.1;  // coarser than the pictures

/// Calls `check` with the middle, the answer and the nearest feature of each cell that lies on no border.
template <class Check>
void for_each_cell(const Simplex& simplex, const Window& window, Check&& check) {
  const RegionGrid grid = ask_everywhere(simplex, window, cell);
  for (int row = 0; row < grid.rows(); ++row) {
    for (int column = 0; column < grid.columns(); ++column) {
      const Point p = grid.middle(column, row);
      const std::string nearest = nearest_feature(simplex, p);
      if (!nearest.empty()) check(p, grid.at(column, row), nearest);
    }
  }
}

std::set<std::string> features_of(int size) {
  if (size == 2) return {"A", "B", "AB"};
  if (size == 3) return {"A", "B", "C", "AB", "AC", "BC", "ABC"};
  return {"A", "B", "C", "D", "AB", "AC", "AD", "BC", "BD", "CD", "ABC", "ABD", "ACD", "BCD", "ABCD"};
}

/// The simplices of the figures, each with the window in which it is drawn.
struct Drawn {
  Simplex simplex;
  Window window;
};
std::vector<Drawn> drawn() {
  return {{figure_6_simplex(), figure_6_window()},
          {figure_7_simplex(), figure_7_window()},
          {figure_8_simplex(), figure_8_slice()}};
}

}  // namespace

TEST_CASE("A point lies in the region beyond a feature exactly when that feature is the nearest") {
  for (const auto& [simplex, window] : drawn()) {
    for_each_cell(simplex, window,
                  [&, &simplex = simplex](const Point& p, const std::string&, const std::string& nearest) {
                    for (const std::string& feature : features_of(simplex.size())) {
                      INFO(feature << " at " << p.transpose());
                      REQUIRE(lies_in(p, region_beyond(simplex, feature)) == (feature == nearest));
                    }
                  });
  }
}

TEST_CASE("The drawn regions are those of the half-spaces and fill the window", "[unsanitized]") {
  for (const auto& [simplex, window] : drawn()) {
    double sum = 0;
    for (const std::string& feature : features_of(simplex.size())) {
      const std::vector<Vec2> part = common_part(window.corners(), region_beyond(simplex, feature), window.height);
      sum += area(part);
      for_each_cell(simplex, window,
                    [&, &window = window](const Point& p, const std::string&, const std::string& nearest) {
                      if (nearest == feature) REQUIRE(holds(part, p.head<2>(), 1e-9));
                    });
      CHECK(
          std::ranges::all_of(part, [&, &window = window](const Vec2& p) { return holds(window.corners(), p, 1e-9); }));
    }
    CHECK(sum == Approx(area(window.corners())));
  }
}

TEST_CASE("Figure 6: Algorithm 3 answers R3 above the line AB and R4 below it, beyond the ends as well") {
  const Simplex simplex = figure_6_simplex();
  const Point A = simplex.point(gjk::Role::A), B = simplex.point(gjk::Role::B);
  for_each_cell(simplex, figure_6_window(), [&](const Point& p, const std::string& answer, const std::string&) {
    const double level = B.y() + (A.y() - B.y()) * (p.x() - B.x()) / (A.x() - B.x());
    INFO(p.transpose());
    REQUIRE(answer == (p.y() > level ? "R3" : "R4"));
  });
}

TEST_CASE(
    "Figure 7: Algorithm 4 answers by the nearest feature where it may be asked, wrongly beyond what is ruled out") {
  std::map<std::string, std::set<std::string>> answers;
  for_each_cell(
      figure_7_simplex(), figure_7_window(),
      [&](const Point&, const std::string& answer, const std::string& nearest) { answers[nearest].insert(answer); });
  using Set = std::set<std::string>;
  CHECK(answers["ABC"] == Set{"R1"});
  CHECK(answers["AB"] == Set{"R3"});
  CHECK(answers["AC"] == Set{"R7"});
  CHECK(answers["A"] == Set{"R3", "R7"});
  CHECK(answers["BC"] == Set{"R1"});
}

TEST_CASE("Figure 8: Algorithm 5 answers by the nearest feature where it may be asked") {
  std::set<std::string> seen;
  for_each_cell(figure_8_simplex(), figure_8_slice(),
                [&](const Point& p, const std::string& answer, const std::string& nearest) {
                  seen.insert(answer);
                  INFO(nearest << " at " << p.transpose() << ": " << answer);
                  if (nearest == "ABCD") REQUIRE(answer == "inside");
                  if (nearest == "ABC" || nearest == "ACD") REQUIRE(answer == nearest);
                  if (nearest == "ABD") REQUIRE(answer == "ADB");
                  if (nearest == "AB" || nearest == "AC" || nearest == "AD")
                    REQUIRE(answer.substr(0, 6) == nearest + " of ");
                });
  CHECK(seen == std::set<std::string>{"inside", "ABC", "ACD", "ADB", "AB of ABC", "AB of ADB", "AC of ABC", "AC of ACD",
                                      "AD of ACD", "AD of ADB"});
}

TEST_CASE("The tests behind an answer bound the cells that got it") {
  for (const auto& [simplex, window] : drawn()) {
    const RegionGrid grid = ask_everywhere(simplex, window, cell);
    const std::vector<AnsweredArea> areas = answered_areas(simplex, grid);
    if (simplex.size() == 2) continue;  // Algorithm 3 has one test for both of its answers
    double sum = 0;
    for (const AnsweredArea& each : areas) sum += area(common_part(window.corners(), each.spaces, window.height));
    CHECK(sum == Approx(area(window.corners())));
    for (int row = 0; row < grid.rows(); ++row) {
      for (int column = 0; column < grid.columns(); ++column) {
        const auto own = std::ranges::find(areas, grid.at(column, row), &AnsweredArea::name);
        REQUIRE(own != areas.end());
        REQUIRE(lies_in(grid.middle(column, row), own->spaces));
      }
    }
  }
}

TEST_CASE("Blocks cover each cell once, with its text") {
  const Window window{.low = {-1, 2}, .high = {3, 4}};
  const RegionGrid grid(window, 8, 5, [](const Point& p) { return p.x() + p.y() > 4 ? "far" : "near"; });
  const std::vector<RegionGrid::Block> blocks = grid.blocks();
  CHECK(blocks.size() < 8 * 5);
  for (int row = 0; row < grid.rows(); ++row) {
    for (int column = 0; column < grid.columns(); ++column) {
      const Vec2 p = grid.middle(column, row).head<2>();
      std::vector<std::string> found;
      for (const RegionGrid::Block& block : blocks)
        if ((p.array() > block.low.array()).all() && (p.array() < block.high.array()).all())
          found.push_back(block.text);
      REQUIRE(found == std::vector<std::string>{p.x() + p.y() > 4 ? "far" : "near"});
    }
  }
}

TEST_CASE("Equal rows are one block each side") {
  const RegionGrid grid({.low = {0, 0}, .high = {4, 4}}, 4, 4,
                        [](const Point& p) { return p.x() > 2 ? "right" : "left"; });
  CHECK(grid.blocks().size() == 2);
}
