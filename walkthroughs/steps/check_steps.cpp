#include "walkthroughs/steps/check_steps.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <random>
#include <utility>

#include "core/certified/fraction.hpp"
#include "walkthroughs/steps/differences.hpp"
#include "walkthroughs/steps/mistakes.hpp"
#include "walkthroughs/steps/right_outcomes.hpp"

namespace walkthroughs::steps {
namespace {

constexpr double rounded_away = 1e-12;  // P·d, of the sizes of its products

// -- Words ------------------------------------------------------------------------------------------------------------

std::string words_of(const Vec& v) { return "(" + shown(v[0]) + ", " + shown(v[1]) + ", " + shown(v[2]) + ")"; }

/// Returns: "[C, A]", the letters that vertices have in a simplex of that size.
std::string letters_of(const Indices& indices, std::size_t size) {
  std::string text;
  for (const int i : indices)
    text += (text.empty() ? "[" : ", ") + std::string(1, "ABCD"[static_cast<int>(size) - 1 - i]);
  return text + "]";
}

std::string letters_and_places(const Vertices& vertices) {
  std::string text;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    text +=
        (text.empty() ? "" : ", ") + std::string(1, "ABCD"[vertices.size() - 1 - i]) + " = " + words_of(vertices[i]);
  return text;
}

// -- Following a search -----------------------------------------------------------------------------------------------

class Following {
 public:
  explicit Following(const ToldRun& run) : run_(run), differences_(run.pair.a, run.pair.b) {}

  CheckedSteps check() {
    for (at_ = 0; at_ < run_.steps.size(); ++at_)
      if (!follow()) go_on_from_its_own();
    std::ranges::stable_sort(findings_, {}, &StepFinding::iteration);
    return {std::move(findings_), std::move(not_made_)};
  }

 private:
  const ToldStep& step() const { return run_.steps[at_]; }
  bool is_last() const { return at_ + 1 == run_.steps.size(); }
  int iteration() const { return static_cast<int>(at_) + 1; }

  /// Whether the vertices of these indices are at the same places: a vertex may have come twice.
  bool are_same_set(const Indices& x, const Indices& y) const {
    const auto holds = [this](const Indices& list, int i) {
      return std::ranges::any_of(list, [&](int k) {
        return differences_.are_same(vertices_[static_cast<std::size_t>(k)], vertices_[static_cast<std::size_t>(i)]);
      });
    };
    return std::ranges::all_of(x, [&](int i) { return holds(y, i); }) &&
           std::ranges::all_of(y, [&](int i) { return holds(x, i); });
  }

  void blame(int iteration, std::string words, std::vector<std::size_t> mistakes, bool may_be_rounding = false) {
    if (!may_be_rounding) may_be_rounding = has_no_room(words, mistakes);
    findings_.push_back({iteration, may_be_rounding ? StepFinding::rounding : StepFinding::wrong, std::move(words),
                         std::move(mistakes)});
  }

  /// ((AB×AO)×AB)·P has four factors of the sets' size, the square of (AB×AO)×AB six, and doubles have room for no more than this:
  /// then the words say so, and no mistake is named.
  bool has_no_room(std::string& words, std::vector<std::size_t>& mistakes) const {
    const double size = differences_.size();
    const bool vanishes = size > 0 && size < 0x1p-170;
    const bool overflows = size > 0x1p+170;
    if (!vanishes && !overflows) return false;
    words += "; but of sets of the size " + shown(size) + " products of " +
             (size < 0x1p-255 || size > 0x1p+255 ? "four" : "six") + " lengths " + (vanishes ? "vanish" : "overflow") +
             " in doubles: that may be the reason, and no line wrong";
    mistakes.clear();
    return true;
  }

  /// Returns: whether it was followed to its simplex.
  bool follow() {
    if (!step().is_of_numbers()) {
      blame(iteration(), "what it tells are no numbers, such as nan or inf", {});
      return false;
    }
    if (at_ > 0 && before_.empty()) return false;  // nothing is known of the simplex before it
    if (step().direction == Vec(Vec::Zero()) && directions_.empty())
      blame(iteration(), "a search along (0, 0, 0) goes nowhere", {});
    if (!directions_.empty()) look_at_direction();
    if (step().direction == Vec(Vec::Zero())) return false;
    const std::optional<Vec> newest = newest_vertex();
    if (!newest) return false;
    const double reach = newest->dot(step().direction);
    if (at_ > 0 && reach < 0 && (is_sure(*newest, step().direction) || ends_with_no())) {
      if (ends_with_no()) return true;
      look_at_going_on(reach);
    }
    vertices_ = before_;
    vertices_.push_back(*newest);
    if (vertices_.size() > 4) {
      blame(iteration(), "the simplex before it has four vertices and was not reduced", {});
      return false;
    }
    directions_.clear();
    look_at_simplex(reach);
    before_ = step().simplex;
    return true;
  }

  /// Of what is not understood its end is the beginning of the next step.
  void go_on_from_its_own() {
    before_ = step().is_of_numbers() ? step().simplex : Vertices{};
    directions_.clear();
    suspect_.reset();
  }

  // -- The direction --------------------------------------------------------------------------------------------------

  /// Requires: that the simplex before it is right.
  void look_at_direction() {
    const Vec& d = step().direction;
    if (std::ranges::any_of(directions_, [&d](const Vec& each) { return parallel(each, d); })) return;
    std::vector<std::size_t> makers;
    for (std::size_t m = 0; m < mistakes().size(); ++m) {
      const Processed other = process_by(m);
      const bool same_kept = !other.contains_origin && are_same_set(indices_of(other.kept), told_indices_);
      if (same_kept && (parallel(other.direction, d) || (d == Vec(Vec::Zero()) && other.direction == d)))
        makers.push_back(m);
    }
    const bool keeps_direction = parallel(run_.steps[at_ - 1].direction, d);
    blame(iteration() - 1,
          "from " + letters_of(told_indices_, vertices_.size()) + ", rightly kept" + why_kept_ + ", the report " +
              (directions_.front() == Vec(Vec::Zero())
                   ? "has no direction, as the origin lies on it up to rounding"
                   : "searches along " + words_of(directions_.front()) + " (only the ratios count)") +
              ", yours " +
              (parallel(directions_.front(), -d) ? "the opposite way, "
               : keeps_direction                 ? "as before, "
                                                 : "") +
              "along " + words_of(d) + "; there " + letters_and_places(vertices_),
          makers);
    findings_.back().keeps_direction = keeps_direction;
  }

  Processed process_by(std::size_t mistake) const { return process_by(mistake, as_told(vertices_)); }
  Processed process_by(std::size_t mistake, const Indices& order) const {
    return mistakes()[mistake].process(simplex_of(vertices_, order));
  }

  // -- The new vertex -------------------------------------------------------------------------------------------------

  /// Returns: the farthest; of those equally far one that it had before, as there is no other in its simplex.
  Vec among(const Vertices& right, const Vec& d) const {
    const auto by_reach = [&d](const Vec& v) { return v.dot(d); };
    const Vec best = *std::ranges::max_element(right, {}, by_reach);
    for (const Vec& each : right)
      if (by_reach(each) == by_reach(best) && differences_.has(before_, each)) return each;
    return best;
  }

  /// Of such a length that no product with it is beyond all doubles.
  static Vec shortened(const Vec& d) {
    const double most = d.cwiseAbs().maxCoeff();
    return most > 0 ? Vec(d / most) : d;
  }

  std::optional<Vec> newest_vertex() {
    const Vec d = shortened(step().direction);
    const Vertices right = differences_.farthest(d, -d);
    Vertices added;
    for (const Vec& v : step().simplex)
      if (!differences_.has(before_, v)) added.push_back(v);
    if (added.size() > 1 && at_ == 0) {
      findings_.push_back({iteration(), StepFinding::otherwise,
                           "it begins with " + std::to_string(added.size()) +
                               " vertices, and how it came to them is not told: tell the first points, too"});
      return std::nullopt;
    }
    if (added.size() > 1) {
      blame(iteration(), "its simplex has " + std::to_string(added.size()) + " vertices that the one before it has not",
            {});
      return std::nullopt;
    }
    if (added.empty()) return among(right, d);
    if (differences_.has(right, added.front()) || differences_.reaches(added.front(), d)) return added.front();
    if (!differences_.contain(added.front())) {
      blame(iteration(),
            words_of(added.front()) + " is no difference a − b of a point of each set" +
                (differences_.contain(-added.front()) ? ", but one b − a: steps are told with a − b" : ""),
            {});
      return std::nullopt;
    }
    const double reach = added.front().dot(step().direction), most = right.front().dot(step().direction);
    blame(iteration(),
          words_of(added.front()) + " is no point of a − b farthest along " + words_of(step().direction) +
              ": it reaches " + shown(reach) + ", " + words_of(right.front()) + " reaches " + shown(most) +
              what_was_told_instead(d),
          may_be_m1() ? std::vector<std::size_t>{0} : std::vector<std::size_t>{},
          most - reach <= run_.roundings * rounded_away * differences_.size() * step().direction.stableNorm());
    return added.front();
  }

  /// Whether each vertex that is new in a step, of later ones too, is farthest along these multiples of its direction.
  bool each_newest_is_farthest(double of_a, double of_b) const {
    Vertices before;
    for (const ToldStep& each : run_.steps) {
      const Vec d = shortened(each.direction);
      if (!std::ranges::all_of(each.simplex, [&](const Vec& v) {
            return differences_.has(before, v) || differences_.is_farthest(v, of_a * d, of_b * d);
          }))
        return false;
      before = each.simplex;
    }
    return true;
  }

  /// Returns: which other direction it may be that was told; nothing where there is none.
  std::string what_was_told_instead(const Vec& d) const {
    if (each_newest_is_farthest(-1, 1)) return "; every vertex is farthest the opposite way";
    const Vertices farthest_along_it = differences_.farthest(d, -d);
    const auto is_next = [&](const Vec& v) {
      return !differences_.has(step().simplex, v) && differences_.has(farthest_along_it, v);
    };
    if (is_last() || std::ranges::none_of(run_.steps[at_ + 1].simplex, is_next)) return "";
    return "; that is the next vertex: told is the direction that was searched along, not the one that follows";
  }

  bool may_be_m1() const { return each_newest_is_farthest(1, 1); }

  /// Whether a formula may round: not of whole numbers, times a power of two, whose products of four, as in ((AB×AO)×AB)·P, are
  /// below 2^53.
  bool any_formula_rounds() const {
    double most = 0;
    for (const Vec& v : vertices_) most = std::max(most, v.cwiseAbs().maxCoeff());
    if (most == 0) return false;
    const auto is_whole = [times = 9 - std::ilogb(most)](double x) {
      return std::ldexp(x, times) == std::round(std::ldexp(x, times));
    };
    return !std::ranges::all_of(vertices_, [&](const Vec& v) { return std::ranges::all_of(v, is_whole); });
  }

  bool is_near_zero(const Vec& newest, const Vec& d) const {
    return std::abs(newest.dot(d)) <= run_.roundings * rounded_away * newest.cwiseAbs().dot(d.cwiseAbs());
  }

  /// Whether every program finds that sign of P·d: it is far from 0, or 0 and nothing is rounded.
  bool is_sure(const Vec& newest, const Vec& d) const {
    if (!is_near_zero(newest, d)) return true;
    gjk::Fraction sum = 0;
    for (Eigen::Index i = 0; i < 3; ++i) {
      const gjk::Fraction product(newest[i] * d[i]);
      if (gjk::Fraction(newest[i]) * gjk::Fraction(d[i]) != product) return false;
      sum += product;
    }
    return sum == 0;
  }

  bool ends_with_no() const { return is_last() && run_.said != gjk::Status::intersecting; }

  /// Eq. 9 says no: the search may end. One that looks for the distance goes on, and says no in the end.
  void look_at_going_on(double reach) {
    const std::string words =
        "P·d = " + shown(reach) + " < 0: the origin was not crossed, so the answer is no; yours goes on";
    if (run_.said == gjk::Status::separated)
      findings_.push_back({iteration(), StepFinding::otherwise, words});
    else
      blame(iteration(), words, {3});
  }

  // -- The simplex ----------------------------------------------------------------------------------------------------

  /// Returns: the vertices that it says are kept, by their places in `vertices_`.
  Indices told_indices() const {
    Indices indices;
    for (const Vec& v : step().simplex) {
      const auto found =
          std::ranges::find_if(vertices_, [&](const Vec& each) { return differences_.are_same(each, v); });
      indices.push_back(static_cast<int>(found - vertices_.begin()));  // newest_vertex() has looked that it is there
    }
    return indices;
  }

  void look_at_simplex(double reach) {
    const std::vector<Outcome> right = right_outcomes(vertices_);
    told_indices_ = told_indices();
    if (is_last()) return look_at_end(right, reach);
    if (right.front().contains_origin) {
      const std::string does = "keeps " + told_letters() + " and goes on";
      const bool finds_it_later =
          run_.said == gjk::Status::intersecting && vertices_.size() < 4 && told_indices_.size() == vertices_.size();
      if (!finds_it_later) return blame_simplex(right.front(), does);
      findings_.push_back(
          {iteration(), StepFinding::otherwise, does + ", though the origin lies in it (" + right.front().why + ")"});
      return;
    }
    const auto found = std::ranges::find_if(
        right, [&](const Outcome& each) { return !each.contains_origin && are_same_set(each.kept, told_indices_); });
    if (found == right.end())
      return blame_simplex(right.front(), "keeps " + told_letters() +
                                              (told_indices_.size() == vertices_.size()
                                                   ? ", all of them (told is the simplex after it was reduced)"
                                                   : ""));
    if (!are_same_set(found->kept, right.front().kept))
      findings_.push_back({iteration(), StepFinding::otherwise,
                           "keeps " + told_letters() + " (" + found->why + "), the report " +
                               letters_of(right.front().kept, vertices_.size()) + " (" + right.front().why + ")"});
    for (const Outcome& each : right)
      if (!each.contains_origin && are_same_set(each.kept, told_indices_)) directions_.push_back(each.direction);
    why_kept_ = found->why.empty() ? "" : " (" + found->why + ")";
    note_order(*found);
    note_mistakes_not_made(right);
  }

  void note_mistakes_not_made(const std::vector<Outcome>& right) {
    for (std::size_t m = 0; m < mistakes().size(); ++m) {
      const Processed other = process_by(m);
      const Indices kept = indices_of(other.kept);
      if (other.contains_origin ||
          std::ranges::none_of(right, [&](const Outcome& each) { return are_same_set(each.kept, kept); }))
        not_made_.insert(m);
    }
  }

  std::string told_letters() const { return letters_of(told_indices_, vertices_.size()); }

  void look_at_end(const std::vector<Outcome>& right, double reach) {
    const bool contains = std::ranges::any_of(right, &Outcome::contains_origin);
    if (run_.said == gjk::Status::intersecting && !contains) return look_at_yes(right);
    if (run_.said == gjk::Status::intersecting || !run_.said) return;
    if (run_.said == gjk::Status::separated && ended_by_untold_step(right)) return;
    if (run_.said == gjk::Status::separated && at_ > 0 && !is_sure(vertices_.back(), step().direction)) return;
    if (run_.said == gjk::Status::separated && at_ > 0 && reach == 0) {
      std::vector<std::size_t> makers{2};
      if (right.front().contains_origin)
        std::ranges::copy(makers_of_simplex("says no").mistakes, std::back_inserter(makers));
      return blame(iteration(),
                   "P·d = 0: the origin may lie on what was reached, and touching is no proof; yours says no",
                   makers_of_no(std::move(makers)));
    }
    if (right.front().contains_origin)
      return blame_simplex(right.front(), run_.said == gjk::Status::separated ? "says no" : "says that it cannot tell");
    if (run_.said == gjk::Status::separated)
      blame(iteration(),
            "the search was ended, and the answer is no, though P·d = " + shown(reach) +
                " ≥ 0 proves nothing; it should be undecided",
            makers_of_no({}));
  }

  /// The step that ends a search with "yes" may not have been told. Returns: what its simplex may be then, if that told last was rightly
  /// kept.
  std::vector<Vertices> untold_simplexes(const std::vector<Outcome>& right) const {
    std::vector<Vertices> all;
    for (const Outcome& each : right) {
      if (each.contains_origin || !are_same_set(each.kept, told_indices_) || each.kept.size() > 3) continue;
      Vertices next;
      for (const int i : told_indices_) next.push_back(vertices_[static_cast<std::size_t>(i)]);
      const Vec d = shortened(each.direction);
      const Vec newest = among(differences_.farthest(d, -d), d);
      if (newest.dot(d) < 0 || differences_.has(next, newest)) continue;
      next.push_back(newest);
      all.push_back(std::move(next));
    }
    return all;
  }

  /// It says yes, and what it told last does not. Blames what makes that of it, or of the simplex after it.
  void look_at_yes(const std::vector<Outcome>& right) {
    const std::vector<Vertices> next = untold_simplexes(right);
    for (const Vertices& each : next)
      if (std::ranges::any_of(right_outcomes(each), &Outcome::contains_origin)) return;
    std::vector<std::size_t> makers;
    for (std::size_t m = 0; m < mistakes().size(); ++m)
      if (std::ranges::any_of(next, [m](const Vertices& each) {
            Indices in_order(each.size());
            std::iota(in_order.begin(), in_order.end(), 0);
            return mistakes()[m].process(simplex_of(each, in_order)).contains_origin;
          }))
        makers.push_back(m);
    if (makers.empty()) return blame_simplex(right.front(), "says yes");
    for (const std::size_t m : makers_of_simplex("says yes").mistakes)
      if (std::ranges::count(makers, m) == 0) makers.push_back(m);
    blame(iteration(),
          "after this step it says yes, which nothing proves: no origin lies in " + told_letters() +
              ", nor in the simplex with the next point; there " + letters_and_places(vertices_),
          makers);
  }

  double reach_along(const Vec& d) const { return among(differences_.farthest(d, -d), d).dot(d); }

  /// Who tells a step at the end of each iteration never comes to the end of the one with P·d < 0: what was told last is then a
  /// simplex that the report keeps, and the step after it must prove the no.
  ///
  /// Returns: whether that is so; blames where the step proves nothing.
  bool ended_by_untold_step(const std::vector<Outcome>& right) {
    Vertices ways;
    for (const Outcome& each : right)
      if (!each.contains_origin && are_same_set(each.kept, told_indices_)) ways.push_back(shortened(each.direction));
    if (ways.empty()) return false;
    for (const Vec& d : ways) {
      const Vec newest = among(differences_.farthest(d, -d), d);
      // Its direction was not told: another formula than ours may have rounded it.
      if (newest.dot(d) < 0 || (any_formula_rounds() ? is_near_zero(newest, d) : !is_sure(newest, d))) return true;
    }
    const double reach = reach_along(ways.front());
    std::vector<std::size_t> makers;
    if (reach == 0) makers.push_back(2);
    for (std::size_t m = 0; m < mistakes().size(); ++m) {
      const Processed other = process_by(m);
      if (other.contains_origin || !are_same_set(indices_of(other.kept), told_indices_)) continue;
      const Vec d = shortened(other.direction);
      if (!parallel(d, ways.front()) && reach_along(d) < 0) makers.push_back(m);
    }
    if (reaches_back(ways.front())) makers.push_back(0);
    blame(iteration(),
          "after this step the search was ended with no, which nothing proves: the report goes on along " +
              words_of(ways.front()) + ", and finds a point with P·d = " + shown(reach) + " ≥ 0" +
              what_may_have_ended_it(),
          makers);
    return true;
  }

  /// Returns: that its steps had begun to repeat; nothing where they had not.
  std::string what_may_have_ended_it() const {
    for (std::size_t i = at_; i-- > 0;)
      if (parallel(run_.steps[i].direction, step().direction) && run_.steps[i].simplex == step().simplex)
        return "; it goes round: step " + std::to_string(iteration()) + " is step " + std::to_string(i + 1) +
               " again, so that a limit of iterations may have ended it";
    return "";
  }

  /// Whether the vertex of M1 along `d` has P·d < 0, and M1 would have found those that were told.
  bool reaches_back(const Vec& d) const {
    return may_be_m1() && std::ranges::any_of(differences_.farthest(d, d), [&](const Vec& v) { return v.dot(d) < 0; });
  }

  /// Returns: also M1 where its vertex has P·d < 0.
  std::vector<std::size_t> makers_of_no(std::vector<std::size_t> makers) const {
    if (reaches_back(shortened(step().direction))) makers.push_back(0);
    return makers;
  }

  /// An order from which the next faces get normals that point inward, unless the program looks at that itself: it is to blame if
  /// the next step goes wrong by that.
  void note_order(const Outcome& right) {
    suspect_.reset();
    if (told_indices_.size() != 3) return;
    const auto at = [&](std::size_t i) { return step().simplex[i]; };
    if ((at(1) - at(2)).cross(at(0) - at(2)).dot(right.direction) >= 0) return;
    std::vector<std::size_t> makers;
    for (std::size_t m = 0; m < mistakes().size(); ++m) {
      const Processed other = process_by(m);
      if (!other.contains_origin && indices_of(other.kept) == told_indices_) makers.push_back(m);
    }
    suspect_ =
        Suspect{iteration(),
                "keeps " + told_letters() + " where the report keeps " + letters_of(right.kept, vertices_.size()) +
                    ": in this order the normals of the next faces point inward (" + letters_and_places(vertices_) +
                    "), which shows in iteration " + std::to_string(iteration() + 1),
                makers};
  }

  /// Whether what it does follows from the order of the vertices alone; or would, but for tests that the report spares, as that
  /// for the origin beyond A.
  bool follows_from_order(const std::string& does) const {
    if (!suspect_ || vertices_.size() != 4) return false;
    const Outcome by_order = outcome_of(vertices_, {0, 1, 2, 3});
    if (does == "says yes") return by_order.contains_origin;
    const auto is_kept = [&](int i) { return std::ranges::find(by_order.kept, i) != by_order.kept.end(); };
    return !by_order.contains_origin && (is_last() || std::ranges::all_of(told_indices_, is_kept));
  }

  /// Returns: those that do with the vertices in this order what the program does, and the report does not.
  std::vector<std::size_t> makers_in(const Indices& order, const std::string& does) const {
    const Outcome right = outcome_of(vertices_, order);
    const bool says_yes = does == "says yes";
    std::vector<std::size_t> makers;
    for (std::size_t m = 0; m < mistakes().size(); ++m) {
      const Processed other = process_by(m, order);
      if (other.contains_origin == says_yes && differs_from(right, other) &&
          (says_yes || is_last() || are_same_set(indices_of(other.kept), told_indices_)))
        makers.push_back(m);
    }
    return makers;
  }

  struct Makers {
    Indices order;  ///< of the vertices, in which they do that
    std::vector<std::size_t> mistakes;
  };
  /// Returns: those in the order of the vertices as they were told; where there are none, in the first other that has some.
  Makers makers_of_simplex(const std::string& does) const {
    for (const Indices& order : outward_orders(vertices_))
      if (std::vector<std::size_t> makers = makers_in(order, does); !makers.empty()) return {order, std::move(makers)};
    return {as_told(vertices_), {}};
  }

  bool does_the_same(const Outcome& outcome, const std::string& does) const {
    if (does == "says yes") return outcome.contains_origin;
    return !outcome.contains_origin && (is_last() || are_same_set(outcome.kept, told_indices_));
  }

  /// Whether the report does the same with vertices moved by a few roundings. What vanishes term by term, as in a plane z = 0,
  /// vanishes then, too: no formula rounds it.
  bool may_be_rounding(const std::string& does) const {
    if (!any_formula_rounds()) return false;
    constexpr int tries = 64;
    const double moved =
        0x1p-49 * run_.roundings;  // 16 units of rounding: an expanded product of three differences has some ten
    std::mt19937 dice(1);
    for (int i = 0; i < tries; ++i) {
      Vertices near = vertices_;
      for (Vec& v : near)
        for (double& x : v) x *= 1 + (dice() & 1 ? moved : -moved);
      for (const Indices& order : outward_orders(near))
        if (does_the_same(outcome_of(near, order), does)) return true;
    }
    return false;
  }

  void blame_simplex(const Outcome& right, const std::string& does) {
    if (follows_from_order(does)) {
      blame(suspect_->iteration, suspect_->words, suspect_->makers);
      return suspect_.reset();  // what comes next does not follow from it any more
    }
    const Indices all = as_told(vertices_);
    const bool may_round = may_be_rounding(does);
    auto [order, makers] = may_round ? Makers{all, {}} : makers_of_simplex(does);
    if (!may_round && does == "says no" && at_ > 0) makers = makers_of_no(makers);
    blame(iteration(),
          "from " + letters_of(all, vertices_.size()) + " the report finds " +
              (right.why.empty() ? "" : right.why + ": ") +
              (right.contains_origin ? "the origin lies in it, the answer is yes"
               : does == "says yes" && right.kept.size() == all.size()
                   ? "no origin in it and goes on"
                   : "keep " + letters_of(right.kept, vertices_.size())) +
              "; yours " + does + "; there " + letters_and_places(vertices_) +
              (order == all ? "" : "; a mistake explains it in the order " + letters_of(order, vertices_.size())) +
              (may_round ? "; of vertices moved by a few roundings the report does the same: that may be "
                           "the reason, and no line wrong"
                         : ""),
          makers, may_round);
  }

  bool differs_from(const Outcome& right, const Processed& other) const {
    return right.contains_origin != other.contains_origin ||
           (!right.contains_origin && !are_same_set(right.kept, indices_of(other.kept)));
  }

  struct Suspect {
    int iteration;
    std::string words;
    std::vector<std::size_t> makers;
  };

  const ToldRun& run_;
  Differences differences_;
  std::size_t at_ = 0;
  Vertices before_, vertices_;  ///< the simplex before this step, and with its new vertex
  Indices told_indices_;
  Vertices directions_;   ///< in which the next search may go; none where nothing is known of that
  std::string why_kept_;  ///< what it goes on from
  std::optional<Suspect> suspect_;
  StepFindings findings_;
  std::set<std::size_t> not_made_;
};

}  // namespace

const StepFinding* first_wrong(const StepFindings& findings) {
  for (const StepFinding::Kind kind : {StepFinding::wrong, StepFinding::rounding})
    if (const auto found = std::ranges::find(findings, kind, &StepFinding::kind); found != findings.end())
      return &*found;
  return nullptr;
}

CheckedSteps check_steps(const ToldRun& run) { return Following(run).check(); }

}  // namespace walkthroughs::steps
