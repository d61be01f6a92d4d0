#include <algorithm>
#include <ostream>

#include "tests/study/claims/claims_text.hpp"

namespace study {
namespace {

constexpr std::array all_ways{Way::double_computed, Way::float_computed, Way::double_snapped, Way::float_snapped};

std::string name_of(Way way) {
  switch (way) {
    case Way::double_computed: return "double";
    case Way::float_computed: return "float";
    case Way::double_snapped: return "double, snapped";
    default: return "float, snapped";
  }
}

const MollerCounts& of_kind(const Counted& counted, const std::string& name) {
  const auto found = std::ranges::find(triangle_kinds(), name, &TriangleKind::name);
  return counted.moller.at(static_cast<std::size_t>(found - triangle_kinds().begin()));
}

const std::string random_ones = "random triangles", hundred = "whole numbers 0 … 100", ten = "whole numbers 0 … 10";

std::string with_right(const Rate& right) {
  return right.trials == 0 ? "0" : grouped(right.trials) + " (right: " + grouped(right.count) + ")";
}

// -- The same pairs, in every way -------------------------------------------------------------------------------------

void write_ways(std::ostream& out, const MollerCounts& counts, RulesAsked rules, const std::string& words) {
  for (const Way way : all_ways) {
    const Comparison& c = counts.of(way, rules);
    const std::uint64_t beyond = c.only_moller[static_cast<std::size_t>(Contact::beyond_plane)].trials;
    row(out, {words, name_of(way), grouped(c.both_yes), grouped(c.both_no), with_right(c.all_only_gjk()),
              with_right(c.all_only_moller()), grouped(beyond), grouped(c.undecided)});
  }
}

void write_comparisons(std::ostream& out, const Counted& counted) {
  const MollerCounts& random = of_kind(counted, random_ones);
  out << "## GJK against Möller's triangle test of 1997\n\n";
  paragraph(
      out,
      "GJK and Möller's test compute in the same scalar, and all ways are asked about the same pairs: coordinates "
      "are rounded to float before anything is asked, so that float and double are given the same numbers. "
      "*Snapped*: distances below 1e-6 count as zero, as in the implementation that Möller published. *Right* is "
      "what exact arithmetic says. *Undecided*: GJK, which then says “no”, as Algorithm 1 does. *Beyond the "
      "plane*: of those that only Möller's test says meet, the pairs of which all of one triangle lies on one "
      "side of the other's plane.");
  paragraph(out, grouped(random.pairs) + " pairs of random triangles, of which " + grouped(random.meet) + " meet:");
  heading(out,
          {"GJK's rules", "Both compute in", "Both: they meet", "Both: they do not", "Only GJK: they meet",
           "Only Möller: they meet", "… beyond the plane", "Undecided"},
          2);
  write_ways(out, random, RulesAsked::as_intended, "as intended");
  write_ways(out, random, RulesAsked::as_printed, "as printed");
  out << '\n';
}

// -- Claims, way by way -----------------------------------------------------------------------------------------------

/// A claim about one way, where it is counted in these kinds of triangles.
template <class HowOften>
void write_claim_by_way(std::ostream& out, const Counted& counted, const Cells& words, Strength strength,
                        const std::vector<std::string>& kinds, HowOften how_often) {
  Cells first = words;
  for (const Way way : all_ways) {
    Claim claim{"", "", "", strength, {}};
    Cells cells = first;
    cells.push_back(name_of(way));
    for (const std::string& kind : {random_ones, hundred, ten}) {
      if (std::ranges::find(kinds, kind) != kinds.end())
        claim.measured.push_back({kind, how_often(of_kind(counted, kind), way)});
      else
        claim.measured.push_back({kind, {}});
    }
    claim.measured.push_back({"pairs made to share a vertex", {}});
    if (std::ranges::find(kinds, common_vertex_kind().name) != kinds.end())
      claim.measured.back().holds = how_often(counted.common_vertex, way);
    for (const Measured& m : claim.measured) cells.push_back(rate_text(m.holds));
    cells.push_back(verdict(claim));
    row(out, cells);
    first = Cells(words.size());  // the words stand in the first row alone
  }
}

void write_claims_by_way(std::ostream& out, const Counted& counted) {
  out << "### What the report says about it, way by way\n\n";
  paragraph(out,
            "The share of cases in which the claim is true, GJK with the rules as intended. Each way has a verdict of "
            "its own: four ways of asking about one pair are not four cases. *All but 2* of a million has an interval "
            "itself, " +
                rate_text({2, 1'000'000}) +
                ": it holds where the interval lies above 99.999 %. Of disagreements there are few, and "
                "an *always* that so few cases kept is left open.");
  heading(out,
          {"The report says", "Section", "Counted as true", "Both compute in", "Random triangles",
           "Whole numbers 0 … 100", "Whole numbers 0 … 10", "Made to share a vertex, 0 … 100", "Verdict"},
          9);
  write_claim_by_way(out, counted,
                     {"“agreed with TriTri for all but 2 pairs of triangles” of a million", "4", "both say the same"},
                     Strength::all_but_few, {random_ones, hundred, ten},
                     [](const MollerCounts& c, Way way) { return c.of(way).agreement(); });
  write_claim_by_way(out, counted,
                     {"“In both cases, our GJK implementation reported that the triangles intersected whereas TriTri "
                      "reported they did not”",
                      "4", "disagreements in which only GJK says that they meet"},
                     Strength::always, {random_ones, hundred, ten}, [](const MollerCounts& c, Way way) {
                       return Rate{c.of(way).all_only_gjk().trials, c.of(way).gjk_right().trials};
                     });
  write_claim_by_way(out, counted,
                     {"where GJK and TriTri disagree, “our implementation was determined to operate correctly”", "5",
                      "disagreements in which GJK is right"},
                     Strength::always, {random_ones, hundred, ten, common_vertex_kind().name},
                     [](const MollerCounts& c, Way way) { return c.of(way).gjk_right(); });
  write_claim_by_way(
      out, counted,
      {"“TriTri reports that a pair of triangles intersect if they share a common vertex”", "4",
       "pairs that share a vertex, of which Möller's test says that they meet"},
      Strength::always, {random_ones, hundred, ten, common_vertex_kind().name},
      [](const MollerCounts& c, Way way) { return c.common_vertex_seen[static_cast<std::size_t>(way)]; });
  out << '\n';
}

// -- The report's two -------------------------------------------------------------------------------------------------

void write_touches_of(std::ostream& out, const std::string& name, const MollerCounts& counts) {
  for (const Way way : {Way::double_computed, Way::float_snapped}) {
    const Comparison& c = counts.of(way);
    row(out, {name, grouped(counts.edges_touch), grouped(counts.common_vertex_seen[0].trials), name_of(way),
              with_right(c.all_only_gjk()), grouped(c.only_gjk_of(Contact::edges).trials),
              grouped(c.only_gjk_of(Contact::common_vertex).trials), with_right(c.all_only_moller())});
  }
}

void write_touches(std::ostream& out, const Counted& counted) {
  out << "### The report's two pairs\n\n";
  paragraph(out,
            "“in both cases the triangles intersected at exactly 1 point along an edge. The intersection point was not "
            "any of the vertices, nor were the triangles coplanar” (Section 4). GJK said that they intersect, TriTri "
            "that they do not, and the author suspected a bug in TriTri. The same experiment with coordinates of more "
            "and more digits; *touch so*: inside an edge of each, exactly.");
  heading(out,
          {"Coordinates", "Pairs that touch so", "Pairs that share a vertex", "Both compute in", "Only GJK: they meet",
           "… and touch so", "… and share a vertex", "Only Möller: they meet"},
          1);
  for (std::size_t i = 0; i < counted.moller.size(); ++i)
    write_touches_of(out, triangle_kinds()[i].name, counted.moller[i]);
  write_touches_of(out, common_vertex_kind().name, counted.common_vertex);
  out << '\n';
}

/// What a count of the report's kind says about its two of a million.
struct Explanations {
  std::vector<std::string> fit, too_many, too_few, unseen;
};

Explanations explanations(const Counted& counted) {
  const Interval report = Rate{2, 1'000'000}.interval();
  Explanations e;
  for (std::size_t i = 0; i < counted.moller.size(); ++i) {
    const MollerCounts& counts = counted.moller[i];
    const Rate rate{counts.of(Way::float_snapped).only_gjk_of(Contact::edges).trials, counts.pairs};
    const std::string text = triangle_kinds()[i].name + " (" + rate_text(rate) + ")";
    const Interval interval = rate.interval();
    auto& list = interval.low > report.high   ? e.too_many
                 : interval.high < report.low ? e.too_few
                 : rate.count == 0            ? e.unseen
                                              : e.fit;
    list.push_back(rate.count == 0 ? triangle_kinds()[i].name : text);
  }
  return e;
}

std::string or_none(const std::vector<std::string>& list) { return list.empty() ? "none" : joined(list); }

/// "double: 4, of which 4 touch so; float: …"
std::string counts_by_way(const MollerCounts& counts) {
  std::string text;
  for (const Way way : all_ways) {
    const Comparison& c = counts.of(way);
    text += (text.empty() ? "" : "; ") + name_of(way) + ": " + grouped(c.all_only_gjk().trials) + ", of which " +
            grouped(c.only_gjk_of(Contact::edges).trials) + " touch so, " +
            grouped(c.only_gjk_of(Contact::common_vertex).trials) + " share a vertex, and GJK is right in " +
            grouped(c.all_only_gjk().count);
  }
  return text;
}

void write_explanation(std::ostream& out, const Counted& counted) {
  paragraph(out, "**With the snap and without it.** Pairs of " + ten + " of which only GJK says that they meet, in " +
                     counts_by_way(of_kind(counted, ten)) + ".");
  paragraph(
      out,
      "**Why.** Möller's test divides, `p + (q − p)·d/(d − e)`, and compares quotients that ought to be equal and "
      "are rounded; the snap is done to the distances `d` and `e`, before that. GJK does not divide: in double, "
      "its products of such numbers are exact, and zero is seen as zero; in float some are rounded. "
      "`moller_1997_test.cpp` follows two pairs through Möller's test, one that touches inside edges, in double, "
      "and one with a common vertex, in float.");
  const Explanations e = explanations(counted);
  const MollerCounts& random = of_kind(counted, random_ones);
  const Comparison& printed = random.of(Way::float_snapped, RulesAsked::as_printed);
  paragraph(out,
            "**Which coordinates did the report take?** It does not say. Of the report's kind are pairs that touch so, "
            "and of which only GJK says that they meet (float, snapped). Too many of them to be the report's 2 of a "
            "million: " +
                or_none(e.too_many) + "; too few: " + or_none(e.too_few) +
                ". As many, within the intervals: " + or_none(e.fit) + ". None seen, which " + grouped(random.pairs) +
                " pairs cannot tell from 2 of a million: " + or_none(e.unseen) +
                ". If the report's coordinates are of a sort that gives as many, then TriTri has no unknown bug but a "
                "rounding "
                "error. Coordinates of more digits than a float has were not asked about.");
  paragraph(out,
            "**Also counted.** The program that agreed with TriTri was not Algorithm 1 as printed, which goes on after "
            "Eq. 9 has said no: with Möller's test in float, snapped, it disagrees in " +
                rate_text(printed.agreement().opposite()) + " of the pairs of random triangles.");
}

}  // namespace

void write_moller(std::ostream& out, const Counted& counted) {
  write_comparisons(out, counted);
  write_claims_by_way(out, counted);
  write_touches(out, counted);
  write_explanation(out, counted);
}

}  // namespace study
