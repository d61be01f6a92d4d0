#include "walkthroughs/trace/trace_rules.hpp"

#include <array>
#include <span>

namespace walkthroughs {
namespace {

using gjk::Relation;

constexpr RuleStep look_at(int place) { return {.place = place}; }
constexpr RuleStep contains_origin() { return {.is_end = true}; }
constexpr RuleStep keep_all(std::string_view direction) { return {.is_end = true, .direction = direction}; }
constexpr RuleStep keep(std::string_view kept, std::string_view direction) {
  return {.is_end = true, .kept = kept, .direction = direction};
}

constexpr RuleRow skip(int place, std::string_view feature, std::string_view label = {}) {
  return {.place = place, .feature = feature, .label = label, .skipped = look_at(place + 1)};
}

/// A region that is all that is left, whatever the value: the relations of its rows exclude each other.
constexpr RuleRow left(int place, std::string_view feature, std::string_view label, std::string_view expression,
                       std::string_view formula, Relation relation, RuleStep chosen) {
  return {.place = place,
          .feature = feature,
          .label = label,
          .expression = expression,
          .formula = formula,
          .relation = relation,
          .chosen = chosen};
}

struct Test {
  std::string_view feature, label, expression, formula, face = {};
};

/// Does the origin lie on the side that a normal points to?
constexpr RuleRow sees(int place, const Test& test, RuleStep chosen, RuleStep rejected) {
  return {.place = place,
          .feature = test.feature,
          .label = test.label,
          .face = test.face,
          .expression = test.expression,
          .formula = test.formula,
          .relation = Relation::positive,
          .chosen = chosen,
          .rejected = rejected};
}

constexpr std::array algorithm_2{left(0, "A", "", "AO", "", Relation::zero, contains_origin()),
                                 left(0, "A", "", "AO", "", Relation::not_zero, keep_all("AO"))};

constexpr std::array algorithm_3{skip(0, "B", "R1"), skip(1, "A", "R2"),
                                 left(2, "AB", "", "AB×AO×AB", "", Relation::zero, contains_origin()),
                                 left(2, "AB", "R3 or R4", "AB×AO×AB", "", Relation::not_zero, keep_all("AB×AO×AB"))};

constexpr std::array algorithm_4{skip(0, "B", "R4"),
                                 skip(1, "BC", "R5"),
                                 skip(2, "C", "R6"),
                                 skip(3, "A", "R2"),
                                 sees(4, {"AB", "R3", "ABn·AO", "AB×ABCn"}, keep("BA", "AB×AO×AB"), look_at(5)),
                                 sees(5, {"AC", "R7", "ACn·AO", "ABCn×AC"}, keep("CA", "AC×AO×AC"), look_at(6)),
                                 left(6, "ABC", "R1", "ABCn·AO", "AB×AC", Relation::zero, contains_origin()),
                                 left(6, "ABC", "R1", "ABCn·AO", "AB×AC", Relation::positive, keep_all("ABCn")),
                                 left(6, "ABC", "R1", "ABCn·AO", "AB×AC", Relation::negative, keep("CAB", "−ABCn"))};

constexpr std::array algorithm_5{
    skip(0, "B"),
    skip(1, "C"),
    skip(2, "D"),
    skip(3, "BC"),
    skip(4, "CD"),
    skip(5, "DB"),
    skip(6, "BCD"),
    skip(7, "A"),
    sees(8, {"ABC", "", "ABCn·AO", "AB×AC"}, look_at(12), look_at(9)),
    sees(9, {"ACD", "", "ACDn·AO", "AC×AD"}, look_at(14), look_at(10)),
    sees(10, {"ADB", "", "ADBn·AO", "AD×AB"}, look_at(16), look_at(11)),
    RuleRow{.place = 11, .feature = "ABCD", .chosen = contains_origin()},
    sees(12, {"AC", "", "ACn·AO", "ABCn×AC", "ABC"}, keep("CA", "AC×AO×AC"), look_at(13)),
    sees(13, {"AB", "", "ABn·AO", "AB×ABCn", "ABC"}, keep("BA", "AB×AO×AB"), keep("CBA", "ABCn")),
    sees(14, {"AD", "", "ADn·AO", "ACDn×AD", "ACD"}, keep("DA", "AD×AO×AD"), look_at(15)),
    sees(15, {"AC", "", "ACn·AO", "AC×ACDn", "ACD"}, keep("CA", "AC×AO×AC"), keep("DCA", "ACDn")),
    sees(16, {"AB", "", "ABn·AO", "ADBn×AB", "ADB"}, keep("BA", "AB×AO×AB"), look_at(17)),
    sees(17, {"AD", "", "ADn·AO", "AD×ADBn", "ADB"}, keep("DA", "AD×AO×AD"), keep("BDA", "ADBn"))};

std::span<const RuleRow> rule_for(int size) {
  switch (size) {
    case 1: return algorithm_2;
    case 2: return algorithm_3;
    case 3: return algorithm_4;
    default: return algorithm_5;
  }
}

}  // namespace

std::vector<RuleRow> rows_at(int place, int size) {
  std::vector<RuleRow> rows;
  for (const RuleRow& row : rule_for(size))
    if (row.place == place) rows.push_back(row);
  return rows;
}

}  // namespace walkthroughs
