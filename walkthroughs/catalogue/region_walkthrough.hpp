/// What the walkthroughs regions/… have in common: each shows one case of Section 3.2, reached by a real search on two real
/// objects. The files regions_of_N_simplex.cpp are tables of such cases.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "walkthroughs/model/walkthrough.hpp"

namespace walkthroughs {

/// One row of the catalogue.
struct RegionRow {
  std::string name;   ///< "r3"; the walkthrough is "regions/2-simplex-r3"
  std::string title;  ///< "the origin lies in R3"; headed by "2-simplex: "
  std::string summary;
  std::string text;  ///< of the RegionCase
  Scene scene;
  std::vector<Remark> remarks;  ///< in the letters of the simplex that is being processed
};

/// A polygon, its corners in any order.
inline Object polygon(std::string name, const std::vector<std::pair<double, double>>& corners) {
  std::vector<Point> vertices;
  for (const auto& [x, y] : corners) vertices.emplace_back(x, y, 0);
  return {.name = std::move(name), .form = points(std::move(vertices))};
}

/// A polyhedron, its corners in any order; or a triangle that stands askew in space.
inline Object polyhedron(std::string name, std::vector<Point> corners) {
  return {.name = std::move(name), .form = points(std::move(corners))};
}

inline Scene in_the_plane(Object a, Object b) {
  return {.name = "search", .a = std::move(a), .b = std::move(b), .dimension = Dimension::plane};
}

inline Scene in_space(Object a, Object b) {
  return {.name = "search", .a = std::move(a), .b = std::move(b), .dimension = Dimension::space};
}

/// Returns: the rows as walkthroughs. Section 3.2.1 is about the 0-simplex, Section 3.2.2 about the 1-simplex, and so on.
inline std::vector<Walkthrough> region_walkthroughs(int dimension_of_simplex, std::vector<RegionRow> rows) {
  const std::string simplex = std::to_string(dimension_of_simplex) + "-simplex";
  const std::string section = "3.2." + std::to_string(dimension_of_simplex + 1);
  std::vector<Walkthrough> walkthroughs;
  for (RegionRow& row : rows)
    walkthroughs.push_back({.name = "regions/" + simplex + "-" + row.name,
                            .title = simplex + ": " + row.title,
                            .source = "ARL-TR-7474, Section " + section,
                            .summary = std::move(row.summary),
                            .naming = Naming::roles,
                            .scenes = {std::move(row.scene)},
                            .remarks = std::move(row.remarks),
                            .region_case = RegionCase{.text = std::move(row.text), .section = section}});
  return walkthroughs;
}

}  // namespace walkthroughs
