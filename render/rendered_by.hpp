/// What made the pictures of a folder: a file of notes beside them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/offscreen_context.hpp"

namespace render {

/// The file holds one JSON object of strings, such as {"gl_renderer": "llvmpipe", "libpng": "1.6.39"}.
inline constexpr const char* rendered_by_file = "rendered-by.json";

/// Keys and values, in the order of the file.
using RenderedBy = std::vector<std::pair<std::string, std::string>>;

/// Returns: what `folder`/rendered-by.json says, or nothing where there is no such file. Pictures can be compared without
/// it, so a file that cannot be understood is no error: one line says so.
std::optional<RenderedBy> read_rendered_by(const std::filesystem::path& folder);

/// Returns: what draws in this process: the driver behind `context`, the libraries, what the processor offers that rounds
/// differently, and the regular font of `fonts` with its size and the CRC-32 of its bytes.
/// Errors: FileError where the font cannot be read.
RenderedBy rendered_by(const OffscreenContext& context, const std::filesystem::path& fonts);

/// Returns: the notes as the text of a file.
std::string rendered_by_json(const RenderedBy& notes);

/// One line of the notes on both sides.
struct RenderedByLine {
  std::string key;
  std::optional<std::string> expected, actual;  ///< empty: that side does not say

  bool differs() const { return expected != actual; }
  friend bool operator==(const RenderedByLine&, const RenderedByLine&) = default;
};

/// Returns: the keys of `expected` in their order, then those that only `actual` has.
std::vector<RenderedByLine> side_by_side(const RenderedBy& expected, const RenderedBy& actual);

}  // namespace render
