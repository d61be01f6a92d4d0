#include "walkthroughs/captions.hpp"

#include <algorithm>
#include <variant>

#include "walkthroughs/words.hpp"

namespace walkthroughs {
namespace {

using Mark = Fact::Mark;
using gjk::Crossing;
using gjk::Relation;
using gjk::Verdict;

/// What follows the number that decides. A zero speaks for itself.
std::string sign(Relation relation) {
  switch (relation) {
    case Relation::positive: return " > 0";
    case Relation::negative: return " < 0";
    case Relation::zero: return "";
    case Relation::not_zero: return " ≠ 0";
  }
  return "";
}

/// Returns: "segment AE", "triangle AEG", or the bare name of a single vertex.
std::string with_kind(const std::string& feature) {
  const char* const kinds[] = {"", "", "segment ", "triangle ", "tetrahedron "};
  return kinds[std::min<std::size_t>(feature.size(), 4)] + feature;
}

std::string all_roles(const Simplex& simplex) {
  return std::string("ABCD").substr(0, static_cast<std::size_t>(simplex.size()));
}

/// Writes caption and facts for one event; `now` is the moment after it. Events that do not change the picture, or that
/// are told together with the next one, give nothing.
class Captions {
 public:
  Captions(const Walkthrough& walkthrough, const LabelledHull& hull, const Moment& now)
      : walkthrough_(walkthrough), hull_(hull), now_(now) {}

  std::optional<Frame> operator()(const gjk::SearchStarted<double>&) const { return std::nullopt; }
  std::optional<Frame> operator()(const gjk::VertexAdded<double>&) const { return std::nullopt; }

  std::optional<Frame> operator()(const gjk::SupportFound<double>& event) const {
    const std::string name = hull_.name(event.vertex.w);
    const std::string along = event.direction == Point(1, 0, 0) ? "Along +x" : "Along d";
    Frame frame = frame_about(Focus::support, along + " the farthest point of the difference is " + name +
                                                  (event.is_new ? "" : " again, so there is no new point"));
    add_remark(frame, Remark::At::support_found, event.iteration);
    frame.facts = {{Mark::none, "d = " + vector(event.direction) + "; " + farthest_two(event)},
                   {Mark::none, name + " = a − b = " + vector(event.vertex.a.point) + " − " +
                                    vector(event.vertex.b.point) + " = " + vector(event.vertex.w)}};
    if (event.iteration == 1) frame.facts.push_back({Mark::none, first_point_fact()});
    return frame;
  }

  std::optional<Frame> operator()(const gjk::CrossingTested<double>& event) const {
    if (!event.value) return std::nullopt;
    const std::string name = hull_.name(now_.found->w);
    const std::string value = name + "·d = " + number(*event.value);
    if (event.verdict == Crossing::not_crossed)
      return frame_about(
          Focus::crossing,
          "The move to " + name + " did not cross the origin: nothing of the difference reaches that far along d",
          {{Mark::no, value + " < 0: the origin was not crossed (Eq. 9)"}});
    if (*event.value == 0)
      return frame_about(Focus::crossing,
                         "The move to " + name + " just reached the origin's level, so the search goes on",
                         {{Mark::none, value + ": this proves nothing"}});
    return frame_about(Focus::crossing, "The move to " + name + " crossed the origin, so the search goes on",
                       {{Mark::yes, value + " > 0: the origin was crossed"}});
  }

  std::optional<Frame> operator()(const gjk::RegionTested<double>& event) const {
    if (event.verdict == Verdict::skipped) return std::nullopt;
    const Letters letters(now_.simplex, hull_);
    Frame frame = frame_about(Focus::region, region_caption(event, letters), {decision(event, letters)});
    add_remark(frame, Remark::At::region_tested, event.iteration);
    if (event.normal)
      frame.facts.push_back({Mark::none, letters.translate(event.expression.substr(0, event.expression.find("·")) +
                                                           " = " + event.formula) +
                                             " = " + vector_in_space(*event.normal)});
    if (is_first_test_of_iteration()) append_skipped(letters, frame.facts);
    return frame;
  }

  std::optional<Frame> operator()(const gjk::SimplexReduced<double>& event) const {
    const Letters letters(event.before, hull_);
    return frame_about(Focus::reduction,
                       event.dropped.empty()
                           ? "The simplex stays, but its order changes"
                           : letters.feature(event.dropped) + " is no longer needed and leaves the simplex",
                       {{Mark::none, list_of_names(event.before, hull_) + " becomes " +
                                         list_of_names(event.after, hull_) + " (oldest first)"},
                        {Mark::none, letters.translate(event.why)}});
  }

  std::optional<Frame> operator()(const gjk::DirectionChosen<double>& event) const {
    const Letters letters(now_.reduction ? now_.reduction->before : now_.simplex, hull_);
    const std::string from = simplex_name(now_.simplex);
    return frame_about(Focus::direction, "The next search goes from " + from + " toward the origin",
                       {{Mark::none, "d = " + letters.translate(event.expression) + " = " + vector(event.direction)}});
  }

  std::optional<Frame> operator()(const gjk::Finished<double>& event) const {
    const gjk::Result<double>& result = event.result;
    const std::string count =
        " after " + std::to_string(result.iterations) + (result.iterations == 1 ? " iteration" : " iterations");
    Frame frame = frame_about(Focus::end, answer_caption(result),
                              {{Mark::answer, std::string(gjk::to_string(result.status)) + count}});
    add_remark(frame, Remark::At::end, result.iterations);
    append_evidence(result, frame.facts);
    return frame;
  }

 private:
  /// `caption`: without the full stop.
  static Frame frame_about(Focus focus, const std::string& caption, std::vector<Fact> facts = {}) {
    return {focus, caption + ".", caption + ".", std::move(facts), {}, {}};
  }

  void add_remark(Frame& frame, Remark::At at, int iteration) const {
    for (const Remark& remark : walkthrough_.remarks)
      if (remark.at == at && remark.iteration == iteration)
        frame.caption.replace(frame.caption.size() - 1, 1, "; " + remark.text + ".");
  }

  std::string first_point_fact() const {
    return walkthrough_.scenes[0].options.crossing_test == gjk::CrossingTest::on
               ? "the crossing test does not apply to the first point"
               : "this run does without the crossing test";
  }

  bool without_crossing_test() const { return now_.crossing && now_.crossing->verdict == Crossing::switched_off; }

  std::string simplex_name(const Simplex& simplex) const {
    return with_kind(Letters(simplex, hull_).feature(all_roles(simplex)));
  }

  /// How far the point found reaches along d, and the corner of the hull that comes next: "E·d = 4.375, then F·d = 3.25".
  std::string farthest_two(const gjk::SupportFound<double>& event) const {
    const render::Vec2 d = event.direction.head<2>(), found = event.vertex.w.head<2>();
    const auto reach = [&](const render::Vec2& corner) { return corner.dot(d); };
    const auto text = [&](const render::Vec2& corner) {
      return hull_.name({corner.x(), corner.y(), 0}) + "·d = " + number(reach(corner));
    };
    std::vector<render::Vec2> others = hull_.corners;
    std::erase(others, found);
    return others.empty() ? text(found) : text(found) + ", then " + text(*std::ranges::max_element(others, {}, reach));
  }

  std::string answer_caption(const gjk::Result<double>& result) const {
    switch (result.status) {
      case gjk::Status::intersecting:
        return "The origin lies in " + simplex_name(result.simplex) + ", so the objects intersect";
      case gjk::Status::separated: return "The difference does not contain the origin, so the objects do not intersect";
      case gjk::Status::undecided: return "The search ends without an answer";
    }
    return "";
  }

  /// What a reader needs to check the answer: the tests that the last simplex passed, or the separating direction.
  void append_evidence(const gjk::Result<double>& result, std::vector<Fact>& facts) const {
    if (result.reason == gjk::Reason::no_new_vertex)
      facts.push_back({Mark::none, "the search has run out of points: " + hull_.name(now_.found->w) + " is not new"});
    if (result.reason == gjk::Reason::iteration_limit) facts.push_back({Mark::none, "the iteration limit is reached"});
    if (result.reason == gjk::Reason::unusable_direction)
      facts.push_back({Mark::none, "the search direction is zero or not finite"});
    if (result.separation)
      facts.push_back({Mark::none, "with d = " + vector(result.separation->direction) + ": w·d ≤ " +
                                       hull_.name(result.separation->vertex.w) +
                                       "·d = " + number(result.separation->support_value) + " < 0 for every w"});
    if (result.status != gjk::Status::intersecting) return;
    const Letters letters(now_.simplex, hull_);
    for (const auto& region : now_.regions)
      if (!region.expression.empty()) facts.push_back({Mark::none, decision(region, letters).text});
  }

  /// Without the full stop.
  std::string region_caption(const gjk::RegionTested<double>& event, const Letters& letters) const {
    const std::string feature = letters.feature(event.feature);
    const bool at_origin = event.relation == Relation::zero;
    if (event.simplex_size == 2 && without_crossing_test())  // its ends are not ruled out
      return std::string("The origin lies ") + (at_origin ? "on" : "to one side of") + " the line " + feature;
    if (event.simplex_size == 1) return feature + (at_origin ? " is the origin" : " is not the origin");
    if (event.simplex_size == 2)
      return std::string("The origin lies ") + (at_origin ? "on" : "to one side of") + " segment " + feature;
    if (event.label == "R1") {
      const char* const where = at_origin ? "in" : event.relation == Relation::positive ? "above" : "below";
      return std::string("The origin lies ") + where + " triangle " + feature;
    }
    return std::string("The origin ") + (event.verdict == Verdict::chosen ? "lies" : "does not lie") + " beyond " +
           (feature.size() == 2 ? "edge " : "face ") + feature;
  }

  /// The inequality that decides, with the region's name: "R3: GE_n·GO = 5.2 > 0".
  Fact decision(const gjk::RegionTested<double>& event, const Letters& letters) const {
    const bool chosen = event.verdict == Verdict::chosen;
    std::string text = event.label.empty() ? "" : event.label + ": ";
    text += letters.translate(event.expression);
    if (const double* value = std::get_if<double>(&event.value))
      text += " = " + number(*value) + (chosen ? sign(event.relation) : " ≤ 0");
    if (const Point* value = std::get_if<Point>(&event.value)) text += " = " + vector(*value) + sign(event.relation);
    if (event.simplex_size == 1 || (event.simplex_size == 2 && without_crossing_test())) return {Mark::none, text};
    return {chosen ? Mark::yes : Mark::no, text};
  }

  bool is_first_test_of_iteration() const {
    return std::ranges::count_if(now_.regions, [](const auto& r) { return r.verdict != Verdict::skipped; }) == 1;
  }

  /// One line for each reason: "skipped R4, R5, R6: …".
  void append_skipped(const Letters& letters, std::vector<Fact>& facts) const {
    std::string reason;
    for (const auto& region : now_.regions) {
      if (region.verdict != Verdict::skipped) continue;
      const std::string name = region.label.empty() ? letters.feature(region.feature) : region.label;
      if (region.reason != reason) {
        facts.push_back({Mark::skipped, name + ": " + letters.translate(region.reason)});
      } else {
        std::string& line = facts.back().text;
        line.insert(line.find(':'), ", " + name);
      }
      reason = region.reason;
    }
  }

  const Walkthrough& walkthrough_;
  const LabelledHull& hull_;
  const Moment& now_;
};

}  // namespace

std::optional<Frame> caption(const gjk::Event<double>& event, const Walkthrough& walkthrough, const LabelledHull& hull,
                             const Moment& now) {
  return std::visit(Captions(walkthrough, hull, now), event);
}

}  // namespace walkthroughs
