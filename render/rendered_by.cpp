#include "render/rendered_by.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "render/file.hpp"

namespace render {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t most_bytes = 1 << 16;  // notes, not data

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
  if (fs::file_size(path, error) > most_bytes) return not_understood("it is longer than 64 KiB");
  try {
    return parse(read_file(path));
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

}  // namespace render
