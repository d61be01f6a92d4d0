// What is said under the pictures, in the letters of the picture.

#include "walkthroughs/story/captions.hpp"

#include <cmath>
#include <iterator>
#include <set>
#include <sstream>

#include "tests/kit/catch.hpp"
#include "tests/kit/text.hpp"
#include "tests/walkthroughs/story/stories.hpp"
#include "walkthroughs/story/alternative_text.hpp"
#include "walkthroughs/story/decision.hpp"

using namespace walkthroughs;
using namespace walkthroughs::test;

namespace {

using Mark = Fact::Mark;

using kit::has;

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

TEST_CASE("Each caption is one sentence on one line, alternative text has no markup and tells of each scene",
          "[unsanitized]") {
  for (const Walkthrough& w : catalogue()) {
    const Story story = tell(w);
    for (std::size_t i = 0; i < story.frames.size(); ++i) {
      const Frame& f = story.frames[i];
      INFO(f.caption);
      CHECK(f.caption.ends_with('.'));
      CHECK_FALSE(f.caption.ends_with(".."));
      for (std::size_t dot = 0; (dot = f.caption.find(". ", dot)) != std::string::npos; ++dot)
        CHECK(f.caption.substr(0, dot).ends_with("Eq"));
      CHECK(f.caption.find_first_of("\n!?") == std::string::npos);
      CHECK_FALSE(has(f.caption, "  "));
      CHECK((f.caption.front() >= 'A' && f.caption.front() <= 'Z'));
      for (const Fact& fact : f.facts) CHECK_FALSE(has(fact.text, "\n"));
      const std::string text = alternative_text(story, i);
      CHECK((text.ends_with('.') && !has(text, "_")));
      for (const Scene& scene : w.scenes)
        CHECK(has(text, "Of the two, " + scene.name + ": ") == (w.scenes.size() == 2));
    }
  }
}

TEST_CASE("Captions as JSON tell file, walkthrough, caption, facts, description and events of each frame") {
  const Story story = tell(walkthrough("figure-5"));
  const std::string json = captions_json({{"out/000.png", story, 0}, {"out/002.png", story, 2}});
  std::string caption = plain(story.frames[2].caption), text = alternative_text(story, 2);
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; ++at) text.replace(at, 1, "\\n");
  for (const std::string& part :
       {std::string("\"schema\": \"gjkstep-captions\""), std::string("\"version\": 1"),
        std::string("\"file\": \"out/000.png\""), std::string("\"file\": \"out/002.png\""),
        std::string("\"walkthrough\": \"figure-5\""), "\"caption\": \"" + caption + "\"",
        "\"" + plain(story.frames[2].facts.at(1).text) + "\"", "\"alternative_text\": \"" + text + "\""}) {
    INFO(part);
    CHECK(has(json, part));
  }
}

TEST_CASE("What exact numbers say against the search is marked so, and no other remark") {
  for (const auto& [name, is_marked] : {std::pair("failures/far-from-the-origin", true),
                                        {"cycle-separated", false},
                                        {"complete/cycle-separated", false}})
    CHECK((std::ranges::count(tell(walkthrough(name)).frames.back().facts, Mark::truth, &Fact::mark) > 0) == is_marked);
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
  const Facts told = facts(frame(story, "The origin lies beyond edge AB."));
  CHECK(told.at(0) == "✓ R7: BA_n·BO = 19 > 0");
  CHECK(told.at(1) == "BA_n = BCA_n×BA = (95, 19, 0)");
  CHECK(told.at(2) == "skipped R4, R6: ruled out when the search kept CA");
  CHECK(frame(story, "C is no longer needed and leaves the simplex.").facts.at(0).text ==
        "[A, C, B] becomes [A, B], oldest first");
  CHECK(facts(frame(story, "The next search goes from segment AB toward the origin.")) ==
        Facts{"d = BA×BO×BA = (5, 1)"});
}
