/// Files of scenes. scene_text.hpp says what they hold.
#pragma once

#include "walkthroughs/text/scene_limits.hpp"
#include "walkthroughs/text/scene_text.hpp"
#include "walkthroughs/text/text_file.hpp"

namespace walkthroughs::text {

/// Returns: scene_in(). Errors: InputError, in which the name stands.
inline SceneFile parse_scene(std::string_view text, const std::string& file_name) {
  return accepted(scene_in(text, file_name), file_name);
}

/// Errors: InputError, about the first thing that is wrong. Reads regular files of at most scene_limits::bytes, and never
/// more than that.
inline SceneFile read_scene(const std::filesystem::path& file) {
  return parse_scene(read_text(file, scene_limits::bytes), called(file));
}

}  // namespace walkthroughs::text
