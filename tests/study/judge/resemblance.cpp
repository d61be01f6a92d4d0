#include "tests/study/judge/resemblance.hpp"

#include <algorithm>

#include "tests/study/judge/starts.hpp"
#include "tests/study/methods/mistakes.hpp"
#include "tests/study/methods/question.hpp"

namespace study {
namespace {

using Vec3 = gjk::Vec3<double>;
using Set = gjk::PointSet<double>;

/// A pair about which the program said something, ready to be asked.
struct Asked {
  Set a, b;
  gjk::PointSet<float> a_in_floats, b_in_floats;
  Vec3 between;
  bool meet, program_is_wrong;
};

Vec3 direction_of(const Start& start, const Asked& pair) { return start.direction_of(pair.between); }

std::string mistake_words(std::size_t mistake) {
  return "M" + std::to_string(mistake + 1) + " (" + mistakes()[mistake].name + ")";
}

/// What Algorithm 1 says: at its limit, no.
bool is_right(const Run& run, bool meet) { return (run.status == gjk::Status::intersecting) == meet; }

gjk::PointSet<float> in_floats(const Body& body) {
  std::vector<gjk::Vec3<float>> points;
  for (const Vec& p : std::get<Points>(body)) points.push_back(p.cast<float>());
  return gjk::PointSet<float>(std::move(points));
}

bool float_is_right(const Asked& pair, const Start& start) {
  const gjk::Options<float> options{.first_direction = direction_of(start, pair).cast<float>()};
  const auto status = gjk::collision<float>(pair.a_in_floats, pair.b_in_floats, options).status;
  return (status == gjk::Status::intersecting) == pair.meet;
}

bool says_something(Verdict verdict) {
  return verdict == Verdict::right || verdict == Verdict::wrong_yes || verdict == Verdict::wrong_no ||
         verdict == Verdict::undecided;
}

std::vector<Asked> asked_of(const std::vector<Judged>& pairs) {
  std::vector<Asked> all;
  for (const Judged& judged : pairs) {
    const Pair& pair = judged.named.pair;
    const auto *a = std::get_if<Points>(&pair.a), *b = std::get_if<Points>(&pair.b);
    if (!a || !b || !says_something(judged.verdict)) continue;
    const bool meet = judged.truth == Truth::intersecting;
    const bool is_wrong = judged.verdict == Verdict::undecided ? meet : judged.verdict != Verdict::right;
    all.push_back(
        {Set(*a), Set(*b), in_floats(pair.a), in_floats(pair.b), between_centers<double>(pair), meet, is_wrong});
  }
  return all;
}

/// One flag a pair.
using Flags = std::vector<bool>;

template <class Of>
Flags flags(const std::vector<Asked>& pairs, const Of& of) {
  Flags all;
  for (const Asked& pair : pairs) all.push_back(of(pair));
  return all;
}

/// Adds up the pairs that count.
Resemblance compared(Resemblance found, const std::vector<Asked>& pairs, const Flags& other_is_right,
                     const Flags& counts) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!counts[i]) continue;
    found.both += pairs[i].program_is_wrong && !other_is_right[i];
    found.either += pairs[i].program_is_wrong || !other_is_right[i];
  }
  return found;
}

bool is_more(const Resemblance& x, const Resemblance& y) {
  if (x.has_evidence() != y.has_evidence()) return x.has_evidence();
  return x.share() != y.share() ? x.share() > y.share() : x.both > y.both;
}

}  // namespace

std::vector<Resemblance> resemblances(const std::vector<Judged>& judged) {
  const std::vector<Asked> pairs = asked_of(judged);
  const Flags all(pairs.size(), true);
  std::vector<Resemblance> best(mistakes().size() + 4);  // in the end those without a mistake, and without a search
  const auto add = [&](Resemblance& known, const Resemblance& other, const Flags& other_is_right, const Flags& counts) {
    if (const Resemblance found = compared(other, pairs, other_is_right, counts); is_more(found, known)) known = found;
  };
  for (const Start& start : starts()) {
    const Flags sound = flags(pairs, [&](const Asked& pair) {
      return is_right(ask_faithfully(pair.a, pair.b, direction_of(start, pair)), pair.meet);
    });
    const Flags in_floats = flags(pairs, [&](const Asked& pair) { return float_is_right(pair, start); });
    Flags sound_in_both;
    for (std::size_t i = 0; i < pairs.size(); ++i) sound_in_both.push_back(sound[i] && in_floats[i]);
    for (std::size_t m = 0; m < mistakes().size(); ++m) {
      const Resemblance other{.mistake = m, .name = mistake_words(m), .first_direction = start.words};
      const Flags rights = flags(pairs, [&](const Asked& pair) {
        return is_right(mistakes()[m].ask_from(direction_of(start, pair), pair.a, pair.b), pair.meet);
      });
      add(best[m], other, rights, sound);
      add(best[m], other, rights, sound_in_both);
    }
    const auto sound_in = [&](Numbers numbers) {
      const std::string words(numbers_words[static_cast<std::size_t>(numbers)]);
      return Resemblance{.name = "the report's algorithm in " + words + " (without a mistake)",
                         .sound_in = numbers,
                         .first_direction = start.words};
    };
    add(best[mistakes().size()], sound_in(Numbers::doubles), sound, all);
    add(best[mistakes().size() + 1], sound_in(Numbers::floats), in_floats, all);
  }
  const auto always = [](const std::string& word) { return Resemblance{.name = "a program that always says " + word}; };
  const Flags yes_is_right = flags(pairs, [](const Asked& pair) { return pair.meet; });
  const Flags no_is_right = flags(pairs, [](const Asked& pair) { return !pair.meet; });
  add(best[mistakes().size() + 2], always("yes"), yes_is_right, all);
  add(best[mistakes().size() + 3], always("no"), no_is_right, all);
  std::erase_if(best, [](const Resemblance& each) { return each.both == 0; });
  // Of two that explain the same, the one that needs no search.
  std::ranges::stable_sort(best, [](const Resemblance& x, const Resemblance& y) {
    return is_more(x, y) || (!is_more(y, x) && !x.mistake && y.mistake);
  });
  return best;
}

}  // namespace study
