#include "walkthroughs/text/shell_word.hpp"

#include <algorithm>
#include <cstdio>
#include <string_view>

#include "render/utf8.hpp"
#include "walkthroughs/text/printable.hpp"

namespace walkthroughs::text {
namespace {

/// Returns: what makes those bytes in a word that is in single quotes, none of which a terminal may act upon.
std::string made_by_printf(std::string_view bytes) {
  std::string octal;
  for (const char byte : bytes) {
    char text[8];
    std::snprintf(text, sizeof text, "\\%03o", static_cast<unsigned>(static_cast<unsigned char>(byte)));
    octal += text;
  }
  return R"-('"$(printf ')-" + octal + R"-(')"')-";
}

/// Of what is not printable, only a line break stays what it is: a shell drops those at the end of what printf says.
std::string in_single_quotes(const render::Letter& letter) {
  if (letter.bytes == "'") return R"('\'')";
  const bool may_be_shown = letter.bytes == "\n" || (letter.is_well_formed && is_printable(letter.code_point));
  return may_be_shown ? std::string(letter.bytes) : made_by_printf(letter.bytes);
}

}  // namespace

std::string shell_quoted(std::string_view text) {
  const auto plain = [](unsigned char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') ||
           std::string_view("/._-+,=:@%").find(static_cast<char>(c)) != std::string_view::npos;
  };
  if (!text.empty() && std::ranges::all_of(text, plain)) return std::string(text);
  std::string quoted = "'";
  while (!text.empty()) {
    const render::Letter letter = render::first_letter(text);
    quoted += in_single_quotes(letter);
    text.remove_prefix(letter.bytes.size());
  }
  return quoted + "'";
}

std::string shell_word(const std::string& path) { return shell_quoted(path.starts_with('-') ? "./" + path : path); }

}  // namespace walkthroughs::text
