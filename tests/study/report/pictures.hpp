/// The three pictures of a study, drawn by gnuplot.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/study/sweep/settings.hpp"

namespace study {

inline constexpr const char* picture_files[] = {"error-vs-time.png", "heat-map.png", "iterations.png"};

struct Picture {
  std::string file;    ///< "heat-map.png"
  std::string script;  ///< for gnuplot, with its data; the picture goes to its standard output
};

Picture error_vs_time(const Settings& settings);
Picture heat_map(const Settings& settings);
Picture iterations(const Settings& settings);

/// Returns: whether gnuplot drew the picture; the file is there whole or not at all. Errors: render::FileError.
bool draw(const Picture& picture, const std::filesystem::path& folder);

}  // namespace study
