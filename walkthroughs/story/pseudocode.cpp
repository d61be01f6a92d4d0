#include "walkthroughs/story/pseudocode.hpp"

#include <algorithm>
#include <array>

namespace walkthroughs {
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
  append(code, {{1, "P joins the simplex and becomes A", Kind::add},
                {1, is_complete ? "keep its feature nearest to O" : "process it by Algorithms 2 to 5", Kind::process},
                {1, "if it contains the origin"},
                {2, "intersecting", Kind::intersecting}});
  if (!ends) append(code, {{1, "else if missed"}, {2, "separated", Kind::separated}});
  code.push_back({0, "undecided", Kind::undecided});
  return code;
}

std::vector<CodeLine> algorithm_2() {
  return {{0, "if AO = 0", Kind::test, "", "A", Relation::zero},
          {1, "the origin is A", Kind::action},
          {0, "else", Kind::test, "", "A", Relation::not_zero},
          {1, "keep [A],  d ← AO", Kind::action}};
}

std::vector<CodeLine> algorithm_3() {
  return {{0, "v ← AB×AO×AB"},
          {0, "if v = 0", Kind::test, "", "AB", Relation::zero},
          {1, "the origin is on AB", Kind::action},
          {0, "else (R3 or R4)", Kind::test, "", "AB", Relation::not_zero},
          {1, "keep [B, A],  d ← v", Kind::action}};
}

std::vector<CodeLine> algorithm_4() {
  return {{0, "ABCn ← AB×AC"},
          {0, "ABn ← AB×ABCn,  ACn ← ABCn×AC"},
          {0, "if ABn·AO > 0 (R3)", Kind::test, "", "AB"},
          {1, "keep [B, A],  d ← AB×AO×AB", Kind::action},
          {0, "else if ACn·AO > 0 (R7)", Kind::test, "", "AC"},
          {1, "keep [C, A],  d ← AC×AO×AC", Kind::action},
          {0, "else (R1)"},
          {1, "if ABCn·AO = 0", Kind::test, "", "ABC", Relation::zero},
          {2, "the origin is in ABC", Kind::action},
          {1, "if ABCn·AO > 0 (above)", Kind::test, "", "ABC", Relation::positive},
          {2, "keep [C, B, A],  d ← ABCn", Kind::action},
          {1, "if ABCn·AO < 0 (below)", Kind::test, "", "ABC", Relation::negative},
          {2, "keep [C, A, B],  d ← −ABCn", Kind::action}};
}

/// One face APQ of Algorithm 5.
void append_face(std::vector<CodeLine>& code, char P, char Q, const std::string& kept_face) {
  const std::string face = {'A', P, Q}, AP = {'A', P}, AQ = {'A', Q};
  const auto keep_edge = [](char other, const std::string& edge) {
    return std::string("keep [") + other + ", A],  d ← " + edge + "×AO×" + edge;
  };
  code.push_back({0, (code.size() > 2 ? "else if " : "if ") + face + "n·AO > 0", Kind::test, "", face});
  code.push_back({1, "if " + AQ + "n·AO > 0", Kind::test, face, AQ});
  code.push_back({2, keep_edge(Q, AQ), Kind::action});
  code.push_back({1, "else if " + AP + "n·AO > 0", Kind::test, face, AP});
  code.push_back({2, keep_edge(P, AP), Kind::action});
  code.push_back({1, "else keep [" + kept_face + "],  d ← " + face + "n", Kind::action});
}

std::vector<CodeLine> algorithm_5() {
  std::vector<CodeLine> code = {{0, "ABCn ← AB×AC,  ACDn ← AC×AD"}, {0, "ADBn ← AD×AB"}};
  append_face(code, 'B', 'C', "C, B, A");
  append_face(code, 'C', 'D', "D, C, A");
  append_face(code, 'D', 'B', "B, D, A");
  code.push_back({0, "else the origin is in ABCD", Kind::test, "", "ABCD"});
  return code;
}

/// The complete rules, for segments, triangles and tetrahedra.
std::vector<CodeLine> nearest_feature() {
  return {{0, "for each edge AX"},
          {1, "if AX·AO > 0", Kind::test, "", "AX", Relation::positive},
          {2, "and AX_n·AO ≥ 0 in each face", Kind::test, "any", "AX", Relation::not_negative},
          {3, "if AX×AO×AX = 0", Kind::test, "", "AX", Relation::zero},
          {4, "the origin is on AX", Kind::action},
          {3, "else", Kind::test, "", "AX", Relation::not_zero},
          {4, "keep [X, A],  d ← AX×AO×AX", Kind::action},
          {0, "if no AX·AO > 0"},
          {1, "if AO = 0", Kind::test, "", "A", Relation::zero},
          {2, "the origin is A", Kind::action},
          {1, "else", Kind::test, "", "A", Relation::not_zero},
          {2, "keep [A],  d ← AO", Kind::action},
          {0, "of a triangle"},
          {1, "if ABCn·AO = 0", Kind::test, "", "ABC", Relation::zero, 3},
          {2, "the origin is in ABC", Kind::action},
          {1, "if ABCn·AO > 0", Kind::test, "", "ABC", Relation::positive, 3},
          {2, "keep [C, B, A],  d ← ABCn", Kind::action},
          {1, "if ABCn·AO < 0", Kind::test, "", "ABC", Relation::negative, 3},
          {2, "keep [C, A, B],  d ← −ABCn", Kind::action},
          {0, "for each face AXY, O within its edges"},
          {1, "if AXY_n·AO > 0", Kind::test, "", "AXY", Relation::positive, 4},
          {2, "keep [Y, X, A],  d ← AXY_n", Kind::action},
          {0, "else the origin is in ABCD", Kind::test, "", "ABCD"}};
}

/// What certified_collision() does.
std::vector<CodeLine> proofs_and_second_search() {
  return {{0, "guess by Algorithm 1"},
          {0, "if separated and −P·d > bound", Kind::direction_proof},
          {1, "separated, proven", Kind::direction_holds},
          {0, "if ABCD holds O beyond a bound", Kind::tetrahedron_proof},
          {1, "intersecting, proven", Kind::tetrahedron_holds},
          {0, "P ← a vertex of the guess", Kind::second_start},
          {0, "repeat"},
          {1, "P joins the simplex and becomes A", Kind::add},
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

/// Returns: whether a feature is `form`, in which X and Y stand for B, C or D.
bool is_of_form(const std::string& feature, const std::string& form) {
  return std::ranges::equal(feature, form, [](char letter, char each) { return each == letter || each >= 'X'; });
}

/// Whether a line to which each edge comes would speak of another edge than the one that is asked about.
bool is_of_earlier_edge(const CodeLine& line, const gjk::RegionTested<double>& region, const Moment& now) {
  const std::string& last = now.regions.back().feature;
  return line.feature == "AX" && last.size() == 2 && region.feature != last;
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
  if (now.is_second_search || now.certified || focus == Focus::proof) return certifying;
  const bool processing =
      focus == Focus::region || focus == Focus::reduction || focus == Focus::direction || focus == Focus::repetition;
  return processing ? now.processed.size() + 1 : 1;
}

const gjk::RegionTested<double>* test_of(const CodeLine& line, const Moment& now) {
  if (line.kind != Kind::test) return nullptr;
  const auto is_its_own = [&](const gjk::RegionTested<double>& region) {
    return region.verdict != gjk::Verdict::skipped && (line.face == "any" || region.face == line.face) &&
           is_of_form(region.feature, line.feature) && (!line.relation || *line.relation == region.relation) &&
           (line.size == 0 || line.size == region.simplex_size) && !is_of_earlier_edge(line, region, now);
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
  if (number == 1) return title;
  std::string translation;
  for (int i = 0; i < simplex.size(); ++i) {
    const gjk::Role role = static_cast<gjk::Role>(i);
    if (names.of(role) == std::string(1, gjk::letter(role))) continue;
    translation.append(translation.empty() ? ": " : ", ") += std::string(1, gjk::letter(role)) + " = " + names.of(role);
  }
  return title + translation;
}

std::string line_in_letters(int number, const CodeLine& line, const Names& names) {
  return number == 1 ? line.text : names.translate(line.text);
}

std::optional<Way> way_of(const CodeLine& line) {
  constexpr std::string_view keep = "keep [", search = "],  d ← ";
  const std::size_t begin = line.text.find(keep), end = line.text.find(search);
  if (line.kind != Kind::action || begin == std::string::npos || end == std::string::npos) return std::nullopt;
  Way way{"", line.text.substr(end + search.size())};
  for (const char c : line.text.substr(begin + keep.size(), end - begin - keep.size()))
    if (c >= 'A' && c <= 'D') way.kept += c;
  return way;
}

}  // namespace walkthroughs
