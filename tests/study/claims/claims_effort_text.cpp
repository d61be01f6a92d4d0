#include <ostream>

#include "tests/study/claims/claims_text.hpp"

namespace study {
namespace {

constexpr Feature A = feature_of(gjk::Role::A), B = feature_of(gjk::Role::B), C = feature_of(gjk::Role::C),
                  D = feature_of(gjk::Role::D);

// -- Effort by shape --------------------------------------------------------------------------------------------------

std::string spread(const Distribution& d) {
  if (d.queries() == 0) return "–";
  return decimals(d.mean(), 2) + " / " + std::to_string(d.percentile_99()) + " / " + std::to_string(d.max());
}

std::string share_or_none(std::uint64_t count, std::uint64_t of) { return share_text(Rate{count, of}.share()); }

void write_iterations(std::ostream& out, const Counted& counted) {
  out << "## Iterations and cross products\n\n";
  paragraph(out,
            "Mean / 99 % / largest per query. Random shapes come first: there hits and misses are told apart by GJK's "
            "answer. In the hard families after them it is held against the truth, and *wrong* answers are neither. "
            "*Undecided*: 20 iterations were not enough, or the search direction was zero.");
  heading(out,
          {"Shape", "Pairs", "Asked", "Hits", "Wrong", "Undecided", "Iterations: hits", "misses",
           "Cross products: hits", "misses"},
          2);
  for (std::size_t i = 0; i < counted.efforts.size(); ++i) {
    const Shape& shape = claim_shapes()[i];
    const ShapeEffort& e = counted.efforts[i];
    const std::uint64_t all = e.queries();
    row(out, {shape.name, shape.what, grouped(all), share_or_none(e.hits.iterations.queries(), all),
              shape.hardness == Hardness::hard ? share_or_none(e.wrong.iterations.queries(), all) : "–",
              share_or_none(e.undecided.iterations.queries(), all), spread(e.hits.iterations),
              spread(e.misses.iterations), spread(e.hits.cross_products), spread(e.misses.cross_products)});
  }
  out << '\n';
  paragraph(out,
            "Algorithm 5 is counted as it runs here: the normals of Eq. 14 one by one, until one sees the origin. The "
            "report's listing makes all three first, which costs up to two more per 3-simplex.");
}

// -- Skipped regions and extra checks by shape ------------------------------------------------------------------------

void write_skipped_row(std::ostream& out, const std::string& name, const Shortcuts& shortcuts) {
  Cells cells{name};
  for (const Skipped& skipped : skipped_regions()) {
    const Rate exceptions = not_nearest(shortcuts, skipped).opposite();
    cells.push_back(grouped(exceptions.count) + " of " + grouped(exceptions.trials));
  }
  row(out, cells);
}

void write_skipped(std::ostream& out, const Counted& counted) {
  out << "## Where the origin lies when a region is skipped\n\n";
  paragraph(out,
            "How often the nearest feature, found exactly for the vertices as they stand, was one that the report "
            "skips, and the origin is not a point of it. Flat simplices, of which it cannot be told, are left out.");
  Cells names{"Shape"};
  for (const Skipped& skipped : skipped_regions()) {
    names.push_back(std::to_string(skipped.size - 1) + "-simplex:");
    for (const Feature feature : skipped.features) names.back() += " " + letters(feature);
  }
  heading(out, names, 1);
  for (std::size_t i = 0; i < counted.efforts.size(); ++i)
    write_skipped_row(out, claim_shapes()[i].name, counted.efforts[i].shortcuts);
  for (std::size_t i = 0; i < counted.in_fractions.size(); ++i)
    write_skipped_row(out, whole_number_shapes()[i] + ", in fractions", counted.in_fractions[i]);
  out << '\n';
  paragraph(
      out,
      "*In fractions*: GJK itself computes without rounding, for the families of whole numbers and fewer pairs. Where "
      "a share is far lower there than in double, rounding makes the difference.");
  paragraph(
      out,
      "Behind BCD: without rounding, the search leaves a triangle on the side of the origin, and goes on only where "
      "it gets past it. In double the sign of `ABCn·AO` can be a rounding error's. For the first triangle of two "
      "spheres it is: their difference is a sphere, and its first three vertices lie in one plane with the "
      "origin but for rounding.");
}

std::string text_of(const ExtraChecks& c) {
  return c.edges == 0 ? "–" : grouped(c.newest_false) + " + " + grouped(c.older_false) + " of " + grouped(c.edges);
}

void write_extra_checks_of(std::ostream& out, const std::string& shape, const std::string& simplex,
                           const std::array<ExtraChecks, Shortcuts::iterations>& by_iteration) {
  ExtraChecks later;
  for (std::size_t k = 5; k < Shortcuts::iterations; ++k) later += by_iteration[k];
  row(out, {shape, simplex, text_of(by_iteration[3]), text_of(by_iteration[4]), text_of(later),
            text_of(sum_of(by_iteration))});
}

void write_extra_checks(std::ostream& out, const Counted& counted) {
  out << "## The checks that the report leaves out\n\n";
  paragraph(out,
            "Section 3.2.3: “`AB·AO > 0` and `BA·BO > 0` in addition to Eq. 12”. False `AX·AO > 0` (the origin lies "
            "beyond A, or level with it) + false `XA·XO > 0` (beyond the older end, or level with it), of all edges AX "
            "that were kept in that iteration. The report speaks of the triangle (Algorithm 4); the edges of a "
            "tetrahedron (Algorithm 5) are kept without these checks, too.");
  heading(out, {"Shape", "Simplex", "Iteration 3", "4", "5 and later", "All"}, 2);
  for (std::size_t i = 0; i < counted.efforts.size(); ++i) {
    const Shortcuts& s = counted.efforts[i].shortcuts;
    write_extra_checks_of(out, claim_shapes()[i].name, "triangle", s.in_triangle);
    write_extra_checks_of(out, claim_shapes()[i].name, "tetrahedron", s.in_tetrahedron);
  }
  out << '\n';
}

}  // namespace

const std::vector<Skipped>& skipped_regions() {
  static const std::vector<Skipped> all{
      {"1-simplex: “the origin cannot be in region R1”, beyond B", "3.2.2", 2, {B}},
      {"1-simplex: “The origin also cannot be in R2”, beyond A", "3.2.2", 2, {A}},
      {"2-simplex: “R4, R5 and R6, so the origin cannot be in those regions” (B, BC, C)", "3.2.3", 3, {B, B | C, C}},
      {"2-simplex: “We can also eliminate region R2”, beyond A", "3.2.3", 3, {A}},
      {"3-simplex: “the points B, C, and D, the line segments BC, CD and DB”",
       "3.2.4",
       4,
       {B, C, D, B | C, C | D, D | B}},
      {"3-simplex: “… and the triangle BCD”", "3.2.4", 4, {B | C | D}},
      {"3-simplex: “we can eliminate the region beyond A”", "3.2.4", 4, {A}},
  };
  return all;
}

Rate not_nearest(const Shortcuts& shortcuts, const Skipped& skipped) {
  Rate rate = shortcuts.nearest_was(skipped.size, 0).opposite();
  rate = {0, rate.count};
  for (const Feature feature : skipped.features) rate.count += shortcuts.nearest_was(skipped.size, feature).count;
  return rate.opposite();
}

ExtraChecks sum_of(const std::array<ExtraChecks, Shortcuts::iterations>& by_iteration) {
  ExtraChecks sum;
  for (const ExtraChecks& checks : by_iteration) sum += checks;
  return sum;
}

void write_effort(std::ostream& out, const Counted& counted) {
  write_iterations(out, counted);
  write_skipped(out, counted);
  write_extra_checks(out, counted);
}

}  // namespace study
