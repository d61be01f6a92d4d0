#include "tests/study/claims.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

#include "tests/study/claims_verdict.hpp"

namespace study {
namespace {

// -- What was counted -------------------------------------------------------------------------------------------------

struct Counted {
  std::vector<ShapeEffort> efforts;  ///< by claim_shapes()
  MollerCounts moller;
  std::vector<TouchCounts> touches;  ///< by coarsenesses()
  MistakeTable triangles, tetrahedra, grid;
};

Counted count_all(const ClaimsOptions& options) {
  const auto tell = [&](const std::string& what) {
    if (options.progress) options.progress(what);
  };
  Counted counted;
  for (const Shape& shape : claim_shapes()) {
    tell("effort: " + shape.name);
    counted.efforts.push_back(measure_effort(shape, options));
  }
  tell("Möller's test");
  counted.moller = measure_moller(options);
  for (const Coarseness& coarseness : coarsenesses()) {
    tell("coarse coordinates: " + std::to_string(coarseness.levels) + " values");
    counted.touches.push_back(measure_touches(coarseness, options));
  }
  tell("mistakes: triangles");
  counted.triangles = measure_mistakes(TestPairs::triangles, options);
  tell("mistakes: tetrahedra");
  counted.tetrahedra = measure_mistakes(TestPairs::tetrahedra, options);
  tell("mistakes: triangles on a grid");
  counted.grid = measure_mistakes(TestPairs::grid_triangles, options);
  return counted;
}

// -- Tables -----------------------------------------------------------------------------------------------------------

using Cells = std::vector<std::string>;

void row(std::ostream& out, const Cells& cells) {
  for (const std::string& cell : cells) out << "| " << cell << ' ';
  out << "|\n";
}

/// `left`: how many columns, from the first, hold words; the others hold numbers.
void heading(std::ostream& out, const Cells& cells, std::size_t left) {
  row(out, cells);
  for (std::size_t i = 0; i < cells.size(); ++i) out << (i < left ? "|---" : "|--:");
  out << "|\n";
}

std::string decimals(double x, int digits = 2) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, x);
  return text;
}

// -- Claims about effort ----------------------------------------------------------------------------------------------

/// A claim looked at for every shape.
template <class HowOften>
Claim about_shapes(const Counted& counted, std::string words, std::string section, std::string what, Strength strength,
                   HowOften how_often) {
  Claim claim{std::move(words), std::move(section), std::move(what), strength, {}};
  for (std::size_t i = 0; i < counted.efforts.size(); ++i)
    claim.measured.push_back({claim_shapes()[i].name, how_often(counted.efforts[i])});
  return claim;
}

constexpr int limit = 20;

std::vector<Claim> claims_of_iterations(const Counted& counted) {
  return {
      about_shapes(counted, "GJK “rarely needs more than 10”", "3.1.4", "at most 10 iterations",
                   Strength::nearly_always, [](const ShapeEffort& e) { return e.all_iterations().between(0, 10); }),
      about_shapes(counted, "“usually around 5–10” iterations", "3.3", "5 to 10 iterations", Strength::usually,
                   [](const ShapeEffort& e) { return e.all_iterations().between(5, 10); }),
      about_shapes(counted, "“If the objects intersect, GJK generally requires at least 4 iterations”", "3.3",
                   "hits of 4 or more iterations", Strength::usually,
                   [](const ShapeEffort& e) { return e.hits.iterations.between(4, limit); }),
      about_shapes(counted, "“If the objects do not intersect, then GJK is usually able to determine that within 2–3”",
                   "3.3", "misses of at most 3 iterations", Strength::usually,
                   [](const ShapeEffort& e) { return e.misses.iterations.between(0, 3); }),
      about_shapes(counted, "“we never found GJK to require 20 iterations”", "3.3", "fewer than 20 iterations",
                   Strength::always, [](const ShapeEffort& e) { return e.all_iterations().between(0, limit - 1); }),
      about_shapes(counted, "“Processing a 3-simplex requires, at most, 7 cross products”", "3.3",
                   "queries without a 3-simplex that took more", Strength::always,
                   [](const ShapeEffort& e) { return e.most_in_a_3simplex.between(0, 7); }),
      about_shapes(counted, "the simplex needs “at most, four 3-D points”", "3.3", "simplices of at most 4 vertices",
                   Strength::always,
                   [](const ShapeEffort& e) {
                     Rate all = e.shortcuts.nearest_was(2, 0);
                     for (const std::size_t size : {3, 4}) all += e.shortcuts.nearest_was(size, 0);
                     return Rate{e.shortcuts.largest_simplex <= 4 ? all.trials : 0, all.trials};
                   }),
  };
}

// -- Claims about skipped regions -------------------------------------------------------------------------------------

struct Skipped {
  std::string words, section;
  std::size_t size;
  std::vector<Feature> features;
};

constexpr Feature A = feature_of(gjk::Role::A), B = feature_of(gjk::Role::B), C = feature_of(gjk::Role::C),
                  D = feature_of(gjk::Role::D);

const std::vector<Skipped>& skipped_regions() {
  static const std::vector<Skipped> all{
      {"1-simplex: “the origin cannot be in region R1”, beyond B", "3.2.2", 2, {B}},
      {"1-simplex: “The origin also cannot be in R2”, beyond A", "3.2.2", 2, {A}},
      {"2-simplex: “R4, R5 and R6, so the origin cannot be in those regions” (B, BC, C)", "3.2.3", 3, {B, B | C, C}},
      {"2-simplex: “We can also eliminate region R2”, beyond A", "3.2.3", 3, {A}},
      {"3-simplex: “we can eliminate … the points B, C, and D”", "3.2.4", 4, {B, C, D}},
      {"3-simplex: “… the line segments BC, CD and DB”", "3.2.4", 4, {B | C, C | D, D | B}},
      {"3-simplex: “… and the triangle BCD”", "3.2.4", 4, {B | C | D}},
      {"3-simplex: “we can eliminate the region beyond A”", "3.2.4", 4, {A}},
  };
  return all;
}

Rate not_nearest(const Shortcuts& shortcuts, const Skipped& skipped) {
  Rate rate = shortcuts.nearest_was(skipped.size, 0);
  rate.count = 0;
  for (const Feature feature : skipped.features) rate.count += shortcuts.nearest_was(skipped.size, feature).count;
  return rate.opposite();
}

std::vector<Claim> claims_of_skipped_regions(const Counted& counted) {
  std::vector<Claim> claims;
  for (const Skipped& skipped : skipped_regions())
    claims.push_back(about_shapes(counted, skipped.words, skipped.section, "the origin lies elsewhere, exactly",
                                  Strength::always,
                                  [&](const ShapeEffort& e) { return not_nearest(e.shortcuts, skipped); }));
  return claims;
}

ExtraChecks sum_of(const std::array<ExtraChecks, Shortcuts::iterations>& by_iteration) {
  ExtraChecks sum;
  for (const ExtraChecks& checks : by_iteration) sum += checks;
  return sum;
}

std::vector<Claim> claims_of_extra_checks(const Counted& counted) {
  const auto newest = [](const ShapeEffort& e) {
    const ExtraChecks sum = sum_of(e.shortcuts.in_triangle);
    return Rate{sum.edges - sum.newest_false, sum.edges};
  };
  const auto older = [](const ShapeEffort& e) {
    const ExtraChecks sum = sum_of(e.shortcuts.in_triangle);
    return Rate{sum.edges - sum.older_false, sum.edges};
  };
  return {
      about_shapes(counted, "“That guarantees that AB·AO > 0”, said of A exactly in the direction searched (E7)",
                   "3.2.3", "AB·AO > 0 where Eq. 12 is true, of any A", Strength::always, newest),
      about_shapes(counted, "BA·BO > 0 is among the checks that “are almost always satisfied” (E7)", "3.2.3",
                   "BA·BO > 0 where Eq. 12 is true", Strength::nearly_always, older),
  };
}

// -- Claims about the comparison with Möller's test -------------------------------------------------------------------

const char* const moller_names[] = {"double", "float", "double, snapped", "float, snapped"};

/// All disagreements of GJK in double, as intended, with the four ways of Möller's test.
Comparison all_of(const std::array<Comparison, ways>& compared) {
  Comparison sum;
  for (const Comparison& c : compared) sum += c;
  return sum;
}

Rate gjk_was_right(const Comparison& c) { return {c.gjk_right(), c.disagreements()}; }
Rate gjk_said_yes(const Comparison& c) { return {c.only_gjk.trials, c.disagreements()}; }

std::string name_of(const Coarseness& c) {
  if (c.divisor == 1) return "whole numbers 0 … " + grouped(static_cast<std::uint64_t>(c.levels - 1));
  return "k/" + grouped(static_cast<std::uint64_t>(c.divisor)) + ", k = 0 … " +
         grouped(static_cast<std::uint64_t>(c.levels - 1));
}

const TouchCounts& touches_of(const Counted& counted, const Coarseness& coarseness) {
  const auto found = std::ranges::find(coarsenesses(), coarseness);
  return counted.touches[static_cast<std::size_t>(found - coarsenesses().begin())];
}

constexpr Coarseness hundred{101, 1};

std::vector<Claim> claims_of_disagreements(const Counted& counted) {
  const Comparison fine = all_of(counted.moller.compared[0]);
  const Comparison coarse = all_of(touches_of(counted, hundred).compared);
  return {
      {"where GJK and TriTri disagree, “our implementation was determined to operate correctly”",
       "5",
       "disagreements in which GJK is right",
       Strength::always,
       {{"random triangles", gjk_was_right(fine)}, {name_of(hundred), gjk_was_right(coarse)}}},
      {"“In both cases, our GJK implementation reported that the triangles intersected whereas TriTri reported they "
       "did "
       "not”",
       "4",
       "disagreements in which only GJK says so",
       Strength::always,
       {{"random triangles", gjk_said_yes(fine)}, {name_of(hundred), gjk_said_yes(coarse)}}},
  };
}

/// "All but 2" of a million: not refuted where the interval reaches down to 2 per million.
void write_agreement_row(std::ostream& out, const Counted& counted) {
  const auto rate = [&](GjkWay gjk) {
    const Comparison& c = counted.moller.of(gjk, MollerWay::float_snapped);
    return Rate{c.disagreements(), c.pairs()};
  };
  const Rate intended = rate(GjkWay::double_intended), printed = rate(GjkWay::double_printed);
  const auto fits = [](const Rate& r) { return r.interval().low <= 2e-6; };
  row(out, {"“agreed with TriTri for all but 2 pairs of triangles” of a million", "4",
            "disagreements with Möller in float, snapped", rate_text(intended),
            "Algorithm 1 as printed: " + rate_text(printed),
            !fits(intended) ? "**does not hold**"
            : fits(printed) ? "**holds**"
                            : "holds only for the rules as intended"});
}

// -- The claim about mistakes -----------------------------------------------------------------------------------------

constexpr double unnoticed = 0.05;  ///< the risk of not seeing a mistake that is left when 95 % is asked for

/// Returns: how many pairs must be tested until a failure of this probability is seen in 95 of 100 test runs.
double pairs_to_see(double p) { return p >= 1 ? 1 : std::ceil(std::log(unnoticed) / std::log1p(-p)); }

double passes(double p, double pairs) { return p >= 1 ? 0 : std::exp(pairs * std::log1p(-p)); }

void write_mistakes_row(std::ostream& out, const Counted& counted) {
  const std::size_t all = mistakes().size();
  const auto passing = [&](double pairs) {
    return std::ranges::count_if(counted.triangles.counts,
                                 [=](const MistakeCounts& m) { return passes(m.fails.share(), pairs) > 0.5; });
  };
  const auto healing = std::ranges::count_if(counted.triangles.counts, [](const MistakeCounts& m) {
    return m.heals.trials > 0 && holds(Strength::usually, m.heals).value_or(false);
  });
  const auto acting =
      std::ranges::count_if(counted.triangles.counts, [](const MistakeCounts& m) { return m.changed.count > 0; });
  const auto of_all = " of " + std::to_string(all);
  row(out, {"“an implementation can have a bug, but still pass many test cases”", "1",
            "mistakes that more likely than not pass 100 random pairs", std::to_string(passing(100)) + of_all,
            std::to_string(passing(10'000)) + of_all + " pass 10,000",
            passing(100) > 0 ? "**holds** for these " + std::to_string(passing(100)) : "**does not hold**"});
  row(out, {"“the implementation can self-correct in later iterations”", "1",
            "mistakes after which most of the runs that they change end rightly",
            std::to_string(healing) + " of the " + std::to_string(acting) + " that change any run", "–",
            healing > 0 ? "**holds** for these " + std::to_string(healing) : "**does not hold**"});
}

// -- The table of claims ----------------------------------------------------------------------------------------------

void write_claim(std::ostream& out, const Claim& claim) {
  const Measured& first = claim.measured.front();
  const Measured& least = worst(claim);
  row(out,
      {claim.words, claim.section, claim.counted, rate_text(first.holds),
       &first == &least || least.holds.share() >= first.holds.share() ? "–"
                                                                      : least.where + ": " + rate_text(least.holds),
       verdict(claim)});
}

void write_claims_table(std::ostream& out, const Counted& counted) {
  out << "## Claim by claim\n\n"
         "The share of cases in which the claim is true, with its 95 % interval. An *always* (“never”, “at most”, "
         "“cannot”) "
         "holds where no exception was seen; an *almost always* or *rarely* where the interval lies above 99 %; a "
         "*usually* "
         "or *generally* where it lies above one half. Section and E7 are those of the report and of our notes on "
         "it.\n\n";
  heading(
      out,
      {"The report says", "Section", "Counted as true", "Random triangles", "Where it is true least often", "Verdict"},
      6);
  for (const auto& claims :
       {claims_of_iterations(counted), claims_of_skipped_regions(counted), claims_of_extra_checks(counted)})
    for (const Claim& claim : claims) write_claim(out, claim);
  write_agreement_row(out, counted);
  for (const Claim& claim : claims_of_disagreements(counted)) write_claim(out, claim);
  write_mistakes_row(out, counted);
  out << '\n';
}

// -- Effort by shape --------------------------------------------------------------------------------------------------

std::string spread(const Distribution& d) {
  if (d.queries() == 0) return "–";
  return decimals(d.mean()) + " / " + std::to_string(d.percentile_99()) + " / " + std::to_string(d.max());
}

void write_effort(std::ostream& out, const Counted& counted) {
  out << "## Iterations and cross products\n\nMean / 99 % / largest per query. Hits and misses as GJK answers "
         "them.\n\n";
  heading(out, {"Shape", "Pairs", "Hits", "Undecided", "Iterations: hits", "misses", "Cross products: hits", "misses"},
          2);
  for (std::size_t i = 0; i < counted.efforts.size(); ++i) {
    const Shape& shape = claim_shapes()[i];
    const ShapeEffort& e = counted.efforts[i];
    const Distribution all = e.all_iterations();
    row(out, {shape.name, shape.what, rate_text({e.hits.iterations.queries(), all.queries()}),
              rate_text({e.undecided.iterations.queries(), all.queries()}), spread(e.hits.iterations),
              spread(e.misses.iterations), spread(e.hits.cross_products), spread(e.misses.cross_products)});
  }
  out << "\nAlgorithm 5 is counted as it runs here: the normals of Eq. 14 one by one, until one sees the origin. The "
         "report's listing makes all three first, which costs up to two more per 3-simplex.\n\n";
}

// -- Skipped regions and extra checks by shape ------------------------------------------------------------------------

void write_skipped(std::ostream& out, const Counted& counted) {
  out << "## Where the origin lies when a region is skipped\n\n"
         "How often the nearest feature, found exactly for the vertices as they stand, was one that the report "
         "skips.\n\n";
  Cells names{"Skipped"};
  for (const Shape& shape : claim_shapes()) names.push_back(shape.name);
  heading(out, names, 1);
  for (const Skipped& skipped : skipped_regions()) {
    std::string name = std::to_string(skipped.size - 1) + "-simplex:";
    for (const Feature feature : skipped.features) name += " " + letters(feature);
    Cells cells{name};
    for (const ShapeEffort& e : counted.efforts) {
      const Rate exceptions = not_nearest(e.shortcuts, skipped).opposite();
      cells.push_back(grouped(exceptions.count) + " of " + grouped(exceptions.trials));
    }
    row(out, cells);
  }
  out << "\nThe difference of two spheres is a sphere: all vertices up to the third lie in one plane with the origin, "
         "and "
         "`ABCn·AO`, which should be zero, is a rounding error (E5). Half of the time its sign is the wrong one, the "
         "search "
         "goes to the wrong side of BCD, and the origin lies behind it by a rounding error. The answer is right all "
         "the "
         "same.\n\n";
}

void write_extra_checks(std::ostream& out, const Counted& counted) {
  out << "## E7: the checks that the report leaves out\n\n"
         "False `AX·AO > 0` (the origin lies beyond A) + false `XA·XO > 0` (beyond the older end), of all edges AX "
         "that were "
         "kept in that iteration. The report speaks of the triangle (Algorithm 4); the edges of a tetrahedron "
         "(Algorithm 5) "
         "are kept without these checks, too.\n\n";
  heading(out, {"Shape", "Simplex", "Iteration 3", "4", "5", "6", "7 and later", "All"}, 2);
  const auto text = [](const ExtraChecks& c) {
    return c.edges == 0 ? std::string("–")
                        : grouped(c.newest_false) + " + " + grouped(c.older_false) + " of " + grouped(c.edges);
  };
  for (std::size_t i = 0; i < counted.efforts.size(); ++i) {
    const Shortcuts& s = counted.efforts[i].shortcuts;
    for (const auto* const by_iteration : {&s.in_triangle, &s.in_tetrahedron}) {
      Cells cells{claim_shapes()[i].name, by_iteration == &s.in_triangle ? "triangle" : "tetrahedron"};
      for (std::size_t k = 3; k < 7; ++k) cells.push_back(text((*by_iteration)[k]));
      ExtraChecks later;
      for (std::size_t k = 7; k < Shortcuts::iterations; ++k) later += (*by_iteration)[k];
      cells.push_back(text(later));
      cells.push_back(text(sum_of(*by_iteration)));
      row(out, cells);
    }
  }
  out << '\n';
}

// -- Möller -----------------------------------------------------------------------------------------------------------

std::string who(const Rate& right) {
  return right.trials == 0 ? "0" : grouped(right.trials) + " (right: " + grouped(right.count) + ")";
}

void write_comparisons(std::ostream& out, const Counted& counted, std::uint64_t pairs) {
  out << "## GJK against Möller's triangle test of 1997\n\n"
      << grouped(pairs) << " random triangle pairs, of which " << grouped(counted.moller.meet)
      << " meet. “Snapped”: distances below 1e-6 count as zero, as in the implementation that Möller published. An "
         "undecided GJK ("
      << grouped(counted.moller.undecided)
      << " as intended, in double) counts as “no”, as in Algorithm 1. Right is what exact arithmetic says of the pair; "
         "where "
         "both tests compute in float, of the pair rounded to float, which changes the truth of "
      << grouped(counted.moller.rounding_changes_truth) << " pairs.\n\n";
  heading(out,
          {"GJK", "Möller", "Both: they meet", "Both: they do not", "Only GJK: they meet", "Only Möller: they meet"},
          2);
  const char* const gjk_names[] = {"double, as intended", "float, as intended", "double, as printed",
                                   "float, as printed"};
  for (std::size_t g = 0; g < ways; ++g)
    for (std::size_t m = 0; m < ways; ++m) {
      if (g % 2 == 1 && m % 2 == 0) continue;  // nobody would run GJK in less than what it is compared with
      const Comparison& c = counted.moller.compared[g][m];
      row(out, {gjk_names[g], moller_names[m], grouped(c.both_yes), grouped(c.both_no), who(c.only_gjk),
                who(c.only_moller)});
    }
  out << '\n';
}

void write_disagreements(std::ostream& out, const Counted& counted) {
  const auto& list = counted.moller.disagreements;
  if (list.empty()) {
    out << "GJK in double, as intended, disagrees with none of them.\n\n";
    return;
  }
  constexpr std::size_t most = 12;
  out << "The disagreements of GJK in double, as intended" << (list.size() > most ? ", the first twelve" : "")
      << ". Where the intervals of Möller's test exist in exact arithmetic, their gap is given as a share of the "
         "shorter "
         "one; where they do not, one triangle lies beyond the other's plane.\n\n";
  heading(out, {"Pair", "Möller", "GJK", "Truth", "Gap"}, 4);
  for (std::size_t i = 0; i < std::min(list.size(), most); ++i) {
    const Disagreement& d = list[i];
    const auto word = [](bool meet) { return meet ? "they meet" : "they do not"; };
    char gap[32];
    std::snprintf(gap, sizeof gap, "%.1e", -d.depth);
    row(out,
        {grouped(d.index), moller_names[static_cast<std::size_t>(d.moller)],
         d.undecided ? "undecided" : word(d.gjk_says), word(d.truth), std::isnan(d.depth) ? "beyond the plane" : gap});
  }
  out << '\n';
}

void write_touches(std::ostream& out, const Counted& counted) {
  out << "## The report's two pairs\n\n"
         "“in both cases the triangles intersected at exactly 1 point along an edge. The intersection point was not "
         "any of "
         "the vertices, nor were the triangles coplanar” (Section 4). GJK said that they intersect, TriTri that they "
         "do not, "
         "and the author suspected a bug in TriTri. The same experiment with coordinates of few digits, GJK as "
         "intended:\n\n";
  heading(out,
          {"Coordinates", "Pairs", "Touch so, exactly", "Möller", "Only GJK: they meet", "… and they touch so",
           "Only Möller: they meet"},
          1);
  for (std::size_t i = 0; i < counted.touches.size(); ++i) {
    const TouchCounts& t = counted.touches[i];
    for (const std::size_t m : {0, 1, 3})
      row(out, {m == 0 ? name_of(coarsenesses()[i]) : "", m == 0 ? grouped(t.pairs) : "",
                m == 0 ? grouped(t.edges_touch.count) : "", moller_names[m], who(t.compared[m].only_gjk),
                grouped(t.edges_touch_only_gjk[m]), who(t.compared[m].only_moller)});
  }
  out << '\n';
}

void write_explanation(std::ostream& out, const Counted& counted) {
  const Comparison fine = all_of(counted.moller.compared[0]);
  const TouchCounts& coarse = touches_of(counted, hundred);
  const Comparison snapped = coarse.compared[static_cast<std::size_t>(MollerWay::float_snapped)];
  const auto so = coarse.edges_touch_only_gjk[static_cast<std::size_t>(MollerWay::float_snapped)];
  out << "**Known.** With coordinates of 53 random bits, " << grouped(fine.only_gjk.trials) << " of "
      << grouped(fine.disagreements())
      << " disagreements (all four ways of Möller's test together) are of the report's kind. "
      << "With coordinates " << name_of(hundred) << ", " << grouped(snapped.only_gjk.trials) << " of "
      << grouped(snapped.disagreements()) << " are (float, snapped), and in " << grouped(so)
      << " of them the triangles touch just as the report says. There GJK is right and Möller's test wrong: products "
         "of "
         "such numbers are exact, so that GJK sees a zero as zero, while Möller's test divides, "
         "`p + (q − p)·d/(d − e)`, and compares two rounded quotients that ought to be equal. The snap does not help: "
         "it is "
         "done to distances, before the division. A common vertex is found all the same, because there is nothing to "
         "divide.\n\n"
         "**Conjecture.** The report does not say how its triangles were made. Two such pairs in a million are what "
         "whole-number coordinates of about a hundred values give, and what random numbers of many digits do not. If "
         "so, "
         "TriTri has no bug that was unknown, but a rounding error; and “one million random pairs” met the boundary, "
         "where "
         "implementations differ, twice.\n\n"
         "**Also known.** The program that agreed with TriTri cannot have been Algorithm 1 as printed (E1), which "
         "disagrees in "
      << rate_text({counted.moller.of(GjkWay::double_printed, MollerWay::float_snapped).disagreements(),
                    counted.moller.of(GjkWay::double_printed, MollerWay::float_snapped).pairs()})
      << ".\n\n";
}

// -- Mistakes ---------------------------------------------------------------------------------------------------------

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
  return needed(fails) + " (" + about(pairs_to_see(fails.interval().high)) + "–" +
         about(pairs_to_see(fails.interval().low)) + ")";
}

std::string chance(double p) { return p > 0.9995 ? "> 99.9 %" : p < 0.001 ? "< 0.1 %" : decimals(100 * p, 1) + " %"; }

std::string passing_text(const Rate& fails, double pairs) {
  if (fails.count == 0) return "≥ " + decimals(100 * passes(fails.interval().high, pairs), 1) + " %";
  return chance(passes(fails.share(), pairs));
}

void write_mistakes(std::ostream& out, const Counted& counted) {
  out << "## How many tests does a mistake survive?\n\n"
         "“The iterative nature of GJK can mask many bugs … an implementation can have a bug, but still pass many test "
         "cases” "
         "(Section 1). Each line is the report's algorithm in double with one of the mistakes in it that the report "
         "names, "
         "asked about random triangle pairs. *Fails*: Algorithm 1 answers wrongly (undecided is “no”), where it is "
         "right "
         "without the mistake. *Undecided*: 20 iterations were not enough. *Changed*: the search went other ways than "
         "without the mistake. *Heals*: of the changed runs, those that end in the right answer all the same. *More "
         "iterations*: of these, on average. *Passes*: the probability that a test of so many random pairs shows "
         "nothing.\n\n";
  heading(out,
          {"Mistake", "Section", "Fails", "Undecided", "Changed", "Heals", "More iterations", "Passes 100 pairs",
           "10,000", "1,000,000"},
          2);
  for (std::size_t i = 0; i < mistakes().size(); ++i) {
    const MistakeCounts& m = counted.triangles.counts[i];
    row(out, {mistakes()[i].name, mistakes()[i].section, rate_text(m.fails), grouped(m.undecided.count),
              share_text(m.changed.share()), m.heals.trials == 0 ? "–" : share_text(m.heals.share()),
              m.heals.count == 0 ? "–" : decimals(m.mean_extra()), passing_text(m.fails, 100),
              passing_text(m.fails, 1e4), passing_text(m.fails, 1e6)});
  }
  out << "\nHow many random pairs must be tested so that the mistake shows in 95 of 100 such tests (in brackets the 95 "
         "% "
         "interval), and how many of other kinds: the right choice of pairs is worth more than their number.\n\n";
  heading(out, {"Mistake", "Random triangles", "Random tetrahedra", "Triangles on a grid of 6 × 6 × 6"}, 1);
  for (std::size_t i = 0; i < mistakes().size(); ++i)
    row(out, {mistakes()[i].name, needed_between(counted.triangles.counts[i].fails),
              needed(counted.tetrahedra.counts[i].fails), needed(counted.grid.counts[i].fails)});
  out << '\n';
}

}  // namespace

void write_claims(std::ostream& out, const ClaimsOptions& options) {
  const Counted counted = count_all(options);
  out << "# The report's claims, measured\n\n"
      << "Made by `gjkstep-study claims --pairs " << options.pairs << " --seed " << options.seed
      << "`; compiler: " << __VERSION__ << ". " << grouped(options.pairs)
      << " pairs of every kind. GJK is gjkstep's, in double, with the rules as intended and exact zero tests, where "
         "nothing "
         "else is said. Intervals are Wilson's for 95 %.\n\n";
  write_claims_table(out, counted);
  write_effort(out, counted);
  write_skipped(out, counted);
  write_extra_checks(out, counted);
  write_comparisons(out, counted, options.pairs);
  write_disagreements(out, counted);
  write_touches(out, counted);
  write_explanation(out, counted);
  write_mistakes(out, counted);
}

}  // namespace study
