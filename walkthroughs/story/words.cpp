#include "walkthroughs/story/words.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace walkthroughs::story {
namespace {

using gjk::Role;

bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

/// Returns: whether `word` names vertices, a vector or a normal in roles: "AB", "AO", "ABCn".
bool is_role_word(std::string_view word) {
  if (word.size() > 1 && word.ends_with('n')) word.remove_suffix(1);
  return word.find_first_not_of("ABCDO") == std::string_view::npos;
}

std::string with_digits(double value, int digits) {
  if (std::isnan(value)) return "nan";  // its sign means nothing
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.*g", digits, value == 0 ? 0.0 : value);  // == 0 for -0 too
  return with_true_minus(buffer);
}

}  // namespace

std::string with_true_minus(std::string number) {
  for (std::size_t at = 0; (at = number.find('-', at)) != std::string::npos;) number.replace(at, 1, "−");
  return number;
}

std::string number(double value) {
  return with_digits(value, value == std::round(value) && std::abs(value) < 1e8 ? 8 : 6);
}

std::string short_number(double value) { return with_digits(value, value == std::round(value) ? 6 : 4); }

std::string vector(const Point& value, Dimension dimension) {
  return "(" + joined(value.head(dimension == Dimension::plane ? 2 : 3), ", ", number) + ")";
}

std::string as_zero(double value) { return value == 0 ? "" : ", which counts as 0"; }

std::string compared_with_zero(const gjk::RegionTested<double>& region, double value) {
  if (region.verdict == gjk::Verdict::rejected && region.relation == gjk::Relation::not_negative) return " < 0";
  if (region.verdict == gjk::Verdict::rejected) return value > 0 ? as_zero(value) : value == 0 ? "" : " ≤ 0";
  switch (region.relation) {
    case gjk::Relation::positive: return " > 0";
    case gjk::Relation::negative: return " < 0";
    case gjk::Relation::zero: return as_zero(value);
    case gjk::Relation::not_zero: return " ≠ 0";
    case gjk::Relation::not_negative: return value < 0 ? as_zero(value) : " ≥ 0";
  }
  return "";
}

/// Returns: the reason as a trace has it; where that leaves a reader asking, what follows from it instead.
std::string reason_told(const gjk::RegionTested<double>& region) {
  switch (region.reason.is) {
    case gjk::RegionReason::crossed_on_the_way:
      return "if the origin were beyond A, the test A·d < 0 would have ended the search";
    case gjk::RegionReason::nearer_with_A: return reason_in_words(region) + ", so what is nearest has A in it";
    default: return reason_in_words(region);
  }
}

std::vector<std::pair<std::string, std::string>> reasons_for_skipping(
    const std::vector<gjk::RegionTested<double>>& regions,
    const std::function<std::string(const gjk::Roles&)>& feature) {
  std::vector<std::pair<std::string, std::string>> reasons;  // and the regions that each is for
  for (const gjk::RegionTested<double>& region : regions) {
    if (region.verdict != gjk::Verdict::skipped) continue;
    const gjk::RegionLabel label = label_of(region);
    const std::string name = label == gjk::RegionLabel::none ? feature(region.feature) : std::string(to_string(label));
    const std::string reason = reason_told(region);
    const auto known = std::ranges::find(reasons, reason, &std::pair<std::string, std::string>::first);
    if (known == reasons.end())
      reasons.emplace_back(reason, name);
    else
      known->second += ", " + name;
  }
  return reasons;
}

std::vector<std::string> differences_told(const gjk::IndexPairs& pairs) {
  std::vector<std::string> told;
  for (const gjk::IndexPair pair : pairs)
    told.push_back("a[" + std::to_string(pair.a) + "] − b[" + std::to_string(pair.b) + "]");
  return told;
}

std::string with_brackets(const gjk::Expression& expression) {
  using Form = gjk::Expression::Form;
  if (expression.form != Form::triple) return to_string(expression);
  return "(" + to_string(gjk::Expression(Form::product, expression.X, expression.Y)) + ")×" + to_string(expression.X);
}

std::string Names::of(Role role) const {
  if (naming_ == Naming::roles) return std::string(1, gjk::letter(role));
  return static_cast<int>(role) < now_.processed.size() ? own_name(now_.processed.point(role)) : "";
}

std::string Names::own_name(const Point& w) const {
  if (naming_ == Naming::corners) return hull_.name(w);
  const auto found = std::ranges::find(now_.known, w);
  if (found == now_.known.end()) return "";
  const auto index = found - now_.known.begin();
  const std::string letter(1, static_cast<char>('A' + index % 26));
  return index < 26 ? letter : letter + std::to_string(index / 26 + 1);  // A … Z, A2 … Z2
}

std::string Names::of(const Point& w) const {
  if (naming_ != Naming::roles) return own_name(w);
  if (now_.found && !now_.added && now_.found->w == w) return "P";
  for (int i = 0; i < now_.processed.size(); ++i)
    if (const Role role = static_cast<Role>(i); now_.processed.point(role) == w) return of(role);
  return "";
}

std::string Names::before(const Point& w) const {
  if (naming_ != Naming::roles || w == now_.processed.point(Role::A)) return "";
  for (int i = 0; i < now_.before.size(); ++i)
    if (const Role role = static_cast<Role>(i); now_.before.point(role) == w) {
      const std::string name = of(role);
      return name == of(w) ? "" : name;
    }
  return "";
}

std::string Names::label(const Point& w) const {
  if (naming_ != Naming::roles) return own_name(w);
  std::vector<std::string> names;
  if (now_.found && !now_.added && now_.found->w == w) names.emplace_back("P");
  for (int i = 0; i < now_.processed.size(); ++i)
    if (const Role role = static_cast<Role>(i); now_.processed.point(role) == w) names.push_back(of(role));
  return joined(names, " = ");
}

std::string Names::sorted(const gjk::Roles& roles) const {
  std::vector<std::string> names;
  for (const Role role : roles) names.push_back(of(role));
  if (naming_ != Naming::roles) std::ranges::sort(names);  // the report writes faces of the simplex as ACD, ADB
  return joined(names, "");
}

std::string Names::translate(std::string_view text) const {
  std::string out;
  while (!text.empty()) {
    const auto end = std::ranges::find_if(text, [&](char c) { return is_letter(c) != is_letter(text.front()); });
    const std::string_view word(text.begin(), end);
    text.remove_prefix(word.size());
    if (!is_role_word(word)) {
      out += word;
      continue;
    }
    for (const char c : word) out += c == 'O' ? "O" : c == 'n' ? "_n" : of(*gjk::role_named(c));
  }
  return out;
}

/// Vertices at one place share their roles out among them, the oldest taking the last.
std::vector<std::string> Names::names_of(const Simplex& simplex) const {
  std::vector<std::string> names;
  for (int i = 0; i < simplex.size(); ++i) {
    std::string name = of(simplex[i].w);
    for (int role = now_.processed.size() - 1; naming_ == Naming::roles && role >= 0; --role) {
      const std::string other = of(static_cast<Role>(role));
      if (now_.processed.point(static_cast<Role>(role)) != simplex[i].w || std::ranges::count(names, other)) continue;
      name = other;
      break;
    }
    names.push_back(name);
  }
  return names;
}

std::string Names::list(const Simplex& simplex) const { return "[" + joined(names_of(simplex), ", ") + "]"; }

std::string Names::simplex(const Simplex& simplex) const {
  std::vector<std::string> names = names_of(simplex);
  std::ranges::sort(names);
  return with_kind(joined(names, ""));
}

std::string with_kind(const std::string& feature) {
  const char* const kinds[] = {"", "", "segment ", "triangle ", "tetrahedron "};
  return kinds[std::min<std::size_t>(feature.size(), 4)] + feature;
}

std::string as_sentence(std::string text) {
  const auto is_small = [&](std::size_t i) { return i < text.size() && 'a' <= text[i] && text[i] <= 'z'; };
  if (is_small(0) && is_small(1)) text[0] += 'A' - 'a';
  return text;
}

std::string with_article(const std::string& name) {
  if (name.size() == 1 || (!name.empty() && 'A' <= name[0] && name[0] <= 'Z')) return name;
  return (std::string("aeiou").find(name[0]) == std::string::npos ? "a " : "an ") + name;
}

std::string literal(std::string_view text) {
  std::string out;
  for (const char c : text) out.append(c == '_' ? "\\_" : std::string(1, c));
  return out;
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

}  // namespace walkthroughs::story
