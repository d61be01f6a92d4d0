#include "walkthroughs/program/missing_letters.hpp"

#include "render/utf8.hpp"
#include "walkthroughs/text/printable.hpp"

namespace walkthroughs {
namespace {

constexpr std::size_t most_named = 8;

std::string name_of(char32_t code) {
  const std::string name = code_point_name(code);
  return is_printable(code) ? render::utf8_of(code) + " (" + name + ")" : name;
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
