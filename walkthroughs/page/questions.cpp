#include "walkthroughs/page/questions.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "walkthroughs/model/words_of.hpp"
#include "walkthroughs/story/captions.hpp"
#include "walkthroughs/story/number_line.hpp"
#include "walkthroughs/story/pseudocode.hpp"

namespace walkthroughs::page {
namespace {

using gjk::Relation;
using gjk::Verdict;
using Kind = Decision::Kind;
using Region = gjk::RegionTested<double>;

// -- Choices ----------------------------------------------------------------------------------------------------------

/// A hint that names the right choice, or what speaks for it, is none; where one number decides among three or more, which one that
/// is leaves it open. Of two choices one that is wrong tells the other.
void keep_open(std::vector<Choice>& choices, const Choice right) {
  const bool is_among_several = std::ranges::count(choices, right.reason, &Choice::reason) > 2 && !right.asked.empty();
  const std::string& called = right.label.empty() ? right.text : right.label;
  for (Choice& choice : choices) {
    const auto tells = [&](const std::string& what) { return choice.hint.find(what) != std::string::npos; };
    if (choices.size() == 2 || choice.text == right.text || tells(called) || tells(right.reason))
      choice.hint = is_among_several && choice.text != right.text && choice.reason == right.reason
                        ? "what decides is " + right.asked
                        : "";
  }
}

/// Returns: the question with its choices in order of their regions, else of the alphabet; nothing where there is no choice, or none is
/// right.
std::optional<Question> asked(Decision decision, std::size_t scene, std::size_t event, std::string text,
                              std::vector<Choice> choices, const std::string& right) {
  std::ranges::sort(choices, {}, [](const Choice& each) { return std::pair(each.place, each.text); });
  const auto found = std::ranges::find(choices, right, &Choice::text);
  if (choices.size() < 2 || found == choices.end()) return std::nullopt;
  const auto place = static_cast<std::size_t>(found - choices.begin());
  keep_open(choices, *found);
  return Question{std::move(decision), scene, event, std::move(text), std::move(choices), place};
}

// -- Where they can be pointed at ----------------------------------------------------------------------------------------

Point middle_of(const Simplex& simplex, const gjk::Roles& roles) {
  Point sum = Point::Zero();
  for (const gjk::Role role : roles) sum += simplex.point(role);
  return sum / std::max(1, roles.size());
}

/// Of a feature of what may be a face, moved away from the rest of that.
Aim aim_at(const Simplex& simplex, const gjk::Roles& feature, const gjk::Roles& of, std::string name) {
  gjk::Roles rest;
  for (const gjk::Role role : of)
    if (!feature.has(role)) rest.add(role);
  const Point at = middle_of(simplex, feature);
  return {.at = at,
          .toward = rest.empty() ? Point(Point::Zero()) : Point(at - middle_of(simplex, rest)),
          .name = std::move(name),
          .face = of.size() == 3 ? of : feature,
          .is_height = feature.size() == 3};
}
Aim aim_at(const Simplex& simplex, const gjk::Roles& feature, std::string name) {
  const gjk::Roles all = simplex.size() == 3 ? gjk::Roles("ABC") : gjk::beside({}, simplex.size());
  return aim_at(simplex, feature, all, std::move(name));
}

/// Of what lies on one side of a triangle.
Aim aim_beside(const Simplex& simplex, const gjk::Roles& face, double side, std::string name) {
  const Point first = simplex.point(face[0]);
  const Point normal = (simplex.point(face[1]) - first).cross(simplex.point(face[2]) - first);
  return {.at = middle_of(simplex, face),
          .toward = side * normal,
          .name = std::move(name),
          .face = face,
          .is_height = true};
}

/// Along what a way on is called: from where it leaves, in any length. Requires: no formula but those of Algorithms 2 to 5.
Point vector_of(const Simplex& simplex, const gjk::NamedVector& vector) {
  const auto point = [&](int i) { return simplex.point(vector.of[i]); };
  if (vector.kind == gjk::NamedVector::Kind::to_origin) return -simplex.point(gjk::Role::A);
  if (vector.of.size() < 3) return point(1) - point(0);
  return (point(1) - point(0)).cross(point(2) - point(0));
}
Point vector_of(const Simplex& simplex, const gjk::Expression& expression) {
  const Point X = vector_of(simplex, expression.X);
  if (expression.form == gjk::Expression::Form::negative) return -X;
  if (expression.form == gjk::Expression::Form::vector) return X;
  const Point product = X.cross(vector_of(simplex, expression.Y));
  return expression.form == gjk::Expression::Form::triple ? Point(product.cross(X)) : product;
}

// -- Choices of regions -----------------------------------------------------------------------------------------------

/// "R3: beyond edge AB".
Choice choice_of(gjk::RegionLabel label, const std::string& words) {
  if (label == gjk::RegionLabel::none) return {.text = words};
  const std::string name(to_string(label));
  const int number = label == gjk::RegionLabel::R3_or_R4 ? 3 : static_cast<int>(label);
  return {.text = name + ": " + words, .label = name, .place = number};
}

/// What a line asks about. R1 of a triangle is three choices.
Choice choice_of(int size, const TestsOf& tests, const std::string& name) {
  using enum gjk::RegionLabel;
  const bool is_zero = tests.relation == Relation::zero, is_above = tests.relation == Relation::positive;
  if (size == 1) return choice_of(none, is_zero ? "yes, it is O" : "no, O lies elsewhere");
  if (size == 2) return is_zero ? choice_of(none, "on segment " + name) : choice_of(R3_or_R4, "to one side of " + name);
  if (size == 3 && tests.feature == "ABC") {
    Choice choice = choice_of(R1, (is_zero ? "in" : is_above ? "above" : "below") + (" triangle " + name));
    if (!is_zero) choice.place = is_above ? 8 : 9;
    return choice;
  }
  if (size == 3) return choice_of(tests.feature == "AB" ? R3 : R7, "beyond edge " + name);
  return choice_of(none, tests.feature.size() == 4 ? "inside: above none of them" : "above face " + name);
}

Choice choice_of_skipped(const Region& region, const std::string& name) {
  constexpr const char* kinds[] = {"beyond ", "beyond edge ", "above face "};
  return choice_of(label_of(region), kinds[region.feature.size() - 1] + name);
}

/// What the newest vertex belongs to, of simplices of any size.
constexpr gjk::Roles features_of_newest[] = {"A", "AB", "AC", "AD", "ABC", "ACD", "ADB", "ABCD"};

bool is_of_simplex(const gjk::Roles& feature, int size) {
  return std::ranges::all_of(feature, [size](gjk::Role role) { return static_cast<int>(role) < size; });
}

// -- One iteration ----------------------------------------------------------------------------------------------------

/// What one iteration of the search of a scene asks. Events are counted from 0 in its trace.
class Iteration {
 public:
  /// `tests`: the place of the first region test that was made; the following ones are looked for.
  Iteration(const Story& story, std::size_t scene, std::size_t tests)
      : scene_(scene),
        telling_(story.tellings[scene]),
        events_(telling_.trace.events),
        first_(tests),
        end_(end_of_tests(tests)),
        now_(replay(telling_.trace, end_)),
        names_(story.walkthrough.naming, telling_.hull, now_),
        size_(now_.processed.size()),
        code_(algorithm(size_ + 1, telling_.scene.rules)) {}

  void ask(std::vector<Question>& questions) const {
    if (!last_chosen() || !chosen_without_face()) return;
    if (telling_.scene.rules == RuleSet::complete && size_ > 1) {
      questions.push_back(*of_nearest());
      return;
    }
    for (const auto& question : {of_region(), of_edge(), of_vertices(), of_direction()})
      if (question) questions.push_back(*question);
  }

 private:
  /// Behind the tests something follows: the last event of a search is Finished.
  std::size_t end_of_tests(std::size_t at) const {
    while (std::holds_alternative<Region>(events_[at])) ++at;
    return at;
  }

  const Region* last_chosen() const {
    const auto found = std::find_if(now_.regions.rbegin(), now_.regions.rend(),
                                    [](const Region& region) { return region.verdict == Verdict::chosen; });
    return found == now_.regions.rend() ? nullptr : &*found;
  }
  /// Of a tetrahedron the face; else the region.
  const Region* chosen_without_face() const {
    const auto found = std::ranges::find_if(
        now_.regions, [](const Region& region) { return region.verdict == Verdict::chosen && region.face.empty(); });
    return found == now_.regions.end() ? nullptr : &*found;
  }

  Decision decision(Kind kind) const {
    const Region& region = *last_chosen();
    return {kind, size_,
            (region.face.empty() ? "" : to_string(region.face) + " ") + to_string(region.feature) + " " +
                std::string(words_of::of(region.relation))};
  }

  /// The number that decided, as the caption of that test says it. Requires: a test of now_, whose tests are the last events
  /// before end_.
  Fact fact_of(const Region& region) const {
    const auto behind = static_cast<std::size_t>(now_.regions.data() + now_.regions.size() - &region);
    const std::size_t at = end_ - behind;
    return telling_.said[at]->facts[0];
  }
  std::string value_of(const Region& region) const { return fact_of(region).text; }

  const Region* made(const gjk::Roles& face, const gjk::Roles& feature) const {
    const auto found = std::ranges::find_if(now_.regions, [&](const Region& region) {
      return region.verdict != Verdict::skipped && region.face == face && region.feature == feature;
    });
    return found == now_.regions.end() ? nullptr : &*found;
  }

  /// Returns: the choice with why the search has not found what that line asks about, or that it has, and what of it may be told
  /// first: its own test; else that of the face in which it asks about an edge; else the one that was right before it.
  Choice explained(Choice choice, const CodeLine& line) const {
    const gjk::Roles& in_face = line.tests.face;
    const Region* face = in_face.empty() ? nullptr : made({}, in_face);
    const Region* own = made(in_face, line.tests.feature);
    if (!own && face && face->verdict != Verdict::chosen) own = face;
    if (own) {
      const Fact fact = fact_of(*own);
      choice.reason = choice.hint = fact.text;
      choice.asked = fact.asked;
    } else {
      choice.hint = "an earlier test has decided";
      choice.reason =
          "not looked at, since " + choice.hint + " (" + value_of(face ? *last_chosen() : *chosen_without_face()) + ")";
    }
    return choice;
  }

  bool is_of(const CodeLine& line, const Region& region) const {
    return line.kind == LineKind::test && line.tests.face == region.face && line.tests.feature == region.feature &&
           (!line.tests.relation || *line.tests.relation == region.relation);
  }

  /// Of a search in the plane, which is never above or below a triangle.
  bool leaves_the_plane(const CodeLine& test) const {
    return telling_.scene.dimension == Dimension::plane && size_ == 3 && test.tests.feature.size() == 3 &&
           test.tests.relation != Relation::zero;
  }

  /// The rules suppose so, whether or not it is true of this search.
  std::string skipped_because(const Region& region) const {
    return "the search does not look there: " + names_.translate(reason_in_words(region));
  }

  /// `relation`: what a line asks about, where it does.
  Aim aim_of(const gjk::Roles& feature, std::optional<Relation> relation, const Choice& choice) const {
    const Simplex& simplex = now_.processed;
    const bool is_zero = relation == Relation::zero, is_above = relation == Relation::positive;
    if (size_ == 3 && feature.size() == 3 && !is_zero)
      return aim_beside(simplex, feature, is_above ? 1 : -1, is_above ? "above" : "below");
    if (feature.size() == size_) {
      const Point middle = middle_of(simplex, feature);
      const bool is_inside = is_zero || size_ == 4;
      return {.at = middle,
              .toward = is_inside ? Point(Point::Zero()) : Point(-middle),
              .name = is_inside ? "inside" : choice.label,
              .face = feature,
              .is_height = true};
    }
    return aim_at(simplex, feature, choice.label.empty() ? names_.sorted(feature) : choice.label);
  }

  std::optional<Question> of_region() const {
    std::vector<Choice> choices;
    std::string right;
    for (const CodeLine& line : code_) {
      if (line.kind != LineKind::test || !line.tests.face.empty() || leaves_the_plane(line)) continue;
      Choice choice = choice_of(size_, line.tests, names_.sorted(line.tests.feature));
      if (is_of(line, *chosen_without_face())) right = choice.text;
      if (size_ > 1) choice.aim = aim_of(line.tests.feature, line.tests.relation, choice);
      add_once(choices, explained(std::move(choice), line));
    }
    for (const Region& region : now_.regions)
      if (region.verdict == Verdict::skipped && (size_ < 4 || region.feature.size() == 3)) {
        Choice choice = choice_of_skipped(region, names_.sorted(region.feature));
        choice.reason = choice.hint = skipped_because(region);
        choice.aim = aim_of(region.feature, Relation::positive, choice);
        add_once(choices, std::move(choice));
      }
    const std::string text = size_ == 4   ? "Above which face does Algorithm 5 find the origin first?"
                             : size_ == 1 ? "Is this vertex the origin?"
                                          : "In which region does the search find the origin?";
    return asked(decision(Kind::region), scene_, first_, text, std::move(choices), right);
  }

  /// The last test of the complete rules of that feature, which ask several things of it, with that verdict.
  const Region* asked_of(const gjk::Roles& feature, Verdict verdict) const {
    const auto found = std::find_if(now_.regions.rbegin(), now_.regions.rend(), [&](const Region& region) {
      return region.verdict == verdict && region.feature == feature && !region.expression.empty();
    });
    return found == now_.regions.rend() ? nullptr : &*found;
  }

  /// What has decided for a feature, or ruled it out; what only left it possible speaks for it.
  std::string reason_of(const gjk::Roles& feature) const {
    for (const Verdict verdict : {Verdict::chosen, Verdict::rejected})
      if (const Region* region = asked_of(feature, verdict)) return value_of(*region);
    return "what was asked of other features has decided";
  }

  /// Of the complete rules, which decide for one feature among all that A belongs to.
  std::optional<Question> of_nearest() const {
    const auto words = [&](const gjk::Roles& feature) { return with_kind(names_.sorted(feature)); };
    std::vector<Choice> choices;
    for (const gjk::Roles& feature : features_of_newest)
      if (is_of_simplex(feature, size_))
        choices.push_back({.text = words(feature),
                           .reason = reason_of(feature),
                           .hint = reason_of(feature),
                           .aim = aim_at(now_.processed, feature, names_.sorted(feature))});
    return asked(decision(Kind::region), scene_, first_, "On which feature does the point nearest to the origin lie?",
                 std::move(choices), words(last_chosen()->feature));
  }

  /// Of a tetrahedron's face.
  std::optional<Question> of_edge() const {
    const Region& face = *chosen_without_face();
    if (size_ != 4 || face.feature.size() != 3) return std::nullopt;
    const std::string name = names_.sorted(face.feature), neither = "beyond neither: above the face itself";
    std::vector<Choice> choices;
    std::string right = neither, values;
    std::size_t event = end_;
    for (const CodeLine& line : code_) {
      if (line.kind != LineKind::test || line.tests.face != face.feature) continue;
      const std::string edge = names_.sorted(line.tests.feature);
      Choice choice = explained({"beyond edge " + edge}, line);
      choice.aim = aim_at(now_.processed, line.tests.feature, face.feature, edge);
      if (is_of(line, *last_chosen())) right = choice.text;
      values += (values.empty() ? "" : "; ") + choice.reason;
      add_once(choices, choice);
    }
    choices.push_back({.text = neither, .reason = values, .aim = aim_at(now_.processed, face.feature, "neither")});
    for (std::size_t i = end_; i-- > first_;)
      if (std::get<Region>(events_[i]).face == face.feature) event = i;
    if (event == end_) return std::nullopt;
    auto question =
        asked(decision(Kind::region), scene_, event,
              "The origin lies above face " + name + ". Projected onto its plane, beyond which edge does it lie?",
              std::move(choices), right);
    if (question) question->tells_before = true;
    return question;
  }

  /// Whether the search goes on, and from where.
  const gjk::SimplexReduced<double>* reduction() const {
    return std::get_if<gjk::SimplexReduced<double>>(&events_[end_]);
  }
  std::size_t direction_at() const { return reduction() ? end_ + 1 : end_; }
  const gjk::DirectionChosen<double>* direction() const {
    return std::get_if<gjk::DirectionChosen<double>>(&events_[direction_at()]);
  }

  std::string in_list(const gjk::Roles& roles) const {
    return "[" + joined(roles, ", ", [this](gjk::Role role) { return names_.of(role); }) + "]";
  }

  static void add_part(std::string& text, const std::string& part) {
    if (text.find(part) == std::string::npos) text += "; " + part;
  }

  /// Choices from the ways on of the running algorithm, each with what the tests before it have found: two lines of a tetrahedron's
  /// may lead the same way.
  template <class Words, class Aims>
  std::vector<Choice> ways(const std::string& right, const std::string& why, const Words& words,
                           const Aims& aims) const {
    std::vector<Choice> choices;
    const CodeLine* test = nullptr;
    for (const CodeLine& line : code_) {
      if (line.kind == LineKind::test) test = &line;
      if (!line.way || !test || leaves_the_plane(*test)) continue;
      const std::string text = words(*line.way);
      Choice choice = text == right ? Choice{text, why} : explained({text}, *test);
      choice.aim = aims(*line.way);
      const auto known = std::ranges::find(choices, text, &Choice::text);
      if (known == choices.end()) {
        choices.push_back(choice);
        continue;
      }
      add_part(known->reason, choice.reason);
      add_part(known->hint, choice.hint);
    }
    return choices;
  }

  Aim aim_at_dropped(const gjk::Roles& kept) const {
    const gjk::Roles dropped = beside(kept, size_);
    if (dropped.empty()) return aim_at(now_.processed, kept, "keep " + in_list(kept));
    return aim_at(now_.processed, dropped,
                  "drop " + joined(dropped, ", ", [this](gjk::Role role) { return names_.of(role); }));
  }

  std::optional<Question> of_vertices() const {
    if (size_ < 3 || (!reduction() && !direction())) return std::nullopt;
    const std::string right = in_list(reduction() ? reduction()->kept : "CBA");
    const std::string why =
        names_.translate(reduction() ? gjk::to_string(reduction()->why)
                                     : "the origin lies above the triangle, on the side of its normal");
    std::vector<Choice> choices = ways(
        right, why, [&](const Way& way) { return in_list(way.kept); },
        [&](const Way& way) { return aim_at_dropped(way.kept); });
    std::set<std::string> without_order;
    for (const Choice& choice : choices) {
      std::string kept = choice.text;
      std::ranges::sort(kept);
      without_order.insert(kept);
    }
    const bool is_order_asked = without_order.size() < choices.size();
    return asked(decision(Kind::vertices), scene_, end_,
                 is_order_asked ? "Which vertices stay, and in which order?" : "Which vertices stay?",
                 std::move(choices), right);
  }

  std::optional<Question> of_direction() const {
    if (size_ < 3 || !direction()) return std::nullopt;
    const std::string right = names_.translate(direction()->expression);
    const std::string why = value_of(*last_chosen()) + "; " + telling_.said[direction_at()]->facts[0].text;
    return asked(decision(Kind::direction), scene_, direction_at(), "Along which formula does the search go on?",
                 ways(
                     right, why, [&](const Way& way) { return names_.translate(way.direction); },
                     [&](const Way& way) {
                       return Aim{.at = middle_of(now_.processed, way.kept),
                                  .toward = vector_of(now_.processed, way.direction),
                                  .name = ""};
                     }),
                 right);
  }

  const std::size_t scene_;
  const Telling& telling_;
  const std::vector<gjk::Event<double>>& events_;
  const std::size_t first_, end_;  ///< of the region tests that were made
  const Moment now_;               ///< after them
  const Names names_;
  const int size_;
  const std::vector<CodeLine>& code_;
};

// -- The crossing test ------------------------------------------------------------------------------------------------

std::optional<Question> of_crossing(const Story& story, std::size_t scene, std::size_t at) {
  const Telling& telling = story.tellings[scene];
  const auto& event = std::get<gjk::CrossingTested<double>>(telling.trace.events[at]);
  if (!event.value) return std::nullopt;
  const std::string why = telling.said[at]->facts[0].text;
  const bool is_crossed = event.verdict == gjk::Crossing::crossed;
  const std::string yes = "yes, or just reached", no = "no";
  return asked({Kind::crossing, 0, is_crossed ? "crossed" : "not crossed"}, scene, at, "Was the origin crossed?",
               {{yes, why, ""}, {no, why, ""}}, is_crossed ? yes : no);
}

// -- The second search ------------------------------------------------------------------------------------------------

bool is_same_feature(const gjk::Roles& one, const gjk::Roles& other) {
  return one.size() == other.size() && std::ranges::all_of(one, [&](gjk::Role role) { return other.has(role); });
}

/// Whether the sign is of what is asked about a feature: A by where the others lie, an edge by AB·AO, AB_n·AO and AB×AO, a face by the
/// normals of its edges and its own, a tetrahedron by those of its faces.
bool is_of_feature(const gjk::SignTaken<double>& sign, const gjk::Roles& feature) {
  const gjk::NamedVector& asked = sign.expression.X;
  const bool is_normal = asked.kind == gjk::NamedVector::Kind::normal;
  if (feature.size() == 1)
    return sign.expression.form == gjk::Expression::Form::dot && asked.kind == gjk::NamedVector::Kind::edge;
  if (feature.size() == 4) return asked.of.size() == 3;
  const bool is_of_its_edge = feature.size() == 3 && is_normal && is_same_feature(sign.face, feature);
  return is_same_feature(asked.of, feature) || is_of_its_edge;
}

/// Returns: what was found of that feature; empty where nothing was.
std::string signs_about(const gjk::Roles& feature, const Moment& now, const Names& names, Dimension dimension) {
  std::string text;
  for (const gjk::SignTaken<double>& sign : now.signs)
    if (is_of_feature(sign, feature) && !(dimension == Dimension::plane && is_out_of_plane(sign)))
      text += (text.empty() ? "" : "; ") + sign_in_words(sign, names);
  return text;
}

/// Of a proof: what exact signs say of the simplex, in which nothing is ruled out by what was before.
std::optional<Question> of_kept(const Story& story, std::size_t scene, std::size_t at) {
  const Telling& telling = story.tellings[scene];
  const auto& event = std::get<gjk::FeatureKept<double>>(telling.trace.events[at]);
  const Moment now = replay(telling.trace, at);
  const Names names(story.walkthrough.naming, telling.hull, now);
  std::vector<Choice> choices;
  std::string found, right;
  for (const gjk::Roles& feature : features_of_newest) {
    if (!is_of_simplex(feature, event.before.size())) continue;
    const std::string text = names.simplex(event.before.only(feature));
    add_once(choices, {.text = text,
                       .reason = signs_about(feature, now, names, telling.scene.dimension),
                       .aim = aim_at(event.before, feature, text)});
    if (!is_same_feature(feature, event.kept)) continue;
    found = to_string(feature);
    right = text;
  }
  for (Choice& choice : choices) {
    if (choice.reason.empty())
      choice.reason = choice.text == right ? "it is no other feature, and one it must be"
                                           : "not looked at, since what was asked of other features has decided";
    choice.hint = choice.reason;
  }
  return asked({Kind::region, event.before.size(), found + " kept"}, scene, at,
               "On which feature does the point nearest to the origin lie?", std::move(choices), right);
}

// -- All of them --------------------------------------------------------------------------------------------------------

void ask_about(std::size_t scene, const Story& story, std::vector<Question>& questions) {
  const std::vector<gjk::Event<double>>& events = story.tellings[scene].trace.events;
  bool is_asked = false;  // about the regions of this iteration
  for (std::size_t i = 0; i < events.size(); ++i) {
    if (std::holds_alternative<gjk::SupportFound<double>>(events[i])) is_asked = false;
    if (std::holds_alternative<gjk::CrossingTested<double>>(events[i]))
      if (const auto question = of_crossing(story, scene, i)) questions.push_back(*question);
    if (std::holds_alternative<gjk::FeatureKept<double>>(events[i]))
      if (const auto question = of_kept(story, scene, i)) questions.push_back(*question);
    const auto* region = std::get_if<Region>(&events[i]);
    if (!region || region->verdict == Verdict::skipped || is_asked) continue;
    Iteration(story, scene, i).ask(questions);
    is_asked = true;
  }
}

/// Returns: the frame that answers the question; nothing where the frame before it does not show what is asked about.
std::optional<std::size_t> answering_frame(const Story& story, const Question& question) {
  const auto [scene, event] = std::pair(question.scene, question.event);
  for (std::size_t i = 1; i < story.frames.size(); ++i) {
    const EventRange range = story.frames[i].events.at(scene);
    if (range.last != event) continue;
    for (std::size_t e = range.first; e < event; ++e)
      if (std::holds_alternative<gjk::SupportFound<double>>(story.tellings[scene].trace.events[e])) return std::nullopt;
    return i;
  }
  return std::nullopt;
}

}  // namespace

std::vector<Question> questions_of(const Story& story) {
  std::vector<Question> questions;
  if (story.shows_mistake()) {
    if (auto question = question_of_line(story)) questions.push_back(std::move(*question));
    return questions;
  }
  for (std::size_t scene = 0; scene < story.tellings.size(); ++scene) ask_about(scene, story, questions);
  if (story.tellings.size() == 1) return questions;
  const auto is_of_both = [&](const Question& question) { return story.parts_at && question.event < *story.parts_at; };
  std::erase_if(questions, [&](const Question& question) { return question.scene > 0 && is_of_both(question); });
  for (Question& question : questions)
    question.text = (is_of_both(question) ? "Both" : story.tellings[question.scene].scene.name) + ": " + question.text;
  return questions;
}

std::vector<Question> in_frames(const std::vector<Question>& questions, const Story& story) {
  std::vector<Question> answered;
  for (Question question : questions) {
    const std::optional<std::size_t> frame = answering_frame(story, question);
    if (!frame) continue;
    question.frame = *frame;
    answered.push_back(std::move(question));
  }
  return answered;
}

}  // namespace walkthroughs::page
