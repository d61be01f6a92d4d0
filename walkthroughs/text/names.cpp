#include "walkthroughs/text/names.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "render/utf8.hpp"
#include "walkthroughs/text/printable.hpp"
#include "walkthroughs/text/scene_limits.hpp"

namespace walkthroughs::text {
namespace {

const std::string nameless = "scene";

/// Returns: the last part of a path without its ending; a dot in front begins none.
std::string stem_of(const std::string& file_name) {
  const std::string name = file_name.substr(file_name.rfind('/') + 1);  // all of it where there is no slash
  const std::size_t dot = name.rfind('.');
  return dot == 0 || name == ".." ? name : name.substr(0, dot);
}

bool is_blank(char32_t c) {
  return c == 0xA0 || c == 0x1680 || (0x2000 <= c && c <= 0x200A) || c == 0x202F || c == 0x205F || c == 0x3000;
}

/// Letters of all scripts, and what no shell and no page takes for anything else.
bool may_begin_a_name(char32_t c) {
  return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '_' || c == '-' ||
         (c >= 0x80 && is_part_of_words(c) && !is_blank(c));
}

bool may_be_in_a_name(char32_t c) { return may_begin_a_name(c) || c == '.'; }

/// Levenshtein (1966): the least number of letters to insert, delete or replace.
std::size_t edit_distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t replaced = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j + 1] + 1, row[j] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string objection_to_words(std::string_view text, std::size_t longest) {
  const std::u32string points = code_points(text);
  if (std::ranges::all_of(points, [](char32_t c) { return c == U' '; }))
    return "is empty; write something, or leave the key out";
  if (const auto hidden = std::ranges::find_if_not(points, is_part_of_words); hidden != points.end())
    return "has " + code_point_name(*hidden) + ", which cannot be shown; leave it out";
  if (points.size() > longest)
    return "has " + std::to_string(points.size()) + " characters; shorten it to " + std::to_string(longest);
  return "";
}

std::string objection_to_name(std::string_view name) {
  if (std::string objection = objection_to_words(name, scene_limits::walkthrough); !objection.empty()) return objection;
  if (name.size() > scene_limits::walkthrough)
    return "has " + std::to_string(name.size()) + " bytes; shorten it to " + std::to_string(scene_limits::walkthrough);
  bool is_begin = true;
  for (const char32_t c : code_points(name) + U"/") {
    const bool is_good = is_begin ? may_begin_a_name(c) : may_be_in_a_name(c) || c == '/';
    if (!is_good)
      return in_quotes(name) + " cannot name a folder; use letters, digits, '_', '-', and inside of words '.'";
    is_begin = c == '/';
  }
  return "";
}

std::string name_from_file(const std::string& file_name) {
  const std::string stem = stem_of(file_name);
  std::string name;
  for (std::string_view rest = stem; !rest.empty();) {
    const render::Letter letter = render::first_letter(rest);
    rest.remove_prefix(letter.bytes.size());
    if (letter.code_point == '.' && name.empty()) continue;
    const std::string_view next = letter.is_well_formed && may_be_in_a_name(letter.code_point) ? letter.bytes : "-";
    if (name.size() + next.size() > scene_limits::walkthrough) break;
    name += next;
  }
  return name.empty() ? nameless : name;
}

std::string title_from_file(const std::string& file_name) {
  const std::string stem = stem_of(file_name);
  std::string title;
  std::size_t length = 0;
  for (std::string_view rest = stem; !rest.empty() && length < scene_limits::title;) {
    const render::Letter letter = render::first_letter(rest);
    rest.remove_prefix(letter.bytes.size());
    const bool divides = letter.code_point == U'_' || letter.code_point == U' ';
    if (divides && (title.empty() || title.ends_with(' '))) continue;
    const bool can_be_shown = letter.is_well_formed && is_part_of_words(letter.code_point);
    title += divides ? " " : can_be_shown ? std::string(letter.bytes) : "-";
    ++length;
  }
  if (title.ends_with(' ')) title.pop_back();
  return title.empty() ? nameless : title;
}

std::string in_small_letters(std::string_view text) {
  std::string small(text);
  for (char& c : small)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return small;
}

std::string nearest(std::string_view word, std::span<const std::string> candidates) {
  word = word.substr(0, 64);
  const auto begun = std::ranges::find_if(candidates, [&](const std::string& each) { return each.starts_with(word); });
  if (begun != candidates.end()) return *begun;
  std::string best;
  std::size_t least = std::min<std::size_t>(3, word.size() / 2) + 1;
  for (const std::string& each : candidates)
    if (const std::size_t letters = edit_distance(word, each); letters < least) {
      least = letters;
      best = each;
    }
  return best;
}

std::string did_you_mean(const std::string& nearest_word) {
  return nearest_word.empty() ? "" : "did you mean '" + nearest_word + "'? ";
}

}  // namespace walkthroughs::text
