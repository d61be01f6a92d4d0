#include <algorithm>
#include <cmath>
#include <ostream>

#include "tests/study/claims/claims_text.hpp"

namespace study {
namespace {

constexpr double unnoticed = 0.05;  ///< the risk of not seeing a mistake that is left where 95 % are asked for

/// Returns: of how many pairs at least one fails in 95 of 100 test runs.
double pairs_to_see(double p) { return p >= 1 ? 1 : std::ceil(std::log(unnoticed) / std::log1p(-p)); }

/// Two digits say all that is known.
std::string about(double pairs) {
  const double unit = std::pow(10, std::max(0.0, std::floor(std::log10(pairs)) - 1));
  return grouped(static_cast<std::uint64_t>(std::round(pairs / unit) * unit));
}

std::string needed(const Rate& fails) {
  if (fails.count == 0) return "more than " + about(pairs_to_see(fails.interval().high));
  return about(pairs_to_see(fails.share()));
}

std::string needed_between(const Rate& fails) {
  if (fails.count == 0) return needed(fails);
  const Interval p = fails.interval();
  return needed(fails) + " (" + about(pairs_to_see(p.high)) + "–" + about(pairs_to_see(p.low)) + ")";
}

/// Where no failure was seen, what is sure at least.
std::string passes_text(const Rate& fails, double pairs) {
  const double p = passes(fails.count == 0 ? fails.interval().high : fails.share(), pairs);
  const std::string at_least = fails.count == 0 ? "≥ " : "";
  if (p > 0.999) return "> 99.9 %";
  if (fails.count > 0 && p < 0.001) return "< 0.1 %";
  return at_least + decimals(100 * p, 1) + " %";
}

std::string healed(const Rate& heals) { return heals.trials == 0 ? "–" : share_text(heals.share()); }

std::string signed_decimals(double x) { return (x < 0 ? "−" : "+") + decimals(std::fabs(x), 2); }

/// What stands for a mistake after it has been named.
std::string number(std::size_t i) { return "M" + std::to_string(i + 1); }

/// Those mistakes for which `is_so` holds, by number.
template <class IsSo>
std::vector<std::string> those(IsSo is_so) {
  std::vector<std::string> numbers;
  for (std::size_t i = 0; i < mistakes().size(); ++i)
    if (is_so(i)) numbers.push_back(number(i));
  return numbers;
}

/// What *can* be is shown by a single mistake; none of these few leaves it open.
void write_claim_of_some(std::ostream& out, const Cells& words, const std::vector<std::string>& mistakes_of_which,
                         std::size_t among) {
  Cells cells = words;
  cells.push_back(grouped(mistakes_of_which.size()) + " of " + grouped(among));
  cells.push_back(mistakes_of_which.empty() ? "–" : joined(mistakes_of_which));
  cells.push_back(mistakes_of_which.empty() ? "left open" : "**holds** for these");
  row(out, cells);
}

void write_claims_about_mistakes(std::ostream& out, const Counted& counted) {
  const auto& counts = counted.triangles.counts;
  const auto seldom_seen_in = [&](double pairs) {  // seen to fail, but seldom, whatever the rate is within its interval
    return those([&counts, pairs](std::size_t i) {
      const Rate& fails = counts[i].fails;
      return fails.count > 0 && passes(fails.interval().high, pairs) > 0.5;
    });
  };
  const auto acting = those([&](std::size_t i) { return counts[i].changed.count > 0; }).size();
  heading(out, {"The report says", "Section", "True of a mistake where …", "Mistakes", "Which", "Verdict"}, 6);
  const std::string can_pass = "“an implementation can have a bug, but still pass many test cases”";
  write_claim_of_some(out, {can_pass, "1", "it fails, and yet more likely than not passes 100 random triangle pairs"},
                      seldom_seen_in(100), mistakes().size());
  write_claim_of_some(out, {can_pass, "1", "… passes 10,000 random triangle pairs"}, seldom_seen_in(10'000),
                      mistakes().size());
  write_claim_of_some(out,
                      {"“the implementation can self-correct in later iterations”", "1",
                       "most runs that it changes end rightly, of pairs that meet and of pairs that do not"},
                      those([&](std::size_t i) { return counts[i].mostly_heals(); }), acting);
  out << '\n';
  paragraph(out, "The last line is about the " + grouped(acting) + " mistakes that change any run.");
}

void write_what_happens(std::ostream& out, const Counted& counted, std::uint64_t pairs) {
  paragraph(out,
            "Each line is the report's algorithm in double with one mistake in it that the report warns of (or, in one "
            "case, prints), asked about the same " +
                grouped(pairs) +
                " random triangle pairs. *Undecided*: 20 iterations were not enough, or the search direction was zero; "
                "Algorithm 1 then says no. *Changed*: the search asked for other directions than without the mistake. "
                "*Healed*: of the changed runs, those that end in the right answer all the same. *More iterations*: of "
                "the healed runs, on average.");
  heading(out,
          {"", "Mistake", "Section", "Wrong yes", "Wrong no", "Undecided", "Changed", "Healed: pairs that meet",
           "Healed: pairs that do not", "More iterations"},
          3);
  for (std::size_t i = 0; i < mistakes().size(); ++i) {
    const MistakeCounts& m = counted.triangles.counts[i];
    const bool heals = m.heals_meeting.count + m.heals_apart.count > 0;
    row(out, {number(i), mistakes()[i].name, mistakes()[i].section, grouped(m.wrong_yes), grouped(m.wrong_no),
              grouped(m.undecided), share_text(m.changed.share()), healed(m.heals_meeting), healed(m.heals_apart),
              heals ? signed_decimals(m.mean_extra()) : "–"});
  }
  out << '\n';
}

void write_how_many_tests(std::ostream& out, const Counted& counted) {
  paragraph(out,
            "*Fails*: Algorithm 1 answers wrongly, and rightly without the mistake. *Passes*: the probability that a "
            "test of so many random triangle pairs shows nothing. *Needed*: how many random pairs show the mistake in "
            "95 of 100 such tests, with the 95 % interval, and how many pairs of other kinds do.");
  heading(out,
          {"", "Fails", "Passes 100", "Passes 10,000", "Passes 1,000,000", "Needed: random triangles",
           "Random tetrahedra", "Triangles on a grid of 6 × 6 × 6"},
          1);
  for (std::size_t i = 0; i < mistakes().size(); ++i) {
    const Rate& fails = counted.triangles.counts[i].fails;
    row(out, {number(i), rate_text(fails), passes_text(fails, 1e2), passes_text(fails, 1e4), passes_text(fails, 1e6),
              needed_between(fails), needed(counted.tetrahedra.counts[i].fails), needed(counted.grid.counts[i].fails)});
  }
  out << '\n';
}

/// After the words for what they have in common.
template <class IsSo>
void list(std::ostream& out, const std::string& what, IsSo is_so) {
  const std::vector<std::string> numbers = those(is_so);
  out << "* " << what << ' ' << (numbers.empty() ? "none" : joined(numbers)) << ".\n";
}

void write_what_it_means(std::ostream& out, const Counted& counted) {
  const auto unseen = [](const MistakeTable& table, std::size_t i) { return table.counts[i].fails.count == 0; };
  const auto by_random_pairs = [&](std::size_t i) {
    return unseen(counted.triangles, i) && unseen(counted.tetrahedra, i);
  };
  list(out, "Never seen by any of the random triangles and tetrahedra, but by the grid, where sets touch:",
       [&](std::size_t i) { return by_random_pairs(i) && !unseen(counted.grid, i); });
  list(out, "Never seen to fail at all, at most to take longer:", [&](std::size_t i) {
    return by_random_pairs(i) && unseen(counted.grid, i);
  });
  list(out, "Seen by the iteration limit more often than by a wrong answer:", [&](std::size_t i) {
    const MistakeCounts& m = counted.triangles.counts[i];
    return m.undecided > m.fails.count && m.fails.count > 0;
  });
  out << '\n';
  paragraph(out,
            "Why mistakes heal: however a search direction was found, `P·d < 0` proves separation (Eq. 9 needs nothing "
            "else, which is also why it may be asked of the very first point). A wrong direction or order therefore "
            "costs iterations, and makes a wrong *no* only through the iteration limit, where Algorithm 1 says no "
            "without proof; a wrong *yes* takes a normal or an order that puts the origin into a simplex that it is "
            "not in, or a vertex that comes back: the normals of a flat simplex are zero, and zero reads as “contains "
            "the origin”. So: tell *undecided* apart from *no*, look at the number of iterations, and test with sets "
            "that touch.");
}

}  // namespace

double passes(double p, double pairs) { return p >= 1 ? 0 : std::exp(pairs * std::log1p(-p)); }

void write_mistakes(std::ostream& out, const Counted& counted) {
  out << "## How many tests does a mistake survive?\n\n";
  paragraph(out,
            "“The iterative nature of GJK can mask many bugs … an implementation can have a bug, but still pass many "
            "test cases” (Section 1). Mistakes are numbered as in the second table below.");
  write_claims_about_mistakes(out, counted);
  write_what_happens(out, counted, counted.options.pairs);
  write_how_many_tests(out, counted);
  write_what_it_means(out, counted);
}

}  // namespace study
