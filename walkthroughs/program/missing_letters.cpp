#include "walkthroughs/program/missing_letters.hpp"

#include <cstdio>

#include "walkthroughs/text/printable.hpp"

namespace walkthroughs {
namespace {

constexpr std::size_t most_named = 8;

std::string utf8(char32_t code) {
  const auto tail = [&](int shift) { return static_cast<char>(0x80 | (code >> shift & 0x3F)); };
  if (code < 0x80) return {static_cast<char>(code)};
  if (code < 0x800) return {static_cast<char>(0xC0 | code >> 6), tail(0)};
  if (code < 0x10000) return {static_cast<char>(0xE0 | code >> 12), tail(6), tail(0)};
  return {static_cast<char>(0xF0 | code >> 18), tail(12), tail(6), tail(0)};
}

std::string name_of(char32_t code) {
  char text[16];
  std::snprintf(text, sizeof text, "U+%04X", static_cast<unsigned>(code));
  return is_printable(code) ? utf8(code) + " (" + text + ")" : text;
}

}  // namespace

std::string missing_letters(const std::set<char32_t>& codes) {
  std::string list;
  std::size_t named = 0;
  for (const char32_t code : codes) {
    if (named++ == most_named) break;
    list += (list.empty() ? "" : ", ") + name_of(code);
  }
  if (codes.size() > most_named) list += " and " + std::to_string(codes.size() - most_named) + " more";
  return "the font has no sign for " + list +
         (codes.size() == 1 ? ": a box stands in its place" : ": boxes stand in their place");
}

}  // namespace walkthroughs
