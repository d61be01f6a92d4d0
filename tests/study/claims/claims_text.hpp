/// The parts of the text that `gjkstep-study claims` writes.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "tests/study/claims/claims_measured.hpp"
#include "tests/study/claims/claims_verdict.hpp"

namespace study {

/// All that was counted, once.
struct Counted {
  ClaimsOptions options;
  std::vector<ShapeEffort> efforts;     ///< by claim_shapes()
  std::vector<Shortcuts> in_fractions;  ///< by whole_number_shapes()
  std::vector<MollerCounts> moller;     ///< by triangle_kinds()
  MollerCounts common_vertex;
  MistakeTable triangles, tetrahedra, grid;
};

// -- Tables in Markdown -----------------------------------------------------------------------------------------------

using Cells = std::vector<std::string>;

void row(std::ostream& out, const Cells& cells);

/// `left`: how many columns, from the first, hold words; the others hold numbers.
void heading(std::ostream& out, const Cells& cells, std::size_t left);

std::string decimals(double x, int digits);

/// One line, with an empty one after it.
void paragraph(std::ostream& out, const std::string& text);

// -- Sections ---------------------------------------------------------------------------------------------------------

void write_claims_table(std::ostream& out, const Counted& counted);
void write_effort(std::ostream& out, const Counted& counted);
void write_moller(std::ostream& out, const Counted& counted);
void write_mistakes(std::ostream& out, const Counted& counted);

// -- What sections share ----------------------------------------------------------------------------------------------

/// A feature, or some that lie alike, that the report skips when it looks for the origin.
struct Skipped {
  std::string words, section;
  std::size_t size;  ///< of the simplex
  std::vector<Feature> features;
};
const std::vector<Skipped>& skipped_regions();

/// Returns: how often the nearest feature was none of these; flat simplices, of which it cannot be told, are left out.
Rate not_nearest(const Shortcuts& shortcuts, const Skipped& skipped);

ExtraChecks sum_of(const std::array<ExtraChecks, Shortcuts::iterations>& by_iteration);

/// Returns: the probability that so many random pairs show nothing, where each fails with probability `p`.
double passes(double p, double pairs);

}  // namespace study
