#include "walkthroughs/story/storyboard.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>
#include <variant>

#include "walkthroughs/model/number_text.hpp"
#include "walkthroughs/model/scene.hpp"
#include "walkthroughs/story/captions.hpp"
#include "walkthroughs/story/mistake_told.hpp"
#include "walkthroughs/story/truth_told.hpp"

namespace walkthroughs::story {
namespace {

// -- One scene --------------------------------------------------------------------------------------------------------

Telling tell_scene(const Walkthrough& walkthrough, const Scene& scene, Trace trace) {
  Telling telling{scene, std::move(trace), {}, walkthrough.panels};
  if (walkthrough.naming == Naming::corners) telling.hull = difference_hull(scene);
  telling.truth = truth_of(scene, answer_of(telling.trace));
  return telling;
}

/// Says once what there is to say of each event.
void say(const Story& story, Telling& telling) {
  Moment now;
  for (const gjk::Event<double>& event : telling.trace.events) {
    advance(now, event);
    telling.said.push_back(caption(event, story, telling, now));
  }
}

/// One scene, told from the first event to the last. Where the search has come back to where it was before, the frame about its
/// last direction says so.
void tell_whole_search(Story& story) {
  const Telling& telling = story.tellings[0];
  const std::vector<gjk::Event<double>>& events = telling.trace.events;
  const auto is_end = [](const auto& event) { return std::holds_alternative<gjk::Finished<double>>(event); };
  const auto end = std::ranges::find_if(events, is_end);
  const std::optional<int> cycle_start = std::get<gjk::Finished<double>>(*end).result.cycle_start;
  const bool begins_late = story.walkthrough.begins_with_the_guess;
  const std::size_t first = begins_late ? static_cast<std::size_t>(end - events.begin()) : 0;
  Moment now;
  for (std::size_t i = 0; i < events.size(); ++i) {
    advance(now, events[i]);
    std::optional<Frame> frame = telling.said[i];
    if (!frame || i < first) continue;
    const bool is_back = cycle_start && end - events.begin() == static_cast<std::ptrdiff_t>(i) + 1;
    if (is_back) frame = repetition(std::move(*frame), *cycle_start - 1);
    frame->moments = {now};
    frame->events = {{0, i}};
    story.frames.push_back(std::move(*frame));
  }
}

// -- Two scenes -------------------------------------------------------------------------------------------------------

/// Returns: the place of the first event of type `E` in that iteration.
template <class E>
std::size_t find_event(const Trace& trace, int iteration) {
  for (std::size_t i = 0; i < trace.events.size(); ++i)
    if (const E* event = std::get_if<E>(&trace.events[i]); event && event->iteration == iteration) return i;
  throw std::logic_error("the scene of this walkthrough ends before the move that it is meant to show");
}

/// Returns: what a frame would say about event `at` of that scene; nothing where it says nothing.
std::optional<Frame> frame_of(const Story& story, std::size_t scene, std::size_t at) {
  const Telling& telling = story.tellings[scene];
  std::optional<Frame> frame = telling.said[at];
  if (!frame) return std::nullopt;
  frame->moments = {replay(telling.trace, at + 1)};
  frame->events = {{0, at}};
  return frame;
}

/// Adds what `one` says of its scene to a frame about several.
void join(Frame& all, const Scene& scene, const Frame& one) {
  for (const Fact& fact : one.facts) all.facts.push_back({fact.mark, scene.name + ": " + fact.text, {}, {}, &scene});
  all.moments.push_back(one.moments[0]);
  all.events.push_back(one.events[0]);
}

/// One frame about the same kind of event in every scene.
template <class E>
void tell_side_by_side(Story& story, int iteration, const std::string& sentence) {
  Frame all{Focus::support, sentence, sentence, {}, {}, {}, {}};
  for (std::size_t s = 0; s < story.tellings.size(); ++s) {
    const Frame one = frame_of(story, s, find_event<E>(story.tellings[s].trace, iteration)).value();
    all.focus = one.focus;
    join(all, story.tellings[s].scene, one);
  }
  story.frames.push_back(std::move(all));
}

/// A move and whether it crossed the origin (Eq. 9).
void tell_move(Story& story, const CloseUp& move) {
  tell_side_by_side<gjk::DirectionChosen<double>>(story, move.iteration - 1, move.direction);
  tell_side_by_side<gjk::SupportFound<double>>(story, move.iteration, move.support);
  tell_side_by_side<gjk::CrossingTested<double>>(story, move.iteration, move.crossing);
}

/// Returns: the last event of that iteration that a frame says something about; of the last iteration where there are fewer.
Frame last_frame_of(const Story& story, std::size_t scene, int iteration) {
  std::optional<Frame> last;
  for (std::size_t i = 0; i < story.tellings[scene].trace.events.size(); ++i) {
    std::optional<Frame> frame = frame_of(story, scene, i);
    if (frame && frame->moments[0].iteration <= iteration) last = std::move(frame);
  }
  return std::move(last.value());
}

int iterations_of(const Trace& trace) {
  return std::visit([](const auto& e) { return e.iteration; }, trace.events.back());
}

/// Two searches, iteration by iteration.
void tell_in_step(Story& story) {
  const int count = std::max(iterations_of(story.tellings[0].trace), iterations_of(story.tellings[1].trace));
  for (int iteration = 1; iteration <= count; ++iteration) {
    const std::string sentence =
        iteration == count ? "Where the two searches end." : "After iteration " + std::to_string(iteration) + ".";
    Frame all{Focus::direction, sentence, sentence, {}, {}, {}, {}};
    for (std::size_t s = 0; s < story.tellings.size(); ++s) {
      Frame one = last_frame_of(story, s, iteration);
      one.facts = {{Fact::Mark::none, one.headline}};
      join(all, story.tellings[s].scene, one);
    }
    story.frames.push_back(std::move(all));
  }
}

/// Returns: how many events the two traces have in common from the start, but for what numbers them.
std::size_t common_events(const Trace& left, const Trace& right) {
  const std::size_t shorter = std::min(left.events.size(), right.events.size());
  std::size_t count = 0;
  while (count < shorter && left.events[count] == right.events[count]) ++count;
  return count;
}

std::size_t last_event(const Story& story) {
  return std::max(story.tellings[0].trace.events.size(), story.tellings[1].trace.events.size()) - 1;
}

int iterations_of(const Telling& telling) {
  const auto* const finished = std::get_if<gjk::Finished<double>>(&telling.trace.events.back());
  return finished ? finished->result.iterations : 0;
}

/// What stands above a frame of two runs, and whether it only says that they go on, or that one does.
struct Sentence {
  std::string text;
  enum class Says { what_happens, both_go_on, one_goes_on } says = Says::what_happens;
};

/// Returns: ", wrongly. In truth the objects are apart"; empty where that is what the search answers.
std::string truth_beside(const Telling& telling) {
  const std::string truth = truth_told(telling.truth, telling.scene, answer_of(telling.trace)).predicate;
  return truth.empty() ? "" : ", wrongly. In truth the objects " + truth;
}

Sentence sentence_for(const Story& story, std::size_t i, std::size_t common, const std::optional<ToldMistake>& told) {
  using enum Sentence::Says;
  if (told && i == last_event(story)) return {told->ending + "."};
  if (i == common)
    return {told ? "Here the two runs part: " + told->meaning + "."
                 : "Here the two runs part: these are the first events that differ."};
  const auto ends_here = [i](const Telling& telling) { return i + 1 == telling.trace.events.size(); };
  if (std::ranges::all_of(story.tellings, ends_here)) return {"Here both runs end."};
  for (const Telling& telling : story.tellings)
    if (ends_here(telling))
      return {"Here one run ends, in iteration " + std::to_string(iterations_of(telling)) + ": " + telling.scene.name +
              (told ? "" : truth_beside(telling)) + "."};
  const auto has_ended = [i](const Telling& telling) { return i >= telling.trace.events.size(); };
  if (std::ranges::none_of(story.tellings, has_ended)) return {"Both runs go on.", both_go_on};
  const Telling& going_on = story.tellings[has_ended(story.tellings[0]) ? 1 : 0];
  return {"Only one run goes on: " + going_on.scene.name + ".", one_goes_on};
}

/// Where no run parts or ends, what the first that says anything does is the sentence, and only its numbers are left to tell below.
void lead_with_first(Frame& frame, const std::string& name, const Frame& first) {
  frame.caption = name + ": " + first.caption;
  if ('a' <= frame.caption[0] && frame.caption[0] <= 'z') frame.caption[0] += 'A' - 'a';  // "The report: …", a sentence
  frame.headline = frame.caption;
  const Fact::Mark mark = frame.facts.front().mark;
  frame.facts.erase(frame.facts.begin());
  if (first.facts.empty()) return;
  if (first.facts[0].is_in_caption)
    frame.facts.insert(frame.facts.begin(), {mark, first.facts[0].text, {}, {}, nullptr, true});
  else
    frame.facts.front() = {mark, name + ": " + first.facts[0].text};
}

/// Of what one run says that which the other says, too: what holds for the rules of both.
std::vector<Fact> said_by_both(const Frame& one, const Frame& other) {
  std::vector<Fact> facts;
  for (const Fact& fact : one.facts)
    if (std::ranges::count(other.facts, fact.text, &Fact::text) > 0) facts.push_back(fact);
  return facts;
}

/// What a run says at an event. A mistaken one that goes on, or heals, may say what is true.
Fact::Mark mark_of(const Scene& scene, const std::optional<ToldMistake>& told, Focus focus) {
  if (!scene.mistake && gjk::not_crossed(scene.rules) == gjk::NotCrossed::answer_at_once) return Fact::Mark::yes;
  if (!told) return Fact::Mark::no;
  const bool is_wrong = focus == Focus::parting ? told->is_wrong_there : focus == Focus::end && told->ends_wrongly;
  return is_wrong ? Fact::Mark::no : Fact::Mark::none;
}

/// Returns: a frame about event `i` of both runs, which part at `common`; nothing where neither has anything to say. The last tells
/// the ends of both.
std::optional<Frame> tell_both(const Story& story, std::size_t i, std::size_t common,
                               const std::optional<ToldMistake>& told) {
  std::vector<std::pair<const Scene*, Frame>> said;
  for (std::size_t s = 0; s < 2; ++s) {
    const std::size_t end = story.tellings[s].trace.events.size() - 1;
    const bool runs = i <= end || (told && i == last_event(story));
    std::optional<Frame> one = runs ? frame_of(story, s, std::min(i, end)) : std::nullopt;
    if (one) said.emplace_back(&story.tellings[s].scene, std::move(*one));
  }
  if (said.empty()) return std::nullopt;
  const Frame& first = said[0].second;
  if (i < common)
    return Frame{first.focus, "Both: " + first.caption, first.headline, said_by_both(first, said.back().second), {}, {},
                 {}};
  const auto [sentence, says] = sentence_for(story, i, common, told);
  const bool is_between = says != Sentence::Says::what_happens;
  Frame frame{i == common ? Focus::parting : first.focus, sentence, sentence, {}, {}, {}, {}};
  for (const auto& [scene, one] : said) {
    const Focus about = i == common ? Focus::parting : one.focus;
    frame.facts.push_back({mark_of(*scene, told, about), scene->name + ": " + one.caption, {}, {}, scene});
    if (told && (i == common || is_between) && !one.facts.empty() && !one.facts[0].is_in_caption)
      frame.facts.push_back({Fact::Mark::none, one.facts[0].text});
  }
  if (told && is_between) lead_with_first(frame, said.front().first->name, first);
  if (told && says == Sentence::Says::one_goes_on)
    frame.facts.push_back({Fact::Mark::none, "the other search has ended"});
  if (told && told->lines && i == common) frame.facts.push_back({Fact::Mark::truth, *told->lines});
  return frame;
}

/// Two runs on the same objects, until they part and to the end of each.
void tell_until_they_part(Story& story) {
  const Trace &left = story.tellings[0].trace, &right = story.tellings[1].trace;
  const std::size_t common = common_events(left, right);
  if (common <= last_event(story)) story.parts_at = common;
  const std::optional<ToldMistake> told = mistake_told(story, common);
  for (std::size_t i = 0; i <= last_event(story); ++i) {
    std::optional<Frame> frame = tell_both(story, i, common, told);
    if (!frame) continue;
    for (const Trace* trace : {&left, &right}) {
      const std::size_t at = std::min(i, trace->events.size() - 1);
      frame->moments.push_back(replay(*trace, at + 1));
      frame->events.push_back({0, at});
    }
    story.frames.push_back(std::move(*frame));
  }
}

// -- Diagrams ---------------------------------------------------------------------------------------------------------

void tell_diagrams(Story& story) {
  story.diagrams = story.walkthrough.diagrams();
  for (const Diagram& diagram : story.diagrams) {
    Frame frame{Focus::diagram, diagram.caption, diagram.caption, {}, {}, {}, {}};
    for (const std::string& fact : diagram.facts) frame.facts.push_back({Fact::Mark::none, fact});
    story.frames.push_back(std::move(frame));
  }
}

// -- All --------------------------------------------------------------------------------------------------------------

/// Each frame covers what has happened since the one before, the first of them all from the beginning.
void set_first_events(std::vector<Frame>& frames) {
  for (EventRange& range : frames.at(0).events) range.first = 0;
  for (std::size_t i = 1; i < frames.size(); ++i)
    for (std::size_t s = 0; s < frames[i].events.size(); ++s)
      frames[i].events[s].first = std::min(frames[i - 1].events[s].last + 1, frames[i].events[s].last);
}

/// Returns: what a search has said last, up to that event.
std::optional<Focus> last_focus(const Telling& telling, std::size_t event) {
  for (std::size_t i = event + 1; i-- > 0;)
    if (telling.said[i]) return telling.said[i]->focus;
  return std::nullopt;
}

/// Of two searches each is drawn as it stands, whatever the frame tells of the other: one that has ended makes no test again.
void set_own_focus(Story& story) {
  if (story.tellings.size() < 2) return;
  for (Frame& frame : story.frames)
    for (std::size_t s = 0; s < frame.events.size(); ++s)
      frame.own_focus.push_back(last_focus(story.tellings[s], frame.events[s].last).value_or(frame.focus));
}

// -- A choice of frames ---------------------------------------------------------------------------------------------------

struct Kind {
  std::string_view word;
  Focus focus;
};

constexpr std::array<Kind, 8> kinds{{{"supports", Focus::support},
                                     {"crossings", Focus::crossing},
                                     {"regions", Focus::region},
                                     {"reductions", Focus::reduction},
                                     {"directions", Focus::direction},
                                     {"proofs", Focus::proof},
                                     {"signs", Focus::sign},
                                     {"end", Focus::end}}};

bool is_about(const Frame& frame, Focus focus) {
  return frame.focus == focus || std::ranges::count(frame.own_focus, focus) > 0;
}

/// Adds what one word says. Returns: whether it says something.
bool add(FrameChoice& choice, std::string_view word) {
  if (const auto kind = std::ranges::find(kinds, word, &Kind::word); kind != kinds.end()) {
    choice.kinds.push_back(kind->focus);
    return true;
  }
  const std::size_t dash = word.find('-');
  const auto from = decimal<std::size_t>(word.substr(0, dash));
  const auto to = dash == std::string_view::npos ? from : decimal<std::size_t>(word.substr(dash + 1));
  if (!from || !to || *from == 0 || *to < *from) return false;
  choice.steps.emplace_back(*from, *to);
  return true;
}

}  // namespace

std::vector<std::size_t> last_of_each_iteration(const std::vector<Frame>& frames) {
  std::vector<std::size_t> last;
  for (std::size_t i = 0; i < frames.size(); ++i)
    if (i + 1 == frames.size() || frames[i].moments.empty() || frames[i + 1].iterations() != frames[i].iterations())
      last.push_back(i);
  return last;
}

void keep_only(Story& story, const std::vector<std::size_t>& places) {
  std::vector<Frame> frames;
  std::vector<Diagram> diagrams;
  for (const std::size_t i : places) {
    frames.push_back(std::move(story.frames[i]));
    if (!story.diagrams.empty()) diagrams.push_back(std::move(story.diagrams[i]));
  }
  story.frames = std::move(frames);
  story.diagrams = std::move(diagrams);
  set_first_events(story.frames);
}

Story tell(const Walkthrough& walkthrough, Detail detail) {
  std::vector<Trace> traces;
  for (const Scene& scene : walkthrough.scenes) traces.push_back(run(scene));
  return tell(walkthrough, std::move(traces), detail);
}

Story tell(const Walkthrough& walkthrough, std::vector<Trace> traces, Detail detail) {
  Story story{walkthrough, {}, {}, {}};
  for (std::size_t s = 0; s < walkthrough.scenes.size(); ++s)
    story.tellings.push_back(tell_scene(walkthrough, walkthrough.scenes[s], std::move(traces[s])));
  for (Telling& telling : story.tellings) say(story, telling);
  switch (walkthrough.layout) {
    case Layout::search: tell_whole_search(story); break;
    case Layout::close_ups: tell_move(story, walkthrough.close_up.value()); break;
    case Layout::in_step: tell_in_step(story); break;
    case Layout::until_they_part: tell_until_they_part(story); break;
    case Layout::diagrams: tell_diagrams(story); break;
  }
  set_first_events(story.frames);
  set_own_focus(story);
  if (detail == Detail::iteration) keep_only(story, last_of_each_iteration(story.frames));
  return story;
}

std::size_t counterpart(const std::vector<Frame>& known, std::size_t index, const std::vector<Frame>& frames) {
  const auto place = [](const Frame& frame) {
    const bool is_last = frame.focus == Focus::end || frame.focus == Focus::proven;
    return std::tuple(is_last ? std::numeric_limits<int>::max() : std::ranges::max(frame.iterations()), frame.focus);
  };
  if (known[index].moments.empty() || frames.front().moments.empty()) return std::min(index, frames.size() - 1);
  if (known[index].focus == Focus::parting)
    if (const auto parting = std::ranges::find(frames, Focus::parting, &Frame::focus); parting != frames.end())
      return static_cast<std::size_t>(parting - frames.begin());
  const auto wanted = place(known[index]);
  const auto nth = std::count_if(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(index),
                                 [&](const Frame& frame) { return place(frame) == wanted; });
  std::size_t best = 0;
  std::ptrdiff_t seen = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const auto here = place(frames[i]);
    if (here < wanted || (here == wanted && seen++ <= nth)) best = i;
  }
  return best;
}

std::string frame_kinds() { return joined(kinds, ", ", &Kind::word); }

std::optional<FrameChoice> frames_in(std::string_view text) {
  FrameChoice choice;
  while (true) {
    const std::size_t comma = text.find(',');
    if (!add(choice, text.substr(0, comma))) return std::nullopt;
    if (comma == std::string_view::npos) return choice;
    text.remove_prefix(comma + 1);
  }
}

std::vector<std::size_t> places_of(const FrameChoice& choice, const std::vector<Frame>& frames) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const bool is_named = std::ranges::any_of(
        choice.steps, [&](const auto& range) { return range.first <= i + 1 && i + 1 <= range.second; });
    const bool is_of_a_kind = std::ranges::any_of(choice.kinds, [&](Focus kind) {
      return kind == Focus::end ? i + 1 == frames.size() : is_about(frames[i], kind);
    });
    if (is_named || is_of_a_kind) places.push_back(i);
  }
  return places;
}

std::string objection_to(const FrameChoice& choice, const std::vector<Frame>& frames) {
  const std::string there_are = frames.size() == 1 ? "has 1 step" : "has " + std::to_string(frames.size()) + " steps";
  for (const auto& [from, to] : choice.steps)
    if (to > frames.size())
      return there_are + ", and no step " + std::to_string(to) + "; choose from 1 to " + std::to_string(frames.size());
  return places_of(choice, frames).empty() ? there_are + ", and none is of these kinds; choose others, or leave it out"
                                           : "";
}

}  // namespace walkthroughs::story
