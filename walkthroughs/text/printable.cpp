#include "walkthroughs/text/printable.hpp"

#include <algorithm>
#include <cstdio>
#include <ranges>
#include <span>

#include "render/utf8.hpp"

namespace walkthroughs::text {
namespace {

struct Range {
  char32_t first, last;
};

/// What is seen only by what it does to the letters around it: joiners and selectors of variants.
constexpr Range shaping[] = {{0x034F, 0x034F}, {0x180B, 0x180D}, {0x180F, 0x180F},
                             {0x200C, 0x200D}, {0xFE00, 0xFE0F}, {0xE0100, 0xE01EF}};

/// The rest of what Unicode calls Default_Ignorable_Code_Point, of its categories Cc, Zl, Zp and, but for Arabic and Kaithi signs
/// that are drawn, Cf, and of the code points that are no characters but for the two at the end of each plane.
/// https://www.unicode.org/Public/16.0.0/ucd/DerivedCoreProperties.txt
constexpr Range never_seen[] = {
    {0x0000, 0x001F},   {0x007F, 0x009F},   {0x00AD, 0x00AD},   {0x061C, 0x061C},  {0x070F, 0x070F}, {0x115F, 0x1160},
    {0x17B4, 0x17B5},   {0x180E, 0x180E},   {0x200B, 0x200B},   {0x200E, 0x200F},  {0x2028, 0x202E}, {0x2060, 0x206F},
    {0x3164, 0x3164},   {0xFDD0, 0xFDEF},   {0xFEFF, 0xFEFF},   {0xFFA0, 0xFFA0},  {0xFFF0, 0xFFFB}, {0x13430, 0x1343F},
    {0x1BCA0, 0x1BCA3}, {0x1D173, 0x1D17A}, {0xE0000, 0xE00FF}, {0xE01F0, 0xE0FFF}};

bool is_in(std::span<const Range> ranges, char32_t c) {
  return std::ranges::any_of(ranges, [c](const Range& range) { return range.first <= c && c <= range.last; });
}

std::string escape(const render::Letter& letter) {
  char text[16];
  if (letter.code_point < 0x80 || !letter.is_well_formed)
    std::snprintf(text, sizeof text, "\\x%02x", static_cast<unsigned>(static_cast<unsigned char>(letter.bytes[0])));
  else
    std::snprintf(text, sizeof text, letter.code_point < 0x10000 ? "\\u%04x" : "\\U%08x",
                  static_cast<unsigned>(letter.code_point));
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

// -- In commands --------------------------------------------------------------------------------------------------------

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

std::u32string code_points(std::string_view text) {
  std::u32string points;
  while (!text.empty()) points += render::next_code_point(text);
  return points;
}

bool is_printable(char32_t c) { return !is_in(never_seen, c) && !is_in(shaping, c) && (c & 0xFFFE) != 0xFFFE; }

bool is_part_of_words(char32_t c) { return is_printable(c) || is_in(shaping, c); }

std::string code_point_name(char32_t code_point) {
  char text[16];
  std::snprintf(text, sizeof text, "U+%04X", static_cast<unsigned>(code_point));
  return text;
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

std::string missing_letters(const std::set<char32_t>& codes) {
  constexpr std::size_t most_named = 8;
  std::string list;
  for (const char32_t code : codes | std::views::take(most_named)) {
    const std::string name = code_point_name(code);
    list += (list.empty() ? "" : ", ") + (is_printable(code) ? render::utf8_of(code) + " (" + name + ")" : name);
  }
  if (codes.size() > most_named) list += " and " + std::to_string(codes.size() - most_named) + " more";
  return "the font has no sign for " + list +
         (codes.size() == 1 ? ": a box stands in its place" : ": boxes stand in their place");
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
