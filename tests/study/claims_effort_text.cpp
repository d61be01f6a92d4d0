#include <ostream>

#include "tests/study/claims_text.hpp"

namespace study {
namespace {

constexpr Feature A = feature_of(gjk::Role::A), B = feature_of(gjk::Role::B), C = feature_of(gjk::Role::C),
                  D = feature_of(gjk::Role::D);

// -- Effort by shape --------------------------------------------------------------------------------------------------

std::string spread(const Distribution& d) {
  if (d.queries() == 0) return "–";
  return decimals(d.mean(), 2) + " / " + std::to_string(d.percentile_99()) + " / " + std::to_string(d.max());
}

void write_iterations(std::ostream& out, const Counted& counted) {
  out << "## Iterations and cross products\n\nMean / 99 % / largest per query. Hits and misses as GJK answers "
         "them.\n\n";
  heading(out, {"Shape", "Pairs", "Hits", "Undecided", "Iterations: hits", "misses", "Cross products: hits", "misses"},
          2);
  for (std::size_t i = 0; i < counted.efforts.size(); ++i) {
    const Shape& shape = claim_shapes()[i];
    const ShapeEffort& e = counted.efforts[i];
    const Distribution all = e.all_iterations();
    row(out, {shape.name, shape.what, share_text(Rate{e.hits.iterations.queries(), all.queries()}.share()),
              rate_text({e.undecided.iterations.queries(), all.queries()}), spread(e.hits.iterations),
              spread(e.misses.iterations), spread(e.hits.cross_products), spread(e.misses.cross_products)});
  }
  out << R"(
Algorithm 5 is counted as it runs here: the normals of Eq. 14 one by one, until one sees the origin. The report's listing
makes all three first, which costs up to two more per 3-simplex.

)";
}

// -- Skipped regions and extra checks by shape ------------------------------------------------------------------------

void write_skipped(std::ostream& out, const Counted& counted) {
  out << R"(## Where the origin lies when a region is skipped

How often the nearest feature, found exactly for the vertices as they stand, was one that the report skips.

)";
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
  out << R"(
The difference of two spheres is a sphere: the first three vertices lie in one plane with the origin, and `ABCn·AO`, which
should be zero, is a rounding error. Where its sign is the wrong one, the search goes to the wrong side of the triangle, and
the origin lies behind BCD, by that rounding error.

)";
}

void write_extra_checks(std::ostream& out, const Counted& counted) {
  out << R"(## The checks that the report leaves out

Section 3.2.3: “`AB·AO > 0` and `BA·BO > 0` in addition to Eq. 12”. False `AX·AO > 0` (the origin lies beyond A) + false
`XA·XO > 0` (it lies beyond the older end), of all edges AX that were kept in that iteration. The report speaks of the
triangle (Algorithm 4); the edges of a tetrahedron (Algorithm 5) are kept without these checks, too.

)";
  heading(out, {"Shape", "Simplex", "Iteration 3", "4", "5 and later", "All"}, 2);
  const auto text = [](const ExtraChecks& c) {
    return c.edges == 0 ? std::string("–")
                        : grouped(c.newest_false) + " + " + grouped(c.older_false) + " of " + grouped(c.edges);
  };
  for (std::size_t i = 0; i < counted.efforts.size(); ++i) {
    const Shortcuts& s = counted.efforts[i].shortcuts;
    for (const auto* const by_iteration : {&s.in_triangle, &s.in_tetrahedron}) {
      Cells cells{claim_shapes()[i].name, by_iteration == &s.in_triangle ? "triangle" : "tetrahedron"};
      for (std::size_t k = 3; k < 5; ++k) cells.push_back(text((*by_iteration)[k]));
      ExtraChecks later;
      for (std::size_t k = 5; k < Shortcuts::iterations; ++k) later += (*by_iteration)[k];
      cells.push_back(text(later));
      cells.push_back(text(sum_of(*by_iteration)));
      row(out, cells);
    }
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
  Rate rate = shortcuts.nearest_was(skipped.size, 0);
  rate.count = 0;
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
