#include "walkthroughs/storyboard.hpp"

#include <variant>

#include "walkthroughs/captions.hpp"

namespace walkthroughs {
namespace {

/// One scene, told from the first event to the last.
void tell_whole_search(Story& story) {
  const Trace& trace = story.traces[0];
  for (std::size_t i = 0; i < trace.events.size(); ++i) {
    Moment now = replay(trace, i + 1);
    std::optional<Frame> frame = caption(trace.events[i], story.walkthrough, story.hulls[0], now);
    if (!frame) continue;
    frame->moments = {std::move(now)};
    frame->events = {{0, i}};
    story.frames.push_back(std::move(*frame));
  }
}

/// Returns: the place of the first event of type `E` in that iteration.
template <class E>
std::size_t find_event(const Trace& trace, int iteration) {
  for (std::size_t i = 0; i < trace.events.size(); ++i)
    if (const E* event = std::get_if<E>(&trace.events[i]); event && event->iteration == iteration) return i;
  throw std::logic_error("the scene of this walkthrough ends before the move that it is meant to show");
}

/// One frame about the same event in every scene.
template <class E>
void tell_side_by_side(Story& story, int iteration, const std::string& sentence) {
  Frame all{Focus::support, sentence, sentence, {}, {}, {}};
  for (std::size_t s = 0; s < story.traces.size(); ++s) {
    const std::size_t at = find_event<E>(story.traces[s], iteration);
    Moment now = replay(story.traces[s], at + 1);
    const Frame one = caption(story.traces[s].events[at], story.walkthrough, story.hulls[s], now).value();
    all.focus = one.focus;
    for (const Fact& fact : one.facts)
      all.facts.push_back({fact.mark, story.walkthrough.scenes[s].name + ": " + fact.text});
    all.moments.push_back(std::move(now));
    all.events.push_back({0, at});
  }
  story.frames.push_back(std::move(all));
}

/// A move and whether it crossed the origin (Eq. 9).
void tell_move(Story& story, const CloseUp& move) {
  tell_side_by_side<gjk::DirectionChosen<double>>(story, move.iteration - 1, move.direction);
  tell_side_by_side<gjk::SupportFound<double>>(story, move.iteration, move.support);
  tell_side_by_side<gjk::CrossingTested<double>>(story, move.iteration, move.crossing);
}

void keep_last_of_each_iteration(std::vector<Frame>& frames) {
  std::vector<Frame> kept;
  for (const std::size_t i : last_of_each_iteration(frames)) kept.push_back(std::move(frames[i]));
  frames = std::move(kept);
}

/// Each frame covers what has happened since the one before.
void set_first_events(std::vector<Frame>& frames) {
  for (std::size_t i = 1; i < frames.size(); ++i)
    for (std::size_t s = 0; s < frames[i].events.size(); ++s)
      frames[i].events[s].first = frames[i - 1].events[s].last + 1;
}

}  // namespace

std::vector<std::size_t> last_of_each_iteration(const std::vector<Frame>& frames) {
  const auto iteration = [&](std::size_t i) { return frames[i].moments[0].iteration; };
  std::vector<std::size_t> last;
  for (std::size_t i = 0; i < frames.size(); ++i)
    if (i + 1 == frames.size() || iteration(i + 1) != iteration(i)) last.push_back(i);
  return last;
}

Story tell(const Walkthrough& walkthrough, Detail detail) {
  Story story{walkthrough, {}, {}, {}};
  for (const Scene& scene : walkthrough.scenes) {
    story.traces.push_back(run(scene));
    story.hulls.push_back(difference_hull(scene));
  }
  switch (walkthrough.layout) {
    case Layout::search: tell_whole_search(story); break;
    case Layout::close_ups: tell_move(story, walkthrough.close_up.value()); break;
    default: break;
  }
  if (detail == Detail::step) keep_last_of_each_iteration(story.frames);
  set_first_events(story.frames);
  return story;
}

}  // namespace walkthroughs
