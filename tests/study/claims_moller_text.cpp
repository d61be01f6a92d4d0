#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

#include "tests/study/claims_text.hpp"

namespace study {
namespace {

const char* const moller_names[] = {"double", "float", "double, snapped", "float, snapped"};

// -- Möller -----------------------------------------------------------------------------------------------------------

std::string who(const Rate& right) {
  return right.trials == 0 ? "0" : grouped(right.trials) + " (right: " + grouped(right.count) + ")";
}

void write_comparisons(std::ostream& out, const Counted& counted) {
  out << "## GJK against Möller's triangle test of 1997\n\n"
      << grouped(counted.moller.compared[0][0].pairs()) << " random triangle pairs, of which "
      << grouped(counted.moller.meet)
      << R"( meet. “Snapped”: distances below 1e-6 count as zero, as in the implementation
that Möller published. Where GJK is undecided ()"
      << grouped(counted.moller.undecided)
      << R"( pairs, as intended in double), it counts as “no”, as in Algorithm 1. Right
is what exact arithmetic says of the pair; where both tests compute in float, of the pair rounded to float, which changes
the truth of )"
      << grouped(counted.moller.rounding_changes_truth) << " pairs.\n\n";
  heading(out,
          {"GJK", "Möller", "Both: they meet", "Both: they do not", "Only GJK: they meet", "Only Möller: they meet"},
          2);
  const char* const gjk_names[] = {"double, as intended", "float, as intended", "double, as printed",
                                   "float, as printed"};
  for (std::size_t g = 0; g < ways; ++g)
    for (std::size_t m = 0; m < ways; ++m) {
      if (g % 2 == 1 && m % 2 == 0) continue;            // nobody asks GJK in float to compare it with double
      if (g >= 2 && m % 2 == 0 && m != g - 2) continue;  // as printed, the ways of Möller hardly differ: two will do
      const Comparison& c = counted.moller.compared[g][m];
      row(out, {gjk_names[g], moller_names[m], grouped(c.both_yes), grouped(c.both_no), who(c.only_gjk),
                who(c.only_moller)});
    }
  out << '\n';
}

/// In words: there are few, and all are of one kind or two.
void write_disagreements(std::ostream& out, const Counted& counted) {
  const auto& list = counted.moller.disagreements;
  const auto beyond = std::ranges::count_if(list, [](const Disagreement& d) { return std::isnan(d.depth); });
  double widest = 0;
  for (const Disagreement& d : list)
    if (!std::isnan(d.depth)) widest = std::max(widest, std::fabs(d.depth));
  out << "GJK in double, as intended, and the four ways of Möller's test disagree " << list.size() << " times. In "
      << beyond
      << " of them all of one triangle lies on one side of the other's plane, and snap or rounding puts it on the "
         "plane";
  if (widest > 0) {
    char gap[32];
    std::snprintf(gap, sizeof gap, "%.0e", widest);
    out << "; in the others the intervals overlap, or are apart, by at most " << gap << " of the shorter one";
  }
  out << ".\n\n";
}

void write_touches(std::ostream& out, const Counted& counted) {
  out << R"(## The report's two pairs

“in both cases the triangles intersected at exactly 1 point along an edge. The intersection point was not any of the
vertices, nor were the triangles coplanar” (Section 4). GJK said that they intersect, TriTri that they do not, and the
author suspected a bug in TriTri. The same experiment with coordinates of few digits; “only GJK” says that they meet, as
intended and in the scalar of Möller's test:

)";
  heading(out,
          {"Coordinates", "Touch so, exactly", "Only GJK (double)", "… and touch so", "Only Möller (double)",
           "Only GJK (float, snapped)", "… and touch so", "Only Möller (float, snapped)"},
          1);
  for (std::size_t i = 0; i < counted.touches.size(); ++i) {
    const TouchCounts& t = counted.touches[i];
    Cells cells{name_of(coarsenesses()[i]), grouped(t.edges_touch.count)};
    for (const MollerWay way : {MollerWay::double_computed, MollerWay::float_snapped}) {
      const auto m = static_cast<std::size_t>(way);
      cells.insert(cells.end(),
                   {who(t.compared[m].only_gjk), grouped(t.edges_touch_only_gjk[m]), who(t.compared[m].only_moller)});
    }
    row(out, cells);
  }
  out << '\n';
}

/// "0 … 100: 4.1 (2.0–8.4) per million; …": what a million pairs of whole numbers give of the report's kind.
std::string of_the_reports_kind(const Counted& counted) {
  std::vector<std::string> rates;
  for (std::size_t i = 0; i < counted.touches.size(); ++i) {
    if (coarsenesses()[i].divisor != 1) continue;
    const Comparison& c = counted.touches[i].compared[static_cast<std::size_t>(MollerWay::float_snapped)];
    rates.push_back("0 … " + grouped(static_cast<std::uint64_t>(coarsenesses()[i].levels - 1)) + ": " +
                    rate_text({c.only_gjk.trials, c.pairs()}));
  }
  return joined(rates);
}

void write_explanation(std::ostream& out, const Counted& counted) {
  const Comparison fine = all_of(counted.moller.compared[0]);
  const TouchCounts& coarse = touches_of(counted, hundred);
  const auto most_used = static_cast<std::size_t>(MollerWay::float_snapped);
  const Comparison& snapped = coarse.compared[most_used];
  const Comparison& printed = counted.moller.of(GjkWay::double_printed, MollerWay::float_snapped);
  out << "**Known.** Coordinates of 53 random bits: of " << grouped(fine.disagreements())
      << " disagreements (all four ways of Möller's test together), only GJK says “they meet” in "
      << grouped(fine.only_gjk.trials) << ". Coordinates that are " << name_of(hundred) << ": in "
      << grouped(snapped.only_gjk.trials) << " of " << grouped(snapped.disagreements())
      << " (float, snapped), of which " << grouped(coarse.edges_touch_only_gjk[most_used]) << R"( touch just as
the report says. GJK is right there, for products of such numbers are exact, and zero is seen as zero. Möller's test
divides, `p + (q − p)·d/(d − e)`, and compares two rounded quotients that ought to be equal. The snap does not help: it is
done to distances, before the division.
Decimal fractions such as k/100 are rounded before anything is asked: then neither test is always right.

**Conjecture.** The report does not say how its triangles were made. Pairs of which only GJK says that they meet (float,
snapped), for whole numbers )"
      << of_the_reports_kind(counted) << R"(. Two in a million fit
coordinates of about a hundred values, and do not fit random numbers of many digits. If the report's coordinates were such
numbers, then TriTri has no unknown bug but a rounding error. Not excluded:
coordinates in float, whose triangles only nearly touch (last line of the table).

**Also known.** The program that agreed with TriTri was not Algorithm 1 as printed, which goes on after Eq. 9 has said no: it
disagrees in )"
      << rate_text({printed.disagreements(), printed.pairs()}) << " of the pairs.\n\n";
}

}  // namespace

Comparison all_of(const std::array<Comparison, ways>& compared) {
  Comparison sum;
  for (const Comparison& c : compared) sum += c;
  return sum;
}

std::string name_of(const Coarseness& c) {
  if (c.divisor == 1) return "whole numbers 0 … " + grouped(static_cast<std::uint64_t>(c.levels - 1));
  return "k/" + grouped(static_cast<std::uint64_t>(c.divisor)) + ", k = 0 … " +
         grouped(static_cast<std::uint64_t>(c.levels - 1));
}

const TouchCounts& touches_of(const Counted& counted, const Coarseness& coarseness) {
  const auto found = std::ranges::find(coarsenesses(), coarseness);
  return counted.touches[static_cast<std::size_t>(found - coarsenesses().begin())];
}

void write_moller(std::ostream& out, const Counted& counted) {
  write_comparisons(out, counted);
  write_disagreements(out, counted);
  write_touches(out, counted);
  write_explanation(out, counted);
}

}  // namespace study
