#include "walkthroughs/text/shell_word.hpp"

#include <algorithm>

namespace walkthroughs {

std::string shell_quoted(const std::string& text) {
  const auto plain = [](unsigned char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '/' || c == '.' ||
           c == '_' || c == '-' || c == '+' || c == ',' || c == '=' || c == ':' || c == '@';
  };
  if (!text.empty() && std::ranges::all_of(text, plain)) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string shell_word(const std::filesystem::path& path) {
  return shell_quoted(path.string().starts_with('-') ? "./" + path.string() : path.string());
}

}  // namespace walkthroughs
