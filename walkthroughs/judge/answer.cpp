#include "walkthroughs/judge/answer.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "core/certified/check.hpp"
#include "walkthroughs/steps/told_run.hpp"
#include "walkthroughs/text/document.hpp"
#include "walkthroughs/text/printable.hpp"

namespace walkthroughs::judge {
namespace {

using Kind = Document::Kind;

// -- What is said -----------------------------------------------------------------------------------------------------

/// In small letters, without blanks and quotes around it.
std::string plain_word(std::string_view text) {
  constexpr std::string_view around = " \t\r\"'";
  const std::size_t first = text.find_first_not_of(around);
  if (first == std::string_view::npos) return "";
  std::string word(text.substr(first, text.find_last_not_of(around) + 1 - first));
  for (char& letter : word) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return word;
}

ProgramAnswer answer_of_distance(double distance) {
  if (!std::isfinite(distance)) return {.said = Said::not_a_number};
  return {.said = distance > 0 ? Said::separated : Said::intersecting, .distance = distance};
}

ProgramAnswer answer_of_word(const std::string& word) {
  for (const auto& [said, words] : {std::pair{Said::intersecting, std::array{"yes", "true", "intersecting"}},
                                    std::pair{Said::separated, std::array{"no", "false", "separated"}},
                                    std::pair{Said::undecided, std::array{"undecided", "undecided", "undecided"}},
                                    std::pair{Said::not_a_number, std::array{"nan", "-nan", "inf"}}})
    if (std::ranges::find(words, word) != words.end()) return {.said = said};
  if (!word.starts_with("distance ")) return {};
  const std::string number = plain_word(std::string_view(word).substr(9));
  char* end = nullptr;
  const double distance = std::strtod(number.c_str(), &end);
  return number.empty() || *end != '\0' ? ProgramAnswer{} : answer_of_distance(distance);
}

// -- Numbers ----------------------------------------------------------------------------------------------------------

/// Fractions of hostile length take hostile time.
constexpr std::size_t most_digits = 2000;

/// Returns: the number, or "p/q", if it is one.
std::optional<gjk::Fraction> fraction_in(const Value& value) {
  if (value.is(Kind::number))
    return std::isfinite(value.number()) ? std::optional(gjk::Fraction(value.number())) : std::nullopt;
  if (!value.is(Kind::string) || value.text().size() > most_digits) return std::nullopt;
  const std::string& text = value.text();
  const std::size_t slash = text.find('/');
  const auto is_whole = [](std::string_view part, bool may_be_negative) {
    if (may_be_negative && part.starts_with('-')) part.remove_prefix(1);
    return !part.empty() && part.find_first_not_of("0123456789") == std::string_view::npos;
  };
  if (!is_whole(std::string_view(text).substr(0, slash), true)) return std::nullopt;
  if (slash == std::string::npos) return gjk::Fraction(text);
  const std::string below = text.substr(slash + 1);
  if (!is_whole(below, false) || below.find_first_not_of('0') == std::string::npos) return std::nullopt;
  return gjk::Fraction(text);
}

std::optional<gjk::detail::Fractions> vector_in(const Value& value) {
  const std::vector<Value> numbers = value.children();
  if (!value.is(Kind::list) || numbers.size() != 3) return std::nullopt;
  gjk::detail::Fractions vector(3);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto number = fraction_in(numbers[i]);
    if (!number) return std::nullopt;
    vector[i] = *number;
  }
  return vector;
}

// -- Points of the difference -----------------------------------------------------------------------------------------

std::optional<int> index_in(const std::optional<Value>& value) {
  if (!value || !value->is(Kind::number) || !(value->number() >= 0 && value->number() < 1e9)) return std::nullopt;
  const int index = static_cast<int>(value->number());
  return index == value->number() ? std::optional(index) : std::nullopt;
}

std::optional<gjk::IndexPair> index_pair_in(const Value& value) {
  const std::vector<Value> two = value.children();
  const bool is_list = value.is(Kind::list);
  if (is_list && two.size() != 2) return std::nullopt;
  const auto a = index_in(is_list ? two[0] : value.member("a_index"));
  const auto b = index_in(is_list ? two[1] : value.member("b_index"));
  return a && b ? std::optional(gjk::IndexPair{*a, *b}) : std::nullopt;
}

/// Returns: one to four of them, if that is what it says.
std::optional<std::vector<gjk::IndexPair>> index_pairs_in(const Value& value) {
  const std::vector<Value> list = value.children();
  if (!value.is(Kind::list) || list.empty() || list.size() > 4) return std::nullopt;
  std::vector<gjk::IndexPair> pairs;
  for (const Value& each : list) {
    const auto pair = index_pair_in(each);
    if (!pair) return std::nullopt;
    pairs.push_back(*pair);
  }
  return pairs;
}

/// A simplex may be flat: then a part of it that is not has the origin in its hull, if the whole has.
bool some_part_holds_origin(const std::vector<gjk::IndexPair>& of, const gjk::PointSet<double>& a,
                            const gjk::PointSet<double>& b) {
  for (unsigned part = 1; part < 1U << of.size(); ++part) {
    gjk::CommonSimplex simplex;
    for (std::size_t i = 0; i < of.size(); ++i)
      if (part >> i & 1) simplex.of.add(of[i]);
    if (gjk::holds(simplex, a, b)) return true;
  }
  return false;
}

// -- Evidence ---------------------------------------------------------------------------------------------------------

Evidence evidence_if(bool holds) { return holds ? Evidence::holds : Evidence::proves_nothing; }

Evidence simplex_evidence(const Value& value, const gjk::PointSet<double>& a, const gjk::PointSet<double>& b) {
  const auto of = index_pairs_in(value);
  return evidence_if(of && some_part_holds_origin(*of, a, b));
}

Evidence nearest_evidence(const Value& value, const gjk::PointSet<double>& a, const gjk::PointSet<double>& b) {
  const auto of = index_pairs_in(value);
  if (!of || of->size() > 3) return Evidence::proves_nothing;
  gjk::SeparatingFeature feature;
  for (const gjk::IndexPair each : *of) feature.of.add(each);
  return evidence_if(gjk::holds(feature, a, b));
}

/// Of round bodies nothing is proven either way: their points are rounded.
Evidence evidence_in(const Value& object, Said said, const Pair& pair) {
  const auto points = points_of(pair);
  if (!points) return Evidence::none;
  const gjk::PointSet<double> a(points->a), b(points->b);
  if (said == Said::separated) {
    if (const auto direction = object.member("direction")) {
      const auto d = vector_in(*direction);
      return evidence_if(d && gjk::detail::separates(*d, a, b));
    }
    if (const auto nearest = object.member("nearest")) return nearest_evidence(*nearest, a, b);
  }
  if (said == Said::intersecting)
    if (const auto simplex = object.member("simplex")) return simplex_evidence(*simplex, a, b);
  return Evidence::none;
}

Evidence evidence_beside(const Value& object, Said said, const Pair& pair) {
  for (const char* const key : {"certificate", "evidence"})
    if (const auto inner = object.member(key))
      if (const Evidence found = evidence_in(*inner, said, pair); found != Evidence::none) return found;
  return evidence_in(object, said, pair);
}

/// Returns: what an object says that is no answer, such as gjkstep's own {"error": ...}.
std::string complaint_in(const Value& root) {
  if (const auto error = root.member("error"); error && error->is(Kind::string)) return error->text();
  return "";
}

ProgramAnswer answer_in(const Value& root, const Pair& pair) {
  const auto status = root.member("status"), distance = root.member("distance");
  ProgramAnswer answer;
  if (status && status->is(Kind::boolean))
    answer.said = status->is_true() ? Said::intersecting : Said::separated;
  else if (status && status->is(Kind::string))
    answer = answer_of_word(plain_word(status->text()));
  else if (!status && distance && distance->is(Kind::number))
    answer = answer_of_distance(distance->number());
  if (answer.said == Said::nothing) {
    const std::string complaint = complaint_in(root);
    answer.why = !complaint.empty() ? complaint : status ? "a status that is not known" : "no \"status\"";
  } else {
    if (distance && distance->is(Kind::number)) answer.distance = distance->number();
    answer.evidence = evidence_beside(root, answer.said, pair);
  }
  return answer;
}

bool is_object(std::string_view line) { return plain_word(line).starts_with('{'); }

}  // namespace

bool is_meant_as_answer(std::string_view line) {
  return (is_object(line) && !is_meant_as_step(line)) || answer_of_word(plain_word(line)).said != Said::nothing;
}

ProgramAnswer read_answer(std::string_view line, const Pair& pair) {
  if (!is_object(line)) {
    ProgramAnswer answer = answer_of_word(plain_word(line));
    if (answer.said == Said::nothing) answer.why = "not yes, no, undecided or distance";
    return answer;
  }
  const Document document = Document::of_line(line);
  if (document.complaint()) return {.why = "no JSON: " + document.complaint()->reason};
  return answer_in(document.root(), pair);
}

}  // namespace walkthroughs::judge
