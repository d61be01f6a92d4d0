/// The report's claims against what is counted, as a text in Markdown.
#pragma once

#include <iosfwd>

#include "tests/study/claims/claims_measured.hpp"

namespace study {

/// Counts everything and writes it down. The text depends on pairs, seed and compiler alone.
void write_claims(std::ostream& out, const ClaimsOptions& options);

}  // namespace study
