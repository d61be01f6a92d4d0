/// In which region does the origin lie? Figures 6-8 ask Algorithms 3-5 of a grid of origins, and draw what they answer.
///
/// The algorithms put the origin at (0,0,0); here the simplex stays and the origin moves: for the origin g they are given the
/// simplex translated by −g. The regions of the report come from geometry alone and the answers from the algorithms alone,
/// so that a picture shows where the two differ.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "render/panel.hpp"
#include "walkthroughs/model/moment.hpp"
#include "walkthroughs/picture/style.hpp"

namespace walkthroughs::catalogue {

// -- Geometry: the regions of the report ----------------------------------------------------------------------------

/// The points p with normal·(p − on) >= 0.
struct HalfSpace {
  Point on, normal;

  double operator()(const Point& p) const { return normal.dot(p - on); }
};

/// Returns: the half-spaces whose common part is the region beyond `feature` ("A", "AB", …): the points to which no point of
/// the simplex is nearer than one of that feature. A triangle's own region reaches above and below its plane.
std::vector<HalfSpace> region_beyond(const Simplex& simplex, std::string_view feature);

/// Returns: the part of the plane z = `height` that lies in all of them and in `polygon`.
std::vector<render::Vec2> common_part(std::vector<render::Vec2> polygon, const std::vector<HalfSpace>& spaces,
                                      double height);

bool lies_in(const Point& p, const std::vector<HalfSpace>& spaces);

// -- Answers of the algorithm -----------------------------------------------------------------------------------------

/// Returns: the simplex with these vertices, given oldest first.
Simplex simplex_of(const std::vector<Point>& oldest_first);

/// What Algorithms 3-5 tell of one origin.
struct Answer {
  std::vector<gjk::RegionTested<double>> regions;  ///< in the order told; the last chosen one is the answer
  Point direction = Point::Zero();                 ///< to search next; zero where the origin lies in the simplex

  const gjk::RegionTested<double>& chosen() const;
};

/// Requires: two to four vertices.
Answer ask(const Simplex& simplex, const Point& origin);

/// Returns: the answer in the report's words: "R3" where it has a label, else "ABC", or "AC of ABC" for an edge of a face,
/// or "inside". Of "R3 or R4" the one that `direction` points into; R3 lies at the left of the way from B to A.
std::string name_of(const Answer& answer, const Simplex& simplex);

/// Returns: the half-spaces that the answer's tests have found the origin in; together, all origins with that answer.
std::vector<HalfSpace> tested_half_spaces(const Answer& answer, const Simplex& simplex);

// -- The grid ---------------------------------------------------------------------------------------------------------

/// A window of the plane z = `height`, in scene units.
struct Window {
  render::Vec2 low, high;
  double height = 0;

  std::vector<render::Vec2> corners() const { return {low, {high.x(), low.y()}, high, {low.x(), high.y()}}; }
};

/// Returns: what a panel shows of the plane z = `height`.
Window window_of(const render::Panel& panel, double height);

/// A text for each cell of a window: what holds at its middle.
class RegionGrid {
 public:
  /// Requires: columns, rows >= 1.
  RegionGrid(const Window& window, int columns, int rows, const std::function<std::string(const Point&)>& ask);

  struct Cell {
    Point middle;
    std::string text;
  };
  /// Returns: row by row from below.
  const std::vector<Cell>& cells() const { return cells_; }

  /// Cells with the same text, merged.
  struct Block {
    render::Vec2 low, high;
    std::string text;
  };
  /// Returns: the whole window: equal neighbours in a row merged, and equal rows on top of each other.
  std::vector<Block> blocks() const;

 private:
  /// Returns: where a cell begins; of the cell behind the last where that ends.
  render::Vec2 corner(int column, int row) const;
  const std::string& text(int column, int row) const;
  bool are_alike(int row, int other) const;

  Window window_;
  int columns_, rows_;
  std::vector<Cell> cells_;
};

/// Returns: the grid of the algorithm's answers. `cell`: about how wide a cell is, in scene units.
RegionGrid ask_everywhere(const Simplex& simplex, const Window& window, double cell);

/// Where the tests behind one answer come out as they did.
struct AnsweredArea {
  std::string name;  ///< of the answer, see name_of()
  std::vector<HalfSpace> spaces;
};

/// Returns: one for each answer in the grid, in the order of first appearance.
std::vector<AnsweredArea> answered_areas(const Simplex& simplex, const RegionGrid& grid);

// -- Drawing ----------------------------------------------------------------------------------------------------------

/// Returns: the grid of the algorithm's answers all over a panel, in cells as small as can be seen.
RegionGrid ask_all_over(const render::Panel& panel, const Simplex& simplex, double height);

/// Fills the blocks with opaque colours: what `fill` looks like on `paper`.
void draw_blocks(render::Panel& panel, const std::vector<RegionGrid::Block>& blocks,
                 const std::function<render::Color(const std::string&)>& fill, render::Color paper);

/// Hatches an area that the report rules out, on a veil that lets what lies below show faintly.
void draw_ruled_out(render::Panel& panel, const std::vector<render::Vec2>& area, const Style& style);

}  // namespace walkthroughs::catalogue
