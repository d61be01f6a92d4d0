#include "walkthroughs/page/questions.hpp"

#include <map>
#include <set>

#include "tests/kit/catch.hpp"
#include "tests/walkthroughs/story/stories.hpp"
#include "tests/walkthroughs/trace/random_scene_files.hpp"
#include "walkthroughs/text/scene_file.hpp"
#include "walkthroughs/trace/trace_json.hpp"

namespace questions_test {

using namespace walkthroughs;
using namespace walkthroughs::program;
using namespace walkthroughs::test;

namespace {

using gjk::Relation;
using gjk::Verdict;
using Kind = Decision::Kind;
using Region = gjk::RegionTested<double>;

std::string without_subscripts(std::string text) {
  std::erase(text, '_');
  return text;
}

/// The one line among the choices that the mistake's definition has otherwise.
std::string line_gone_wrong_in(const Question& question) {
  std::string found;
  for (const auto& known : wrong_on_purpose::all())
    for (const auto& line : known.lines)
      for (const Choice& choice : question.choices)
        if (known.word == question.decision.found && line.algorithm == question.decision.simplex_size + 1 &&
            line.right == without_subscripts(choice.text))
          found += line.right;
  return found;
}

/// What the trace did, found in its events alone, in words of the report's letters.
std::string done(const Trace& trace, const Question& question) {
  const auto& events = trace.events;
  const gjk::Event<double>& event = events.at(question.event);
  switch (question.decision.kind) {
    case Kind::crossing:
      return std::get<gjk::CrossingTested<double>>(event).verdict == gjk::Crossing::crossed ? "yes, or just reached"
                                                                                            : "no";
    case Kind::vertices: {
      const auto* reduced = std::get_if<gjk::SimplexReduced<double>>(&event);
      std::string list;
      for (const gjk::Role role : reduced ? reduced->kept : gjk::Roles("CBA"))
        list += (list.empty() ? "" : ", ") + std::string(1, letter(role));
      return "[" + list + "]";
    }
    case Kind::direction: return with_brackets(std::get<gjk::DirectionChosen<double>>(event).expression);
    case Kind::line: return line_gone_wrong_in(question);
    case Kind::region: break;
  }
  if (const auto* kept = std::get_if<gjk::FeatureKept<double>>(&event)) {
    std::string letters = to_string(kept->kept);
    std::ranges::sort(letters);
    return with_kind(letters);
  }
  if (question.text.find("On which feature") != std::string::npos) {  // the complete rules
    std::string feature;
    for (std::size_t i = question.event; i < events.size() && std::holds_alternative<Region>(events[i]); ++i)
      if (const Region& region = std::get<Region>(events[i]); region.verdict == Verdict::chosen)
        feature = to_string(region.feature);
    return with_kind(feature);
  }
  const Region* chosen = nullptr;
  const gjk::Roles face = std::get<Region>(event).face;
  for (std::size_t i = question.event; i < events.size() && std::holds_alternative<Region>(events[i]); ++i)
    if (const Region& region = std::get<Region>(events[i]);
        region.verdict == Verdict::chosen && region.face == face && !chosen)
      chosen = &region;
  if (!chosen) return "beyond neither: above the face itself";
  static const std::map<std::pair<std::string, Relation>, std::string> words{
      {{"A", Relation::zero}, "yes, it is O"},          {{"A", Relation::not_zero}, "no, O lies elsewhere"},
      {{"AB", Relation::zero}, "on segment AB"},        {{"AB", Relation::not_zero}, "R3 or R4: to one side of AB"},
      {{"ABC", Relation::zero}, "R1: in triangle ABC"}, {{"ABC", Relation::negative}, "R1: below triangle ABC"},
  };
  const std::string feature = to_string(chosen->feature);
  if (!face.empty()) return "beyond edge " + feature;
  if (chosen->feature == "ABCD") return "inside: above none of them";
  if (chosen->simplex_size == 4) return "above face " + feature;
  if (chosen->feature == "ABC" && chosen->relation == Relation::positive) return "R1: above triangle ABC";
  if (chosen->simplex_size == 3 && chosen->feature != "ABC")
    return std::string(to_string(label_of(*chosen))) + ": beyond edge " + feature;
  return words.at({feature, chosen->relation});
}

/// Returns: how many questions there are; each has been checked.
int check_questions(Walkthrough walkthrough) {
  walkthrough.naming = Naming::roles;  // the report's letters, in which events are told
  const Story story = tell(walkthrough);
  const std::vector<Question> questions = questions_of(story);
  std::pair<std::size_t, std::size_t> last{0, 0};
  for (const Question& question : questions) {
    INFO(question.text);
    std::set<std::string> different;
    for (const Choice& choice : question.choices) {
      INFO(choice.text);
      CHECK(different.insert(choice.text).second);
      CHECK_FALSE(choice.reason.empty());
    }
    CHECK(question.choices.size() >= 2);
    const auto is_alphabetical = [](const Choice& x, const Choice& y) { return x.text < y.text; };
    const auto others = std::ranges::find_if(question.choices, [](const Choice& each) { return each.text[0] != 'R'; });
    if (question.decision.kind != Kind::line) CHECK(std::is_sorted(others, question.choices.end(), is_alphabetical));
    REQUIRE(question.right < question.choices.size());
    CHECK(without_subscripts(question.choices[question.right].text) ==
          done(story.tellings.at(question.scene).trace, question));
    CHECK(std::pair(question.scene, question.event) >= last);
    last = {question.scene, question.event};
    const bool is_one_of_two = story.tellings.size() == 2 && question.decision.kind != Kind::line;
    const bool is_of_both = story.parts_at && question.event < *story.parts_at;
    const std::string& whose = is_of_both ? "Both" : story.tellings[question.scene].scene.name;
    CHECK(question.text.starts_with(whose + ": ") == is_one_of_two);
  }
  return static_cast<int>(questions.size());
}

/// How many decisions a trace has, from that event on, that leave a choice: what must be asked.
int decisions_in(const Scene& scene, std::size_t from) {
  const bool is_complete = scene.rules == RuleSet::complete;  // of which one thing is asked about each simplex
  const Trace trace = run(scene);
  int count = 0, size = 0;
  bool is_finished = false;
  const Region* before = nullptr;
  for (std::size_t i = 0; i < trace.events.size(); ++i) {
    if (i == from) count = 0;
    const auto& event = trace.events[i];
    is_finished |= std::holds_alternative<gjk::Finished<double>>(event);
    if (const auto* kept = std::get_if<gjk::FeatureKept<double>>(&event)) count += kept->before.size() > 1;
    if (is_finished) continue;  // of proofs nothing else is asked
    const auto* region = std::get_if<Region>(&event);
    if (const auto* crossing = std::get_if<gjk::CrossingTested<double>>(&event)) count += crossing->value.has_value();
    if (const auto* added = std::get_if<gjk::VertexAdded<double>>(&event)) size = added->simplex.size();
    if (region && region->verdict != Verdict::skipped && (!before || before->verdict == Verdict::skipped)) ++count;
    if (is_complete) {
      before = region;
      continue;
    }
    if (region && !region->face.empty() && before && before->face.empty()) ++count;
    const bool is_reduced = std::holds_alternative<gjk::SimplexReduced<double>>(event);
    const bool is_direction = std::holds_alternative<gjk::DirectionChosen<double>>(event);
    if (size >= 3 && (is_reduced || (is_direction && before))) ++count;  // which stay
    if (size >= 3 && is_direction) ++count;
    before = region;
  }
  return count;
}

/// "AO" of "R3 or R4: AO = (2, −1) ≠ 0".
std::string asked_first(const std::string& text) {
  const std::string asked = text.substr(0, text.find(" = "));
  const std::size_t label = asked.find(": ");
  return label == std::string::npos ? asked : asked.substr(label + 2);
}

}  // namespace

TEST_CASE(
    "Every question about every walkthrough has one right choice, which is what the trace did, and each decision is "
    "asked about") {
  int asked = 0;
  for (const Walkthrough& w : whole_catalogue()) {
    INFO(w.name);
    const int count = check_questions(w);
    int decisions = 0;
    for (std::size_t s = 0; s < w.scenes.size(); ++s)
      decisions += decisions_in(w.scenes[s], s == 0 ? 0 : tell(w).parts_at.value_or(0));
    const bool is_mistaken = w.scenes.size() == 2 && w.scenes[0].mistake;
    CHECK(count == (is_mistaken ? 1 : decisions));
    asked += count;
  }
  CHECK(asked > 300);
}

TEST_CASE("Every question about 1,000 scenes at random has one right choice, which is what the trace did",
          "[unsanitized][full]") {
  RandomSceneFiles files(16);
  int asked = 0;
  for (int i = 0; i < 1000; ++i) {
    const RandomSceneFile file = files.next();
    INFO("seed 16, scene " << i << ": " << file.text);
    try {
      const SceneFile scene = parse_scene(file.text, "scene.json");
      const int count = check_questions(scene.walkthrough);
      CHECK(count == decisions_in(scene.walkthrough.scenes[0], 0));
      asked += count;
    } catch (const InputError&) {  // what cannot be asked at all, such as a center beyond all floats
    }
  }
  CHECK(asked > 1000);
}

TEST_CASE("A wrong choice is answered by the value that decided, or by why its region is skipped") {
  Walkthrough w = walkthrough("regions/2-simplex-r3");
  const Story story = tell(w);
  const std::vector<Question> questions = questions_of(story);
  const auto found = std::ranges::find_if(
      questions, [](const Question& q) { return q.decision.kind == Kind::region && q.decision.simplex_size == 3; });
  REQUIRE(found != questions.end());
  const auto reason = [&](const std::string& text) {
    const auto choice = std::ranges::find(found->choices, text, &Choice::text);
    return choice == found->choices.end() ? "" : choice->reason;
  };
  CHECK(found->choices[found->right].text == "R3: beyond edge AB");
  CHECK(reason("R3: beyond edge AB").starts_with("R3: AB_n·AO = "));
  CHECK(reason("R4: beyond B") == "the search does not look there: ruled out when the search kept BC");
  CHECK(reason("R7: beyond edge AC").starts_with("not looked at, since an earlier test has decided (R3: AB_n·AO = "));
}

TEST_CASE(
    "Of a tetrahedron a wrong choice is answered by the face that ruled it out, and by the edge where that was asked") {
  const Story story = tell(walkthrough("regions/3-simplex-face-adb-edge-ad"));
  std::map<Kind, const Question*> last;
  const std::vector<Question> questions = questions_of(story);
  for (const Question& question : questions)
    if (question.decision.simplex_size == 4) last[question.decision.kind] = &question;
  const auto reason = [&](Kind kind, const std::string& text) {
    const auto& choices = last.at(kind)->choices;
    const auto choice = std::ranges::find(choices, text, &Choice::text);
    return choice == choices.end() ? "" : choice->reason;
  };
  const std::string face_abc = reason(Kind::vertices, "[C, B, A]"), face_acd = reason(Kind::vertices, "[D, C, A]");
  CHECK(face_abc.find("ABC_n·AO = −37") != std::string::npos);
  CHECK(face_acd.find("ACD_n·AO = −8") != std::string::npos);
  CHECK(reason(Kind::vertices, "[C, A]") == face_abc + "; " + face_acd);  // both have the edge AC
  CHECK(reason(Kind::vertices, "[B, A]").find("AB_n·AO = −333") != std::string::npos);
  CHECK(reason(Kind::direction, "ACD_n") == face_acd);
  for (const Question& question : questions)
    if (question.decision.simplex_size == 4 && question.text.starts_with("Above which face")) {
      const auto inside = std::ranges::find(question.choices, "inside: above none of them", &Choice::text);
      REQUIRE(inside != question.choices.end());
      CHECK(inside->reason.find("ADB_n·AO = 28") != std::string::npos);
    }
}

TEST_CASE("What is asked about a simplex says of how many points it is") {
  std::map<int, std::string> asked;
  for (const char* const name :
       {"regions/0-simplex-a-is-origin", "regions/1-simplex-r3", "regions/2-simplex-r3", "regions/3-simplex-inside"})
    for (const Question& q : questions_of(tell(walkthrough(name))))
      if (q.decision.kind == Kind::region) asked[q.decision.simplex_size] = q.text;
  CHECK(asked[1] == "Is this vertex the origin?");
  CHECK(asked[3] == "In which region does the search find the origin?");
  CHECK(asked[4] == "Above which face does Algorithm 5 find the origin first?");
}

TEST_CASE("The key of a region is its number, and of a triangle's R1 above and below come last") {
  int triangles = 0;
  for (const Walkthrough& w : whole_catalogue())
    for (const Question& q : questions_of(tell(w))) {
      if (q.decision.simplex_size != 3 || q.choices.size() != 9) continue;
      INFO(w.name << ": " << q.text);
      CHECK(q.choices[0].text.starts_with("R1: in "));
      for (std::size_t r = 2; r <= 7; ++r) CHECK(q.choices[r - 1].text.starts_with("R" + std::to_string(r) + ": "));
      CHECK(q.choices[7].text.starts_with("R1: above "));
      CHECK(q.choices[8].text.starts_with("R1: below "));
      ++triangles;
    }
  CHECK(triangles > 20);
}

TEST_CASE("Of two searches that have not parted each question is asked once, of both") {
  const Story story = tell(walkthrough("as-printed-spheres"));
  REQUIRE(story.parts_at);
  int of_both = 0;
  for (const Question& q : questions_of(story)) {
    INFO(q.text);
    CHECK(q.text.starts_with("Both: ") == (q.event < *story.parts_at));
    if (q.event < *story.parts_at) CHECK(q.scene == 0);
    of_both += q.text.starts_with("Both: ");
  }
  CHECK(of_both > 0);
}

TEST_CASE("What the rules do not look at is told as that, not as true of the search") {
  int skipped = 0;
  for (const Question& q : questions_of(tell(walkthrough("as-printed-spheres"))))
    for (const Choice& choice : q.choices)
      if (choice.reason.find("would not have reached") != std::string::npos) {
        CHECK(choice.reason.starts_with("the search does not look there: "));
        ++skipped;
      }
  CHECK(skipped > 0);
}

TEST_CASE("Every wrong choice has a reason, and a hint unless all that is known of it would tell the right one",
          "[unsanitized][full]") {
  int hints = 0, untold = 0;
  for (const Walkthrough& w : whole_catalogue())
    for (const Question& question : questions_of(tell(w))) {
      if (question.choices.size() == 2) continue;
      INFO(w.name << ": " << question.text);
      const Choice& right = question.choices[question.right];
      const std::string label = right.text.substr(0, right.text.find(':'));
      for (const Choice& choice : question.choices) {
        if (&choice == &right) continue;
        INFO(choice.text << ": " << choice.reason);
        CHECK_FALSE(choice.reason.empty());
        const bool tells =
            choice.reason.find(label) != std::string::npos || choice.reason.find(right.reason) != std::string::npos;
        CHECK((!choice.hint.empty() || tells));
        ++(choice.hint.empty() ? untold : hints);
      }
    }
  CHECK(hints > 1100);
  CHECK(untold < 90);
}

TEST_CASE("No hint contains the right choice or its label, nor what speaks for it", "[full]") {
  int hints = 0;
  for (const Walkthrough& w : whole_catalogue())
    for (const Question& question : questions_of(tell(w))) {
      INFO(w.name << ": " << question.text);
      const Choice& right = question.choices[question.right];
      for (const Choice& choice : question.choices) {
        INFO(choice.text << ": " << choice.hint);
        CHECK(choice.hint.find(right.text) == std::string::npos);
        CHECK(choice.hint.find(right.text.substr(0, right.text.find(':'))) == std::string::npos);
        CHECK(choice.hint.find(right.reason) == std::string::npos);
        hints += !choice.hint.empty();
      }
      CHECK(right.hint.empty());
    }
  CHECK(hints > 300);
}

TEST_CASE("Who is asked for the wrong line is told what both searches find of the same thing, which no picture shows") {
  std::vector<std::string> by_words;
  for (const Walkthrough& w : whole_catalogue()) {
    const Story story = tell(w);
    for (const Question& question : questions_of(story)) {
      if (question.decision.kind != Kind::line) continue;
      INFO(question.text);
      const Frame& parting = *std::ranges::find(story.frames, Focus::parting, &Frame::focus);
      if (*w.scenes[0].mistake == Mistake::first_point_tested) continue;  // of which the report says nothing
      const std::string words = parting.facts[0].text.substr(0, parting.facts[0].text.size() - 1);
      if (question.text.find(words) != std::string::npos) {  // of one number what they make of it
        const auto other = std::ranges::find_if(
            parting.facts, [&](const Fact& fact) { return fact.text.starts_with(w.scenes[1].name + ": "); });
        REQUIRE(other != parting.facts.end());
        CHECK(question.text.ends_with("? " + words + "; " + other->text));
        by_words.push_back(w.scenes[0].name);
        continue;
      }
      const std::size_t one = question.text.find("? " + w.scenes[0].name + ": ");
      const std::size_t other = question.text.find("; " + w.scenes[1].name + ": ");
      REQUIRE((one < other && other != std::string::npos));
      const std::size_t from = one + 4 + w.scenes[0].name.size();
      const std::string mistaken = question.text.substr(from, other - from);
      const std::string right = question.text.substr(other + 4 + w.scenes[1].name.size());
      CHECK(right != mistaken + ".");
      if (question.text.find(" = ") != std::string::npos) CHECK(asked_first(mistaken) == asked_first(right));
    }
  }
  CHECK(by_words == std::vector<std::string>{"M3", "M5", "M6", "M12", "M13", "M21"});
}

TEST_CASE("At a feature that a proof keeps a wrong one is answered by the signs that were taken of it") {
  const Story story = tell(walkthrough("certified/cycle-separated"));
  const std::vector<Question> questions = questions_of(story);
  int of_proof = 0;
  for (const Question& question : questions) {
    if (!std::holds_alternative<gjk::FeatureKept<double>>(story.tellings[0].trace.events[question.event])) continue;
    ++of_proof;
    INFO(question.choices[question.right].text);
    CHECK(question.choices[question.right].reason.find(" ± ") != std::string::npos);
    for (const Choice& choice : question.choices)
      if (choice.text.starts_with("segment A") && choice.text != question.choices[question.right].text)
        CHECK(choice.reason.starts_with(choice.text.substr(8) + "·AO = "));
  }
  CHECK(of_proof >= 3);
}

TEST_CASE("By the complete rules a wrong feature is answered by what rules it out, not by what left it possible") {
  const Question question = [] {
    for (const Question& each : questions_of(tell(walkthrough("complete/cycle-separated"))))
      if (each.decision.simplex_size == 4 && each.decision.found.starts_with("ACD")) return each;
    return Question{};
  }();
  const auto edge = std::ranges::find_if(question.choices,
                                         [](const Choice& c) { return c.reason.find("1191") != std::string::npos; });
  CHECK(edge == question.choices.end());  // beyond AC in one plane, which speaks for AC
  CHECK(std::ranges::any_of(question.choices,
                            [](const Choice& c) { return c.reason.find("−453") != std::string::npos; }));
}

TEST_CASE(
    "Practice is another walkthrough of regions in which the search decides likewise, of each decision in the "
    "catalogue") {
  std::map<std::string, std::vector<Decision>> decisions;
  for (const Walkthrough& each : whole_catalogue()) {
    if (each.layout == Layout::diagrams) continue;
    const Story story = tell(each);
    for (const Question& question : questions_of(story)) decisions[each.name].push_back(question.decision);
  }
  const auto makes = [&](const std::string& name, const Decision& decision, const auto& is_likewise) {
    return std::ranges::any_of(decisions[name], [&](const Decision& other) {
      return other.kind == decision.kind && other.simplex_size == decision.simplex_size &&
             is_likewise(other.found, decision.found);
    });
  };
  const auto same = [](const std::string& one, const std::string& other) { return one == other; };
  const auto about_same = [](const std::string& one, const std::string& other) {
    return one.substr(0, one.find(' ')) == other.substr(0, other.find(' '));
  };
  int exact = 0;
  for (const auto& [name, made] : std::map(decisions))
    for (const Decision& decision : made) {
      if (decision.kind == Kind::line) continue;
      const std::string best = practice_for(decision, ""), practice = practice_for(decision, name);
      INFO(name << ", " << decision.found << ": " << best << ", " << practice);
      CHECK(practice != name);
      CHECK(makes(practice, decision, about_same));
      const bool can_be_same = std::ranges::any_of(decisions, [&](const auto& each) {
        return each.first.starts_with("regions/") && makes(each.first, decision, same);
      });
      CHECK(makes(best, decision, same) == can_be_same);
      exact += can_be_same;
    }
  CHECK(exact > 500);
  CHECK(practice_for({Kind::region, 3, "AB positive"}, "") == "regions/2-simplex-r3");
  CHECK(practice_for({Kind::region, 7, "nothing"}, "").empty());
}

TEST_CASE("Practice is about just the decision that was missed, where there is such a walkthrough") {
  struct Row {
    Decision missed;
    std::string but, practice;
  };
  const std::vector<Row> rows{
      {{Kind::crossing, 0, "not crossed"}, "", "1-simplex-r2-cannot-happen"},
      {{Kind::region, 1, "A = 0"}, "", "0-simplex-a-is-origin"},
      {{Kind::region, 2, "AB = 0"}, "", "1-simplex-on-segment"},
      {{Kind::region, 3, "AB > 0"}, "", "2-simplex-r3"},
      {{Kind::region, 3, "AB > 0"}, "2-simplex-r3", "2-simplex-r4-cannot-happen"},
      {{Kind::vertices, 3, "AC > 0"}, "", "2-simplex-r7"},
      {{Kind::region, 3, "ABC > 0"}, "", "2-simplex-r1-above"},
      {{Kind::direction, 3, "ABC < 0"}, "", "2-simplex-r1-below"},
      {{Kind::region, 3, "ABC = 0"}, "", "2-simplex-r1-in-plane"},
      {{Kind::region, 4, "ACD > 0"}, "", "3-simplex-face-acd"},
      {{Kind::region, 4, "ADB > 0"}, "", "3-simplex-face-adb"},
      {{Kind::region, 4, "ADB AD > 0"}, "", "3-simplex-face-adb-edge-ad"},
      {{Kind::region, 4, "ADB AD > 0"}, "3-simplex-face-adb-edge-ad", "3-simplex-face-adb"},
      {{Kind::region, 4, "ABCD > 0"}, "", "3-simplex-inside"},
      {{Kind::line, 2, "m13-origin-in-triangle"}, "", "2-simplex-r1-in-plane"},
      {{Kind::line, 3, "m21-origin-in-face"}, "", "3-simplex-on-face"},
  };
  for (const Row& row : rows) {
    INFO(row.missed.found << ", not " << row.but);
    CHECK(practice_for(row.missed, "regions/" + row.but) == "regions/" + row.practice);
  }
  CHECK(practice_for({Kind::line, 0, "m1-wrong-side-of-b"}, "").empty());
  for (const auto& mistake : wrong_on_purpose::all()) {
    const std::string name = practice_for({Kind::line, 0, std::string(mistake.word)}, "");
    INFO(mistake.word << ": " << name);
    CHECK((name.empty() || find_walkthrough(name)));
  }
}

}  // namespace questions_test
