// The pseudo-code beside a search, held against the events of every search of the catalogue.

#include "walkthroughs/story/pseudocode.hpp"

#include "tests/kit/catch.hpp"
#include "tests/kit/text.hpp"
#include "tests/walkthroughs/support.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/story/words.hpp"

namespace pseudocode_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;

namespace {

using kit::has;

/// Calls `check(event, now, rules)` after each event of that kind, in every search by any rules.
template <template <class> class E, class Check>
void after_each(Check check) {
  for (const Walkthrough& w : whole_catalogue()) {
    for (Scene scene : w.scenes) {
      for (const auto& rules : gjk::rule_sets) {
        scene.rules = rules.value;
        scene.mistake.reset();
        const Trace trace = run(scene);
        for (std::size_t i = 0; i < trace.events.size(); ++i) {
          const auto* event = std::get_if<E<double>>(&trace.events[i]);
          if (!event || replay(trace, i + 1).in_exact_fallback) continue;
          INFO(w.name << ", " << rules.name << ", event " << i);
          check(*event, replay(trace, i + 1), rules.value);
        }
      }
    }
  }
}

const std::vector<CodeLine>& code_of(const Moment& now, Focus focus, RuleSet rules) {
  return algorithm(running_algorithm(now, focus), rules);
}

/// Returns: the line where the search is. Fails where there is none.
CodeLine line_at(const Moment& now, Focus focus, RuleSet rules) {
  const std::optional<std::size_t> current = current_line(code_of(now, focus, rules), now, focus);
  REQUIRE(current);
  return code_of(now, focus, rules).at(*current);
}

/// Returns: "[B, A]" for "BA".
std::string listed(const std::string& roles) {
  std::string list;
  for (const char role : roles) list += (list.empty() ? "" : ", ") + std::string(1, role);
  return "[" + list + "]";
}

/// Returns: the text with X and Y of the complete rules replaced by the letters of what is kept, "CBA" being [Y, X, A].
std::string with_letters(std::string text, const std::string& kept) {
  const bool is_face = text.find('Y') != std::string::npos;
  for (char& c : text) {
    if (c == 'Y') c = kept[0];
    if (c == 'X') c = kept[is_face ? 1 : 0];
  }
  std::erase(text, '_');
  return text;
}

}  // namespace

TEST_CASE("Every region test that was made has exactly one line, the current one, and no other line has a value") {
  after_each<gjk::RegionTested>([](const gjk::RegionTested<double>& event, const Moment& now, RuleSet rules) {
    const std::vector<CodeLine>& code = code_of(now, Focus::region, rules);
    std::ptrdiff_t made = 0, shown = 0;
    for (const auto& region : now.regions) made += region.verdict != gjk::Verdict::skipped;
    std::vector<std::size_t> lines;
    for (std::size_t i = 0; i < code.size(); ++i) {
      const auto* test = test_of(code[i], now);
      shown += test != nullptr;
      CHECK((code[i].kind == LineKind::test || !test));
      if (test == &now.regions.back()) lines.push_back(i);
    }
    if (rules == RuleSet::complete)  // one line for several edges
      CHECK((shown > 0) == (made > 0));
    else
      CHECK(shown == made);
    if (event.verdict == gjk::Verdict::skipped) return;
    INFO(to_string(event.face) << " " << to_string(event.feature));
    REQUIRE(lines.size() == 1);
    CHECK(current_line(code, now, Focus::region) == lines[0]);
  });
}

TEST_CASE("The line after the tests says which vertices are kept and in which order") {
  after_each<gjk::SimplexReduced>([](const gjk::SimplexReduced<double>& event, const Moment& now, RuleSet rules) {
    const std::string text = with_letters(line_at(now, Focus::reduction, rules).text, to_string(event.kept));
    INFO(text);
    CHECK(has(text, "keep " + listed(to_string(event.kept)) + ","));
  });
}

TEST_CASE("The line after the tests says which direction is chosen") {
  after_each<gjk::DirectionChosen>([](const gjk::DirectionChosen<double>& event, const Moment& now, RuleSet rules) {
    const CodeLine line = line_at(now, Focus::direction, rules);
    INFO(line.text << " for " << to_string(event.expression));
    const bool in_two_steps = event.expression == "AB×AO×AB" && line.text.ends_with("d ← v");  // Algorithm 3 tests it
    const std::string text = with_letters(line.text, now.reduction ? to_string(now.reduction->kept) : "BA");
    CHECK((text.ends_with("d ← " + with_brackets(event.expression)) || in_two_steps));
  });
}

TEST_CASE("Algorithm 1 is at its support function, its crossing test and its end when the search is there") {
  after_each<gjk::SupportFound>([](const auto&, const Moment& now, RuleSet rules) {
    CHECK(line_at(now, Focus::support, rules).kind == LineKind::support);
  });
  after_each<gjk::CrossingTested>([](const auto&, const Moment& now, RuleSet rules) {
    CHECK(line_at(now, Focus::crossing, rules).kind == LineKind::crossing);
  });
  after_each<gjk::Finished>([](const gjk::Finished<double>& event, const Moment& now, RuleSet rules) {
    const LineKind kind = line_at(now, Focus::end, rules).kind;
    CHECK((kind == LineKind::intersecting) == (event.result.status == gjk::Status::intersecting));
    CHECK((kind == LineKind::separated) == (event.result.reason == gjk::Reason::origin_not_crossed));
  });
}

}  // namespace pseudocode_test
