/// All walkthroughs of the program.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "walkthroughs/model/walkthrough.hpp"

namespace walkthroughs::catalogue {

/// Returns: all walkthroughs, in the order of the report.
const std::vector<Walkthrough>& whole_catalogue();

/// Returns: the walkthrough of that name, or all walkthroughs of the folder of that name ("regions"); none if there is neither.
std::vector<const Walkthrough*> find_walkthroughs(std::string_view name);

/// Returns: the walkthrough of that name, or null.
const Walkthrough* find_walkthrough(std::string_view name);

/// Returns: those with that word in name, title, summary or case; capitals do not matter.
std::vector<const Walkthrough*> walkthroughs_that_say(std::string_view word);

/// Returns: the name of the walkthrough that is spelled most like `name`, with or without its folder; nothing where none is
/// spelled like it.
std::string nearest_name(std::string_view name);

// The walkthroughs by their families, each made in a file of its name.
std::vector<Walkthrough> lesson();
std::vector<Walkthrough> two_triangles();
std::vector<Walkthrough> figure_1();
std::vector<Walkthrough> figure_2();
std::vector<Walkthrough> figure_3();
std::vector<Walkthrough> figures_4_and_5();
std::vector<Walkthrough> figures_6_and_7();
std::vector<Walkthrough> figure_8();
std::vector<Walkthrough> region_cases();
std::vector<Walkthrough> vehicle_and_threat();
std::vector<Walkthrough> other_rules();
std::vector<Walkthrough> failures();
std::vector<Walkthrough> certified_answers();
std::vector<Walkthrough> mistakes();

/// Returns: a search with a mistake in it, beside the report's, "mistakes/m14-order-below-triangle": the scene searched with that
/// mistake, and as the report has it. Requires: a scene without a mistake, whose rules are the report's as intended.
Walkthrough beside_the_report(Mistake mistake, Scene right);

// What families are made of. `place`: in the report, "Section 2.2".

Walkthrough diagrams_of(const std::string& name, const std::string& title, const std::string& place,
                        const std::string& summary, std::vector<Diagram> (*draw)());

/// Returns: a walkthrough of one search, whose vertices are called by their roles in the simplex.
Walkthrough search_of(const std::string& name, const std::string& title, const std::string& place,
                      const std::string& summary, Scene scene, std::vector<Remark> remarks = {});

/// Of a polygon or a polyhedron.
struct Corner {
  double x, y, z = 0;
};

/// Returns: two sets of points, their corners in any order; in the plane, where all of them lie there.
Scene scene_of(const std::string& a, const std::vector<Corner>& corners_of_a, const std::string& b,
               const std::vector<Corner>& corners_of_b, const std::string& name = "search");

}  // namespace walkthroughs::catalogue
