/// Texts of scenes, and what is said about bad ones.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/text/scene_file.hpp"

namespace walkthroughs::test {

// -- Scenes -----------------------------------------------------------------------------------------------------------

inline const std::string ball = R"({"sphere": {"center": [0, 0, 0], "radius": 1}})";
inline const std::string corner = R"({"points": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]})";

/// Each on its own line: a on 2, b on 3, the rest from 4 on.
inline std::string scene_text(const std::string& a, const std::string& b, const std::string& rest = "") {
  return "{\n  \"a\": " + a + ",\n  \"b\": " + b + (rest.empty() ? "" : ",\n  " + rest) + "\n}\n";
}
inline std::string plane_text(const std::string& a, const std::string& b) {
  return scene_text(a, b, R"("dimension": 2)");
}

inline SceneFile parsed(const std::string& text, const std::string& file = "my scene.json") {
  return parse_scene(text, file);
}
inline Scene scene_of(const std::string& text) { return parsed(text).walkthrough.scenes.at(0); }

inline const std::vector<Point>& points_of(const Object& object) { return std::get<Points>(object.form); }

// -- Complaints -------------------------------------------------------------------------------------------------------

inline std::string complaint(const std::string& text) {
  try {
    parsed(text, "bad.json");
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no complaint";
}

/// `place`: "LINE: KEY", or "LINE" for the text as a whole.
inline void check_complaint(const std::string& text, const std::string& place, const std::vector<std::string>& parts) {
  INFO(text.substr(0, 300));
  const std::string said = complaint(text);
  INFO(said.substr(0, 600));
  CHECK(said.starts_with("bad.json:" + place + ": "));
  for (const std::string& part : parts) CHECK(said.find(part) != std::string::npos);
  CHECK(said.size() < 400);
}

/// A file in a folder of its own.
struct Written {
  explicit Written(const std::string& text, const std::string& name = "scene.json") : path(folder.path() / name) {
    std::ofstream(path, std::ios::binary) << text;
  }
  Folder folder;
  std::filesystem::path path;
};

inline std::string complaint_about_file(const std::filesystem::path& file) {
  try {
    read_scene(file);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no complaint";
}

}  // namespace walkthroughs::test
