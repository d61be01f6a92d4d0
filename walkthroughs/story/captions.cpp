#include "walkthroughs/story/captions.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>
#include <variant>

#include "walkthroughs/story/decision.hpp"
#include "walkthroughs/story/rounding.hpp"
#include "walkthroughs/story/truth_told.hpp"
#include "walkthroughs/story/words.hpp"

namespace walkthroughs::story {
namespace {

using Mark = Fact::Mark;
using gjk::Crossing;
using gjk::Relation;
using gjk::Verdict;

// -- Remarks ----------------------------------------------------------------------------------------------------------

bool is_about(const Remark& remark, const gjk::RegionTested<double>& region) {
  const std::string &wanted = remark.only_for, feature = to_string(region.feature);
  return wanted.empty() || wanted == to_string(label_of(region)) || wanted == feature ||
         wanted == to_string(region.face) + " " + feature;
}

bool is_about(const Remark& remark, const gjk::Event<double>& event) {
  if (std::visit([](const auto& e) { return e.iteration; }, event) != remark.iteration) return false;
  switch (remark.at) {
    case Remark::At::support_found: return std::holds_alternative<gjk::SupportFound<double>>(event);
    case Remark::At::crossing_tested: return std::holds_alternative<gjk::CrossingTested<double>>(event);
    case Remark::At::reduced: return std::holds_alternative<gjk::SimplexReduced<double>>(event);
    case Remark::At::direction_chosen: return std::holds_alternative<gjk::DirectionChosen<double>>(event);
    case Remark::At::end: return std::holds_alternative<gjk::Finished<double>>(event);
    case Remark::At::region_tested: break;
  }
  const auto* region = std::get_if<gjk::RegionTested<double>>(&event);
  return region && is_about(remark, *region);
}

// -- Captions ---------------------------------------------------------------------------------------------------------

/// Writes caption and facts for one event; `now` is the moment after it. Events that do not change the picture, or that
/// are told together with the next one, give nothing.
class Captions {
 public:
  Captions(const Story& story, const Telling& telling, const Moment& now)
      : story_(story),
        walkthrough_(story.walkthrough),
        telling_(telling),
        scene_(telling.scene),
        now_(now),
        names_(walkthrough_.naming, telling.hull, now) {}

  std::optional<Frame> operator()(const gjk::SearchStarted<double>&) const { return std::nullopt; }

  std::optional<Frame> operator()(const gjk::SupportFound<double>& event) const {
    const std::string name = names_.of(event.vertex.w);
    const std::string along = event.direction == Point(1, 0, 0) ? "+x" : "d";
    if (scene_.mistake == Mistake::wrong_side_of_b) return of_wrong_side(event, name, along);
    const std::string found = "the support point along " + along + " is " + name;
    std::string caption = found + (event.is_new ? "" : " again: there is no new point");
    if (walkthrough_.naming == Naming::roles && !event.is_new)
      caption = found + ", which was found before, in iteration " +
                std::to_string(iteration_that_found(event.vertex.w)) +
                (is_vertex(event.vertex.w) ? "" : ", and dropped since");
    const bool is_retold_exactly =  // the doubles here are not the search's floats
        scene_.scalar == Scalar::binary64 && !is_otherwise_exactly(event);
    Frame frame = frame_about(
        Focus::support, caption,
        {{Mark::none, "d = " + vec(event.direction) + (is_retold_exactly ? "; " + farthest_two(event) : "")},
         difference_told(event, name, now_.in_exact_fallback ? "a − b" : "support(a, d) − support(b, −d)")});
    if (event.iteration == 1) frame.facts.push_back({Mark::none, first_point_fact()});
    if (now_.in_exact_fallback)
      frame.facts.push_back({Mark::none, "no vertex that the first search ended with reaches across"});
    return frame;
  }

  std::optional<Frame> operator()(const gjk::CrossingTested<double>& event) const {
    if (!event.value) return std::nullopt;
    const std::string name = names_.of(now_.found->w);
    const std::string value = name + "·d = " + number(*event.value);
    const auto frame = [&](const std::string& compared, const std::string& conclusion, Mark mark,
                           const std::string& what) {
      return frame_by_number(Focus::crossing, value + compared, conclusion,
                             {mark, value + compared + ": " + what, name + "·d", number(*event.value)});
    };
    const bool is_first = event.iteration == 1, is_missed = event.verdict == Crossing::not_crossed;
    const std::string stops = name + " stops short of the origin along d",
                      level = name + " lies level with the origin along d",
                      nothing =
                          " (Eq. 9)" + std::string(is_farthest() ? ". Nothing of the difference reaches farther" : "");
    if (is_missed && is_first)
      return frame(" < 0", stops + nothing, Mark::no, "the difference ends before the origin (Eq. 9)");
    if (is_missed && *event.value == 0)
      return frame("", level + ", and that counts as missed", Mark::no, "taken for a proof, which it is not");
    if (is_missed)
      return frame(" < 0", stops + (in_float() ? ", computed in floats" : nothing), Mark::no,
                   "the origin was not crossed (Eq. 9)");
    if (!(*event.value > 0))
      return frame(as_zero(*event.value), level + ". The search goes on", Mark::none, "this proves nothing");
    return frame(" > 0", "along d, " + name + " lies past the origin. The search goes on", Mark::yes,
                 is_first ? "this proves nothing" : "the origin was crossed");  // no move led to the first
  }

  /// Joins to the last frame what is true beside the answer, behind that. How a mistake ends is told in words of its own.
  void add_truth(Frame& frame, const gjk::Event<double>& event) const {
    if (scene_.mistake || &event != &telling_.trace.events.back()) return;
    const TruthTold told = truth_told(telling_.truth, scene_, answer_of(telling_.trace));
    if (!told.predicate.empty()) {
      append_to(frame, "in truth they " + told.predicate);
      frame.headline = frame.caption;
    }
    frame.facts.insert(frame.facts.begin() + 1, told.facts.begin(), told.facts.end());
  }

  /// Joins to a frame what the walkthrough has to say about its event.
  void add_remarks(Frame& frame, const gjk::Event<double>& event) const {
    for (const Remark& remark : walkthrough_.remarks) {
      if (!is_about(remark, event)) continue;
      append_to(frame, in_letters(remark.text));
      if (remark.fact.empty()) continue;
      const Mark mark = remark.contradicts ? Mark::truth : Mark::none;
      frame.facts.insert(frame.facts.begin() + 1, {mark, in_letters(remark.fact)});
    }
  }

  /// Says so where the number of a frame decides otherwise than exact arithmetic, unless a remark says why.
  void add_exact(Frame& frame, const gjk::Event<double>& event) const {
    const std::optional<std::string> exactly = exact_otherwise(event, now_, scene_, names_);
    if (!exactly) return;
    frame.facts.insert(frame.facts.begin() + 1, {Mark::truth, "in exact arithmetic: " + *exactly});
    const auto says_why = [&](const Remark& remark) { return remark.contradicts && is_about(remark, event); };
    if (std::ranges::none_of(walkthrough_.remarks, says_why)) append_to(frame, "in exact arithmetic it is otherwise");
  }

  /// Corners keep their names, so there is nothing to tell; roles move on.
  std::optional<Frame> operator()(const gjk::VertexAdded<double>& event) const {
    if (now_.in_exact_fallback && event.simplex.size() == 1) return second_start();
    if (walkthrough_.naming == Naming::corners || event.simplex.size() == 1) return std::nullopt;
    const std::string newest = names_.of(event.simplex.point(gjk::Role::A));
    return frame_about(Focus::added,
                       walkthrough_.naming == Naming::roles ? "P joins the simplex as its newest vertex, A"
                                                            : newest + " joins the simplex as its newest vertex",
                       facts_of_newest(newest));
  }

  std::optional<Frame> operator()(const gjk::RegionTested<double>& event) const {
    if (event.verdict == Verdict::skipped) return std::nullopt;
    Frame frame = decided(event, region_caption(event));
    append_to(frame, gone_on_as_if(event));
    const auto tell = [&](const std::string& text) { frame.facts.push_back({Mark::none, text}); };
    if (event.formula.form == gjk::Expression::Form::product)  // not an edge itself
      tell(names_.translate(event.expression.X) + " = " + names_.translate(event.formula) + " = " +
           vector(*event.normal, Dimension::space));
    if (event.simplex_size == 1 && walkthrough_.naming == Naming::roles)
      tell("P is the first vertex of the simplex, and called A there");
    if (label_of(event) == gjk::RegionLabel::R3_or_R4)
      tell(names_.translate(event.expression) + " points toward the origin in both, so they need not be told apart");
    if (event.feature.size() == 4 && !is_complete())
      tell(names_.sorted("AB") + ", " + names_.sorted("AC") + ", " + names_.sorted("AD") +
           " not asked: the origin lies above none of their faces");
    append_skipped(frame.facts);
    return frame;
  }

  std::optional<Frame> operator()(const gjk::SimplexReduced<double>& event) const {
    const gjk::Roles dropped = event.dropped();
    const bool is_same = event.kept == gjk::beside({}, event.before.size());
    const std::string kept = "keep " + in_words(event.kept);
    Frame frame = frame_about(Focus::reduction, !dropped.empty() ? kept + ", drop " + in_words(dropped)
                                                : is_same        ? kept + ", in their order"
                                                                 : kept + ". Their order changes");
    frame.facts = {{Mark::none, names_.list(event.before) + " becomes " + names_.list(event.after) +
                                    (std::ranges::is_sorted(event.kept, std::greater{})
                                         ? ", oldest first"
                                         : ", no longer by age: " + names_.of(gjk::Role::A) + " is still the newest")},
                   {Mark::none, why_told(event)}};
    append_not_asked(frame.facts);
    return frame;
  }

  std::optional<Frame> operator()(const gjk::DirectionChosen<double>& event) const {
    Frame frame = frame_about(
        Focus::direction,
        now_.simplex.size() == 3
            ? "the next direction d is the normal of " + names_.simplex(now_.simplex) + " on the origin's side"
            : "the next direction d leads from " + names_.simplex(now_.simplex) + " toward the origin",
        {{Mark::none, direction_told(event), "d", vec(event.direction)}});
    if (now_.in_exact_fallback)
      frame.facts.push_back({Mark::none, "where d is rounded, what is decided along it is not"});
    else if (now_.simplex.size() == 3 && !now_.reduction)
      frame.facts.push_back({Mark::none, "the simplex stays " + names_.list(now_.simplex) +
                                             ": read from the list, its normal points to the origin already"});
    return frame;
  }

  std::optional<Frame> operator()(const gjk::Finished<double>& event) const {
    const gjk::Result<double>& result = event.result;
    const std::string count =
        " after " + std::to_string(result.iterations) + (result.iterations == 1 ? " iteration" : " iterations");
    Frame frame = frame_about(Focus::end, answer_caption(result),
                              {{Mark::answer, std::string(gjk::to_string(result.status)) + count}});
    append_evidence(result, frame.facts);
    if (scene_.certified && result.status != gjk::Status::undecided)
      frame.facts.push_back({Mark::none, "rounding may have misled it: is it proven?"});
    return frame;
  }

  /// Of proofs, and of the second search.
  std::optional<Frame> operator()(const auto& event) const { return caption_of(event, names_, now_, scene_); }

 private:
  /// The second search takes one of the first where that reaches far enough, and asks no support function then.
  std::vector<Fact> facts_of_newest(const std::string& newest) const {
    std::vector<Fact> facts{{Mark::none, lettered_anew()}};
    if (now_.in_exact_fallback && !now_.found)
      facts.push_back({Mark::none, (walkthrough_.naming == Naming::roles ? "P" : newest) +
                                       " is a vertex of the first search: along d it reaches the origin, or farther"});
    return facts;
  }

  /// The second search doubles or halves a direction as often as it likes.
  std::string direction_told(const gjk::DirectionChosen<double>& event) const {
    const std::string expression = names_.translate(event.expression);
    return now_.in_exact_fallback ? "d = " + vec(event.direction) + ", a multiple of " + expression
                                  : "d = " + expression + " = " + vec(event.direction);
  }

  Frame second_start() const {
    return frame_about(
        Focus::added, "the exact fallback begins with a vertex of the first search: " + names_.of(gjk::Role::A),
        {{Mark::none, "it keeps the feature that is nearest to the origin"},
         {Mark::none, "each of its signs is certain: doubles know their error, and in doubt whole numbers decide"}});
  }

  /// With the mistake of asking b along d, too.
  Frame of_wrong_side(const gjk::SupportFound<double>& event, const std::string& name, const std::string& along) const {
    return frame_about(Focus::support, name + " is taken from the farthest points of both objects along " + along,
                       {difference_told(event, name, "support(a, d) − support(b, d)")});
  }
  Fact difference_told(const gjk::SupportFound<double>& event, const std::string& name, const std::string& how) const {
    const std::string a = vec(event.vertex.a.point), b = vec(event.vertex.b.point), w = vec(event.vertex.w);
    return {Mark::none, name + " = " + how + " = " + a + " − " + b + " = " + w, name, w};
  }

  /// Where a mistake decides otherwise than its numbers say.
  std::string gone_on_as_if(const gjk::RegionTested<double>& event) const {
    if (!scene_.mistake || !event.reason.goes_on_as_if) return "";
    return names_.translate("but these rules go on as if " + gjk::in_words(*event.reason.goes_on_as_if, event));
  }

  std::string why_told(const gjk::SimplexReduced<double>& event) const {
    using enum gjk::ReductionReason;
    if (event.why != beyond_edge && event.why != nearest_on_edge) return names_.translate(gjk::to_string(event.why));
    const gjk::Roles newest_first = {event.kept[event.kept.size() - 1], event.kept[0]};
    return std::string(is_decided_otherwise() ? "by the rounded number, " : "") +
           (event.why == beyond_edge ? "the origin lies beyond" : "the point nearest to the origin lies on") +
           " edge " + names_.sorted(newest_first);
  }

  /// What Algorithm 4 or 5 has not come to, because what stands before it has decided, and why that does no harm.
  void append_not_asked(std::vector<Fact>& facts) const {
    if (is_complete() || now_.regions.empty() || now_.regions.back().feature.size() > 3) return;
    const gjk::RegionTested<double>& last = now_.regions.back();
    const bool is_edge = last.feature.size() == 2 && last.verdict == Verdict::chosen;
    const auto append = [&](const std::string& names, const std::string& why) {
      if (!names.empty()) facts.push_back({Mark::none, names + " not asked: " + why});
    };
    const std::string one_edge = "the first edge that has the origin beyond it decides";
    if (now_.processed.size() == 3)
      return append(!is_edge ? "" : label_of(last) == gjk::RegionLabel::R3 ? "R7, R1" : "R1", one_edge);
    const gjk::Roles& deciding = last.face.empty() ? last.feature : last.face;
    std::string own, behind, to_come;  // edges of the face that decides, of faces below which the origin lies, the rest
    const auto add = [](std::string& names, const std::string& name) { names += (names.empty() ? "" : ", ") + name; };
    for (const gjk::Roles& face : {gjk::Roles("ACD"), gjk::Roles("ADB")})
      if (!test_of(now_, face))
        add(to_come,
            names_.sorted(face) + (height_of_origin(now_, face) > 0 ? " (above which the origin lies, too)" : ""));
    using Faces = std::array<gjk::Roles, 2>;
    for (const auto& [edge, faces] :
         {std::pair<gjk::Roles, Faces>{"AB", {"ABC", "ADB"}}, {"AC", {"ABC", "ACD"}}, {"AD", {"ACD", "ADB"}}}) {
      if (std::ranges::count(now_.regions, edge, &gjk::RegionTested<double>::feature) > 0) continue;
      const bool is_behind = test_of(now_, faces[0]) && test_of(now_, faces[1]);
      add(std::ranges::count(faces, deciding) > 0 ? own : is_behind ? behind : to_come, names_.sorted(edge));
    }
    if (is_edge) add(own, "the inside of " + names_.sorted(deciding));
    append(own, one_edge);
    append(behind, "the origin lies above neither of its faces");
    append(to_come,
           "the first face that has the origin above it decides; a vertex that is dropped is found again if needed");
  }

  /// Returns: "the simplex is [D, C, B, A]: P becomes A, the old A becomes B, the old B becomes C"; where no letter moves only
  /// the list.
  std::string lettered_anew() const {
    const int older = now_.simplex.size() - 1;
    const std::string simplex = names_.list(now_.simplex);
    if (walkthrough_.naming != Naming::roles || older == 0) return "the simplex is " + simplex;
    std::string letters, moves;
    for (int i = 0; i < older; ++i) {
      const std::string now(1, static_cast<char>('A' + older - i)), before = letter_before(now_.simplex[i].w, letters);
      letters += before;
      if (before != now) moves = ", the old " + before + " becomes " + now + moves;
    }
    return "the simplex is " + simplex + ": P becomes A" + moves;
  }

  /// Returns: the letter in the picture before; of vertices at one place, where a search comes back, one that is not yet taken.
  std::string letter_before(const Point& w, const std::string& taken) const {
    for (int role = now_.before.size(); role-- > 0;)
      if (const char letter = static_cast<char>('A' + role);
          now_.before.point(static_cast<gjk::Role>(role)) == w && taken.find(letter) == std::string::npos)
        return {letter};
    return "";
  }

  bool is_vertex(const Point& w) const {
    for (int i = 0; i < now_.simplex.size(); ++i)
      if (now_.simplex[i].w == w) return true;
    return false;
  }

  int iteration_that_found(const Point& w) const {
    for (const auto& event : telling_.trace.events)
      if (const auto* found = std::get_if<gjk::SupportFound<double>>(&event); found && found->vertex.w == w)
        return found->iteration;
    return now_.iteration;
  }

  /// Remarks are written in the letters of the picture already; where these are roles, normals get their subscript.
  std::string in_letters(const std::string& text) const {
    return walkthrough_.naming == Naming::corners ? text : names_.translate(text);
  }

  std::string vec(const Point& value) const { return vector(value, scene_.dimension); }

  std::string first_point_fact() const {
    if (scene_.options.crossing_test == gjk::CrossingTest::off) return "this run does without the crossing test";
    return gjk::first_point(scene_.rules) == gjk::FirstPoint::tested
               ? "these rules apply the crossing test to the first point, too"
               : "no test P·d < 0 yet: it asks whether the move from one point to the next has crossed the origin";
  }

  bool without_crossing_test() const { return now_.crossing && now_.crossing->verdict == Crossing::switched_off; }

  /// How far the point found reaches along d, and the corner of the hull that comes next: "E·d = 4.375 is the largest, F·d = 3.25 the next".
  std::string farthest_two(const gjk::SupportFound<double>& event) const {
    const auto text = [&](const Point& w) { return names_.of(w) + "·d = " + number(event.direction.dot(w)); };
    if (telling_.hull.corners.empty())
      return text(event.vertex.w) +
             (event.vertex.w.allFinite() && event.direction.allFinite() ? ", the largest w·d of the difference" : "");
    std::vector<Point> others;
    for (const render::Vec2& corner : telling_.hull.corners)
      if (corner != event.vertex.w.head<2>()) others.emplace_back(corner.x(), corner.y(), 0);
    const auto reach = [&](const Point& w) { return event.direction.dot(w); };
    return others.empty() ? text(event.vertex.w)
                          : text(event.vertex.w) + " is the largest, " +
                                text(*std::ranges::max_element(others, {}, reach)) + " the next";
  }

  /// "A, B and C".
  std::string in_words(const gjk::Roles& roles) const {
    std::vector<std::string> names;
    for (const gjk::Role role : roles) names.push_back(names_.of(role));
    std::ranges::sort(names);
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
      text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    return text;
  }

  /// Where rounded numbers decide an answer is what the search concludes, and may be wrong.
  bool in_float() const { return scene_.scalar == Scalar::binary32; }

  std::string place_of_origin(const gjk::Simplex<double>& simplex) const {
    return (simplex.size() == 1 ? "is " : simplex.size() == 2 ? "lies on " : "lies in ") + names_.simplex(simplex);
  }

  bool is_wrong(const gjk::Result<double>& result) const {
    return result.status != gjk::Status::undecided && is_otherwise(telling_.truth, result.status);
  }

  /// What stands before an answer that may be wrong. Where it is, not by rounding, that is said at once.
  std::string concluded(const gjk::Result<double>& result) const {
    const bool is_mistaken = !telling_.truth.by_rounded_turn && (scene_.mistake || scene_.rules == RuleSet::as_printed);
    if (is_wrong(result))
      return is_mistaken  ? "the search concludes, wrongly, that "
             : in_float() ? "in floats the search concludes that "
                          : "in doubles the search concludes that ";
    const bool is_doubtful = is_open(telling_.truth) || telling_.truth.of_decimals || telling_.truth.by_rounded_turn,
               is_unproven = result.status == gjk::Status::intersecting && !holds_origin_exactly(result.simplex);
    return in_float() || is_doubtful || is_unproven ? "the search concludes that " : "";
  }

  bool is_otherwise_exactly(const gjk::Event<double>& event) const {
    return exact_otherwise(event, now_, scene_, names_).has_value();
  }
  /// Whether a region of this iteration was decided otherwise than exact arithmetic decides it.
  bool is_decided_otherwise() const {
    return std::ranges::any_of(now_.regions, [&](const auto& region) { return is_otherwise_exactly(region); });
  }
  /// Whether no point is known to reach farther along d than the one that was found.
  bool is_farthest() const {
    const auto is_wrong_here = [&](const gjk::Event<double>& event) {
      const auto* found = std::get_if<gjk::SupportFound<double>>(&event);
      return found && found->iteration == now_.iteration && is_otherwise_exactly(event);
    };
    return std::ranges::none_of(telling_.trace.events, is_wrong_here) &&
           !is_otherwise(telling_.truth, answer_of(telling_.trace));
  }

  std::string answer_caption(const gjk::Result<double>& result) const {
    const std::string before = concluded(result);
    switch (result.status) {
      case gjk::Status::intersecting:
        return before + "the origin " + place_of_origin(result.simplex) + ", so the objects intersect";
      case gjk::Status::separated:
        return !before.empty() ? before + "the objects do not intersect"
                               : "the difference does not contain the origin, so the objects do not intersect";
      case gjk::Status::undecided: return "the search ends without an answer";
    }
    return "";
  }

  /// What a reader needs to check the answer: the tests that the last simplex passed, or the separating direction.
  void append_evidence(const gjk::Result<double>& result, std::vector<Fact>& facts) const {
    const auto tell = [&](const std::string& text) { facts.push_back({Mark::none, text}); };
    if (result.reason == gjk::Reason::no_new_vertex)
      tell("the search has run out of points: " + names_.of(now_.found->w) + " is not new");
    if (result.reason == gjk::Reason::iteration_limit) tell("the iteration limit is reached");
    if (result.cycle_start)
      tell("it would go round for ever: iteration " + std::to_string(result.iterations + 1) +
           " would begin as iteration " + std::to_string(*result.cycle_start) + " did");
    if (result.reason == gjk::Reason::unusable_direction) tell("the search direction is zero or not finite");
    if (result.separation)
      tell("with d = " + vec(result.separation->direction) + ": w·d ≤ " + names_.of(result.separation->vertex.w) +
           "·d = " + number(result.separation->support_value) + " < 0 for every point w of the difference" +
           (in_float()         ? ", computed in floats"
            : is_wrong(result) ? ", computed in doubles"
                               : ""));
    if (result.status != gjk::Status::intersecting || is_wrong(result)) return;
    if (is_complete() && now_.regions.back().feature.size() == 4)
      return tell("no edge or face at " + names_.of(gjk::Role::A) + " has the origin beyond it");
    for (const auto& region : now_.regions)
      if (!region.expression.empty()) facts.push_back({Mark::none, decision(region).text});
  }

  /// As part of a sentence.
  std::string region_caption(const gjk::RegionTested<double>& event) const {
    const std::string feature = names_.sorted(event.feature);
    const bool zero = event.relation == Relation::zero;
    if (is_complete() && event.simplex_size > 1 && event.feature.size() < 3)
      if (const std::string caption = complete_caption(event, feature); !caption.empty()) return caption;
    switch (event.simplex_size) {
      case 1: return feature + (zero ? " is the origin" : " is not the origin");
      case 2:
        return std::string("the origin lies ") + (zero ? "on" : "to one side of") +
               (without_crossing_test() ? " the line " : " segment ") + feature;  // its ends may not be ruled out
      case 3: return caption_of_triangle(event, feature);
      default: return caption_of_tetrahedron(event, feature);
    }
  }

  bool is_complete() const { return scene_.rules == RuleSet::complete; }

  /// What only the complete rules ask of a vertex or an edge; empty for what others ask, too.
  std::string complete_caption(const gjk::RegionTested<double>& event, const std::string& feature) const {
    const bool zero = event.relation == Relation::zero;
    const std::string A = names_.of(gjk::Role::A);
    if (event.feature == "A") return zero ? A + " is the origin" : "the point nearest to the origin is " + A;
    if (event.relation == Relation::positive)
      return "edge " + feature + (event.verdict == Verdict::rejected ? " does not lead" : " leads") + " from " + A +
             " toward the origin";
    if (event.simplex_size == 2 || event.relation == Relation::not_negative) return "";
    return (zero ? "the origin lies on edge " : "the point nearest to the origin lies on edge ") + feature;
  }

  /// Of an edge in space: in the plane of its triangle.
  std::string beyond_edge(const gjk::RegionTested<double>& event, const std::string& feature) const {
    const std::string lies = event.verdict == Verdict::rejected ? "does not lie" : "lies";
    const std::string face = names_.sorted(event.face.empty() ? gjk::Roles("ABC") : event.face);
    const bool is_flat = scene_.dimension == Dimension::plane;
    return (is_flat ? "" : "projected onto the plane of " + face + ", ") + "the origin " + lies + " beyond edge " +
           feature;
  }

  std::string caption_of_triangle(const gjk::RegionTested<double>& event, const std::string& feature) const {
    if (label_of(event) != gjk::RegionLabel::R1) return beyond_edge(event, feature);
    const char* const where = event.relation == Relation::zero       ? "in"
                              : event.relation == Relation::positive ? "above"
                                                                     : "below";
    return std::string("the origin lies ") + where + " triangle " + feature;
  }

  std::string caption_of_tetrahedron(const gjk::RegionTested<double>& event, const std::string& feature) const {
    const bool is_above = event.verdict == Verdict::chosen && event.relation != Relation::zero;
    const std::string lies = is_above ? "the origin lies " : "the origin does not lie ";
    if (event.feature.size() == 4) return "no face sees the origin: it lies in tetrahedron " + feature;
    if (event.face.empty()) return lies + "above face " + feature;
    return beyond_edge(event, feature);
  }

  /// The inequality that decides: "GE_n·GO = 5.2 > 0".
  std::string inequality(const gjk::RegionTested<double>& event) const {
    const double* const scalar = std::get_if<double>(&event.value);
    const double size = scalar ? *scalar : std::get<Point>(event.value).cwiseAbs().maxCoeff();
    return names_.translate(event.expression) + " = " + value_of(event) + compared_with_zero(event, size);
  }
  std::string value_of(const gjk::RegionTested<double>& event) const {
    const double* const scalar = std::get_if<double>(&event.value);
    return scalar ? number(*scalar) : vec(std::get<Point>(event.value));
  }

  /// With the region's name before it: "R3: GE_n·GO = 5.2 > 0".
  Fact decision(const gjk::RegionTested<double>& event) const {
    if (event.expression.empty()) return {Mark::yes, "no normal points toward the origin"};
    const gjk::RegionLabel label = label_of(event);
    const std::string where = !event.face.empty()               ? "face " + names_.sorted(event.face) + ": "
                              : label == gjk::RegionLabel::none ? ""
                                                                : std::string(to_string(label)) + ": ";
    const bool is_open = event.simplex_size == 1 || (event.simplex_size == 2 && without_crossing_test());
    const Mark mark = is_open ? Mark::none : event.verdict != Verdict::rejected ? Mark::yes : Mark::no;
    return {mark, where + inequality(event), names_.translate(event.expression), value_of(event)};
  }

  Frame decided(const gjk::RegionTested<double>& event, const std::string& conclusion) const {
    if (event.expression.empty()) return frame_about(Focus::region, conclusion, {decision(event)});
    const std::string label(to_string(label_of(event)));
    return frame_by_number(Focus::region, inequality(event),
                           conclusion + (label.empty() ? "" : " (region " + label + ")"), decision(event));
  }

  /// One line for each reason: "skipped R4, R5, R6: …".
  void append_skipped(std::vector<Fact>& facts) const {
    for (const auto& [reason, names] :
         reasons_for_skipping(now_.regions, [&](const gjk::Roles& roles) { return names_.sorted(roles); }))
      facts.push_back({Mark::skipped, names + ": " + names_.translate(reason)});
  }

  const Story& story_;
  const Walkthrough& walkthrough_;
  const Telling& telling_;
  const Scene& scene_;
  const Moment& now_;
  const Names names_;
};

}  // namespace

std::optional<Frame> caption(const gjk::Event<double>& event, const Story& story, const Telling& telling,
                             const Moment& now) {
  const Captions captions(story, telling, now);
  std::optional<Frame> frame = std::visit(captions, event);
  if (!frame) return frame;
  captions.add_truth(*frame, event);
  captions.add_remarks(*frame, event);
  captions.add_exact(*frame, event);
  return frame;
}

Frame repetition(Frame frame, int earlier) {
  const std::string before = "iteration " + std::to_string(earlier);
  frame.focus = Focus::repetition;
  frame.headline = "The simplex and the direction are those of " + before + ".";
  frame.caption =
      "The simplex and the direction are those of " + before + ": from here on everything repeats, for ever.";
  frame.facts.push_back({Mark::no, "the search goes round in a circle"});
  return frame;
}

}  // namespace walkthroughs::story
