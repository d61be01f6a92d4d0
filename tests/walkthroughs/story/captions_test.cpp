// What is said under the pictures, in the letters of the picture.

#include "walkthroughs/story/captions.hpp"

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/story/stories.hpp"
#include "walkthroughs/story/words.hpp"

namespace captions_test {

using namespace walkthroughs::program;
using namespace walkthroughs::test;

namespace {

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

}  // namespace

TEST_CASE("Each remark stands in exactly one caption") {
  std::size_t remarks = 0;
  for (const Story& story : whole_searches()) {
    remarks += story.walkthrough.remarks.size();
    for (const Remark& remark : story.walkthrough.remarks)
      CHECK(std::ranges::count_if(story.frames, [&](const Frame& f) {
              return plain(f.caption).ends_with(" " + as_sentence(remark.text) + ".");
            }) == 1);
  }
  CHECK(remarks > 0);
}

TEST_CASE("What a frame says names only vertices that the search holds at that moment") {
  for (const Story& story : whole_searches()) {
    const bool by_role = story.walkthrough.naming == Naming::roles;
    for (const Frame& f : story.frames) {
      const std::string held = by_role ? roles_held(f) : corners_held(story, f);
      std::string said = f.caption;
      for (const Remark& remark : story.walkthrough.remarks)  // which may look further
        for (std::size_t end = said.find(". "); end != std::string::npos; end = said.find(". ", end + 1))
          if (plain(said.substr(end + 2)) == as_sentence(remark.text) + ".") said.resize(end);
      for (const Fact& fact : f.facts)
        said += "\n" + fact.text.substr(0, fact.text.find(" is the largest, "));  // what comes next
      INFO(said);
      CHECK(vertices_named(said, by_role ? "ABCDPO" : "ABCDEFGO").find_first_not_of(held) == std::string::npos);
    }
  }
}

TEST_CASE("Behind a number stands what it was taken for, also where only the zero test takes it for zero") {
  using gjk::Relation;
  using gjk::Verdict;
  const Story story = tell(walkthrough("figure-4-left"));
  const Telling& telling = story.tellings.at(0);
  const auto first_fact = [&](const gjk::Event<double>& event, std::size_t place) {
    return caption(event, story, telling, replay(telling.trace, place + 1)).value().facts.at(0).text;
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
      CHECK(told(Verdict::rejected, Relation::positive, 0) == "0");
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

}  // namespace captions_test
