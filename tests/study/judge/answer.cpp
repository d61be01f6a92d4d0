#include "tests/study/judge/answer.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "core/certified/check.hpp"
#include "tests/study/truth/proofs.hpp"
#include "walkthroughs/text/document.hpp"
#include "walkthroughs/text/printable.hpp"

namespace study {
namespace {

using walkthroughs::text::Document;
using walkthroughs::text::Value;
using Kind = Document::Kind;

// -- What is said -----------------------------------------------------------------------------------------------------

Said said_by(const Value& value) {
  if (value.is(Kind::boolean)) return value.is_true() ? Said::intersecting : Said::separated;
  if (!value.is(Kind::string)) return Said::nothing;
  if (value.text() == "intersecting") return Said::intersecting;
  if (value.text() == "separated") return Said::separated;
  return value.text() == "undecided" ? Said::undecided : Said::nothing;
}

// -- Numbers ----------------------------------------------------------------------------------------------------------

/// Fractions of hostile length take hostile time.
constexpr std::size_t most_digits = 2000;

/// Returns: the number, or "p/q", if it is one.
std::optional<Rational> rational_in(const Value& value) {
  if (value.is(Kind::number))
    return std::isfinite(value.number()) ? std::optional(Rational(value.number())) : std::nullopt;
  if (!value.is(Kind::string) || value.text().size() > most_digits) return std::nullopt;
  const std::string& text = value.text();
  const std::size_t slash = text.find('/');
  const auto is_whole = [](std::string_view part, bool may_be_negative) {
    if (may_be_negative && part.starts_with('-')) part.remove_prefix(1);
    return !part.empty() && part.find_first_not_of("0123456789") == std::string_view::npos;
  };
  if (!is_whole(std::string_view(text).substr(0, slash), true)) return std::nullopt;
  if (slash == std::string::npos) return Rational(text);
  const std::string below = text.substr(slash + 1);
  if (!is_whole(below, false) || below.find_first_not_of('0') == std::string::npos) return std::nullopt;
  return Rational(text);
}

std::optional<RationalVec> vector_in(const Value& value) {
  const std::vector<Value> numbers = value.children();
  if (!value.is(Kind::list) || numbers.size() != 3) return std::nullopt;
  RationalVec vector;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto number = rational_in(numbers[i]);
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

/// Of round bodies a simplex proves nothing either way: its points are rounded.
Evidence simplex_evidence(const Value& value, const Pair& pair) {
  const auto *a = std::get_if<Points>(&pair.a), *b = std::get_if<Points>(&pair.b);
  if (!a || !b) return Evidence::none;
  const auto of = index_pairs_in(value);
  return evidence_if(of && some_part_holds_origin(*of, gjk::PointSet<double>(*a), gjk::PointSet<double>(*b)));
}

Evidence nearest_evidence(const Value& value, const Pair& pair) {
  const auto *a = std::get_if<Points>(&pair.a), *b = std::get_if<Points>(&pair.b);
  if (!a || !b) return Evidence::none;
  const auto of = index_pairs_in(value);
  if (!of || of->size() > 3) return Evidence::proves_nothing;
  gjk::SeparatingFeature feature;
  for (const gjk::IndexPair each : *of) feature.of.add(each);
  return evidence_if(gjk::holds(feature, gjk::PointSet<double>(*a), gjk::PointSet<double>(*b)));
}

Evidence evidence_in(const Value& object, Said said, const Pair& pair) {
  if (said == Said::separated) {
    if (const auto direction = object.member("direction")) {
      const auto d = vector_in(*direction);
      return evidence_if(d && separates(*d, pair));
    }
    if (const auto nearest = object.member("nearest")) return nearest_evidence(*nearest, pair);
  }
  if (said == Said::intersecting) {
    if (const auto simplex = object.member("simplex")) return simplex_evidence(*simplex, pair);
    if (const auto point = object.member("point")) {
      const auto p = vector_in(*point);
      return evidence_if(p && contains(pair.a, *p) && contains(pair.b, *p));
    }
  }
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
  if (!root.is(Kind::object)) {
    const Said said = said_by(root);
    return {said, Evidence::none, said == Said::nothing ? "neither true, false nor a status" : ""};
  }
  const auto status = root.member("status");
  const Said said = status ? said_by(*status) : Said::nothing;
  if (said != Said::nothing) return {said, evidence_beside(root, said, pair), ""};
  const std::string complaint = complaint_in(root);
  if (!complaint.empty()) return {said, Evidence::none, complaint};
  return {said, Evidence::none, status ? "a status that is not known" : "no \"status\""};
}

}  // namespace

ProgramAnswer read_answer(std::string_view line, const Pair& pair) {
  const std::size_t first = line.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {.why = "a blank line"};
  const std::string_view words = line.substr(first, line.find_last_not_of(" \t\r") + 1 - first);
  if (words == "True" || words == "False")
    return {.why = std::string(words) + " is no JSON: write true or false, in Python print(json.dumps(answer))"};
  const Document document = Document::of_line(line);
  if (document.complaint()) return {.why = "no JSON: " + document.complaint()->reason};
  return answer_in(document.root(), pair);
}

}  // namespace study
