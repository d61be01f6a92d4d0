#include "walkthroughs/trace/trace_mistakes.hpp"

#include <algorithm>
#include <optional>

namespace walkthroughs {
namespace {

using gjk::Relation;
using wrong_on_purpose::Mistake;

constexpr RuleStep contains_origin{.is_end = true};
constexpr RuleStep below_triangle{.is_end = true, .kept = "CAB", .direction = "−ABCn"};

RuleStep keep_all(std::string_view direction) { return {.is_end = true, .direction = direction}; }

// -- One row ----------------------------------------------------------------------------------------------------------

void reverse_normal(RuleRow& row, std::string_view feature, std::string_view formula) {
  if (row.feature == feature && row.face.empty()) row.formula = formula;
}

void take_normal_of(RuleRow& row, std::string_view face, std::string_view feature, std::string_view formula) {
  if (row.face == face && row.feature == feature) row.formula = formula;
}

/// Of an edge beyond which the origin lies.
void search_from_edge_along(RuleRow& row, std::string_view direction) {
  if (row.chosen && row.chosen->direction.find("×AO×") != std::string_view::npos) row.chosen->direction = direction;
}

void change(RuleRow& row, Mistake mistake, int size) {
  const bool is_triangle = size == 3 && row.feature == "ABC";
  switch (mistake) {
    case Mistake::origin_at_vertex_missed:
      if (size == 1) row.chosen = keep_all("AO");
      return;
    case Mistake::origin_on_segment_missed:
      if (size != 2 || row.feature != "AB") return;
      row.label = "R3 or R4";
      row.chosen = keep_all("AB×AO×AB");
      return;
    case Mistake::direction_from_vertex:
      if (size == 2 && row.feature == "AB") row.expression = "AO";
      return search_from_edge_along(row, "AO");
    case Mistake::triangle_normal_reversed:
      if (size == 3) reverse_normal(row, "ABC", "AC×AB");
      return;
    case Mistake::triangle_abn_inward:
      if (size == 3) reverse_normal(row, "AB", "ABCn×AB");
      return;
    case Mistake::triangle_acn_inward:
      if (size == 3) reverse_normal(row, "AC", "AC×ABCn");
      return;
    case Mistake::edge_normal_as_direction:
      if (size > 2) search_from_edge_along(row, row.expression.substr(0, row.expression.find("·")));
      return;
    case Mistake::two_dimensions_only:
      if (is_triangle) row.chosen = contains_origin;
      return;
    case Mistake::origin_in_triangle_missed:
      if (is_triangle && row.relation == Relation::zero) row.chosen = below_triangle;
      return;
    case Mistake::order_kept_below_triangle:
      if (is_triangle && row.relation == Relation::negative) row.chosen->kept = "CBA";
      return;
    case Mistake::abcn_inward:
      if (size == 4) reverse_normal(row, "ABC", "AC×AB");
      return;
    case Mistake::acdn_inward: return reverse_normal(row, "ACD", "AD×AC");
    case Mistake::adbn_inward: return reverse_normal(row, "ADB", "AB×AD");
    case Mistake::edge_normals_reused:
      take_normal_of(row, "ACD", "AC", "ABCn×AC");
      return take_normal_of(row, "ADB", "AD", "ACDn×AD");
    case Mistake::abn_reused_for_adb: return take_normal_of(row, "ADB", "AB", "AB×ABCn");
    case Mistake::order_of_adb:
      if (row.face == "ADB" && row.rejected->kept == "BDA") row.rejected->kept = "DBA";
      return;
    case Mistake::wrong_side_of_b:
    case Mistake::first_point_tested:
    case Mistake::touching_is_apart:
    case Mistake::as_printed:
    case Mistake::origin_in_face_seen_outside: return;
  }
}

/// A face that sees the origin may also hold it.
void add_origin_in_face(std::vector<RuleRow>& rows) {
  const RuleRow row = rows.front();
  if (row.feature.size() != 3 || !row.face.empty() || !row.chosen) return;
  rows.push_back(row);
  rows.back().relation = Relation::zero;
  rows.back().rejected.reset();
}

}  // namespace

void make_mistake(Mistake mistake, int size, std::vector<RuleRow>& rows) {
  for (RuleRow& row : rows) change(row, mistake, size);
  if (mistake == Mistake::origin_in_face_seen_outside && size == 4) add_origin_in_face(rows);
}

std::string with_reversed_normals(std::string expression, Mistake mistake, int size) {
  const auto reverse = [&](std::string_view normal, std::string_view reversed) {
    if (const std::size_t at = expression.find(normal); at != std::string::npos)
      expression.replace(at, normal.size(), reversed);
  };
  if (mistake == Mistake::triangle_normal_reversed && size == 3) reverse("ABCn", "ACBn");
  if (mistake == Mistake::abcn_inward && size == 4) reverse("ABCn", "ACBn");
  if (mistake == Mistake::acdn_inward) reverse("ACDn", "ADCn");
  if (mistake == Mistake::adbn_inward) reverse("ADBn", "ABDn");
  return expression;
}

std::string formula_of(const std::string& direction, Mistake mistake,
                       const std::vector<gjk::RegionTested<double>>& told) {
  if (mistake == Mistake::edge_normal_as_direction && direction.size() == 3)  // "ABn", the normal of the region chosen
    return told.back().formula;
  return with_reversed_normals(direction, mistake, told.back().simplex_size);
}

}  // namespace walkthroughs
