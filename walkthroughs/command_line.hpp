/// What the words of all commands have in common.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "render/geometry.hpp"
#include "walkthroughs/walkthrough.hpp"

namespace walkthroughs {

/// The command line asks for something that there is not; what() says what there is instead.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Errors: UsageError, with the name that was probably meant.
const Walkthrough& walkthrough_named(const std::string& name);

/// Returns: the walkthrough of that name, or those of the folder of that name. Errors: as walkthrough_named().
std::vector<const Walkthrough*> walkthroughs_named(const std::string& name);

/// Reads "1280x720". Errors: UsageError.
render::Size parse_size(const std::string& text);

/// Whether a word of the command line means a scene file and not a walkthrough.
inline bool is_scene_file(const std::string& name) { return name.ends_with(".json"); }

}  // namespace walkthroughs
