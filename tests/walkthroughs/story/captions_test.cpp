// What is said under the pictures, in the letters of the picture.

#include "walkthroughs/story/captions.hpp"

#include <cmath>
#include <iterator>
#include <set>
#include <sstream>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/story/stories.hpp"
#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/story/decision.hpp"
#include "walkthroughs/story/storyboard.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

namespace {

using Mark = Fact::Mark;

const Frame& frame(const Story& story, const std::string& caption) {
  const auto found = std::ranges::find(story.frames, caption, &Frame::caption);
  if (found == story.frames.end()) throw std::logic_error("no frame says: " + caption);
  return *found;
}

using Facts = std::vector<std::string>;

bool without_crossing_test(const Story& story) {
  return story.walkthrough.scenes[0].options.crossing_test == gjk::CrossingTest::off;
}

/// Returns: the facts as they stand in the picture.
Facts facts(const Frame& frame) {
  Facts list;
  for (const Fact& fact : frame.facts) {
    const char* const marks[] = {"", "✓ ", "✗ ", "skipped ", "answer: ", "truth: "};
    static_assert(std::size(marks) == 1 + static_cast<std::size_t>(Mark::truth));
    list.push_back(marks[static_cast<int>(fact.mark)] + fact.text);
  }
  return list;
}

/// Returns: the letters of the vertices that `text` names in words such as "EG" or "GE_n", but not in "Eq".
/// `letters_in_use`: those that a vertex may have, and the O of the origin.
std::string vertices_named(const std::string& text, std::string_view letters_in_use) {
  std::string letters, word;
  for (const char c : text + " ") {
    if ((c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z')) {
      word += c;
      continue;
    }
    if (word.find_first_not_of(letters_in_use) == std::string::npos) letters += word;
    word.clear();
  }
  std::erase(letters, 'O');
  return letters;
}

/// Returns: every number after the last "=" of `text`, the "0" of a comparison left out.
std::vector<double> numbers_at_the_end(std::string text) {
  for (std::size_t at; (at = text.find("−")) != std::string::npos;) text.replace(at, std::string("−").size(), "-");
  text.erase(0, text.rfind("= ") + 2);
  for (const char* sign : {" >", " <", " ≤", " ≥", " ≠", ":"}) text.erase(std::min(text.find(sign), text.size()));
  std::ranges::replace_if(
      text, [](char c) { return c == '(' || c == ',' || c == ')'; }, ' ');
  std::vector<double> numbers;
  for (const char* at = text.c_str();;) {
    char* end = nullptr;
    const double value = std::strtod(at, &end);
    if (end == at) return numbers;
    numbers.push_back(value);
    at = end;
  }
}

/// Returns: the letters of the corners that the search holds in that frame.
std::string corners_held(const Story& story, const Frame& frame) {
  const Moment& now = frame.moments[0];
  const LabelledHull& hull = story.tellings[0].hull;
  std::string held = now.found ? hull.name(now.found->w) : "";
  for (const Simplex& s : {now.simplex, now.reduction ? now.reduction->before : now.simplex})
    for (int i = 0; i < s.size(); ++i) held += hull.name(s[i].w);
  return held;
}

/// Returns: the roles in the simplex that is being processed, and P from when a point is found until it has been added.
std::string roles_held(const Frame& frame) {
  const Moment& now = frame.moments[0];
  const bool becomes_A = frame.focus == Focus::added || (frame.focus == Focus::region && now.processed.size() == 1);
  const bool has_P = (now.found && !now.added) || becomes_A;
  return std::string("ABCD").substr(0, static_cast<std::size_t>(now.processed.size())) + (has_P ? "P" : "");
}

/// Returns: the regions that a line about what was skipped lists: "R4, R5: reason" are two.
std::vector<std::string> regions_listed(const std::string& fact) {
  std::istringstream in(fact.substr(0, fact.find(": ")) + ",");
  std::vector<std::string> regions;
  for (std::string region; std::getline(in >> std::ws, region, ',');) regions.push_back(region);
  return regions;
}

void check_numbers(const std::string& fact, const std::vector<double>& expected) {
  INFO(fact);
  if (fact.find("inf") != std::string::npos) {
    CHECK(std::ranges::any_of(expected, [](double x) { return std::isinf(x); }));
    return;
  }
  const std::vector<double> printed = numbers_at_the_end(fact);
  REQUIRE(printed.size() <= expected.size());
  REQUIRE(printed.size() >= std::min<std::size_t>(expected.size(), 2));
  for (std::size_t i = 0; i < printed.size(); ++i)
    CHECK(printed[i] == Approx(expected[i]).epsilon(5.1e-6).margin(1e-12));
}

std::vector<double> components(const Point& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace

TEST_CASE("Each caption is one sentence on one line", "[unsanitized]") {
  for (const Walkthrough& w : catalogue()) {
    for (const Frame& f : tell(w).frames) {
      INFO(f.caption);
      CHECK(f.caption.ends_with('.'));
      CHECK_FALSE(f.caption.ends_with(".."));
      for (std::size_t dot = 0; (dot = f.caption.find(". ", dot)) != std::string::npos; ++dot)
        CHECK(f.caption.substr(0, dot).ends_with("Eq"));
      CHECK(f.caption.find_first_of("\n!?") == std::string::npos);
      CHECK(f.caption.find("  ") == std::string::npos);
      CHECK((f.caption.front() >= 'A' && f.caption.front() <= 'Z'));
      for (const Fact& fact : f.facts) CHECK(fact.text.find('\n') == std::string::npos);
    }
  }
}

TEST_CASE("What exact numbers say against the search is marked so, and no other remark") {
  const auto last_marks = [](const char* name) {
    const Story story = tell(walkthrough(name));
    std::set<Fact::Mark> marks;
    for (const Fact& fact : story.frames.back().facts) marks.insert(fact.mark);
    return marks;
  };
  CHECK(last_marks("failures/far-from-the-origin").contains(Fact::Mark::truth));
  for (const char* name : {"cycle-separated", "complete/cycle-separated"})
    CHECK_FALSE(last_marks(name).contains(Fact::Mark::truth));
}

TEST_CASE("Each remark stands in exactly one caption") {
  std::size_t remarks = 0;
  for (const Story& story : whole_searches()) {
    remarks += story.walkthrough.remarks.size();
    for (const Remark& remark : story.walkthrough.remarks)
      CHECK(std::ranges::count_if(story.frames, [&](const Frame& f) {
              return plain(f.caption).ends_with("; " + remark.text + ".");
            }) == 1);
  }
  CHECK(remarks > 0);
}

TEST_CASE("What a frame says names only vertices that the search holds at that moment") {
  for (const Story& story : whole_searches()) {
    const bool by_role = story.walkthrough.naming == Naming::roles;
    for (const Frame& f : story.frames) {
      const std::string held = by_role ? roles_held(f) : corners_held(story, f);
      std::string said = f.caption.substr(0, f.caption.find(';'));  // a remark may look further
      for (const Fact& fact : f.facts)
        said += "\n" + fact.text.substr(0, fact.text.find(", then "));  // the next farthest
      INFO(said);
      CHECK(vertices_named(said, by_role ? "ABCDPO" : "ABCDEFGO").find_first_not_of(held) == std::string::npos);
    }
  }
}

TEST_CASE("The numbers in the facts are those of the events") {
  std::set<std::size_t> kinds, kinds_of_values;
  for (const Story& story : whole_searches()) {
    const auto events = shown(story);
    REQUIRE(events.size() == story.frames.size());
    for (std::size_t i = 0; i < events.size(); ++i) {
      kinds.insert(events[i].index());
      std::vector<Fact> list = story.frames.at(i).facts;
      std::erase_if(list, [](const Fact& fact) { return fact.mark == Mark::truth; });  // not of the event
      if (const auto* e = std::get_if<gjk::SupportFound<double>>(&events[i])) {
        check_numbers(list.at(0).text.substr(0, list[0].text.find(';')), components(e->direction));
        if (story.tellings[0].scene.scalar == Scalar::binary64)
          check_numbers(list.at(0).text.substr(0, list[0].text.find(", then")), {e->vertex.w.dot(e->direction)});
        check_numbers(list.at(1).text, components(e->vertex.w));
        const bool by_role = story.walkthrough.naming == Naming::roles;
        CHECK(list[1].text.starts_with((by_role ? "P" : story.tellings[0].hull.name(e->vertex.w)) + " = a − b = ("));
      }
      if (const auto* e = std::get_if<gjk::CrossingTested<double>>(&events[i]))
        check_numbers(list.at(0).text, {e->value.value()});
      if (const auto* e = std::get_if<gjk::DirectionChosen<double>>(&events[i]))
        check_numbers(list.at(0).text, components(e->direction));
      if (const auto* e = std::get_if<gjk::RegionTested<double>>(&events[i])) {
        kinds_of_values.insert(e->value.index());
        if (const double* value = std::get_if<double>(&e->value)) check_numbers(list.at(0).text, {*value});
        if (const Point* value = std::get_if<Point>(&e->value)) check_numbers(list.at(0).text, components(*value));
        if (e->normal && !asks_along_edge(*e)) check_numbers(list.at(1).text, components(*e->normal));
        const bool uncertain = e->simplex_size == 1 || (e->simplex_size == 2 && without_crossing_test(story));
        CHECK(list[0].mark == (uncertain ? Mark::none : e->verdict == gjk::Verdict::rejected ? Mark::no : Mark::yes));
      }
    }
  }
  for (const gjk::Event<double>& looked_at :
       {gjk::Event<double>(gjk::SupportFound<double>{}), gjk::Event<double>(gjk::CrossingTested<double>{}),
        gjk::Event<double>(gjk::DirectionChosen<double>{}), gjk::Event<double>(gjk::RegionTested<double>{})})
    CHECK(kinds.contains(looked_at.index()));
  CHECK(kinds_of_values.size() >= 2);  // numbers and vectors
}

TEST_CASE("Every region that is skipped is told with its reason, in each frame of a test of that iteration") {
  std::size_t skipped = 0;
  for (const Story& story : whole_searches()) {
    INFO(story.walkthrough.name);
    for (const gjk::RegionTested<double>& region : all<gjk::RegionTested>(story.tellings[0].trace)) {
      if (region.verdict != gjk::Verdict::skipped) continue;
      ++skipped;
      const std::string name = region.label.empty() ? region.feature : region.label;
      const std::string reason = story.walkthrough.naming == Naming::roles ? region.reason : "";  // untranslated
      std::size_t frames = 0, told = 0;
      for (const Frame& f : story.frames) {
        if (f.focus != Focus::region || f.moments[0].iteration != region.iteration) continue;
        ++frames;
        told += static_cast<std::size_t>(std::ranges::count_if(f.facts, [&](const Fact& fact) {
          return fact.mark == Mark::skipped && std::ranges::count(regions_listed(fact.text), name) == 1 &&
                 fact.text.ends_with(reason);
        }));
      }
      CHECK(frames > 0);
      CHECK(told == frames);
    }
  }
  CHECK(skipped > 0);
}

TEST_CASE("Figure 4, left, in the letters of the picture") {
  const Story story = tell(walkthrough("figure-4-left"));
  CHECK(facts(story.frames.at(0)) == Facts{"d = (1, 0); A·d = 3.75, then G·d = 3.5",
                                           "A = a − b = (2.25, 1.75) − (−1.5, −1.5) = (3.75, 3.25)",
                                           "no crossing test yet: it judges the move from one point to the next"});
  CHECK(facts(frame(story, "The move to E crossed the origin, so the search goes on.")) ==
        Facts{"✓ E·d = 4.375 > 0: the origin was crossed"});
  CHECK(facts(frame(story, "The origin lies to one side of segment AE.")) ==
        Facts{"✓ R3 or R4: EA×EO×EA = (24, −72) ≠ 0",
              "EA×EO×EA points toward the origin in both, so they need not be told apart",
              "skipped R1: the search has just moved away from A, toward the origin",
              "skipped R2: were the origin beyond E, the move to E would not have reached it"});
  CHECK(facts(frame(story, "The origin lies beyond edge EG.")) ==
        Facts{"✓ R3: GE_n·GO = 71.5 > 0", "GE_n = GE×GEA_n = (−38.5, −126.5, 0)",
              "skipped R4, R6: ruled out when the search kept EA",
              "skipped R5: the search has just moved away from EA, toward the origin",
              "skipped R2: were the origin beyond G, the move to G would not have reached it"});
  CHECK(facts(frame(story, "A is no longer needed and leaves the simplex.")) ==
        Facts{"[A, E, G] becomes [E, G], oldest first", "the origin lies beyond this edge; G stays the newest",
              "not asked: R7, R1: one edge beyond which the origin lies is enough"});
  CHECK(facts(frame(story, "The next search goes from segment EG toward the origin.")) ==
        Facts{"d = GE×GO×GE = (−5.6875, −18.6875)"});
  CHECK(facts(frame(story, "The origin does not lie beyond edge EF.")) ==
        Facts{"✗ R7: FE_n·FO = −20.25 ≤ 0", "FE_n = FGE_n×FE = (−20.25, −20.25, 0)",
              "skipped R4, R6: ruled out when the search kept GE",
              "skipped R5: the search has just moved away from GE, toward the origin",
              "skipped R2: were the origin beyond F, the move to F would not have reached it"});
  CHECK(facts(frame(story, "The origin lies in triangle EFG.")) ==
        Facts{"✓ R1: FGE_n·FO = 0", "FGE_n = FG×FE = (0, 0, 9)", "skipped R4, R6: ruled out when the search kept GE",
              "skipped R5: the search has just moved away from GE, toward the origin",
              "skipped R2: were the origin beyond F, the move to F would not have reached it"});
  CHECK(facts(frame(story, "The origin lies in triangle EFG, so the objects intersect.")) ==
        Facts{"answer: intersecting after 4 iterations", "R3: FG_n·FO = −31.5 ≤ 0", "R7: FE_n·FO = −20.25 ≤ 0",
              "R1: FGE_n·FO = 0"});
}

TEST_CASE("What has not been asked is told with what is dropped, and why it need not be") {
  const auto not_asked = [](const std::string& name) {
    const Story story = tell(walkthrough("regions/3-simplex-" + name));
    Facts said;
    for (const Frame& each : story.frames)
      if (each.focus == Focus::reduction && each.moments[0].processed.size() == 4 && said.empty())
        for (const Fact& fact : each.facts)
          if (fact.text.starts_with("not asked: ")) said.push_back(fact.text.substr(11));
    return said;
  };
  const std::string edge = ": one edge beyond which the origin lies is enough",
                    face =
                        ": one face above which the origin lies is enough; a vertex that is dropped is found again if "
                        "needed",
                    neither = ": the origin lies above neither of its faces",
                    too = " (above which the origin lies, too)";
  CHECK(not_asked("face-abc") == Facts{"ACD, ADB, AD" + face});
  CHECK(not_asked("face-abc-edge-ab") == Facts{"the inside of ABC" + edge, "ACD, ADB" + too + ", AD" + face});
  CHECK(not_asked("face-abc-edge-ac") == Facts{"AB, the inside of ABC" + edge, "ACD" + too + ", ADB, AD" + face});
  CHECK(not_asked("face-acd") == Facts{"ADB, AB" + face});
  CHECK(not_asked("face-acd-edge-ad") == Facts{"AC, the inside of ACD" + edge, "ADB" + too + ", AB" + face});
  CHECK(not_asked("face-adb") == Facts{"AC" + neither});
  CHECK(not_asked("face-adb-edge-ab") == Facts{"AD, the inside of ADB" + edge, "AC" + neither});
}

TEST_CASE("That no edge of a tetrahedron around the origin was asked is told, and that a triangle stays as it is") {
  const Story inside = tell(walkthrough("regions/3-simplex-inside"));
  std::ptrdiff_t told = 0;
  for (const Frame& each : inside.frames)
    if (each.caption.starts_with("No face sees"))
      told += std::ranges::count(facts(each), "not asked: AB, AC, AD: the origin lies above none of their faces");
  CHECK(told == 1);
  const auto stays = [](const std::string& name) {
    const Story story = tell(walkthrough(name));
    int count = 0;
    for (const Frame& each : story.frames)
      if (each.focus == Focus::direction && each.facts.size() > 1)
        count += each.facts[1].text ==
                 "the simplex stays [C, B, A]: read from the list, its normal points to the origin already";
    return count;
  };
  CHECK(stays("regions/2-simplex-r1-above") == 1);
  CHECK(stays("regions/2-simplex-r3") == 0);
}

TEST_CASE("A list that is not by age any more is not called so") {
  const Story story = tell(walkthrough("regions/2-simplex-r1-below"));
  for (const Frame& each : story.frames)
    if (each.caption.starts_with("The simplex stays"))
      CHECK(each.facts[0].text == "[C, B, A] becomes [C, A, B], no longer by age: A is still the newest");
}

TEST_CASE("Figure 4, right, says where the two tellings part") {
  const Story with = tell(walkthrough("figure-4-right")),
              without = tell(walkthrough("figure-4-right-no-crossing-test"));
  CHECK(with.frames.back().caption ==
        "The difference does not contain the origin, so the objects do not intersect; Section 3.1.2 does not use "
        "the test yet and goes on to F.");
  CHECK(facts(with.frames.back()) ==
        Facts{"answer: separated after 2 iterations", "with d = (−4.25, −4.5): w·d ≤ E·d = −10.1875 < 0 for every w"});
  CHECK(facts(with.frames.at(4)) == Facts{"✗ E·d = −10.1875 < 0: the origin was not crossed (Eq. 9)"});
  CHECK(without.frames.at(10).caption ==
        "Along d the farthest point of the difference is E again, so there is no new point.");
  CHECK(without.frames.at(0).facts.back().text == "this run does without the crossing test");
  CHECK(facts(without.frames.at(4)).at(0) == "R3 or R4: EA×EO×EA = (23.5, −52.875) ≠ 0");  // not certain: no mark
  CHECK(facts(without.frames.back()) == Facts{"answer: separated after 4 iterations",
                                              "the search has run out of points: E is not new",
                                              "with d = (−15.25, −24.7812): w·d ≤ E·d = −58.1406 < 0 for every w"});
}

TEST_CASE("A move that ends at the origin's height proves nothing, and says so") {
  const Walkthrough touching = walkthrough_of({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}});
  const Story story = tell(touching);  // A (2,0), B (0,2), C the origin
  CHECK(facts(frame(story, "The move to C just reached the origin's level, so the search goes on.")) ==
        Facts{"C·d = 0: this proves nothing"});
  CHECK(frame(story, "The origin lies on segment AC.").facts.at(0).text == "CA×CO×CA = (0, 0)");
  CHECK(story.frames.back().caption == "The origin lies in segment AC, so the objects intersect.");
}

TEST_CASE("Behind a number stands what it was taken for, also where only the zero test takes it for zero") {
  using gjk::Relation;
  using gjk::Verdict;
  const Story story = tell(walkthrough("figure-4-left"));
  const Telling& telling = story.tellings.at(0);
  const auto first_fact = [&](const gjk::Event<double>& event, std::size_t place) {
    return facts(caption(event, story, telling, replay(telling.trace, place + 1)).value()).at(0);
  };
  for (std::size_t i = 0; i < telling.trace.events.size(); ++i) {
    if (const auto* region = std::get_if<gjk::RegionTested<double>>(&telling.trace.events[i]);
        region && region->normal) {
      const auto told = [&](Verdict verdict, Relation relation, double value) {
        auto changed = *region;
        changed.verdict = verdict, changed.relation = relation, changed.value = value;
        const std::string fact = first_fact(changed, i);
        return fact.substr(fact.rfind(" = ") + 3);
      };
      CHECK(told(Verdict::chosen, Relation::positive, 0.25) == "0.25 > 0");
      CHECK(told(Verdict::chosen, Relation::negative, -0.25) == "−0.25 < 0");
      CHECK(told(Verdict::chosen, Relation::zero, 0) == "0");
      CHECK(told(Verdict::chosen, Relation::zero, -0.25) == "−0.25, which counts as 0");
      CHECK(told(Verdict::rejected, Relation::positive, -0.25) == "−0.25 ≤ 0");
      CHECK(told(Verdict::rejected, Relation::positive, 0) == "0 ≤ 0");
      CHECK(told(Verdict::rejected, Relation::positive, 0.25) == "0.25, which counts as 0");
    }
    if (const auto* test = std::get_if<gjk::CrossingTested<double>>(&telling.trace.events[i]); test && test->value) {
      const auto told = [&](double value) {
        auto changed = *test;
        changed.value = value, changed.verdict = gjk::Crossing::crossed;
        const std::string fact = first_fact(changed, i);
        return fact.substr(fact.find(" = ") + 3);
      };
      CHECK(told(0.25) == "0.25 > 0: the origin was crossed");
      CHECK(told(0) == "0: this proves nothing");
      CHECK(told(-0.25) == "−0.25, which counts as 0: this proves nothing");
    }
  }
}

TEST_CASE("A search that runs into its limit ends without an answer") {
  Walkthrough cut_short = walkthrough("figure-4-left");
  cut_short.scenes[0].options.iteration_limit = 2;
  const Story story = tell(cut_short);
  CHECK(story.frames.back().caption == "The search ends without an answer.");
  CHECK(facts(story.frames.back()) == Facts{"answer: undecided after 2 iterations", "the iteration limit is reached"});
}

TEST_CASE("The origin beyond the other edge of a triangle is told as R7, and the edge keeps its letters") {
  const Walkthrough across = walkthrough_of({{-5, 5, 0}, {-1, 4, 0}, {0, -1, 0}, {-4, -2, 0}});
  const Story story = tell(across);  // A, C, B are found, C is dropped
  CHECK(facts(frame(story, "The origin lies beyond edge AB.")) ==
        Facts{"✓ R7: BA_n·BO = 19 > 0", "BA_n = BCA_n×BA = (95, 19, 0)",
              "skipped R4, R6: ruled out when the search kept CA",
              "skipped R5: the search has just moved away from CA, toward the origin",
              "skipped R2: were the origin beyond B, the move to B would not have reached it"});
  CHECK(frame(story, "C is no longer needed and leaves the simplex.").facts.at(0).text ==
        "[A, C, B] becomes [A, B], oldest first");
  CHECK(facts(frame(story, "The next search goes from segment AB toward the origin.")) ==
        Facts{"d = BA×BO×BA = (5, 1)"});
}
