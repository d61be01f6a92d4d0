#include "walkthroughs/trace/trace_nearest.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "core/nearest.hpp"

namespace walkthroughs {
namespace {

using gjk::Relation;
using gjk::Role;
using gjk::Verdict;
using Told = std::vector<gjk::RegionTested<double>>;

constexpr RuleStep asks_on{};
constexpr RuleStep contains_origin{.is_end = true};

/// Words of the edge AX, and what is kept of it.
struct Edge {
  std::string_view name, toward, direction, kept;
};
constexpr std::array<Edge, 4> edges{
    {{}, {"AB", "AB·AO", "AB×AO×AB", "BA"}, {"AC", "AC·AO", "AC×AO×AC", "CA"}, {"AD", "AD·AO", "AD×AO×AD", "DA"}}};
constexpr const Edge& edge(Role X) { return edges[static_cast<std::size_t>(X)]; }

/// Words of the edge AX in the plane of AX and AY.
struct EdgeOfFace {
  Role X, Y;
  std::string_view face, expression, formula;
};
constexpr std::array<EdgeOfFace, 6> edges_of_faces{{{Role::B, Role::C, "ABC", "ABn·AO", "AB×ABCn"},
                                                    {Role::C, Role::B, "ABC", "ACn·AO", "ABCn×AC"},
                                                    {Role::C, Role::D, "ACD", "ACn·AO", "AC×ACDn"},
                                                    {Role::D, Role::C, "ACD", "ADn·AO", "ACDn×AD"},
                                                    {Role::D, Role::B, "ADB", "ADn·AO", "AD×ADBn"},
                                                    {Role::B, Role::D, "ADB", "ABn·AO", "ADBn×AB"}}};

struct FaceWords {
  Role P;
  std::string_view name, normal, expression, formula, kept;
};
constexpr std::array<FaceWords, 3> faces{{{Role::B, "ABC", "ABCn", "ABCn·AO", "AB×AC", "CBA"},
                                          {Role::C, "ACD", "ACDn", "ACDn·AO", "AC×AD", "DCA"},
                                          {Role::D, "ADB", "ADBn", "ADBn·AO", "AD×AB", "BDA"}}};

struct Skipped {
  std::string_view feature, label = {};
};
constexpr Skipped behind_segment[] = {{"B", "R1"}};
constexpr Skipped behind_triangle[] = {{"B", "R4"}, {"BC", "R5"}, {"C", "R6"}};
constexpr Skipped behind_tetrahedron[] = {{"B"}, {"C"}, {"D"}, {"BC"}, {"CD"}, {"DB"}, {"BCD"}};
std::span<const Skipped> behind(int size) {
  if (size == 2) return behind_segment;
  if (size == 3) return behind_triangle;
  return behind_tetrahedron;
}

/// Answers as nearest_with_A() asks for them. The first that has not been told yet is what must be told next; what is answered
/// in its place does not matter.
class Answers {
 public:
  Answers(const Told& told, int size) : told_(told), size_(size) {}

  bool is_toward(Role X) const {
    const RuleRow row{.feature = edge(X).name,
                      .expression = edge(X).toward,
                      .formula = edge(X).name,
                      .rejected = asks_on,
                      .possible = asks_on};
    return answer(row);
  }
  bool is_beyond(Role X, Role Y) const {
    const EdgeOfFace& words = *std::ranges::find_if(edges_of_faces, [=](auto& e) { return e.X == X && e.Y == Y; });
    RuleRow row{.feature = edge(X).name,
                .face = size_ == 4 ? words.face : "",
                .expression = words.expression,
                .formula = words.formula,
                .relation = Relation::not_negative,
                .rejected = asks_on};
    if (size_ == 3) row.label = X == Role::B ? "R3" : "R7";
    (is_settled(X, Y) ? row.chosen : row.possible) = asks_on;
    return answer(row);
  }
  bool is_above(Role X, Role, Role) const {
    const FaceWords& face = *std::ranges::find(faces, X, &FaceWords::P);
    return answer({.feature = face.name,
                   .expression = face.expression,
                   .formula = face.formula,
                   .chosen = RuleStep{.is_end = true, .kept = face.kept, .direction = face.normal},
                   .rejected = asks_on});
  }

  const std::optional<RuleRow>& missing() const { return missing_; }

 private:
  const gjk::RegionTested<double>* find(const RuleRow& row) const {
    const auto found = std::ranges::find_if(
        told_, [&](const auto& each) { return each.face == row.face && each.expression == row.expression; });
    return found == told_.end() ? nullptr : &*found;
  }
  bool answer(const RuleRow& row) const {
    if (const auto* known = find(row)) return known->verdict != Verdict::rejected;
    if (!missing_) missing_ = row;
    return false;
  }
  /// Returns: whether a yes to "beyond AX in the plane of AX and AY" leaves nothing to be asked of the edge.
  bool is_settled(Role X, Role Y) const {
    const auto is_yes = [&](std::string_view face, std::string_view expression) {
      const auto* known = find({.feature = {}, .face = face, .expression = expression});
      return known && known->verdict != Verdict::rejected;
    };
    if (!is_yes("", edge(X).toward)) return false;
    return std::ranges::all_of(edges_of_faces, [&](const EdgeOfFace& other) {
      return other.X != X || other.Y == Y || static_cast<int>(other.Y) >= size_ || is_yes(other.face, other.expression);
    });
  }

  const Told& told_;
  const int size_;
  mutable std::optional<RuleRow> missing_;
};

std::vector<RuleRow> zero_or_not(RuleRow row, RuleStep unless_zero) {
  RuleRow other = row;
  row.relation = Relation::zero;
  row.chosen = contains_origin;
  other.relation = Relation::not_zero;
  other.chosen = unless_zero;
  return {row, other};
}

std::vector<RuleRow> rows_for_A(int size) {
  return zero_or_not({.feature = "A", .label = size == 4 ? "" : "R2", .expression = "AO"},
                     {.is_end = true, .kept = "A", .direction = "AO"});
}

std::vector<RuleRow> rows_for_edge(Role X, int size) {
  std::vector<RuleRow> rows =
      zero_or_not({.feature = edge(X).name, .expression = edge(X).direction},
                  {.is_end = true, .kept = size == 2 ? "" : edge(X).kept, .direction = edge(X).direction});
  if (size == 2) rows[1].label = "R3 or R4";
  return rows;
}

std::vector<RuleRow> rows_for_triangle() {
  std::vector<RuleRow> rows(3, {.feature = "ABC", .label = "R1", .expression = "ABCn·AO", .formula = "AB×AC"});
  rows[0].relation = Relation::zero;
  rows[0].chosen = contains_origin;
  rows[1].relation = Relation::positive;
  rows[1].chosen = RuleStep{.is_end = true, .direction = "ABCn"};
  rows[2].relation = Relation::negative;
  rows[2].chosen = RuleStep{.is_end = true, .kept = "CAB", .direction = "−ABCn"};
  return rows;
}

}  // namespace

std::vector<RuleRow> complete_rows(const Told& told, int size) {
  if (const auto left_behind = behind(size); told.size() < left_behind.size()) {
    const Skipped& next = left_behind[told.size()];
    return {{.feature = next.feature, .label = next.label, .skipped = asks_on}};
  }
  const Answers answers(told, size);
  const gjk::Order kept = gjk::detail::nearest_with_A(answers, size);
  if (answers.missing()) return {*answers.missing()};
  switch (kept.end() - kept.begin()) {
    case 1: return rows_for_A(size);
    case 2: return rows_for_edge(*kept.begin(), size);
    case 3: return rows_for_triangle();  // a face of a tetrahedron has ended the step
    default: return {{.feature = "ABCD", .chosen = contains_origin}};
  }
}

}  // namespace walkthroughs
