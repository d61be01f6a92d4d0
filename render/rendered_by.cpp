#include "render/rendered_by.hpp"

#include <libdeflate.h>
#include <png.h>

#include <Eigen/Core>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "render/file.hpp"
#include "render/font.hpp"
#include "render/json_text.hpp"

namespace render {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t most_bytes = 1 << 16;  // notes, not data

std::string crc32_of(const std::vector<std::uint8_t>& bytes) {
  char text[16];
  std::snprintf(text, sizeof text, "%08x", libdeflate_crc32(0, bytes.data(), bytes.size()));
  return text;
}

std::string eigen_version() {
  return std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
         std::to_string(EIGEN_MINOR_VERSION);
}

/// Mesa compiles its shaders for the processor that it finds.
std::string processor() {
#if defined(__x86_64__)
  const auto says = [](const char* name, int has) { return std::string(has ? "with " : "without ") + name; };
  return "x86-64, " + says("AVX2", __builtin_cpu_supports("avx2")) + ", " + says("FMA", __builtin_cpu_supports("fma"));
#else
  return "not x86-64";
#endif
}

std::optional<std::string> find(const RenderedBy& notes, const std::string& key) {
  const auto found = std::ranges::find(notes, key, &RenderedBy::value_type::first);
  return found == notes.end() ? std::nullopt : std::optional(found->second);
}

RenderedBy not_understood(const std::string& why) { return {{rendered_by_file, "cannot be read: " + why}}; }

RenderedBy parse(const std::vector<std::uint8_t>& bytes) {
  const auto json = nlohmann::ordered_json::parse(bytes, nullptr, /*allow_exceptions=*/false);
  if (!json.is_object()) return not_understood("it is not a JSON object");
  RenderedBy notes;
  for (const auto& [key, value] : json.items()) {
    if (!value.is_string()) return not_understood("the value of '" + key + "' is not a string");
    notes.emplace_back(key, value.get<std::string>());
  }
  return notes;
}

}  // namespace

std::optional<RenderedBy> read_rendered_by(const fs::path& folder) {
  const fs::path path = folder / rendered_by_file;
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return std::nullopt;
  try {
    return parse(read_file(path, most_bytes));
  } catch (const ReadError& unreadable) {
    return not_understood(unreadable.what());
  }
}

std::vector<RenderedByLine> side_by_side(const RenderedBy& expected, const RenderedBy& actual) {
  std::vector<RenderedByLine> lines;
  for (const auto& [key, value] : expected) lines.push_back({key, value, find(actual, key)});
  for (const auto& [key, value] : actual)
    if (!find(expected, key)) lines.push_back({key, std::nullopt, value});
  return lines;
}

RenderedBy rendered_by(const OffscreenContext& context, const fs::path& fonts) {
  const fs::path font = fonts / "DejaVuSans.ttf";
  const std::vector<std::uint8_t> bytes = read_file(font);
  return {
      {"drawn by", context.description()},
      {"libpng", png_get_libpng_ver(nullptr)},
      {"libdeflate", LIBDEFLATE_VERSION_STRING},
      {"FreeType", freetype_version()},
      {"Eigen", eigen_version()},
      {"processor", processor()},
      {"font", font.filename().string() + ", " + std::to_string(bytes.size()) + " bytes, CRC-32 " + crc32_of(bytes)}};
}

std::string rendered_by_json(const RenderedBy& notes) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [key, value] : notes) json[key] = value;
  return json_text(json, 2) + "\n";
}

}  // namespace render
