#include <algorithm>
#include <ostream>

#include "tests/study/claims/claims_text.hpp"

namespace study {
namespace {

// -- Claims about effort ----------------------------------------------------------------------------------------------

/// A claim looked at for every shape.
template <class HowOften>
Claim about_shapes(const Counted& counted, std::string words, std::string section, std::string what, Strength strength,
                   HowOften how_often) {
  Claim claim{std::move(words), std::move(section), std::move(what), strength, {}};
  for (std::size_t i = 0; i < counted.efforts.size(); ++i) {
    const Shape& shape = claim_shapes()[i];
    claim.measured.push_back({shape.name, how_often(counted.efforts[i]),
                              shape.hardness == Hardness::hard ? "hard families" : "random shapes",
                              shape.asks_all(counted.options) ? Cases::all : Cases::thrown});
  }
  return claim;
}

constexpr int iteration_limit = 20;

std::vector<Claim> claims_of_iterations(const Counted& counted) {
  const auto answered_within = [](int least, int most) {
    return [=](const ShapeEffort& e) { return e.answered_within(least, most); };
  };
  return {
      about_shapes(counted, "GJK “rarely needs more than 10”", "3.1.4", "answers within 10 iterations",
                   Strength::nearly_always, answered_within(0, 10)),
      about_shapes(counted, "“usually around 5–10” iterations", "3.3", "answers after 5 to 10 iterations",
                   Strength::usually, answered_within(5, 10)),
      about_shapes(counted, "“If the objects intersect, GJK generally requires at least 4 iterations”", "3.3",
                   "hits of 4 or more iterations", Strength::usually,
                   [](const ShapeEffort& e) { return e.hits.iterations.between(4, iteration_limit); }),
      about_shapes(counted, "“If the objects do not intersect, then GJK is usually able to determine that within 2–3”",
                   "3.3", "misses of at most 3 iterations", Strength::usually,
                   [](const ShapeEffort& e) { return e.misses.iterations.between(0, 3); }),
      about_shapes(counted, "“we never found GJK to require 20 iterations”", "3.3", "answers within 19 iterations",
                   Strength::always, answered_within(0, iteration_limit - 1)),
  };
}

std::vector<Claim> claims_of_cost(const Counted& counted) {
  return {
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

std::vector<Claim> claims_of_skipped_regions(const Counted& counted) {
  std::vector<Claim> claims;
  for (const Skipped& skipped : skipped_regions())
    claims.push_back(about_shapes(counted, skipped.words, skipped.section, "the origin lies elsewhere, exactly",
                                  Strength::always,
                                  [&](const ShapeEffort& e) { return not_nearest(e.shortcuts, skipped); }));
  return claims;
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
  const auto both_of_any_edge = [](const ShapeEffort& e) {
    ExtraChecks sum = sum_of(e.shortcuts.in_triangle);
    sum += sum_of(e.shortcuts.in_tetrahedron);
    return Rate{sum.edges - sum.newest_false - sum.older_false, sum.edges};
  };
  return {
      about_shapes(counted, "“That guarantees that AB·AO > 0”, said of A exactly in the direction searched", "3.2.3",
                   "AB·AO > 0 where Eq. 12 is true, of any A", Strength::always, newest),
      about_shapes(counted, "BA·BO > 0 is among the checks that “are almost always satisfied”", "3.2.3",
                   "BA·BO > 0 where Eq. 12 is true", Strength::nearly_always, older),
      about_shapes(counted, "“some peculiar cases that require these extra checks, though we never encountered any”",
                   "3.2.3", "both checks are true, of edges kept by Algorithms 4 and 5", Strength::always,
                   both_of_any_edge),
      about_shapes(counted, "the new simplex is “the triangle face itself, or an edge, whichever feature is closer”",
                   "3.2.4", "what Algorithm 5 keeps is the feature nearest to the origin", Strength::always,
                   [](const ShapeEffort& e) { return e.shortcuts.kept_the_nearest; }),
  };
}

// -- The table of claims ----------------------------------------------------------------------------------------------

void write_claim(std::ostream& out, const Claim& claim) {
  const Measured& first = claim.measured.front();
  const Measured& least = worst(claim);
  row(out, {claim.words, claim.section, claim.counted, rate_text(first.holds),
            &first == &least || least.holds.share() >= first.holds.share() ? "–" : text_of(least), verdict(claim)});
}

}  // namespace

void write_claims_table(std::ostream& out, const Counted& counted) {
  out << "## Claim by claim\n\n";
  paragraph(
      out,
      "The share of cases in which the claim is true, with its 95 % interval: of random triangles, which the "
      "report took, and where that share is least among all random shapes and hard families (listed under "
      "“Iterations and cross products”). Sections are the report's. Claims about Möller's test and about mistakes are "
      "judged further down, each in a table of its own.");
  paragraph(out,
            "An *always* (“never”, “at most”, “cannot”) holds where no exception was seen and the interval lies above "
            "99 %; with *rare exceptions*, which refute the word but are under 1 %, where the interval lies there all "
            "the same; else it fails. An *almost always* or *rarely* holds where the interval lies above 99 %; a "
            "*usually* or *generally* where it lies above one half. Where the interval leaves that open, so does the "
            "verdict. *Mostly* holds or fails: for most of the shapes and families, each counted once. Simplices and "
            "edges of one query are counted as if they were independent, which makes their intervals a little too "
            "narrow.");
  heading(
      out,
      {"The report says", "Section", "Counted as true", "Random triangles", "Where it is true least often", "Verdict"},
      6);
  for (const auto& claims : {claims_of_iterations(counted), claims_of_cost(counted), claims_of_skipped_regions(counted),
                             claims_of_extra_checks(counted)})
    for (const Claim& claim : claims) write_claim(out, claim);
  out << '\n';
}

}  // namespace study
