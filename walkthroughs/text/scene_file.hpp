/// Files of scenes. scene_text.hpp says what they hold.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "walkthroughs/text/scene_limits.hpp"
#include "walkthroughs/text/scene_text.hpp"
#include "walkthroughs/text/text_file.hpp"

namespace walkthroughs {

/// Errors: InputError, about the first thing that is wrong. Reads regular files of at most scene_limits::bytes, and never
/// more than that.
SceneFile read_scene(const std::filesystem::path& file);

/// Returns: scene_in(). Errors: InputError, in which the name stands.
SceneFile parse_scene(std::string_view text, const std::string& file_name);

}  // namespace walkthroughs
