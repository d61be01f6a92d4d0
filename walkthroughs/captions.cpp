#include "walkthroughs/captions.hpp"

#include <algorithm>
#include <variant>

#include "walkthroughs/words.hpp"

namespace walkthroughs {
namespace {

using Mark = Fact::Mark;
using gjk::Crossing;
using gjk::Relation;
using gjk::Role;
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
    Frame frame{Focus::support, along + " the farthest point of the difference is " + name, {}, {}};
    if (!event.is_new) frame.caption += " again, so there is no new point";
    finish_sentence(frame.caption, Remark::At::support_found, event.iteration);
    frame.facts = {{Mark::none, "d = " + vector(event.direction)},
                   {Mark::none, name + " = a − b = " + vector(event.vertex.a.point) + " − " +
                                    vector(event.vertex.b.point) + " = " + vector(event.vertex.w)}};
    if (walkthrough_.scenes[0].options.crossing_test == gjk::CrossingTest::off)
      frame.facts.push_back({Mark::none, "this run does without the crossing test"});
    else if (event.iteration == 1)
      frame.facts.push_back({Mark::none, "the crossing test does not apply to the first point"});
    return frame;
  }

  std::optional<Frame> operator()(const gjk::CrossingTested<double>& event) const {
    if (!event.value) return std::nullopt;
    const std::string name = hull_.name(now_.found->w);
    const std::string value = name + "·d = " + number(*event.value);
    if (event.verdict == Crossing::not_crossed)
      return Frame{
          Focus::crossing,
          "The move to " + name + " did not cross the origin: nothing of the difference reaches that far along d.",
          {{Mark::no, value + " < 0: the origin was not crossed (Eq. 9)"}},
          {}};
    return Frame{Focus::crossing,
                 "The move to " + name + " crossed the origin, so the search goes on.",
                 {{Mark::yes, value + (*event.value > 0 ? " > 0: the origin was crossed" : ": this proves nothing")}},
                 {}};
  }

  std::optional<Frame> operator()(const gjk::RegionTested<double>& event) const {
    if (event.verdict == Verdict::skipped) return std::nullopt;
    const Letters letters(now_.simplex, hull_);
    Frame frame{Focus::region, region_caption(event, letters), {decision(event, letters)}, {}};
    finish_sentence(frame.caption, Remark::At::region_tested, event.iteration);
    if (event.normal)
      frame.facts.push_back({Mark::none, letters.translate(event.expression.substr(0, event.expression.find("·")) +
                                                           " = " + event.formula) +
                                             " = " + vector_in_space(*event.normal)});
    if (is_first_test_of_iteration()) append_skipped(letters, frame.facts);
    return frame;
  }

  std::optional<Frame> operator()(const gjk::SimplexReduced<double>& event) const {
    const Letters letters(event.before, hull_);
    Frame frame{Focus::reduction, "", {}, {}};
    if (event.dropped.empty())
      frame.caption = "The simplex stays, but its order changes.";
    else
      frame.caption = letters.feature(event.dropped) + " is no longer needed and leaves the simplex.";
    frame.facts = {{Mark::none, list_of_names(event.before, hull_) + " becomes " + list_of_names(event.after, hull_) +
                                    " (oldest first)"},
                   {Mark::none, letters.translate(event.why)}};
    return frame;
  }

  std::optional<Frame> operator()(const gjk::DirectionChosen<double>& event) const {
    const Letters letters(now_.reduction ? now_.reduction->before : now_.simplex, hull_);
    const std::string from = simplex_name(now_.simplex);
    return Frame{Focus::direction,
                 "The next search goes from " + from + " toward the origin.",
                 {{Mark::none, "d = " + letters.translate(event.expression) + " = " + vector(event.direction)}},
                 {}};
  }

  std::optional<Frame> operator()(const gjk::Finished<double>& event) const {
    const gjk::Result<double>& result = event.result;
    Frame frame{Focus::end, "", {}, {}};
    const std::string count =
        " after " + std::to_string(result.iterations) + (result.iterations == 1 ? " iteration" : " iterations");
    switch (result.status) {
      case gjk::Status::intersecting:
        frame.caption = "The origin lies in " + simplex_name(result.simplex) + ", so the objects intersect";
        frame.facts = {{Mark::yes, "intersecting" + count}};
        break;
      case gjk::Status::separated:
        frame.caption = "The difference does not contain the origin, so the objects do not intersect";
        frame.facts = {{Mark::no, "separated" + count},
                       {Mark::none, "w·d ≤ " + number(result.separation->support_value) +
                                        " < 0 for every point w of the difference"}};
        break;
      case gjk::Status::undecided:
        frame.caption = "The search ends without an answer";
        frame.facts = {{Mark::none, "undecided" + count + ": " + std::string(gjk::to_string(result.reason))}};
        break;
    }
    finish_sentence(frame.caption, Remark::At::end, result.iterations);
    return frame;
  }

 private:
  void finish_sentence(std::string& caption, Remark::At at, int iteration) const {
    for (const Remark& remark : walkthrough_.remarks)
      if (remark.at == at && remark.iteration == iteration) caption += "; " + remark.text;
    caption += ".";
  }

  std::string simplex_name(const Simplex& simplex) const {
    return with_kind(Letters(simplex, hull_).feature(all_roles(simplex)));
  }

  /// Without the full stop.
  std::string region_caption(const gjk::RegionTested<double>& event, const Letters& letters) const {
    const std::string feature = letters.feature(event.feature);
    const bool at_origin = event.relation == Relation::zero;
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
