/// All walkthroughs of the program, each made in a file of its name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "walkthroughs/model/walkthrough.hpp"

namespace walkthroughs {

/// Returns: all walkthroughs, in the order of the report.
const std::vector<Walkthrough>& catalogue();

/// Returns: the walkthrough of that name, or all walkthroughs of the folder of that name ("regions"); none if there is neither.
std::vector<const Walkthrough*> find_walkthroughs(std::string_view name);

/// Returns: the walkthrough of that name, or null.
const Walkthrough* find_walkthrough(std::string_view name);

/// Returns: those with that word in name, title, summary or case; capitals do not matter.
std::vector<const Walkthrough*> walkthroughs_that_say(std::string_view word);

/// Returns: the name of the walkthrough that is spelled most like `name`, with or without its folder.
std::string nearest_name(std::string_view name);

Walkthrough figure_1();
Walkthrough figure_2();
Walkthrough figure_3();
Walkthrough figure_4();
Walkthrough figure_4_left();
Walkthrough figure_4_right();
Walkthrough figure_4_right_no_crossing_test();
Walkthrough figure_5();
Walkthrough figure_6();
Walkthrough figure_7();
Walkthrough figure_8();
std::vector<Walkthrough> regions_of_0_simplex();
std::vector<Walkthrough> regions_of_1_simplex();
std::vector<Walkthrough> regions_of_2_simplex();
std::vector<Walkthrough> regions_of_3_simplex();
std::vector<Walkthrough> vehicle_and_threat();
Walkthrough cycle_separated();
Walkthrough cycle_intersecting();
std::vector<Walkthrough> complete_rules();
Walkthrough as_printed_spheres();
Walkthrough eager_between_centers();
std::vector<Walkthrough> failures();
std::vector<Walkthrough> certified_answers();
Walkthrough mistakes_survival();
std::vector<Walkthrough> mistakes();

}  // namespace walkthroughs
