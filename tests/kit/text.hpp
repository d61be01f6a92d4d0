/// Texts, as tests look at them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kit {

inline bool has(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

/// Returns: the lines that end with a newline, without it.
inline std::vector<std::string> lines(std::string_view text) {
  std::vector<std::string> list;
  for (std::size_t at = 0, end; (end = text.find('\n', at)) != std::string_view::npos; at = end + 1)
    list.emplace_back(text.substr(at, end - at));
  return list;
}

}  // namespace kit
