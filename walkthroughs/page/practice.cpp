#include "walkthroughs/page/practice.hpp"

#include <algorithm>
#include <variant>
#include <vector>

#include "walkthroughs/catalogue/catalogue.hpp"
#include "walkthroughs/page/index_entry.hpp"
#include "walkthroughs/story/storyboard.hpp"
#include "walkthroughs/wrong_on_purpose/mistakes.hpp"

namespace walkthroughs {
namespace {

using Kind = Decision::Kind;

/// A walkthrough of regions, with the decisions that its search makes, and those that it is about.
struct Practice {
  std::string name;
  std::vector<Decision> made, told;
};

int iteration_of(const gjk::Event<double>& event) {
  return std::visit(
      [](const auto& each) {
        if constexpr (requires { each.iteration; }) return static_cast<int>(each.iteration);
        return 0;
      },
      event);
}

/// Whether its name says that it is about such a simplex; a crossing test is about none.
bool is_about(const Walkthrough& w, const Decision& decision) {
  return decision.simplex_size == 0 ||
         w.name.starts_with("regions/" + std::to_string(decision.simplex_size - 1) + "-simplex-");
}

std::vector<Practice> practices() {
  std::vector<Practice> all;
  for (const Walkthrough& w : catalogue()) {
    if (!w.region_case) continue;
    const Story story = tell(w);
    Practice practice{w.name, {}, {}};
    for (const Question& question : questions_of(story)) {
      const auto& event = story.tellings[question.scene].trace.events[question.event];
      practice.made.push_back(question.decision);
      if (is_about(w, question.decision) && iteration_of(event) == told_iteration(w))
        practice.told.push_back(question.decision);
    }
    all.push_back(std::move(practice));
  }
  return all;
}

/// The face or feature in words of Decision::found.
std::string first_word(const std::string& found) { return found.substr(0, found.find(' ')); }

/// That of M1 is about no region.
std::string practice_for_mistake(const std::string& word) {
  const auto known = wrong_on_purpose::all();
  const auto found = std::ranges::find(known, word, &wrong_on_purpose::Description::word);
  return found == known.end() || found->practice.empty() ? "" : "regions/" + std::string(found->practice);
}

}  // namespace

std::string practice_for(const Decision& decision, const std::string& but) {
  if (decision.kind == Kind::line) return practice_for_mistake(decision.found);
  static const std::vector<Practice> all = practices();
  const auto find = [&](const auto& is_likewise) {
    const auto found =
        std::ranges::find_if(all, [&](const Practice& each) { return each.name != but && is_likewise(each); });
    return found == all.end() ? "" : found->name;
  };
  const auto is_alike = [&](const Decision& other) {
    return other.kind == decision.kind && other.simplex_size == decision.simplex_size &&
           first_word(other.found) == first_word(decision.found);
  };
  for (const std::string& name : {find([&](const Practice& each) { return std::ranges::count(each.told, decision); }),
                                  find([&](const Practice& each) { return std::ranges::any_of(each.told, is_alike); }),
                                  find([&](const Practice& each) { return std::ranges::count(each.made, decision); })})
    if (!name.empty()) return name;
  return "";
}

}  // namespace walkthroughs
