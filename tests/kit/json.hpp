/// JSON Lines, as tests read, change and write them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/kit/text.hpp"

namespace kit {

using Json = nlohmann::ordered_json;

inline std::vector<Json> json_lines(const std::string& text) {
  std::vector<Json> all;
  for (const std::string& line : lines(text)) all.push_back(Json::parse(line));
  return all;
}

inline std::string text_of(const std::vector<Json>& lines) {
  std::string text;
  for (const Json& line : lines) text += line.dump() + "\n";
  return text;
}

}  // namespace kit
