#include "walkthroughs/words.hpp"

#include <algorithm>
#include <cstdio>
#include <vector>

namespace walkthroughs {
namespace {

constexpr std::string_view roles = "ABCD";

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

/// Returns: whether `word` names vertices, a vector or a normal in roles: "AB", "AO", "ABCn".
bool is_role_word(std::string_view word) {
  if (word.size() > 1 && word.ends_with('n')) word.remove_suffix(1);
  return word.find_first_not_of("ABCDO") == std::string_view::npos;
}

std::string list(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) text.append(text.empty() ? "(" : ", ").append(number(value));
  return text += ")";
}

}  // namespace

std::string number(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.8g", value == 0 ? 0.0 : value);  // == 0 for -0 too
  std::string text = digits;
  for (std::size_t at = 0; (at = text.find('-', at)) != std::string::npos;) text.replace(at, 1, "−");
  return text;
}

std::string vector(const Point& value) { return list({value.x(), value.y()}); }

std::string vector_in_space(const Point& value) { return list({value.x(), value.y(), value.z()}); }

Letters::Letters(const Simplex& simplex, const LabelledHull& hull) {
  for (int i = 0; i < simplex.size(); ++i) names_[simplex.size() - 1 - i] = hull.name(simplex[i].w);
}

std::string Letters::translate(std::string_view text) const {
  std::string out;
  while (!text.empty()) {
    const auto end = std::ranges::find_if(text, [&](char c) { return is_letter(c) != is_letter(text.front()); });
    const std::string_view word(text.begin(), end);
    text.remove_prefix(word.size());
    if (!is_role_word(word)) {
      out += word;
      continue;
    }
    for (const char c : word) {
      const auto role = roles.find(c);
      out += role != std::string_view::npos ? names_[role] : c == 'n' ? "_n" : std::string(1, c);
    }
  }
  return out;
}

std::string Letters::feature(std::string_view feature_roles) const {
  std::vector<std::string> sorted;
  for (const char c : feature_roles) sorted.push_back(names_[roles.find(c)]);
  std::ranges::sort(sorted);
  std::string out;
  for (const std::string& name : sorted) out += name;
  return out;
}

std::string list_of_names(const Simplex& simplex, const LabelledHull& hull) {
  std::string names;
  for (int i = 0; i < simplex.size(); ++i) names += (i ? ", " : "") + hull.name(simplex[i].w);
  return std::string("[").append(names).append("]");
}

std::string plain(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.substr(i).starts_with("\\_"))
      out += text[++i];
    else if (text[i] != '_' && text[i] != '{' && text[i] != '}')
      out += text[i];
  }
  return out;
}

}  // namespace walkthroughs
