#include "walkthroughs/text/printable.hpp"

#include <cstdio>

#include "render/utf8.hpp"

namespace walkthroughs {
namespace {

std::string escape(const render::Letter& letter) {
  char text[16];
  if (letter.code_point < 0x80 || !letter.is_well_formed)
    std::snprintf(text, sizeof text, "\\x%02x", static_cast<unsigned>(static_cast<unsigned char>(letter.bytes[0])));
  else
    std::snprintf(text, sizeof text, "\\u%04x", static_cast<unsigned>(letter.code_point));
  return text;
}

std::string printable(const render::Letter& letter) {
  const bool can_be_shown = letter.is_well_formed && is_printable(letter.code_point);
  return can_be_shown ? std::string(letter.bytes) : escape(letter);
}

/// Takes up to `count` letters off the front of `text`. Returns: them, printable.
std::string take(std::string_view& text, std::size_t count) {
  std::string out;
  for (; count > 0 && !text.empty(); --count) {
    const render::Letter letter = render::first_letter(text);
    out += printable(letter);
    text.remove_prefix(letter.bytes.size());
  }
  return out;
}

}  // namespace

std::u32string code_points(std::string_view text) {
  std::u32string points;
  while (!text.empty()) points += render::next_code_point(text);
  return points;
}

bool is_printable(char32_t c) {
  const bool control = c < 0x20 || (0x7F <= c && c < 0xA0);
  const bool turns_or_breaks_lines = (0x200E <= c && c <= 0x200F) || (0x2028 <= c && c <= 0x202E) ||
                                     (0x2066 <= c && c <= 0x2069) || c == 0x061C || c == 0xFEFF;
  const bool cannot_be_seen = c == 0x00AD || c == 0x200B || (0x2060 <= c && c <= 0x2064);
  return !control && !turns_or_breaks_lines && !cannot_be_seen;
}

std::optional<std::size_t> first_not_utf_8(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const render::Letter letter = render::first_letter(text.substr(at));
    if (!letter.is_well_formed) return at;
    at += letter.bytes.size();
  }
  return std::nullopt;
}

std::string printable(std::string_view text) { return take(text, text.size()); }

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 40;
  const std::string shown = take(text, longest);
  return "'" + shown + (text.empty() ? "'" : "…'");
}

std::string message_line(std::string_view text) {
  constexpr std::size_t front = 200, back = 80;
  std::string line;
  while (!text.empty()) {
    std::string_view word = text.substr(0, text.find(' ', 1));  // with the blank before it
    text.remove_prefix(word.size());
    const std::size_t letters = code_points(word).size();
    if (letters > front + back) {
      line += take(word, front) + "…";
      take(word, letters - front - back);
    }
    line += printable(word);
  }
  return line;
}

}  // namespace walkthroughs
