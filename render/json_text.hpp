/// JSON as text.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace render {

/// Returns: `json` in one line; in several, indented by so many blanks, where `indent` is not negative. Names of files may be
/// no UTF-8: each byte of those becomes U+FFFD.
template <class Json>
std::string json_text(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace render
