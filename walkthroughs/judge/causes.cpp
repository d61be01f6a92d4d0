#include "walkthroughs/judge/causes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "walkthroughs/judge/starts.hpp"
#include "walkthroughs/pairs/dice.hpp"
#include "walkthroughs/steps/mistakes.hpp"
#include "walkthroughs/wrong_on_purpose/mistakes.hpp"

namespace walkthroughs::judge {
namespace {

/// "57 of 58".
std::string of(std::size_t count, std::size_t all) { return std::to_string(count) + " of " + std::to_string(all); }

/// A sample, ready to be asked of the report's algorithm.
struct Sample {
  const Judged* judged;
  gjk::PointSet<double> a, b;
  std::vector<Vec> directions;  ///< one for each of starts()
  bool is_wrong;
  bool touches, one_is_inside;
  Called right;           ///< the answer
  bool is_clear;          ///< neither rounding, be it to floats, nor a cycle decides
  std::vector<Run> runs;  ///< of the report's algorithm, one for each of starts()
  bool misleads_the_report() const {
    return std::ranges::any_of(runs,
                               [&](const Run& run) { return (run.status == gjk::Status::intersecting) != meet(); });
  }

  bool says_yes() const { return judged->said == Said::intersecting; }
  bool meet() const { return judged->asked.meet(); }
  bool is_right(bool says_yes) const { return right == Called::either || says_yes == (right == Called::intersecting); }
  /// What a program says that finds this, and calls sets one of which is inside the other what they are to be called.
  bool says_yes_where(bool they_meet) const { return they_meet && !(one_is_inside && right == Called::separated); }
};

constexpr double near_contact = 1e-5;  // relative to the largest number
constexpr double small = 1e-9, large = 1e9;

/// Whether no product of a search in floats rounds: of four factors, each a difference, and sums of three.
bool is_whole(const PointPair& pair) {
  const auto are_whole = [](const Points& points) {
    return std::ranges::all_of(points, [](const Vec& p) { return p == p.array().round().matrix(); });
  };
  return largest_number(pair) <= 8 && are_whole(pair.a) && are_whole(pair.b);
}

bool is_clear(const Judged& judged, bool in_plane) {
  const double size = largest_number(judged.asked.pair);
  if (is_whole(judged.asked.pair)) return true;
  return size > small && size < large && how_far(judged.asked, in_plane).length > near_contact * size;
}

std::vector<Sample> samples_of(const Judgement& judgement, const Standard& standard) {
  const bool in_plane = standard.expected.in_plane;
  std::vector<Sample> samples;
  for (const Judged& each : judgement.samples) {
    const PointPair& pair = each.asked.pair;
    const bool meet = each.asked.meet(), touches = meet && only_touch(pair, in_plane);
    Sample sample{.judged = &each,
                  .a = gjk::PointSet<double>(pair.a),
                  .b = gjk::PointSet<double>(pair.b),
                  .directions = {},
                  .is_wrong = false,
                  .touches = touches,
                  .one_is_inside = meet && !touches && one_is_inside(pair, in_plane),
                  .right = right_answer(each.asked, standard),
                  .is_clear = false,
                  .runs = {}};
    for (const Start& start : starts()) {
      sample.directions.push_back(start(pair));
      sample.runs.push_back(ask_faithfully(sample.a, sample.b, sample.directions.back()));
    }
    sample.is_wrong = !sample.is_right(sample.says_yes());
    sample.is_clear = !sample.misleads_the_report() && is_clear(each, in_plane);
    samples.push_back(std::move(sample));
  }
  return samples;
}

constexpr std::size_t enough_wrong = 3;  // fewer may be so by chance
// Of the size: no search in doubles misses that by rounding, unless the sets are flat.
constexpr double beyond_doubles = 1e-11;
constexpr double enough_of_limit = 0.95;  // whoever fails at many simplices looks a little like it

/// Of the samples that a program with some fault, or this one, answers wrongly, those that both do.
struct Overlap {
  std::size_t both = 0, either = 0;
  double share() const { return either == 0 ? 0 : static_cast<double>(both) / static_cast<double>(either); }
};

class Search {
 public:
  Search(const AskedProgram& program, const Judgement& judgement, const Standard& standard)
      : program_(program), samples_(samples_of(judgement, standard)) {
    for (const Sample& each : samples_) {
      wrong_ += each.is_wrong;
      clearly_wrong_ += each.is_wrong && each.is_clear;
    }
  }

  std::vector<Cause> go() {
    if (wrong_ < enough_wrong) return {};
    look_at_memory();
    look_at_scale();
    if (clearly_wrong_ == 0) {
      look_at_rounding();
    } else {
      look_at_answers();
      look_at_searches();
      drop_what_does_not_agree();
      if (causes_.empty()) look_at_orders_and_place();
    }
    drop_what_does_not_agree();
    // Of two that explain the same the one that was looked for first, which is simpler.
    std::ranges::stable_sort(
        causes_, [](const Cause& one, const Cause& other) { return one.agreement > other.agreement + 0.02; });
    return std::move(causes_);
  }

 private:
  void drop_what_does_not_agree() {
    std::erase_if(causes_, [](const Cause& each) { return each.agreement < enough_agreement; });
  }

  // -- Predictions ----------------------------------------------------------------------------------------------------

  /// Only samples count in which rounding does not decide.
  template <class SaysYes>
  Overlap overlap_with(const SaysYes& says_yes) const {
    Overlap overlap;
    for (const Sample& each : samples_) {
      if (!each.is_clear) continue;
      const bool is_predicted = !each.is_right(says_yes(each));
      overlap.both += is_predicted && each.is_wrong;
      overlap.either += is_predicted || each.is_wrong;
    }
    return overlap;
  }

  static std::string words_of(const Overlap& overlap) {
    return "wrong on " + of(overlap.both, overlap.either) + " pairs that it or the program gets wrong";
  }

  template <class SaysYes>
  void predict(const std::string& name, const std::string& how, const SaysYes& says_yes,
               const std::string& option = "") {
    const Overlap overlap = overlap_with(says_yes);
    causes_.push_back({name, how + ": " + words_of(overlap), overlap.share(), "", option});
  }

  template <class Change>
  void predict_after(const std::string& name, const std::string& how, const Change& change) {
    predict(name, how, [&](const Sample& each) {
      PointPair pair = each.judged->asked.pair;
      return each.says_yes_where(change(pair) ? truth_of(pair) == gjk::Status::intersecting : each.meet());
    });
  }

  void look_at_answers() {
    const auto says = [&](bool yes) {
      return std::ranges::all_of(samples_, [yes](const Sample& each) { return each.says_yes() == yes; });
    };
    if (says(true)) predict("it always says yes", "that answer", [](const Sample&) { return true; });
    if (says(false)) predict("it always says no", "that answer", [](const Sample&) { return false; });
    predict("contact is taken for a miss", "'no' to all that only touch",
            [](const Sample& each) { return each.says_yes_where(each.meet()) && !each.touches; });
    predict(
        "a set inside the other is taken for apart", "'no' where one lies inside the other",
        [](const Sample& each) { return each.meet() && !each.one_is_inside; }, "--solid no");
    predict_after("z is ignored", "the truth with every z at 0", [](PointPair& pair) {
      for (Points* const set : {&pair.a, &pair.b})
        for (Vec& p : *set) p.z() = 0;
      return true;
    });
    predict("it compares boxes along the axes", "that the boxes overlap", [](const Sample& each) {
      const auto range = [](const Points& points, int axis) {
        const auto [low, high] = std::ranges::minmax(points, {}, [axis](const Vec& p) { return p[axis]; });
        return std::pair(low[axis], high[axis]);
      };
      for (int axis = 0; axis < 3; ++axis) {
        const auto [low_a, high_a] = range(each.judged->asked.pair.a, axis);
        const auto [low_b, high_b] = range(each.judged->asked.pair.b, axis);
        if (high_a < low_b || high_b < low_a) return false;
      }
      return true;
    });
    predict("contact is taken for an intersection", "'yes' to all that only touch",
            [](const Sample& each) { return each.says_yes_where(each.meet()); });
    predict("a set inside the other is taken for an intersection", "'yes' where one lies inside the other",
            [](const Sample& each) { return each.one_is_inside || each.right == Called::intersecting; });
    for (const auto& [most, where] :
         {std::pair{2, "a vertex or segment"}, std::pair{3, "a vertex, segment or triangle"}})
      predict(std::string("the origin is not seen on ") + where + ", as where a zero direction is normalized",
              "'no' where such a simplex holds it",
              [most](const Sample& each) { return each.says_yes_where(each.meet()) && each.runs[0].vertices > most; });
    look_at_parts();
  }

  /// What is not looked at cannot matter.
  void look_at_parts() {
    struct Part {
      std::string words;
      std::function<void(Points&)> cut;
    };
    const auto first = [](std::size_t count) {
      return [count](Points& points) { points.resize(std::min(points.size(), count)); };
    };
    std::vector<Part> parts{{"the last point",
                             [](Points& points) {
                               if (points.size() > 1) points.pop_back();
                             }},
                            {"the first point", [](Points& points) {
                               if (points.size() > 1) points.erase(points.begin());
                             }}};
    for (const std::size_t count : {2, 3, 4, 8})
      parts.push_back({"what comes after the first " + std::to_string(count) + " points", first(count)});
    for (const auto& [words, cut] : parts)
      for (const auto& [whose, sets] : {std::pair{" of a", 1}, std::pair{" of b", 2}, std::pair{" of a and of b", 3}})
        predict_after(words + whose + " is not looked at", "the truth without it", [&](PointPair& pair) {
          const auto [a, b] = std::pair(pair.a.size(), pair.b.size());
          if (sets & 1) cut(pair.a);
          if (sets & 2) cut(pair.b);
          return a != pair.a.size() || b != pair.b.size();
        });
  }

  // -- Searches that others have written ------------------------------------------------------------------------------

  void look_at_rounding() {
    const auto is_beyond_doubles = [](const Sample& each) {
      const double size = largest_number(each.judged->asked.pair);
      return each.is_wrong && !each.misleads_the_report() && each.judged->how_far.relative > beyond_doubles &&
             size > small && size < large;
    };
    const auto beyond = static_cast<std::size_t>(std::ranges::count_if(samples_, is_beyond_doubles));
    const bool in_floats = 10 * beyond > wrong_;
    causes_.push_back(
        {in_floats ? "it computes in floats" : "nothing but rounding in doubles, and cycles",
         "all " + std::to_string(wrong_) +
             " wrong answers looked at are near contact, have numbers beyond 1e±9, or mislead the "
             "report's algorithm, too" +
             (in_floats ? "; doubles would tell " + std::to_string(beyond) + " of them" : ""),
         1, "", in_floats ? "--numbers float" : "--tolerance 1e-9", Cause::rounding});
  }

  void look_at_searches() {
    Overlap limited;
    int limit = 0;
    std::vector<Overlap> mistaken(mistakes().size());
    for (std::size_t start = 0; start < starts().size(); ++start) {
      for (int most = 1; most <= 30; ++most) {
        const Overlap found = overlap_with([&](const Sample& each) {
          return each.runs[start].iterations <= most &&
                 each.says_yes_where(each.runs[start].status == gjk::Status::intersecting);
        });
        if (found.share() <= limited.share()) continue;
        limited = found;
        limit = most;
      }
      for (std::size_t m = 0; m < mistakes().size(); ++m) {
        const Overlap found = overlap_with([&](const Sample& each) {
          return each.says_yes_where(mistakes()[m].ask_from(each.directions[start], each.a, each.b).status ==
                                     gjk::Status::intersecting);
        });
        if (found.share() > mistaken[m].share()) mistaken[m] = found;
      }
    }
    if (limited.share() > enough_of_limit)
      causes_.push_back({"a limit of " + std::to_string(limit) + " iterations",
                         "'no' where the report's algorithm needs more: " + words_of(limited), limited.share()});
    for (std::size_t m = 0; m < mistakes().size(); ++m)
      if (mistaken[m].both >= 3) {
        const auto& known = wrong_on_purpose::all()[m];
        causes_.push_back({wrong_on_purpose::number_of(known.value) + ": " + std::string(known.meaning),
                           "a program with this mistake: " + words_of(mistaken[m]), mistaken[m].share(),
                           std::string(known.word)});
      }
  }

  // -- Asking again after a change ------------------------------------------------------------------------------------

  /// What came of a change that must not change the answer.
  struct Changed {
    std::size_t wrong = 0, mended = 0;  ///< answers that were wrong; of these, those that are right now
    std::size_t right = 0, broken = 0;  ///< answers that were right; of these, those that are wrong now
    double mended_share() const { return wrong == 0 ? 0 : static_cast<double>(mended) / static_cast<double>(wrong); }
    double broken_share() const { return right == 0 ? 0 : static_cast<double>(broken) / static_cast<double>(right); }
  };

  template <class Change>
  Changed ask_after(const Change& change, bool in_reverse = false) const {
    std::vector<const Sample*> asked;
    std::vector<std::string> questions;
    for (const Sample& each : samples_)
      if (const auto pair = change(each)) {
        asked.push_back(&each);
        questions.push_back(question_line({pair->a, pair->b}));
      }
    if (in_reverse) {
      std::ranges::reverse(asked);
      std::ranges::reverse(questions);
    }
    const Replies replies = ask_all(program_, questions);
    Changed changed;
    for (std::size_t i = 0; i < asked.size(); ++i) {
      if (replies.all[i].kind != Reply::line) continue;
      const Said said =
          read_answer(replies.all[i].text, {asked[i]->judged->asked.pair.a, asked[i]->judged->asked.pair.b}).said;
      const bool is_answer = said == Said::intersecting || said == Said::separated;
      const bool is_right = is_answer && asked[i]->is_right(said == Said::intersecting);
      ++(asked[i]->is_wrong ? changed.wrong : changed.right);
      changed.mended += asked[i]->is_wrong && is_right;
      changed.broken += !asked[i]->is_wrong && !is_right;
    }
    return changed;
  }

  Changed ask_exchanged() const {
    return ask_after([](const Sample& each) -> std::optional<PointPair> {
      if (!each.is_clear) return std::nullopt;
      return PointPair{each.judged->asked.pair.b, each.judged->asked.pair.a};
    });
  }

  Changed ask_permuted() const {
    return ask_after([](const Sample& each) -> std::optional<PointPair> {
      if (!each.is_clear) return std::nullopt;
      PointPair pair = each.judged->asked.pair;
      Dice dice(1, each.judged->asked.name, 0);
      dice.shuffle(pair.a);
      dice.shuffle(pair.b);
      return pair;
    });
  }

  /// By a power of two, so that the largest number is about so large.
  Changed ask_scaled(double wanted) const {
    return ask_after([&](const Sample& each) -> std::optional<PointPair> {
      if (each.is_wrong && each.judged->how_far.relative < 1e-7) return std::nullopt;  // rounding may be why
      PointPair pair = each.judged->asked.pair;
      if (largest_number(pair) == 0) return std::nullopt;
      const double factor = std::ldexp(1.0, std::ilogb(wanted) - std::ilogb(largest_number(pair)));
      for (Points* const set : {&pair.a, &pair.b})
        for (Vec& p : *set) {
          const Vec before = p;
          p *= factor;
          if (p / factor != before || !p.allFinite()) return std::nullopt;
        }
      return pair;
    });
  }

  /// So that the first point is the origin, where that rounds nothing.
  Changed ask_about_origin() const {
    return ask_after([](const Sample& each) -> std::optional<PointPair> {
      PointPair pair = each.judged->asked.pair;
      const Vec by = pair.a[0];
      if (!each.is_clear || by == Vec::Zero()) return std::nullopt;
      for (Points* const set : {&pair.a, &pair.b})
        for (Vec& p : *set) {
          const Vec before = p;
          p -= by;
          if (p + by != before || before - p != by) return std::nullopt;
        }
      return pair;
    });
  }

  static std::string words_of(const Changed& changed) {
    return of(changed.mended, changed.wrong) + " wrong answers become right, " + of(changed.broken, changed.right) +
           " right ones wrong";
  }

  /// The same pairs in another order.
  void look_at_memory() {
    const Changed again = ask_after([](const Sample& each) { return std::optional(each.judged->asked.pair); }, true);
    const std::size_t changed = again.mended + again.broken;
    if (changed < enough_wrong) return;
    causes_.push_back({"it answers otherwise when it is asked again: chance, or what it keeps from pair to pair",
                       "the same pairs in reverse order: " + words_of(again), 1});
  }

  void look_at_scale() {
    const double size = std::ldexp(1.0, 20);
    const Changed larger = ask_scaled(size), smaller = ask_scaled(1 / size);
    // A tolerance breaks what is small, and most of all nothing that is large.
    if (smaller.broken_share() <= 0.1) return;
    const bool is_lopsided = smaller.broken_share() > 10 * larger.broken_share();
    causes_.push_back({"an absolute tolerance",
                       "in size 2^20, " + words_of(larger) + "; in size 2^-20, " + words_of(smaller),
                       std::max(larger.mended_share(), is_lopsided ? enough_agreement : 0)});
  }

  void look_at_orders_and_place() {
    // What leads a search another way may mend it by chance: a cause mends what other changes do not.
    struct Try {
      std::string name, change;
      Changed changed;
    };
    const std::array tries{Try{"the order of a and b matters", "a and b exchanged", ask_exchanged()},
                           Try{"the order of points matters", "points permuted", ask_permuted()},
                           Try{"the place in the world matters", "moved to the origin", ask_about_origin()}};
    for (const Try& each : tries) {
      double others = 0;
      for (const Try& other : tries)
        if (&other != &each) others = std::max(others, other.changed.mended_share());
      causes_.push_back({each.name, each.change + ", " + words_of(each.changed),
                         others > 0.5 ? 0 : each.changed.mended_share(), "", "", Cause::symptom});
    }
  }

  const AskedProgram& program_;
  std::vector<Sample> samples_;
  std::size_t wrong_ = 0, clearly_wrong_ = 0;
  std::vector<Cause> causes_;
};

// -- Distances ----------------------------------------------------------------------------------------------------------

/// Those that rounding in floats leaves.
std::string digits_of(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.7g", x);
  return text;
}

double between_nearest_vertices(const PointPair& pair) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec& p : pair.a)
    for (const Vec& q : pair.b) least = std::min(least, (p - q).stableNorm());
  return least;
}

double between_boxes(const PointPair& pair) {
  const auto middle = [](const Points& points) {
    Vec least = points[0], most = points[0];
    for (const Vec& p : points) {
      least = least.cwiseMin(p);
      most = most.cwiseMax(p);
    }
    return Vec(least / 2 + most / 2);
  };
  return (middle(pair.a) - middle(pair.b)).stableNorm();
}

/// A wrong distance is explained where what is predicted is as wrong, up to a hundredth.
std::vector<Cause> causes_of_distances(const Judgement& judgement, const Standard& standard) {
  const double good = good_distance(standard.expected.numbers);
  std::vector<const Judged*> told;
  std::vector<double> ratios;
  for (const Judged& each : judgement.samples) {
    if (!each.distance || !(each.how_far.length > 0) || !std::isfinite(each.how_far.length)) continue;
    told.push_back(&each);
    if (how_wrong(each) > good) ratios.push_back(*each.distance / each.how_far.length);
  }
  std::vector<Cause> causes;
  const auto predict = [&](const std::string& name, const std::string& how, const auto& distance_of) {
    Overlap overlap;
    for (const Judged* const each : told) {
      Judged predicted = *each;
      predicted.distance = distance_of(*each);
      const bool is_wrong = how_wrong(*each) > good;
      overlap.both += is_wrong && std::abs(*predicted.distance - *each->distance) <=
                                      0.01 * std::abs(*each->distance - each->how_far.length);
      overlap.either += is_wrong || how_wrong(predicted) > good;
    }
    if (overlap.share() >= enough_agreement)
      causes.push_back({name,
                        how + ": " + of(overlap.both, overlap.either) + " distances that it or the program gets wrong",
                        overlap.share()});
  };
  predict("it tells the square of the distance", "that",
          [](const Judged& each) { return each.how_far.length * each.how_far.length; });
  if (!ratios.empty()) {
    std::ranges::nth_element(ratios, ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2));
    const double ratio = ratios[ratios.size() / 2];
    predict("it tells " + digits_of(ratio) + " times the distance", "that",
            [ratio](const Judged& each) { return ratio * each.how_far.length; });
  }
  predict("it tells the distance between the nearest vertices", "that",
          [](const Judged& each) { return between_nearest_vertices(each.asked.pair); });
  predict("it tells the distance between the centers", "the means of the points",
          [](const Judged& each) { return (mean_of(each.asked.pair.a) - mean_of(each.asked.pair.b)).stableNorm(); });
  predict("it tells the distance between the centers", "the middles of the boxes",
          [](const Judged& each) { return between_boxes(each.asked.pair); });
  std::ranges::stable_sort(causes, std::greater(), &Cause::agreement);
  return causes;
}

}  // namespace

std::vector<Cause> probable_causes(const AskedProgram& program, const Judgement& judgement, const Standard& standard) {
  const Tally& all = judgement.all;
  std::vector<Cause> causes, of_distances;
  if (all.of(Verdict::wrong_distance) >= enough_wrong) of_distances = causes_of_distances(judgement, standard);
  if (all.of(Verdict::wrong_yes) + all.of(Verdict::wrong_no) + all.of(Verdict::within_tolerance) >= enough_wrong)
    causes = Search(program, judgement, standard).go();
  const bool are_mostly_distances = 2 * all.of(Verdict::wrong_distance) > all.wrong();
  if (are_mostly_distances)  // which rounding does not explain
    std::erase_if(causes, [](const Cause& each) { return each.rank == Cause::rounding; });
  causes.insert(are_mostly_distances ? causes.begin() : causes.end(), of_distances.begin(), of_distances.end());
  return causes;
}

}  // namespace walkthroughs::judge
