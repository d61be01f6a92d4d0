#include "tests/study/corpus/corpus.hpp"

#include <algorithm>
#include <map>

#include "tests/study/corpus/published.hpp"
#include "tests/study/corpus/shown.hpp"
#include "tests/study/corpus/smallest.hpp"
#include "tests/study/methods/mistakes.hpp"
#include "tests/study/methods/question.hpp"
#include "tests/study/pairs/pairs.hpp"
#include "tests/study/truth/oracle.hpp"

namespace study {
namespace {

constexpr std::uint64_t seed = 1, candidates = 1000;  // of each family, from the first
constexpr std::ptrdiff_t least_of_mistake = 6;
constexpr std::size_t bytes_of_family = 1380, most_of_family = 12;

/// What a candidate shows, as numbers: those of mistakes from 0, then what follows.
enum Aspect : std::size_t { sound_fails = 1000, floats_change_it, apart, together };

std::vector<std::size_t> aspects_of(const Pair& pair) {
  std::vector<std::size_t> aspects;
  const Truth found = truth(pair);
  aspects.push_back(found == Truth::separated ? apart : together);
  const auto in_floats = study::rounded<float>(pair);
  if (in_floats && in_floats->differs && truth(in_floats->pair) != found) aspects.push_back(floats_change_it);
  if (!std::holds_alternative<Points>(pair.a)) return aspects;
  const Shown shown = shown_by(pair);
  if (shown.sound_fails) aspects.push_back(sound_fails);
  for (std::size_t i = 0; i < shown.by_mistake.size(); ++i)
    if (shown.by_mistake[i]) aspects.push_back(i);
  return aspects;
}

/// How often each aspect has been chosen: the more often, the less one more is worth.
class Chosen {
 public:
  double worth(const std::vector<std::size_t>& aspects) const {
    double sum = 0;
    for (const std::size_t aspect : aspects) {
      const auto found = count_.find(aspect);
      const double weight = aspect == sound_fails ? 20 : 1;  // as many as it keeps from being seen
      sum += weight / (1 + (found == count_.end() ? 0 : found->second));
    }
    return sum;
  }
  void add(const std::vector<std::size_t>& aspects) {
    for (const std::size_t aspect : aspects) ++count_[aspect];
  }

 private:
  std::map<std::size_t, int> count_;
};

/// Large pairs have few candidates: they take their time, and room in the file for one only.
std::uint64_t candidates_of(const Family& family) {
  const Pair first = family.make(seed, 0);
  const auto* const points = std::get_if<Points>(&first.a);
  return std::min(points && points->size() > 30 ? 50 : candidates, family.size.value_or(candidates));
}

/// The most telling for their length first, as far as there is room; one at least. What is rare in all families is worth more
/// than what is rare in this one.
void choose_from(const Family& family, Chosen& overall, std::vector<NamedPair>& all) {
  struct Candidate {
    NamedPair named;
    std::vector<std::size_t> aspects;
    std::size_t bytes;  ///< without its answer
  };
  std::vector<Candidate> left;
  for (std::uint64_t i = 0; i < candidates_of(family); ++i) {
    const NamedPair named{family.name + "-" + std::to_string(i), family.name, family.make(seed, i)};
    left.push_back({named, aspects_of(named.pair), question_line(named.pair).size()});
  }
  Chosen chosen;
  for (std::size_t bytes = 0, count = 0; count < most_of_family && bytes < bytes_of_family && !left.empty(); ++count) {
    const auto best = std::ranges::max_element(left, {}, [&](const Candidate& candidate) {
      const double worth = chosen.worth(candidate.aspects) + 10 * overall.worth(candidate.aspects);
      return worth / static_cast<double>(candidate.bytes);
    });
    chosen.add(best->aspects);
    overall.add(best->aspects);
    bytes += answered_line(answered(best->named)).size();
    all.push_back(std::move(best->named));
    left.erase(best);
  }
}

/// Adds pairs on which each mistake shows that shows on too few, where candidates have any.
void complete(std::vector<NamedPair>& all) {
  for (std::size_t mistake = 0; mistake < mistakes().size(); ++mistake) {
    const auto has = [&](const NamedPair& each) {
      return std::holds_alternative<Points>(each.pair.a) && shows(each.pair, mistake);
    };
    auto count = std::ranges::count_if(all, has);
    for (auto family = families().begin(); family != families().end() && count < least_of_mistake; ++family)
      for (std::uint64_t i = 0; i < candidates_of(*family) && count < least_of_mistake; ++i) {
        const NamedPair named{family->name + "-" + std::to_string(i), family->name, family->make(seed, i)};
        if (!has(named) || std::ranges::find(all, named.name, &NamedPair::name) != all.end()) continue;
        all.push_back(named);
        ++count;
      }
  }
}

}  // namespace

std::vector<NamedPair> kept_corpus() {
  std::vector<NamedPair> all = published_failures();
  for (NamedPair& each : smallest_pairs()) all.push_back(std::move(each));
  Chosen overall;
  for (const Family& family : families()) choose_from(family, overall, all);
  complete(all);
  return all;
}

}  // namespace study
