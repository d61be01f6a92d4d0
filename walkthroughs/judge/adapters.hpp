/// Main functions for programs that are to be judged, as texts in the program.
#pragma once

#include <map>
#include <string>

#include "walkthroughs/rooms.hpp"

namespace walkthroughs::judge {

/// By their names: "judge.c". Made by CMake from walkthroughs/judge/adapters.
extern const std::map<std::string, std::string> adapter_files;

/// `language`: c, cpp, py or mjs.
inline const std::string& adapter(const std::string& language) { return adapter_files.at("judge." + language); }

}  // namespace walkthroughs::judge
