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

/// Returns: the name of the walkthrough that is spelled most like `name`, with or without its folder.
std::string nearest_name(std::string_view name);

// The walkthroughs by their families, each made in a file of its name.
Walkthrough figure_1();
Walkthrough figure_2();
Walkthrough figure_3();
std::vector<Walkthrough> figures_4_and_5();
std::vector<Walkthrough> figures_6_and_7();
Walkthrough figure_8();
std::vector<Walkthrough> region_cases();
std::vector<Walkthrough> vehicle_and_threat();
std::vector<Walkthrough> endless_searches();
std::vector<Walkthrough> other_rules();
std::vector<Walkthrough> failures();
std::vector<Walkthrough> certified_answers();
Walkthrough mistakes_survival();
std::vector<Walkthrough> mistakes();

/// Returns: a search with a mistake in it, beside the report's, "mistakes/m14-order-below-triangle": the scene searched with that
/// mistake, and as the report has it. Requires: a scene without a mistake, whose rules are the report's as intended.
Walkthrough beside_the_report(Mistake mistake, Scene right);

}  // namespace walkthroughs::catalogue
