/// Comparison of PNG files and of folders of them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/compare.hpp"

namespace render {

enum class Sides { both, only_expected, only_actual };

/// One picture and where each side has it, or would have it.
struct FilePair {
  std::string name;  ///< relative to both folders, with / between folders
  std::filesystem::path expected, actual;
  Sides sides = Sides::both;
};

/// Returns: the names of all *.png (or *.PNG) in `folder` and below, relative to it, sorted. Links are followed. Nothing
/// that may hold pictures is left out: whatever else has such a name, a folder that cannot be read, a link that leads back
/// to a folder around it, and one that leads nowhere, which may have led to a folder, are listed, and found unreadable when
/// they are compared.
/// Errors: ReadError where `folder` itself cannot be read, or where it takes more than 1,000 links, as folders of links
/// to folders of links do.
std::vector<std::string> pictures_in(const std::filesystem::path& folder);

/// Returns: every name that either folder has, sorted. Errors: as pictures_in().
std::vector<FilePair> file_pairs(const std::filesystem::path& expected, const std::filesystem::path& actual);

/// One pair of files with what was found. `comparison` is of use where both pictures are there.
struct ComparedFiles {
  FilePair files;
  Verdict verdict = Verdict::same;
  std::string words;                      ///< one line of plain text about the verdict
  std::optional<Image> expected, actual;  ///< empty: no such file, or unreadable
  Comparison comparison = {};
};

/// Reads both files, as far as there are, and compares them. A file that cannot be read is the verdict `unreadable`.
ComparedFiles compare_files(const FilePair& files, const Tolerance& tolerance = {});

}  // namespace render
