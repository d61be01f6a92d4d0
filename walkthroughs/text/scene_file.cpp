#include "walkthroughs/text/scene_file.hpp"

namespace walkthroughs {

SceneFile parse_scene(std::string_view text, const std::string& file_name) {
  auto [file, complaint] = scene_in(text, file_name);
  if (complaint) throw InputError(file_name + ":" + std::to_string(complaint->line) + ": " + complaint->text());
  return std::move(file);
}

SceneFile read_scene(const std::filesystem::path& file) {
  return parse_scene(read_text(file, scene_limits::bytes), file.string());
}

}  // namespace walkthroughs
