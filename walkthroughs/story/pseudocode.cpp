#include "walkthroughs/story/pseudocode.hpp"

#include <algorithm>
#include <array>

namespace walkthroughs::story {
namespace {

using gjk::Relation;
using Kind = LineKind;

void append(std::vector<CodeLine>& code, const std::vector<CodeLine>& more) {
  code.insert(code.end(), more.begin(), more.end());
}

std::vector<CodeLine> algorithm_1(RuleSet rules) {
  const std::string missed =
      gjk::first_point(rules) == gjk::FirstPoint::tested ? "P·d < 0" : "not the first and P·d < 0";
  const bool ends = gjk::not_crossed(rules) == gjk::NotCrossed::answer_at_once;
  const bool is_complete = rules == RuleSet::complete;
  std::vector<CodeLine> code{{0, "d ← first direction, simplex ← [ ]"},
                             {0, "repeat, at most N times"},
                             {1, "P ← support(a, d) − support(b, −d)", Kind::support},
                             {1, (ends ? "if " : "missed ← ") + missed, Kind::crossing}};
  if (ends) code.push_back({2, "separated", Kind::separated});
  append(code, {{1, "P joins the simplex as its newest", Kind::add},
                {1, is_complete ? "keep its feature nearest to O" : "process it by Algorithms 2 to 5", Kind::process},
                {1, "if it contains the origin"},
                {2, "intersecting", Kind::intersecting}});
  if (!ends) append(code, {{1, "else if missed"}, {2, "separated", Kind::separated}});
  code.push_back({0, "undecided", Kind::undecided});
  return code;
}

CodeLine test(int indent, const std::string& text, const TestsOf& tests) { return {indent, text, Kind::test, tests}; }

/// "else keep [B, A],  d ← (AB×AO)×AB".
CodeLine keep(int indent, const gjk::Roles& kept, const gjk::Expression& direction, const std::string& before = "") {
  std::string list;
  for (const gjk::Role role : kept) list.append(list.empty() ? "" : ", ") += letter(role);
  return {
      indent, before + "keep [" + list + "],  d ← " + with_brackets(direction), Kind::action, {}, Way{kept, direction}};
}

/// "keep [B, A],  d ← (AB×AO)×AB".
CodeLine keep_edge(int indent, gjk::Role X) {
  return keep(indent, {X, gjk::Role::A},
              {gjk::Expression::Form::triple, gjk::NamedVector::edge(gjk::Role::A, X), gjk::AO});
}

std::vector<CodeLine> algorithm_2() {
  return {test(0, "if AO = 0", {.feature = "A", .relation = Relation::zero}),
          {1, "the origin is A", Kind::action},
          test(0, "else", {.feature = "A", .relation = Relation::not_zero}),
          keep(1, "A", "AO")};
}

std::vector<CodeLine> algorithm_3() {
  return {{0, "v ← (AB×AO)×AB"},
          test(0, "if v = 0", {.feature = "AB", .relation = Relation::zero}),
          {1, "the origin is on AB", Kind::action},
          test(0, "else (R3 or R4)", {.feature = "AB", .relation = Relation::not_zero}),
          {1, "keep [B, A],  d ← v", Kind::action}};
}

std::vector<CodeLine> algorithm_4() {
  return {{0, "ABCn ← AB×AC"},
          {0, "ABn ← AB×ABCn,  ACn ← ABCn×AC"},
          test(0, "if ABn·AO > 0 (R3)", {.feature = "AB"}),
          keep_edge(1, gjk::Role::B),
          test(0, "else if ACn·AO > 0 (R7)", {.feature = "AC"}),
          keep_edge(1, gjk::Role::C),
          {0, "else (R1)", Kind::otherwise},
          test(1, "if ABCn·AO = 0", {.feature = "ABC", .relation = Relation::zero}),
          {2, "the origin is in ABC", Kind::action},
          test(1, "if ABCn·AO > 0 (above)", {.feature = "ABC", .relation = Relation::positive}),
          keep(2, "CBA", "ABCn"),
          test(1, "if ABCn·AO < 0 (below)", {.feature = "ABC", .relation = Relation::negative}),
          keep(2, "CAB", "−ABCn")};
}

/// One face APQ of Algorithm 5.
void append_face(std::vector<CodeLine>& code, gjk::Role P, gjk::Role Q) {
  const gjk::Roles face{gjk::Role::A, P, Q}, AP{gjk::Role::A, P}, AQ{gjk::Role::A, Q};
  const gjk::NamedVector normal = gjk::NamedVector::normal(face);
  code.push_back(test(0, (code.size() > 2 ? "else if " : "if ") + to_string(normal) + "·AO > 0", {.feature = face}));
  code.push_back(test(1, "if " + to_string(AQ) + "n·AO > 0", {.feature = AQ, .face = face}));
  code.push_back(keep_edge(2, Q));
  code.push_back(test(1, "else if " + to_string(AP) + "n·AO > 0", {.feature = AP, .face = face}));
  code.push_back(keep_edge(2, P));
  code.push_back(keep(1, {Q, P, gjk::Role::A}, normal, "else "));
}

std::vector<CodeLine> algorithm_5() {
  std::vector<CodeLine> code = {{0, "ABCn ← AB×AC,  ACDn ← AC×AD"}, {0, "ADBn ← AD×AB"}};
  append_face(code, gjk::Role::B, gjk::Role::C);
  append_face(code, gjk::Role::C, gjk::Role::D);
  append_face(code, gjk::Role::D, gjk::Role::B);
  code.push_back(test(0, "else the origin is in ABCD", {.feature = "ABCD"}));
  return code;
}

/// The complete rules, for segments, triangles and tetrahedra. X and Y stand for B, C or D.
std::vector<CodeLine> nearest_feature() {
  return {{0, "for each edge AX"},
          test(1, "if AX·AO > 0", {.relation = Relation::positive, .any_of_size = 2}),
          test(2, "and AX_n·AO ≥ 0, each face at AX",
               {.relation = Relation::not_negative, .any_of_size = 2, .in_any_face = true}),
          test(3, "if (AX×AO)×AX = 0", {.relation = Relation::zero, .any_of_size = 2}),
          {4, "the origin is on AX", Kind::action},
          test(3, "else", {.relation = Relation::not_zero, .any_of_size = 2}),
          {4, "keep [X, A],  d ← (AX×AO)×AX", Kind::action},
          {0, "if no AX·AO > 0"},
          test(1, "if AO = 0", {.feature = "A", .relation = Relation::zero}),
          {2, "the origin is A", Kind::action},
          test(1, "else", {.feature = "A", .relation = Relation::not_zero}),
          keep(2, "A", "AO"),
          {0, "if it is a triangle"},
          test(1, "if ABCn·AO = 0", {.feature = "ABC", .relation = Relation::zero, .simplex_size = 3}),
          {2, "the origin is in ABC", Kind::action},
          test(1, "if ABCn·AO > 0", {.feature = "ABC", .relation = Relation::positive, .simplex_size = 3}),
          keep(2, "CBA", "ABCn"),
          test(1, "if ABCn·AO < 0", {.feature = "ABC", .relation = Relation::negative, .simplex_size = 3}),
          keep(2, "CAB", "−ABCn"),
          {0, "for each face AXY, O within its edges"},
          test(1, "if AXY_n·AO > 0", {.relation = Relation::positive, .any_of_size = 3, .simplex_size = 4}),
          {2, "keep [Y, X, A],  d ← AXY_n", Kind::action},
          test(0, "else the origin is in ABCD", {.feature = "ABCD"})};
}

/// What certified_collision() does.
std::vector<CodeLine> proofs_and_second_search() {
  return {{0, "search by Algorithm 1"},
          {0, "if apart and −P·d > error bound", Kind::direction_proof},
          {1, "separated, proven", Kind::direction_holds},
          {0, "if O is in ABCD by more than that", Kind::tetrahedron_proof},
          {1, "intersecting, proven", Kind::tetrahedron_holds},
          {0, "P ← a vertex of that search", Kind::second_start},
          {0, "repeat"},
          {1, "P joins the simplex as its newest", Kind::add},
          {1, "keep the feature nearest to O,", Kind::process},
          {1, "   each sign exact", Kind::test},
          {1, "if O is in it"},
          {2, "intersecting, proven", Kind::intersecting},
          {1, "d ← from it toward O", Kind::toward},
          {1, "P ← a vertex with P·d ≥ 0", Kind::support},
          {1, "if there is none"},
          {2, "separated, proven", Kind::separated}};
}

bool is_nearest_feature(int number, RuleSet rules) {
  return rules == RuleSet::complete && number > 2 && number < certifying;
}

LineKind kind_of_certifying(Focus focus, const Moment& now) {
  switch (focus) {
    case Focus::support: return Kind::support;
    case Focus::added: return now.simplex.size() == 1 ? Kind::second_start : Kind::add;
    case Focus::direction: return Kind::toward;
    case Focus::kept: return Kind::process;
    case Focus::sign: return now.kept ? Kind::support : Kind::test;
    case Focus::proof:
      return now.proof->proof == gjk::Proof::direction ? Kind::direction_proof : Kind::tetrahedron_proof;
    default: break;
  }
  if (now.certified->proof == gjk::Proof::direction) return Kind::direction_holds;
  if (now.certified->proof == gjk::Proof::tetrahedron) return Kind::tetrahedron_holds;
  return now.certified->status == gjk::Status::separated ? Kind::separated : Kind::intersecting;
}

/// Whether a line to which each edge comes would speak of another edge than the one that is asked about.
bool is_of_earlier_edge(const TestsOf& tests, const gjk::RegionTested<double>& region, const Moment& now) {
  const gjk::Roles& last = now.regions.back().feature;
  return tests.any_of_size == 2 && last.size() == 2 && region.feature != last;
}

LineKind kind_of(Focus focus, const Moment& now) {
  switch (focus) {
    case Focus::support: return Kind::support;
    case Focus::crossing: return Kind::crossing;
    case Focus::added: return Kind::add;
    case Focus::end:
      if (now.result->status == gjk::Status::intersecting) return Kind::intersecting;
      if (now.result->reason == gjk::Reason::origin_not_crossed) return Kind::separated;
      return now.result->reason == gjk::Reason::no_new_vertex ? Kind::support : Kind::undecided;
    default: return Kind::process;
  }
}

std::optional<std::size_t> place_of(const std::vector<CodeLine>& code, LineKind kind) {
  const auto line = std::ranges::find(code, kind, &CodeLine::kind);
  if (line == code.end()) return std::nullopt;
  return static_cast<std::size_t>(line - code.begin());
}

/// Returns: the last line whose test has been made; tests are made from top to bottom.
std::optional<std::size_t> last_test(const std::vector<CodeLine>& code, const Moment& now) {
  std::optional<std::size_t> last;
  for (std::size_t i = 0; i < code.size(); ++i)
    if (const auto* test = test_of(code[i], now); test && test == &now.regions.back()) last = i;
  return last;
}

/// Returns: the action after test line `at`: the next one, or where its last test was rejected, the "else" that follows.
std::optional<std::size_t> action_after(const std::vector<CodeLine>& code, std::size_t at, const Moment& now) {
  const bool rejected = now.regions.back().verdict == gjk::Verdict::rejected;
  for (std::size_t i = at + 1, skipped = 0; i < code.size(); ++i)
    if (code[i].kind == Kind::action && skipped++ == (rejected ? 1U : 0U)) return i;
  return std::nullopt;
}

std::string name_of_algorithm(int number, RuleSet rules) {
  if (number == certifying) return "Certified";
  return is_nearest_feature(number, rules) ? "Nearest feature" : "Algorithm " + std::to_string(number);
}

}  // namespace

const std::vector<CodeLine>& algorithm(int number, RuleSet rules) {
  static const std::array<std::vector<CodeLine>, 4> others = {algorithm_2(), algorithm_3(), algorithm_4(),
                                                              algorithm_5()};
  static const auto first = [] {
    std::array<std::vector<CodeLine>, gjk::rule_sets.size()> each;
    for (std::size_t i = 0; i < each.size(); ++i) each[i] = algorithm_1(gjk::rule_sets[i].value);
    return each;
  }();
  static const std::vector<CodeLine> complete = nearest_feature();
  static const std::vector<CodeLine> certified = proofs_and_second_search();
  if (number == 1) return first.at(static_cast<std::size_t>(rules));
  if (number == certifying) return certified;
  return is_nearest_feature(number, rules) ? complete : others.at(static_cast<std::size_t>(number - 2));
}

int running_algorithm(const Moment& now, Focus focus) {
  if (now.in_exact_fallback || now.certified || focus == Focus::proof) return certifying;
  const bool processing =
      focus == Focus::region || focus == Focus::reduction || focus == Focus::direction || focus == Focus::repetition;
  return processing ? now.processed.size() + 1 : 1;
}

const gjk::RegionTested<double>* test_of(const CodeLine& line, const Moment& now) {
  if (line.kind != Kind::test) return nullptr;
  const TestsOf& tests = line.tests;
  const auto is_its_own = [&](const gjk::RegionTested<double>& region) {
    const bool is_feature =
        tests.any_of_size > 0 ? region.feature.size() == tests.any_of_size : region.feature == tests.feature;
    return region.verdict != gjk::Verdict::skipped && (tests.in_any_face || region.face == tests.face) && is_feature &&
           (!tests.relation || *tests.relation == region.relation) &&
           (tests.simplex_size == 0 || tests.simplex_size == region.simplex_size) &&
           !is_of_earlier_edge(tests, region, now);
  };
  const auto last = std::find_if(now.regions.rbegin(), now.regions.rend(), is_its_own);
  return last == now.regions.rend() ? nullptr : &*last;
}

std::optional<std::size_t> current_line(const std::vector<CodeLine>& code, const Moment& now, Focus focus) {
  const int number = running_algorithm(now, focus);
  if (number == certifying) return place_of(code, kind_of_certifying(focus, now));
  if (number == 1) return place_of(code, kind_of(focus, now));
  const std::optional<std::size_t> tested = last_test(code, now);
  if (focus == Focus::region || !tested) return tested;
  return action_after(code, *tested, now);
}

std::string outcome(const gjk::RegionTested<double>& test, bool with_value) {
  const double* value = with_value ? std::get_if<double>(&test.value) : nullptr;
  return (value ? "= " + short_number(*value) + " " : "") + (test.verdict == gjk::Verdict::rejected ? "✗" : "✓");
}

std::string title_of(int number, RuleSet rules, const Names& names, const Simplex& simplex) {
  const std::string title = name_of_algorithm(number, rules);
  const std::string newest = number == 1 || simplex.size() == 0 ? "A" : names.of(gjk::Role::A);
  return newest == "A" ? title : title + ", its A is " + newest;
}

std::string line_in_letters(int number, const CodeLine& line, const Names& names) {
  return number == 1 ? line.text : names.translate(line.text);
}

}  // namespace walkthroughs::story
