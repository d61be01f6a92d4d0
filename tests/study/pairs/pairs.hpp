/// The pairs of walkthroughs/pairs under the study's own names, and what is true of one.
#pragma once

#include "walkthroughs/pairs/dice.hpp"
#include "walkthroughs/pairs/families.hpp"
#include "walkthroughs/pairs/named_pair.hpp"

namespace study {

using walkthroughs::model::Ball;
using walkthroughs::model::Points;
using walkthroughs::pairs::Body;
using walkthroughs::pairs::Can;
using walkthroughs::pairs::Dice;
using walkthroughs::pairs::families;
using walkthroughs::pairs::Family;
using walkthroughs::pairs::family_named;
using walkthroughs::pairs::hash;
using walkthroughs::pairs::kept_pairs;
using walkthroughs::pairs::largest_number;
using walkthroughs::pairs::NamedPair;
using walkthroughs::pairs::Pair;
using walkthroughs::pairs::question_line;
using walkthroughs::pairs::Vec;

/// Sets are closed: touching is intersecting.
enum class Truth { separated, intersecting };

}  // namespace study
