#include "walkthroughs/story/iterations.hpp"

#include <variant>

#include "walkthroughs/story/words.hpp"

namespace walkthroughs::story {
namespace {

/// Adds to an iteration what one event has done.
struct Adding {
  IterationTold& told;
  const Frame* said;  ///< of the event; null where nothing is
  const Names& names;
  Dimension dimension;

  void operator()(const gjk::SupportFound<double>& event) const {
    const std::string name = names.of(event.vertex.w);
    told.found = {"d = " + vector(event.direction, dimension), (name.empty() ? "w" : name) + " = " +
                                                                   vector(event.vertex.w, dimension) +
                                                                   (event.is_new ? "" : ", found before")};
  }
  void operator()(const gjk::CrossingTested<double>& event) const {
    if (event.value) tell_number(event.verdict == gjk::Crossing::not_crossed ? told.decided : told.found);
  }
  void operator()(const gjk::RegionTested<double>& event) const {
    if (event.verdict == gjk::Verdict::chosen) decide();
  }
  void operator()(const gjk::FilterTried<double>&) const { decide(); }
  void operator()(const gjk::FeatureKept<double>&) const { decide(); }
  void operator()(const gjk::DirectionChosen<double>& event) const {
    told.next = names.translate(event.expression) + " = " + vector(event.direction, dimension);
  }
  void operator()(const gjk::Finished<double>&) const { end(); }
  void operator()(const gjk::Certified<double>&) const { end(); }
  void operator()(const auto&) const {}

 private:
  /// And what exact numbers would have decided.
  void tell_number(std::vector<std::string>& lines) const {
    if (!said) return;
    for (const Fact& fact : said->facts)
      if (&fact == &said->facts[0] || fact.mark == Fact::Mark::truth) lines.push_back(fact.text);
  }
  void decide() const {
    if (said) told.decided.push_back(said->headline);
    tell_number(told.decided);
  }
  void end() const {
    if (said && !said->facts.empty()) told.next = said->facts[0].text;
  }
};

}  // namespace

std::vector<IterationTold> iterations_told(const Story& story, std::size_t scene) {
  const Telling& telling = story.tellings[scene];
  std::vector<IterationTold> all;
  Moment now;
  for (std::size_t i = 0; i < telling.trace.events.size(); ++i) {
    const gjk::Event<double>& event = telling.trace.events[i];
    advance(now, event);
    if (std::holds_alternative<gjk::SearchStarted<double>>(event)) continue;
    if (all.empty() || all.back().number != now.iteration) all.push_back({.number = now.iteration});
    const Names names(story.walkthrough.naming, telling.hull, now);
    std::visit(Adding{all.back(), telling.said[i] ? &*telling.said[i] : nullptr, names, telling.scene.dimension},
               event);
    all.back().last = i;
    all.back().simplex = now.simplex.size() == 0 ? "" : names.list(now.simplex);
  }
  return all;
}

}  // namespace walkthroughs::story
