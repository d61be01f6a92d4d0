#include "walkthroughs/story/frame_choice.hpp"

#include <algorithm>
#include <array>

#include "walkthroughs/model/number_text.hpp"

namespace walkthroughs::story {
namespace {

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

std::string frame_kinds() {
  std::string words;
  for (const Kind& kind : kinds) words.append(words.empty() ? "" : ", ").append(kind.word);
  return words;
}

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
  const std::string there_are =
      frames.size() == 1 ? "there is 1 step" : "there are " + std::to_string(frames.size()) + " steps";
  for (const auto& [from, to] : choice.steps)
    if (to > frames.size()) return there_are + ", and no step " + std::to_string(to);
  return places_of(choice, frames).empty() ? there_are + ", and none is about that" : "";
}

}  // namespace walkthroughs::story
