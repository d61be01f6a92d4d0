// Read once for all files of the program that runs in pages: half of the time that Clang takes for them.
#pragma once

#include "walkthroughs/live/wasm/pairs_of_doubles.hpp"  // before Eigen

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/certified/dyadic.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/model/words_of.hpp"
#include "walkthroughs/page/page.hpp"
#include "walkthroughs/picture/diagram_parts.hpp"
#include "walkthroughs/picture/draw.hpp"
#include "walkthroughs/picture/panels.hpp"
#include "walkthroughs/picture/pencil.hpp"
#include "walkthroughs/story/storyboard.hpp"
#include "walkthroughs/story/truth_told.hpp"
#include "walkthroughs/story/words.hpp"
#include "walkthroughs/text/scene_text.hpp"
#include "walkthroughs/trace/trace_json.hpp"
